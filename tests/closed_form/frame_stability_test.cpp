// Elastic critical loads of bars and portals against Euler's and the slope-deflection equations.
// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), 2.1, 2.4.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "support/rest_frame.hpp"

namespace frame_stability_test {

using namespace boxbeam;
using namespace boxbeam::frame;

namespace {

constexpr double L = 3.0, b = 0.08, h = 0.12, P = 1e3;
constexpr double EI = 2.1e11 * b * h * h * h / 12.0;

double factor_of(const Structure& of) {
  const Statics statics(of, 8);
  return statics.critical_factor(statics.axial_forces(statics.solve(acting_at(of, 0.0))), 1e6);
}

/// A bar pushed along its axis at its end.
Structure bar(const std::array<double, 6>& start, const std::array<double, 6>& end) {
  Structure of = test::level_frame({test::segment(0.0, L, test::solid(b, h), test::solid(b, h))});
  test::support(of, 0.0, start);
  if (end[1] > 0.0 || end[5] > 0.0) test::support(of, L, end);
  test::act(of, PointAction{{0, {L, 0.0, 0.0}}, {-P, 0.0, 0.0}, Eigen::Vector3d::Zero()});
  return of;
}

TEST_CASE("Euler's bars buckle at pi^2 E I/(beta L)^2", "[frame]") {
  const double euler = std::pow(std::numbers::pi / L, 2) * EI / P;
  constexpr std::array<double, 6> free{};
  constexpr std::array<double, 6> clamp{0.0, test::rigid, 0.0, 0.0, 0.0, test::rigid};
  CHECK(factor_of(bar(test::pinned, test::roller)) == Approx(euler).epsilon(1.5e-3));
  CHECK(factor_of(bar(test::fixed, free)) == Approx(0.25 * euler).epsilon(1.5e-3));
  CHECK(factor_of(bar(test::fixed, test::roller)) ==
        Approx(std::pow(4.493409, 2) * EI / (L * L) / P).epsilon(1.5e-3));
  CHECK(factor_of(bar(test::fixed, clamp)) == Approx(4.0 * euler).epsilon(2e-3));
  // Tension does not buckle.
  Structure pulled = bar(test::pinned, test::roller);
  std::get<PointAction>(pulled.cases[0].actions[0].kind).force.x() = P;
  CHECK(factor_of(pulled) == 1e6);
}

TEST_CASE("a bar in space buckles about its weaker axis", "[frame]") {
  Structure of = bar(test::fixed, {});
  of.plane = false;
  const double weaker = 2.1e11 * h * b * b * b / 12.0;
  CHECK(factor_of(of) ==
        Approx(0.25 * std::pow(std::numbers::pi / L, 2) * weaker / P).epsilon(1.5e-3));
}

/// Two columns of 4 m and a beam of 6 m, all of one section, P down on each corner; the beam is the
/// member that is looked at.
Structure portal(const std::array<double, 6>& feet) {
  constexpr double height = 4.0, width = 6.0;
  Structure of =
      test::level_frame({test::segment(0.0, width, test::solid(b, h), test::solid(b, h))});
  of.members[0].start = {0.0, height, 0.0};
  for (const double x : {0.0, width}) {
    Member column =
        test::level_member({test::segment(0.0, height, test::solid(b, h), test::solid(b, h))});
    column.name = "column";
    column.start = {x, 0.0, 0.0};
    column.axes << 0, -0.0, -1, 1, 0, 0, 0, -1, 0;
    of.members.push_back(column);
    const int index = static_cast<int>(of.members.size()) - 1;
    test::support(of, 0.0, feet, index);
    Joint corner;
    corner.name = "corner";
    corner.a = {0, {x, 0.0, 0.0}};
    corner.b = {index, {height, 0.0, 0.0}};
    corner.stiffness = test::fixed;
    of.joints.push_back(corner);
    test::act(of,
              PointAction{{index, {height, 0.0, 0.0}}, {0.0, -P, 0.0}, Eigen::Vector3d::Zero()});
  }
  return of;
}

/// The smallest root of f above `from`, by halving its first change of sign.
template <class F>
double root_of(const F& f, double from) {
  double low = from;
  while (f(low) * f(low + 1e-3) > 0.0) low += 1e-3;
  double high = low + 1e-3;
  for (int i = 0; i < 60; ++i) {
    const double half = 0.5 * (low + high);
    (f(low) * f(half) > 0.0 ? low : high) = half;
  }
  return low;
}

TEST_CASE("portals sway at tan(k h) = -k h I_c l/(6 I_b h) and k h tan(k h) = 6 I_b h/(I_c l)",
          "[frame]") {
  constexpr double height = 4.0, ratio = 6.0 * height / 6.0;  // 6 I_b h/(I_c l)
  const double fixed = root_of([&](double x) { return std::tan(x) * ratio + x; }, 1.6);
  CHECK(factor_of(portal(test::fixed)) ==
        Approx(fixed * fixed * EI / (height * height) / P).epsilon(1.5e-3));
  const double hinged = root_of([&](double x) { return x * std::tan(x) - ratio; }, 0.1);
  CHECK(factor_of(portal(test::pinned)) ==
        Approx(hinged * hinged * EI / (height * height) / P).epsilon(1.5e-3));
}

}  // namespace

}  // namespace frame_stability_test
