#include "boxbeam/beam/beam_loads.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "catch.hpp"

namespace beam_loads_test {

using namespace boxbeam;
using Eigen::Vector3d;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Length m(double x) { return si<Length>(x); }

constexpr double rho = 7800;

/// A box 400 mm wide with 50 mm plates, uniform for 1.5 m at 600 mm of height, then tapered to
/// 1000 mm over 1.7 m: A = 0.1 h + 0.03 m^2.
TaperedBeam tapered() {
  const Section A1{symmetric_box(mm(400), mm(600), mm(50), mm(50)), {}};
  const Section A2{symmetric_box(mm(400), mm(1000), mm(50), mm(50)), {}};
  TaperedBeam beam;
  beam.segments = {{"S1", m(0), m(1.5), A1, A1}, {"S2", m(1.5), m(1.7), A1, A2}};
  beam.density = si<Density>(rho);
  return beam;
}

double height_at(double s) { return s < 1.5 ? 0.6 : 0.6 + 0.4 * (s - 1.5) / 1.7; }
double area_at(double s) { return 0.1 * height_at(s) + 0.03; }
double I_y_at(double s) {
  const double h = height_at(s);
  return (0.4 * std::pow(h, 3) - 0.3 * std::pow(h - 0.1, 3)) / 12;
}

std::vector<LineLoad> loads_of(const TaperedBeam& beam, const Vector3d& gravity,
                               const BeamMotion& motion) {
  return weight_and_inertia(beam, mass_distribution_of(beam), gravity, motion);
}

}  // namespace

TEST_CASE("weight per metre of the sledge rig as the thesis prints it, 6.89 and 9.953 kN/m") {
  const TaperedBeam beam = tapered();
  const auto loads = loads_of(beam, {0, 0, -9.815}, {});
  CHECK(loads[0].force[2](0.7) == Approx(-6.89e3).epsilon(1e-3));
  CHECK(loads[1].force[2](1.7) == Approx(-9.953e3).epsilon(1e-3));
  CHECK(loads[0].force[0](0.7) == 0.0);
  CHECK(loads[1].couple[1](0.7) == 0.0);
}

TEST_CASE("load per length is rho A (g - a) at every place, d'Alembert") {
  const TaperedBeam beam = tapered();
  const Vector3d gravity(1.5, -2.0, -9.0);
  const BeamMotion motion{{3.0, 1.0, -4.0}, {0.5, -1.5, 2.0}, {1.0, -7.0, 0.25}};
  // alpha x e_x + omega (omega . e_x) - omega^2 e_x, written out.
  const Vector3d gradient(-(1.5 * 1.5 + 2.0 * 2.0), 0.25 - 0.5 * 1.5, 7.0 + 0.5 * 2.0);
  const auto loads = loads_of(beam, gravity, motion);
  for (const double s : {0.0, 0.4, 1.2, 1.6, 2.0, 3.1}) {
    const std::size_t i = s < 1.5 ? 0 : 1;
    const double x = s - beam.segments[i].start.value();
    const Vector3d expected = rho * area_at(s) * (gravity - motion.acceleration - gradient * s);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CAPTURE(s, axis);
      CHECK(loads[i].force[axis](x) ==
            Approx(expected[static_cast<int>(axis)]).epsilon(1e-10).margin(1e-8));
    }
  }
}

TEST_CASE("free fall: weight and inertia cancel") {
  const Vector3d g(0.4, 0.0, -9.81);
  const auto loads = loads_of(tapered(), g, {g, Vector3d::Zero(), Vector3d::Zero()});
  for (const LineLoad& load : loads) {
    for (const auto& component : load.force) CHECK(component(0.9) == Approx(0.0).margin(1e-9));
  }
}

TEST_CASE("rotary inertia is a couple -rho I_y alpha per length, where it counts") {
  TaperedBeam beam = tapered();
  const BeamMotion turning{Vector3d::Zero(), Vector3d::Zero(), {0.0, 12.0, 0.0}};
  CHECK(loads_of(beam, Vector3d::Zero(), turning)[1].couple[1](0.5) == 0.0);
  beam.rotary_inertia = true;
  const auto loads = loads_of(beam, Vector3d::Zero(), turning);
  CHECK(loads[0].couple[1](0.5) == Approx(-rho * I_y_at(0.5) * 12.0).epsilon(1e-10));
  CHECK(loads[1].couple[1](0.5) == Approx(-rho * I_y_at(2.0) * 12.0).epsilon(1e-10));
  CHECK(loads[1].couple[0](0.5) == 0.0);
  CHECK(loads[1].couple[2](0.5) == 0.0);
}

