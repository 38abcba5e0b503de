// A wedge under a force across its tip. Source: Timoshenko and Goodier, Theory of Elasticity,
// article 38: sigma_r = 2 P sin(theta)/(r (2 alpha - sin 2 alpha)) and no stress on radial cuts,
// alpha the half angle, thickness 1. A tapered plate must find the stress nearly and no shear along
// its rays.

#include <cmath>
#include <numbers>

#include "boxbeam/section/level_shear.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_points.hpp"
#include "catch.hpp"

namespace wedge_test {

using namespace boxbeam;

namespace {

Section wedge_at(double x, double alpha) {
  return {Plate{si<Length>(1.0), si<Length>(2.0 * x * std::tan(alpha))}, {}};
}

Taper taper_at(double x, double alpha) {
  const double step = 1e-5 * x;
  return {{wedge_at(x - step, alpha), -0.5 / step}, {wedge_at(x + step, alpha), 0.5 / step}};
}

}  // namespace

TEST_CASE("wedge: the exact radial stresses balance the force and leave no thrust") {
  for (const double degrees : {2.0, 10.0, 30.0}) {
    const double alpha = degrees * std::numbers::pi / 180;
    double across = 0.0, along = 0.0;
    constexpr int steps = 2000;
    for (int k = 0; k < steps; ++k) {
      const double theta = alpha * (2.0 * (k + 0.5) / steps - 1.0);
      const double force =
          2 * std::sin(theta) / (2 * alpha - std::sin(2 * alpha)) * 2.0 * alpha / steps;
      across += force * std::sin(theta);
      along += force * std::cos(theta);
    }
    CAPTURE(degrees);
    CHECK(across == Approx(1.0).epsilon(1e-6));
    CHECK(std::abs(along) < 1e-12);
  }
}

TEST_CASE("wedge: M/W is 0.9998, 0.9985, 0.9939, 0.9861 of the exact edge stress", "[validation]") {
  const double table[][2] = {{2, 0.9998}, {5, 0.9985}, {10, 0.9939}, {15, 0.9861}};
  const double x = 2.0, P = 1e4;
  for (const auto& [degrees, ratio] : table) {
    const double alpha = degrees * std::numbers::pi / 180;
    const double edge = x * std::tan(alpha);
    const double beam = P * x *
                        normal_influence(sums_of(outline_of(wedge_at(x, alpha), {})), 0.0, edge)
                            .normal[cut_force::M_y];
    const double exact =
        2 * P * std::sin(alpha) / (x / std::cos(alpha) * (2 * alpha - std::sin(2 * alpha)));
    CAPTURE(degrees);
    CHECK(beam / exact == Approx(ratio).margin(5e-5));
  }
}

TEST_CASE("wedge: no shear along any ray, where V S/(I b) says 1.5 V/A", "[validation]") {
  const double x = 2.0, P = 1e4;
  for (const double degrees : {2.0, 5.0, 10.0, 15.0}) {
    const double alpha = degrees * std::numbers::pi / 180;
    const double edge = x * std::tan(alpha), area = 2.0 * edge;
    CutForces cut;
    cut.V_z = si<Force>(P);
    cut.M_y = si<Moment>(P * x);
    const StressField field = stress_field_of(wedge_at(x, alpha), {}, taper_at(x, alpha));
    for (const double part : {-0.9, -0.5, 0.0, 0.3, 0.99}) {
      const auto at = points_at_level(field, "", si<Length>(part * edge), PointSet::in_plane).at(0);
      CAPTURE(degrees, part);
      CHECK(std::abs(stress_at(at.influence, cut).shear.value()) < 1e-6 * P / area);
      CHECK(stress_at(at.prismatic, cut).shear.value() ==
            Approx(1.5 * P / area * (1 - part * part)).epsilon(1e-9));
    }
  }
}

TEST_CASE("wedge: shear and inclined normal stress carry V", "[validation]") {
  // A wedge that ends before its tip, so that there is shear: force P across at x, moment M free.
  // V = int (tau + sigma dz/dx) dA with dz/dx = z/x along each ray.
  const double x = 2.0, P = 1e4, M = 0.3 * P * x, alpha = 0.1;
  const double edge = x * std::tan(alpha);
  double sum = 0.0;
  const int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double z = edge * (-1 + (2 * i + 1.0) / steps);
    const CutFactors shear = level_shear_of(wedge_at(x, alpha), {}, taper_at(x, alpha), z);
    const double tau = shear[cut_force::V_z] * P + shear[cut_force::M_y] * M;
    const double sigma = M * normal_influence(sums_of(outline_of(wedge_at(x, alpha), {})), 0.0, z)
                                 .normal[cut_force::M_y];
    sum += (tau + sigma * z / x) * 2 * edge / steps;
  }
  CHECK(sum == Approx(P).epsilon(1e-5));
}

}  // namespace wedge_test
