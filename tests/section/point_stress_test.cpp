#include "boxbeam/section/point_stress.hpp"

#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"

namespace point_stress_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

// The 1000 mm box of the sledge rig: A = 130e3 mm^2, I = 15.108e9 mm^4.
const Section box{symmetric_box(mm(400), mm(1000), mm(50), mm(50)), {}};
const double I = (400e9 - 300.0 * 900 * 900 * 900) / 12 * 1e-12;

StressInfluence level_at(double z, const std::vector<Hole>& holes = {}) {
  return points_at_level(stress_field_of(box, holes, {}), "", mm(z), PointSet::in_plane)
      .at(0)
      .influence;
}

CutForces cut(double N, double V_z, double M_y) {
  CutForces forces;
  forces.N = si<Force>(N);
  forces.V_z = si<Force>(V_z);
  forces.M_y = si<Moment>(M_y);
  return forces;
}

}  // namespace

TEST_CASE("N > 0 is tension everywhere, N/A") {
  for (const double z : {-500.0, -100.0, 0.0, 500.0}) {
    const PointStress stress = stress_at(level_at(z), cut(130e3, 0, 0));
    CHECK(stress.normal.value() == Approx(1e6).epsilon(1e-12));
    CHECK(stress.shear.value() == 0.0);
  }
}

TEST_CASE("M_y > 0 puts +z in tension and -z in compression, M z/I") {
  const CutForces bending = cut(0, 0, 308e3);
  // 308 kN m at 500 mm: 10.2 MPa (the moment from the thesis' end forces).
  CHECK(stress_at(level_at(500), bending).normal.value() == Approx(308e3 * 0.5 / I).epsilon(1e-12));
  CHECK(stress_at(level_at(500), bending).normal.value() == Approx(10.2e6).epsilon(2e-3));
  CHECK(stress_at(level_at(-500), bending).normal.value() ==
        Approx(-308e3 * 0.5 / I).epsilon(1e-12));
  CHECK(stress_at(level_at(0), bending).normal.value() == Approx(0.0).margin(1e-6));
}

TEST_CASE("shear has the sign of V_z and Jourawski's value, V S/(I b)") {
  const double S = (400 * 50 * 475.0 + 100 * 450 * 225.0) * 1e-9;
  const double tau = 1e5 * S / (I * 0.1);
  CHECK(stress_at(level_at(0), cut(0, 1e5, 0)).shear.value() == Approx(tau).epsilon(1e-12));
  CHECK(stress_at(level_at(0), cut(0, -1e5, 0)).shear.value() == Approx(-tau).epsilon(1e-12));
  // It vanishes at the free faces.
  CHECK(stress_at(level_at(500), cut(0, 1e5, 0)).shear.value() == Approx(0.0).margin(1e-9));
  CHECK(stress_at(level_at(-500), cut(0, 1e5, 0)).shear.value() == Approx(0.0).margin(1e-6));
}

TEST_CASE("the shear at the crown of a round tube is none, not 0/0") {
  const Section tube{RoundTube{mm(500), mm(20)}, {}};
  const auto crown =
      points_at_level(stress_field_of(tube, {}, {}), "", mm(250), PointSet::in_plane);
  CHECK(std::abs(stress_at(crown.at(0).influence, cut(0, 1e5, 0)).shear.value()) < 1e-6);
}

TEST_CASE("normal stresses of a net section resist N at mid-height and M_y about it") {
  // Equilibrium over the section with a hole off mid-height, by the midpoint rule: the integral of
  // sigma dA is N, that of sigma z dA is M_y.
  const std::vector<Hole> holes{{"hole", mm(120), HoleWalls::webs, mm(150)}};
  const AreaSums net = sums_of(outline_of(box, holes));
  const CutForces acting = cut(-2.5e5, 0, 4e5);
  double force = 0.0, moment = 0.0;
  const int steps = 20000;  // steps of 0.05 mm: every jump of the width is a border of two
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double z = -0.5 + (i + 0.5) * h;
    const double width = width_at(box, holes, si<Length>(z)).value();
    if (width == 0.0) continue;
    const double sigma = stress_at(normal_influence(net, 0.0, z), acting).normal.value();
    force += sigma * width * h;
    moment += sigma * width * z * h;
  }
  CHECK(force == Approx(-2.5e5).epsilon(1e-6));
  CHECK(moment == Approx(4e5).epsilon(1e-6));
}

TEST_CASE("von Mises: sqrt(sigma^2 + 3 tau^2)") {
  const auto v = [](double sigma, double tau) {
    return PointStress{si<Stress>(sigma), si<Stress>(tau)}.von_mises().value();
  };
  CHECK(v(100e6, 0) == 100e6);
  CHECK(v(-100e6, 0) == 100e6);
  CHECK(v(0, 100e6) == Approx(100e6 * std::sqrt(3.0)).epsilon(1e-15));
  // A triple by hand: 11^2 + 3*4^2 = 13^2.
  CHECK(v(11e6, -4e6) == Approx(13e6).epsilon(1e-15));
}

TEST_CASE("stress is linear: doubled cut forces double it, sums add") {
  const StressInfluence level = level_at(475);
  const PointStress one = stress_at(level, cut(1e5, 2e4, 3e5));
  const PointStress two = stress_at(level, cut(2e5, 4e4, 6e5));
  CHECK(two.normal.value() == Approx(2.0 * one.normal.value()).epsilon(1e-15));
  CHECK(two.shear.value() == Approx(2.0 * one.shear.value()).epsilon(1e-15));
  CHECK(two.von_mises().value() == Approx(2.0 * one.von_mises().value()).epsilon(1e-15));
  const PointStress axial = stress_at(level, cut(1e5, 0, 0));
  const PointStress bending = stress_at(level, cut(0, 2e4, 3e5));
  CHECK((axial.normal + bending.normal).value() == Approx(one.normal.value()).epsilon(1e-14));
}

}  // namespace point_stress_test