TEST_CASE("imbalance of point loads is their sum, moments about s = 0 by the cross product") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const TaperedBeam beam = tapered();
  BeamLoads loads;
  loads.lines = unloaded_lines(beam);
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  for (int i = 0; i < 20; ++i) {
    PointLoad load;
    load.s = m(1.6 * (1.0 + any(random)));
    load.force = 1e4 * Vector3d(any(random), any(random), any(random));
    load.moment = 1e3 * Vector3d(any(random), any(random), any(random));
    force += load.force;
    // r x F with r along x, written out.
    const double s = load.s.value();
    moment += load.moment + Vector3d(0.0, -s * load.force.z(), s * load.force.y());
    loads.points.push_back(load);
  }
  const Imbalance sum = imbalance_of(loads);
  CHECK((sum.force - force).norm() < 1e-9);
  CHECK((sum.moment - moment).norm() < 1e-9);
}

TEST_CASE("imbalance of weight is mass times g, acting at the centre of mass") {
  const TaperedBeam beam = tapered();
  const MassProperties body = mass_properties_of(beam);
  const Vector3d g(1.0, 2.0, -9.81);
  const Imbalance sum = imbalance_of({{}, loads_of(beam, g, {})});
  const Vector3d weight = body.mass.value() * g;
  CHECK((sum.force - weight).norm() < 1e-8);
  const Vector3d at(body.centre.value(), 0, 0);
  CHECK((sum.moment - at.cross(weight)).norm() < 1e-8);
}

TEST_CASE("inertia of a rotation about the start: force -m a_c, moment -J alpha about the start") {
  TaperedBeam beam = tapered();
  beam.rotary_inertia = true;
  const MassProperties body = mass_properties_of(beam);
  const double alpha = 3.0, omega = 2.0, centre = body.centre.value();
  // alpha about y takes a point at s along -z: alpha e_y x s e_x = -alpha s e_z.
  const BeamMotion motion{Vector3d::Zero(), {0.0, omega, 0.0}, {0.0, alpha, 0.0}};
  const Imbalance sum = imbalance_of({{}, loads_of(beam, Vector3d::Zero(), motion)});
  const double mass = body.mass.value();
  CHECK(sum.force.x() == Approx(mass * omega * omega * centre).epsilon(1e-11));
  CHECK(sum.force.z() == Approx(mass * alpha * centre).epsilon(1e-11));
  const double J = body.inertia.value() + mass * centre * centre;
  CHECK(sum.moment.y() == Approx(-J * alpha).epsilon(1e-10));
  CHECK(sum.moment.x() == Approx(0.0).margin(1e-9));
  CHECK(sum.moment.z() == Approx(0.0).margin(1e-9));
}

TEST_CASE("loads are added so many times, and unloaded they are none") {
  const TaperedBeam beam = tapered();
  PointLoad load;
  load.s = m(1.0);
  load.force = {1.0, -2.0, 3.0};
  load.moment = {0.5, 4.0, -1.0};
  const BeamLoads one{
      {load},
      loads_of(beam, {1.0, 2.0, -9.81}, {{0.3, 0.1, 0.2}, Vector3d::Zero(), Vector3d::Zero()})};
  BeamLoads sum = one;
  add(sum, 2.5, one);
  const Imbalance single = imbalance_of(one), whole = imbalance_of(sum);
  CHECK((whole.force - 3.5 * single.force).norm() < 1e-12 * whole.force.norm());
  CHECK((whole.moment - 3.5 * single.moment).norm() < 1e-12 * whole.moment.norm());
  unload(sum);
  REQUIRE(sum.points.size() == 1);
  CHECK(sum.points[0].s == load.s);
  CHECK(sum.lines.size() == one.lines.size());
  CHECK(imbalance_of(sum).force.norm() == 0.0);
  CHECK(imbalance_of(sum).moment.norm() == 0.0);
}

}  // namespace beam_loads_test
