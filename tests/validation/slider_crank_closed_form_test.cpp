// Slider-cranks against hand formulas, through positions where crank and rod fold together, too.
// Every solved instant is also checked body by body by Newton and Euler. Source: Norton, Design of
// Machinery (slider-crank by closed loops, section 6.7).

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/closed_forms.hpp"

namespace slider_crank_closed_form_test {

using namespace boxbeam;
using namespace boxbeam::planar;
using namespace test::closed_forms;

namespace {

/// Crank 0, rod 1, slider 2 on the x axis.
Mechanism slider_crank(double r, double l, double crank_mass, double rod_mass, double slider_mass,
                       const Driver& driver) {
  const double theta = driver_at(driver, 0.0).value;
  const double phi = -std::asin(std::clamp(r / l * std::sin(theta), -1.0, 1.0));
  const Eigen::Vector2d A = r * unit_of(theta);
  Mechanism mechanism;
  mechanism.bodies = {bar("crank", r, crank_mass, {0.0, 0.0}, theta),
                      bar("rod", l, rod_mass, A, phi),
                      Body{"slider", slider_mass, 0.0, {}, {A + l * unit_of(phi), 0.0}}};
  mechanism.joints = {{"O", Pin{{0, {-0.5 * r, 0.0}}, {ground, {0.0, 0.0}}}},
                      {"A", Pin{{0, {0.5 * r, 0.0}}, {1, {-0.5 * l, 0.0}}}},
                      {"B", Pin{{1, {0.5 * l, 0.0}}, {2, {0.0, 0.0}}}},
                      {"guide", Slider{{2}, {ground, {0.0, 0.0}}}},
                      {"motor", Driven{{0, {-0.5 * r, 0.0}}, Coordinate::angle, driver}}};
  return mechanism;
}

/// x = r cos(theta) + sqrt(l^2 - r^2 sin^2(theta)) and its derivatives by time.
Rates slider_of(double r, double l, const DriverState& theta) {
  const double s = std::sin(theta.value), c = std::cos(theta.value);
  const double root = std::sqrt(l * l - r * r * s * s);
  const double by_angle = -r * s - r * r * s * c / root;
  const double curvature = -r * c - r * r * (c * c - s * s) / root -
                           r * r * r * r * s * s * c * c / (root * root * root);
  return {r * c + root, by_angle * theta.rate,
          by_angle * theta.acceleration + curvature * theta.rate * theta.rate};
}

}  // namespace

TEST_CASE("slider-crank: motion over a turn, up to almost aligned") {
  for (const double ratio : {0.25, 0.6, 0.9, 0.99}) {
    const double l = 0.5, r = ratio * l;
    const RateDriver driver{0.3, 12.0};
    Mechanism mechanism = slider_crank(r, l, 1.0, 2.0, 3.0, driver);
    mechanism.gravity = {0.0, -g};
    const Motion motion = solve_motion(mechanism, 360);
    Errors slider, rod;
    for (const State& state : motion.states) {
      const DriverState theta = driver_at(driver, state.time);
      slider.add(state, 6, slider_of(r, l, theta));
      // sin(phi) = -r/l sin(theta).
      const double s = -ratio * std::sin(theta.value);
      const double root = std::sqrt(1.0 - s * s);
      const double rate = -ratio * std::cos(theta.value) * theta.rate / root;
      rod.add_angle(
          state, 1,
          {std::asin(s), rate,
           (ratio * std::sin(theta.value) * theta.rate * theta.rate + s * rate * rate) / root});
    }
    INFO("r/l = " << ratio << ": slider " << slider.q << " m, " << slider.v << " m/s, " << slider.a
                  << " m/s^2; rod " << rod.q << ", " << rod.v << ", " << rod.a);
    CHECK(slider.q < 1e-13);
    CHECK(slider.v < 1e-11);
    CHECK(slider.a < 1e-8);
    CHECK(rod.q < 1e-12);
    CHECK(rod.v < 1e-10);
    CHECK(rod.a < 1e-7);
    CHECK(worst_imbalance(mechanism, motion) < 1e-12);
  }
}

TEST_CASE("slider-crank: crank moment and piston force by virtual work, massless links") {
  // M omega = (m a - F) v: the driver gives what the piston takes; along the rod the force is
  // (F - m a)/cos(phi), and the wall takes its part across.
  const double r = 0.1, l = 0.35, m = 1.7, F = -800.0, omega = 40.0;
  const RateDriver driver{0.2, omega};
  Mechanism mechanism = slider_crank(r, l, 0.0, 0.0, m, driver);
  mechanism.forces = {{"gas", PointForce{{2}, 0.0, false, HarmonicDriver{F, 0.0, 0.0, 0.0, {}}}}};
  const Motion motion = solve_motion(mechanism, 72);
  double moment_error = 0.0, wall_error = 0.0, rod_error = 0.0;
  for (const State& state : motion.states) {
    const DriverState theta = driver_at(driver, state.time);
    const Rates x = slider_of(r, l, theta);
    const double push = F - m * x.acceleration;
    const double moment = -push * x.rate / omega;
    const double phi = -std::asin(r / l * std::sin(theta.value));
    const Reaction motor = reaction_on(mechanism, state, "motor", 0);
    const Reaction wall = reaction_on(mechanism, state, "guide", 2);
    const Reaction rod = reaction_on(mechanism, state, "B", 1);
    moment_error = std::max(moment_error, std::abs(motor.moment - moment));
    wall_error = std::max(wall_error, std::abs(wall.force.y() - push * std::tan(phi)));
    rod_error = std::max(rod_error, (rod.force - push / std::cos(phi) * unit_of(phi)).norm());
  }
  INFO("moment " << moment_error << " N m, wall " << wall_error << " N, rod " << rod_error << " N");
  CHECK(moment_error < 1e-9);
  CHECK(wall_error < 1e-9);
  CHECK(rod_error < 1e-9);
  CHECK(worst_imbalance(mechanism, motion) < 1e-12);
}

TEST_CASE("slider-crank with r = l: the smooth branch through the aligned positions") {
  // x = 2 r cos(theta), the rod at -theta. At 90 and 270 degrees crank and rod fold together, and
  // the slider could as well stay at the pivot.
  const double r = 0.2, omega = 2.0;
  for (const int instants : {97, 360}) {  // beside the dead points, and on them
    const RateDriver driver{0.25 * pi, omega};
    const Mechanism mechanism = slider_crank(r, r, 0.0, 0.0, 0.0, driver);
    const Motion motion = solve_motion(mechanism, instants);
    Errors slider, rod;
    double force = 0.0;
    for (const State& state : motion.states) {
      const DriverState theta = driver_at(driver, state.time);
      const double s = std::sin(theta.value), c = std::cos(theta.value);
      slider.add(state, 6, {2.0 * r * c, -2.0 * r * s * omega, -2.0 * r * c * omega * omega});
      rod.add_angle(state, 1, {-theta.value, -omega, 0.0});
      force = std::max(force, state.lambda.lpNorm<Eigen::Infinity>());
    }
    INFO(instants << " instants: slider " << slider.q << ", " << slider.v << ", " << slider.a
                  << "; rod " << rod.q << ", " << rod.v << ", " << rod.a << "; force " << force);
    CHECK(slider.q < 1e-9);
    CHECK(slider.v < 1e-8);
    CHECK(slider.a < 1e-6);
    CHECK(rod.q < 1e-9);
    CHECK(force < 1e-12);
    // 90 and 270 degrees, from 45.
    REQUIRE(motion.change_points.size() == 2);
    CHECK(motion.change_points[0] == Approx(0.25 * pi / omega).epsilon(1e-3));
    CHECK(motion.change_points[1] == Approx(1.25 * pi / omega).epsilon(1e-3));
  }
}

TEST_CASE("slider-crank with r = l: a start in the singular position") {
  // At 90 degrees the slider stands on the crank's pivot. Two smooth motions lead on: the slider
  // goes, x = 2 r cos(theta) with the rod at -theta; or it stays, and the rod turns with the crank,
  // at theta - pi. Whichever the sketch leans to is kept, around the whole turn.
  const double r = 0.2, omega = 2.0;
  const RateDriver driver{0.5 * pi, omega};
  const auto errors_of = [&](const Motion& motion, bool goes) {
    Errors errors;
    for (const State& state : motion.states) {
      const DriverState theta = driver_at(driver, state.time);
      const double s = std::sin(theta.value), c = std::cos(theta.value);
      if (goes) {
        errors.add(state, 6, {2.0 * r * c, -2.0 * r * s * omega, -2.0 * r * c * omega * omega});
        errors.add_angle(state, 1, {-theta.value, -omega, 0.0});
      } else {
        errors.add(state, 6, {});
        errors.add_angle(state, 1, {theta.value - pi, omega, 0.0});
      }
    }
    return errors;
  };
  const auto check = [](const Errors& errors) {
    CHECK(errors.q < 1e-9);
    CHECK(errors.v < 1e-8);
    CHECK(errors.a < 1e-6);
  };
  SECTION("from the exact position: either, but one of them throughout") {
    const Motion motion = solve_motion(slider_crank(r, r, 0.0, 0.0, 0.0, driver), 96);
    const Errors goes = errors_of(motion, true), stays = errors_of(motion, false);
    check(goes.q < stays.q ? goes : stays);
  }
  SECTION("from a rough position a little behind on the way out: the slider goes") {
    const double theta = 0.5 * pi + 0.1;
    Mechanism mechanism = slider_crank(r, r, 0.0, 0.0, 0.0, driver);
    mechanism.bodies[0].sketch = {0.5 * r * unit_of(theta), theta};
    mechanism.bodies[1].sketch = {r * unit_of(theta) + 0.5 * r * unit_of(-theta), -theta};
    mechanism.bodies[2].sketch = {{2.0 * r * std::cos(theta), 0.0}, 0.0};
    check(errors_of(solve_motion(mechanism, 96), true));
  }
  SECTION("from a rough position a little behind with the slider at the pivot: it stays") {
    const double theta = 0.5 * pi + 0.1;
    Mechanism mechanism = slider_crank(r, r, 0.0, 0.0, 0.0, driver);
    mechanism.bodies[0].sketch = {0.5 * r * unit_of(theta), theta};
    mechanism.bodies[1].sketch = {0.5 * r * unit_of(theta), theta - pi};
    check(errors_of(solve_motion(mechanism, 96), false));
  }
}

}  // namespace slider_crank_closed_form_test
