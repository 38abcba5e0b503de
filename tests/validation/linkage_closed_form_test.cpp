// Driven linkages against hand formulas: positions, velocities, accelerations, and forces
// by virtual work. Every solved instant is also checked body by body by Newton and Euler.
// Sources: Norton, Design of Machinery (four-bar and slider-crank by closed loops,
// sections 4.5, 6.7 and 7.3); Craig, Introduction to Robotics (two-link arm, section 6.7).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/closed_forms.hpp"

namespace linkage_closed_form_test {

using namespace boxbeam;
using namespace boxbeam::planar;
using namespace test::closed_forms;

namespace {

// ---- slider-crank

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

// ---- four-bar

TEST_CASE("four-bar: position by circles, rates by Norton's equations, moment by virtual work") {
  const double d = 0.4, r = 0.1, l = 0.35, s = 0.25;  // ground, crank, coupler, rocker: Grashof
  for (const double side : {1.0, -1.0}) {
    const HarmonicDriver sway{1.0, 0.8, 7.0, 0.2, {}};
    const RateDriver turn{0.4, 15.0};
    for (const Driver& driver : {Driver(sway), Driver(turn)}) {
      const auto joint_of = [&](double theta) {  // circles about crank pin and rocker's pivot
        const Eigen::Vector2d A = r * unit_of(theta), D(d, 0.0);
        const double distance = (D - A).norm();
        const Eigen::Vector2d u = (D - A) / distance;
        const double along = (l * l - s * s + distance * distance) / (2.0 * distance);
        return Eigen::Vector2d(A + along * u +
                               side * std::sqrt(l * l - along * along) * left_of(u));
      };
      const double start = driver_at(driver, 0.0).value;
      const Eigen::Vector2d A = r * unit_of(start), B = joint_of(start);
      Mechanism mechanism;
      mechanism.bodies = {bar("crank", r, 0.0, {0.0, 0.0}, start),
                          bar("coupler", l, 0.0, A, std::atan2(B.y() - A.y(), B.x() - A.x())),
                          bar("rocker", s, 0.0, {d, 0.0}, std::atan2(B.y(), B.x() - d))};
      mechanism.joints = {{"O", Pin{{0, {-0.5 * r, 0.0}}, {ground, {0.0, 0.0}}}},
                          {"A", Pin{{0, {0.5 * r, 0.0}}, {1, {-0.5 * l, 0.0}}}},
                          {"B", Pin{{1, {0.5 * l, 0.0}}, {2, {0.5 * s, 0.0}}}},
                          {"D", Pin{{2, {-0.5 * s, 0.0}}, {ground, {d, 0.0}}}},
                          {"motor", Driven{{0}, Coordinate::angle, driver}}};
      const double load = 25.0;  // a moment against the rocker
      mechanism.forces = {{"load", Couple{{2}, {ground}, HarmonicDriver{load, 0.0, 0.0, 0.0, {}}}}};
      const Motion motion = solve_motion(mechanism, 200);
      Errors errors;
      double moment_error = 0.0;
      for (const State& state : motion.states) {
        const DriverState theta = driver_at(driver, state.time);
        const Eigen::Vector2d a = r * unit_of(theta.value), b = joint_of(theta.value);
        const double t2 = theta.value, w2 = theta.rate, alpha2 = theta.acceleration;
        const double t3 = std::atan2(b.y() - a.y(), b.x() - a.x());
        const double t4 = std::atan2(b.y(), b.x() - d);
        const double w3 = r * w2 / l * std::sin(t4 - t2) / std::sin(t3 - t4);
        const double w4 = r * w2 / s * std::sin(t2 - t3) / std::sin(t4 - t3);
        // Norton's A to F.
        const double cA = s * std::sin(t4), cB = l * std::sin(t3);
        const double cC = r * alpha2 * std::sin(t2) + r * w2 * w2 * std::cos(t2) +
                          l * w3 * w3 * std::cos(t3) - s * w4 * w4 * std::cos(t4);
        const double cD = s * std::cos(t4), cE = l * std::cos(t3);
        const double cF = r * alpha2 * std::cos(t2) - r * w2 * w2 * std::sin(t2) -
                          l * w3 * w3 * std::sin(t3) + s * w4 * w4 * std::sin(t4);
        const double alpha3 = (cC * cD - cA * cF) / (cA * cE - cB * cD);
        const double alpha4 = (cC * cE - cB * cF) / (cA * cE - cB * cD);
        errors.add_angle(state, 1, {t3, w3, alpha3});
        errors.add_angle(state, 2, {t4, w4, alpha4});
        if (std::abs(w2) > 0.1) {
          const Reaction motor = reaction_on(mechanism, state, "motor", 0);
          moment_error = std::max(moment_error, std::abs(motor.moment + load * w4 / w2));
        }
      }
      INFO("errors " << errors.q << " rad, " << errors.v << " rad/s, " << errors.a
                     << " rad/s^2, moment " << moment_error << " N m");
      CHECK(errors.q < 1e-13);
      CHECK(errors.v < 1e-11);
      CHECK(errors.a < 1e-9);
      CHECK(moment_error < 1e-11);
      CHECK(worst_imbalance(mechanism, motion) < 1e-12);
    }
  }
}

TEST_CASE("four-bar: Freudenstein's equation holds between crank and rocker") {
  // K1 cos(t4) - K2 cos(t2) + K3 = cos(t2 - t4), K1 = d/r, K2 = d/s, K3 = (r^2 - l^2 + s^2 +
  // d^2)/(2 r s).
  const double d = 0.4, r = 0.1, l = 0.35, s = 0.25;
  Mechanism mechanism;
  mechanism.bodies = {bar("crank", r, 0.3, {0.0, 0.0}, 0.0), bar("coupler", l, 0.7, {r, 0.0}, 0.8),
                      bar("rocker", s, 0.5, {d, 0.0}, 1.5)};
  mechanism.joints = {{"O", Pin{{0, {-0.5 * r, 0.0}}, {ground, {0.0, 0.0}}}},
                      {"A", Pin{{0, {0.5 * r, 0.0}}, {1, {-0.5 * l, 0.0}}}},
                      {"B", Pin{{1, {0.5 * l, 0.0}}, {2, {0.5 * s, 0.0}}}},
                      {"D", Pin{{2, {-0.5 * s, 0.0}}, {ground, {d, 0.0}}}},
                      {"motor", Driven{{0}, Coordinate::angle, RateDriver{0.0, 15.0}}}};
  const Motion motion = solve_motion(mechanism, 120);
  for (const State& state : motion.states) {
    const double t2 = state.q[2], t4 = state.q[8];
    const double K3 = (r * r - l * l + s * s + d * d) / (2.0 * r * s);
    CHECK(std::abs(d / r * std::cos(t4) - d / s * std::cos(t2) + K3 - std::cos(t2 - t4)) < 1e-13);
  }
  CHECK(worst_imbalance(mechanism, motion) < 1e-12);
}

// ---- parallelogram with three cranks

namespace {

/// Three equal cranks (0, 1, 2) and the coupler 3 that they carry; massless. A force stands on the
/// coupler.
Mechanism three_cranks(const std::array<Eigen::Vector2d, 3>& pivots, double r, const Driver& driver,
                       const Eigen::Vector2d& load) {
  const double theta = driver_at(driver, 0.0).value;
  Mechanism mechanism;
  const char* names[] = {"crank 0", "crank 1", "crank 2"};
  for (std::size_t i = 0; i < 3; ++i) {
    mechanism.bodies.push_back(bar(names[i], r, 0.0, pivots[i], theta));
  }
  mechanism.bodies.push_back(Body{"coupler", 0.0, 0.0, {}, {r * unit_of(theta), 0.0}});
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& pivot = pivots[static_cast<std::size_t>(i)];
    mechanism.joints.push_back(
        {"fixed " + std::to_string(i), Pin{{i, {-0.5 * r, 0.0}}, {ground, pivot}}});
    mechanism.joints.push_back(
        {"moving " + std::to_string(i), Pin{{i, {0.5 * r, 0.0}}, {3, pivot}}});
  }
  mechanism.joints.push_back({"motor", Driven{{0}, Coordinate::angle, driver}});
  if (load.norm() > 0.0) {
    mechanism.forces = {{"load", PointForce{{3, {0.1, 0.2}},
                                            std::atan2(load.y(), load.x()),
                                            false,
                                            HarmonicDriver{load.norm(), 0.0, 0.0, 0.0, {}}}}};
  }
  return mechanism;
}

/// The coupler moves along a circle of the cranks' radius without turning.
Errors coupler_errors(const Motion& motion, double r, const RateDriver& driver) {
  Errors errors;
  for (const State& state : motion.states) {
    const DriverState theta = driver_at(driver, state.time);
    const Eigen::Vector2d e = unit_of(theta.value), n = left_of(e);
    const double w = theta.rate;
    errors.add(state, 9, {r * e.x(), r * w * n.x(), -r * w * w * e.x()});
    errors.add(state, 10, {r * e.y(), r * w * n.y(), -r * w * w * e.y()});
    errors.add(state, 11, {});
    for (int crank = 1; crank < 3; ++crank) errors.add_angle(state, crank, {theta.value, w, 0.0});
  }
  return errors;
}

}  // namespace

TEST_CASE("parallelogram with a third crank off the line: one redundancy, nowhere singular") {
  const double r = 0.3, omega = 5.0;
  const RateDriver driver{0.35, omega};
  const Eigen::Vector2d load(40.0, -70.0);
  const Mechanism mechanism =
      three_cranks({Eigen::Vector2d(0.0, 0.0), {1.0, 0.0}, {0.4, 0.6}}, r, driver, load);
  const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
  CHECK(freedom.gruebler == 0);  // 12 - 12
  CHECK(freedom.by_rank == 1);
  CHECK(freedom.redundant == 1);
  CHECK(freedom.drivers == 1);
  CHECK(freedom.undriven == 0);
  // The coupler can be held in tension by its three cranks, and by nothing else: all pins take
  // part, the driver does not.
  CHECK(freedom.repeating == std::vector<int>{0, 1, 2, 3, 4, 5});
  for (int joint = 0; joint < 6; ++joint) CHECK_FALSE(is_unique(freedom, joint));
  CHECK(is_unique(freedom, 6));

  const Motion motion = solve_motion(mechanism, 144);
  const Errors errors = coupler_errors(motion, r, driver);
  double moment_error = 0.0;
  for (const State& state : motion.states) {
    // The driver's moment by virtual work, whatever the cranks share.
    const Reaction motor = reaction_on(mechanism, state, "motor", 0);
    const Eigen::Vector2d n = left_of(unit_of(driver_at(driver, state.time).value));
    moment_error = std::max(moment_error, std::abs(motor.moment + r * load.dot(n)));
  }
  CHECK(errors.q < 1e-13);
  CHECK(errors.v < 1e-12);
  CHECK(errors.a < 1e-10);
  CHECK(moment_error < 1e-11);
  CHECK(motion.change_points.empty());
  CHECK(worst_imbalance(mechanism, motion) < 1e-12);
}

TEST_CASE("three cranks off a line: nothing happens where two of them are a flat parallelogram") {
  // Two of the cranks alone would be at a change point where they lie along their pivots' line; the
  // third keeps the whole regular (its condition stays below 50 all around). So an instant exactly
  // there is like any other, and the shares of the load in the cranks stay of its size.
  const double r = 0.3, omega = 5.0;
  const Eigen::Vector2d load(40.0, -70.0);
  const std::array<Eigen::Vector2d, 3> pivots = {Eigen::Vector2d(0.0, 0.0), {1.0, 0.0}, {0.4, 0.6}};
  for (const double flat : {0.0, std::atan2(0.6, 0.4), std::atan2(0.6, -0.6)}) {
    const RateDriver driver{flat - 0.25 * pi, omega};
    const Mechanism mechanism = three_cranks(pivots, r, driver, load);
    const Motion motion = solve_motion(mechanism, 144);  // every 2.5 degrees, `flat` among them
    const Errors errors = coupler_errors(motion, r, driver);
    double largest = 0.0, condition = 0.0;
    for (const State& state : motion.states) {
      condition = std::max(condition, condition_of(mechanism, state.q));
      for (const Reaction& reaction : reactions_of(mechanism, state)) {
        largest = std::max(largest, reaction.force.norm());
      }
    }
    INFO("flat at " << flat << ": errors " << errors.q << ", " << errors.v << ", " << errors.a
                    << "; largest force " << largest << " N; condition " << condition);
    CHECK(condition < 50.0);
    CHECK(errors.v < 1e-12);
    CHECK(errors.a < 1e-10);
    CHECK(largest < 20.0 * load.norm());
    CHECK(motion.change_points.empty());
    CHECK_NOTHROW(solve_motion(mechanism));
  }
}

TEST_CASE("parallelogram with a third crank on the line: through the flat position") {
  // Where all pivots lie on one line, the flat position loses rank: a change point, twice per turn.
  const double r = 0.3, omega = 5.0;
  const std::array<Eigen::Vector2d, 3> pivots = {
      Eigen::Vector2d(0.0, 0.0), {1.0, 0.0}, {0.45, 0.0}};
  for (const double start : {0.35, 0.0}) {  // beside the flat position, and in it
    const RateDriver driver{start, omega};
    const Mechanism mechanism = three_cranks(pivots, r, driver, {0.0, 0.0});
    if (start > 0.0) {
      const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
      CHECK(freedom.gruebler == 0);
      CHECK(freedom.by_rank == 1);
      CHECK(freedom.redundant == 1);
      CHECK(is_unique(freedom, 6));
    } else {
      // Each crank could start out on its own.
      const DegreesOfFreedom flat = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
      CHECK(flat.by_rank > 1);
      CHECK(flat.redundant > 1);
    }
    const Motion motion = solve_motion(mechanism, 144);
    const Errors errors = coupler_errors(motion, r, driver);
    // Within half a milliradian of a change point only ten digits of a velocity are left.
    CHECK(errors.q < 1e-11);
    CHECK(errors.v < 1e-8);
    CHECK(errors.a < 1e-4);
    CHECK(motion.change_points.size() >= 2);
  }
}

// ---- pin in slot: quick return

TEST_CASE("quick return: a crank pin in the slot of a turning arm") {
  // Arm pivot h below the crank's: tan(psi) = (h + r sin)/(r cos). Arm rate and its change by hand:
  // psi' = (r^2 + r h sin)/rho^2, psi'' = r h cos (h^2 - r^2)/rho^4, rho^2 = r^2 + h^2 + 2 r h sin.
  const double r = 0.2, omega = 6.0;
  for (const double h : {0.5, 0.08}) {  // swinging arm (Crank-shaper), turning arm (Whitworth)
    const RateDriver driver{0.7, omega};
    const auto arm_of = [&](double theta) {
      const double s = std::sin(theta), c = std::cos(theta);
      const double rho2 = r * r + h * h + 2.0 * r * h * s;
      return Rates{std::atan2(h + r * s, r * c), (r * r + r * h * s) / rho2 * omega,
                   r * h * c * (h * h - r * r) / (rho2 * rho2) * omega * omega};
    };
    Mechanism mechanism;
    const double length = 1.0, load = 30.0;
    mechanism.bodies = {bar("crank", r, 0.0, {0.0, 0.0}, 0.7),
                        bar("arm", length, 4.0, {0.0, -h}, arm_of(0.7).value)};
    mechanism.joints = {{"O", Pin{{0, {-0.5 * r, 0.0}}, {ground, {0.0, 0.0}}}},
                        {"C", Pin{{1, {-0.5 * length, 0.0}}, {ground, {0.0, -h}}}},
                        {"slot", PinInSlot{{0, {0.5 * r, 0.0}}, {1, {0.0, 0.0}}}},
                        {"motor", Driven{{0}, Coordinate::angle, driver}}};
    mechanism.forces = {{"load", Couple{{1}, {ground}, HarmonicDriver{-load, 0.0, 0.0, 0.0, {}}}}};
    const Motion motion = solve_motion(mechanism, 180);
    Errors errors;
    double moment_error = 0.0, slot_error = 0.0;
    for (const State& state : motion.states) {
      const double theta = driver_at(driver, state.time).value;
      const Rates arm = arm_of(theta);
      errors.add_angle(state, 1, arm);
      // Power: the driver gives what load and inertia about the pivot (m L^2/3) take.
      const double taken = load + 4.0 * length * length / 3.0 * arm.acceleration;
      const Reaction motor = reaction_on(mechanism, state, "motor", 0);
      moment_error = std::max(moment_error, std::abs(motor.moment - taken * arm.rate / omega));
      // The slot pushes across itself, at the pin.
      const double rho = std::sqrt(r * r + h * h + 2.0 * r * h * std::sin(theta));
      const Reaction slot = reaction_on(mechanism, state, "slot", 1);
      slot_error =
          std::max(slot_error, (slot.force - taken / rho * left_of(unit_of(arm.value))).norm());
      slot_error = std::max(slot_error, std::abs(slot.point.x() + 0.5 * length - rho));
    }
    CHECK(errors.q < 1e-13);
    CHECK(errors.v < 1e-11);
    CHECK(errors.a < 1e-9);
    CHECK(moment_error < 1e-9);
    CHECK(slot_error < 1e-9);
    CHECK(worst_imbalance(mechanism, motion) < 1e-12);
  }
}

// ---- rigid joint, distance joint

TEST_CASE("rigid joint: the cut forces of a turning rod") {
  // Uniform rod turning about its end; the joint at share c carries the outer part: mass
  // m (1 - c), centre at L (1 + c)/2.
  const double L = 1.5, m = 6.0, c = 0.4;
  const HarmonicDriver driver{0.4, 0.9, 5.0, 0.2, {}};
  const double start = driver_at(driver, 0.0).value;
  for (const double angle : {0.0, 0.7}) {  // the axes of the outer part may stand askew
    Mechanism mechanism;
    mechanism.gravity = {0.0, -g};
    const double outer = L * (1.0 - c), inner = L * c;
    const double mass = m * (1.0 - c);
    mechanism.bodies = {bar("inner", inner, m * c, {0.0, 0.0}, start),
                        bar("outer", outer, mass, inner * unit_of(start), start)};
    mechanism.bodies[1].sketch.angle += angle;
    const Eigen::Vector2d end = turned(-angle, {-0.5 * outer, 0.0});
    mechanism.joints = {{"pin", Pin{{0, {-0.5 * inner, 0.0}}, {ground, {0.0, 0.0}}}},
                        {"weld", Rigid{{1, end}, {0, {0.5 * inner, 0.0}}, angle}},
                        {"motor", Driven{{0}, Coordinate::angle, driver}}};
    const Motion motion = solve_motion(mechanism, 60);
    double force_error = 0.0, moment_error = 0.0, motor_error = 0.0;
    for (const State& state : motion.states) {
      const DriverState phi = driver_at(driver, state.time);
      const Eigen::Vector2d e = unit_of(phi.value), n = left_of(e);
      const double centre = 0.5 * L * (1.0 + c);
      const Eigen::Vector2d force =
          mass *
          (centre * (phi.acceleration * n - phi.rate * phi.rate * e) + Eigen::Vector2d(0.0, g));
      const double moment =
          mass * outer * outer / 12.0 * phi.acceleration + 0.5 * outer * n.dot(force);
      const double whole =
          m * L * L / 3.0 * phi.acceleration + 0.5 * m * g * L * std::cos(phi.value);
      const Reaction weld = reaction_on(mechanism, state, "weld", 1);
      force_error = std::max(force_error, (weld.force - force).norm());
      moment_error = std::max(moment_error, std::abs(weld.moment - moment));
      motor_error =
          std::max(motor_error, std::abs(reaction_on(mechanism, state, "motor", 0).moment - whole));
    }
    CHECK(force_error < 1e-11);
    CHECK(moment_error < 1e-11);
    CHECK(motor_error < 1e-11);
    CHECK(worst_imbalance(mechanism, motion) < 1e-13);
  }
}

TEST_CASE("distance joint: the same as a rod without mass") {
  const double d = 0.4, r = 0.1, l = 0.35, s = 0.25;
  const RateDriver driver{0.4, 15.0};
  Mechanism with_rod;
  with_rod.gravity = {0.0, -g};
  with_rod.bodies = {bar("crank", r, 0.8, {0.0, 0.0}, 0.4), bar("rocker", s, 1.6, {d, 0.0}, 1.6),
                     bar("rod", l, 0.0, r * unit_of(0.4), 0.6)};
  const Attachment A{0, {0.5 * r, 0.0}}, B{1, {0.5 * s, 0.0}};
  with_rod.joints = {{"O", Pin{{0, {-0.5 * r, 0.0}}, {ground, {0.0, 0.0}}}},
                     {"D", Pin{{1, {-0.5 * s, 0.0}}, {ground, {d, 0.0}}}},
                     {"motor", Driven{{0}, Coordinate::angle, driver}},
                     {"A", Pin{A, {2, {-0.5 * l, 0.0}}}},
                     {"B", Pin{B, {2, {0.5 * l, 0.0}}}}};
  Mechanism with_distance = with_rod;
  with_distance.bodies.pop_back();
  with_distance.joints.resize(3);
  with_distance.joints.push_back({"rod", Distance{A, B, l}});
  const Motion rod = solve_motion(with_rod, 120);
  const Motion distance = solve_motion(with_distance, 120);
  Errors errors;
  double force_error = 0.0;
  for (std::size_t i = 0; i < rod.states.size(); ++i) {
    const State& a = rod.states[i];
    const State& b = distance.states[i];
    errors.q = std::max(errors.q, (a.q.head(6) - b.q).lpNorm<Eigen::Infinity>());
    errors.v = std::max(errors.v, (a.v.head(6) - b.v).lpNorm<Eigen::Infinity>());
    errors.a = std::max(errors.a, (a.a.head(6) - b.a).lpNorm<Eigen::Infinity>());
    for (const auto& [pin, body] : {std::pair("A", 0), std::pair("B", 1)}) {
      const Eigen::Vector2d by_pin = reaction_on(with_rod, a, pin, body).force;
      const Eigen::Vector2d by_rod = reaction_on(with_distance, b, "rod", body).force;
      force_error = std::max(force_error, (by_pin - by_rod).norm());
    }
    force_error = std::max(force_error, std::abs(reaction_on(with_rod, a, "motor", 0).moment -
                                                 reaction_on(with_distance, b, "motor", 0).moment));
  }
  CHECK(errors.q < 1e-13);
  CHECK(errors.v < 1e-12);
  CHECK(errors.a < 1e-9);
  CHECK(force_error < 1e-9);
  CHECK(worst_imbalance(with_rod, rod) < 1e-12);
  CHECK(worst_imbalance(with_distance, distance) < 1e-12);
}

// ---- drivers

TEST_CASE("two-link arm: a driver of the angle between two bodies") {
  // Point masses at the ends of massless links; Craig's dynamic equations of the two-link arm.
  const double l1 = 0.8, l2 = 0.5, m1 = 3.0, m2 = 2.0;
  const HarmonicDriver shoulder{0.3, 0.9, 5.0, 0.4, {}};
  const HarmonicDriver elbow{0.8, 0.6, 10.0, 1.0, {}};
  const double q1 = driver_at(shoulder, 0.0).value, q2 = driver_at(elbow, 0.0).value;
  const Eigen::Vector2d knee = l1 * unit_of(q1);
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  mechanism.bodies = {Body{"upper", m1, 0.0, {}, {knee, q1}},
                      Body{"lower", m2, 0.0, {}, {knee + l2 * unit_of(q1 + q2), q1 + q2}}};
  mechanism.joints = {
      {"shoulder", Pin{{0, {-l1, 0.0}}, {ground, {0.0, 0.0}}}},
      {"elbow", Pin{{1, {-l2, 0.0}}, {0, {0.0, 0.0}}}},
      {"motor 1", Driven{{0, {-l1, 0.0}}, Coordinate::angle, shoulder}},
      {"motor 2", Driven{{1, {-l2, 0.0}}, Coordinate::angle, elbow, {0, {0.0, 0.0}}}}};
  const Motion motion = solve_motion(mechanism, 100);
  double error_1 = 0.0, error_2 = 0.0, tip = 0.0;
  for (const State& state : motion.states) {
    const DriverState a = driver_at(shoulder, state.time), b = driver_at(elbow, state.time);
    const double c2 = std::cos(b.value), s2 = std::sin(b.value);
    const double c1 = std::cos(a.value), c12 = std::cos(a.value + b.value);
    const double tau_1 =
        m2 * l2 * l2 * (a.acceleration + b.acceleration) +
        m2 * l1 * l2 * c2 * (2.0 * a.acceleration + b.acceleration) +
        (m1 + m2) * l1 * l1 * a.acceleration - m2 * l1 * l2 * s2 * b.rate * b.rate -
        2.0 * m2 * l1 * l2 * s2 * a.rate * b.rate + m2 * l2 * g * c12 + (m1 + m2) * l1 * g * c1;
    const double tau_2 = m2 * l1 * l2 * c2 * a.acceleration + m2 * l1 * l2 * s2 * a.rate * a.rate +
                         m2 * l2 * g * c12 + m2 * l2 * l2 * (a.acceleration + b.acceleration);
    // On the upper link the first motor, less what the second takes back.
    error_1 =
        std::max(error_1, std::abs(reaction_on(mechanism, state, "motor 1", 0).moment - tau_1));
    error_2 =
        std::max(error_2, std::abs(reaction_on(mechanism, state, "motor 2", 1).moment - tau_2));
    const Eigen::Vector2d end = l1 * unit_of(a.value) + l2 * unit_of(a.value + b.value);
    tip = std::max(tip, (state.q.segment<2>(3) - end).norm());
  }
  CHECK(tip < 1e-14);
  CHECK(error_1 < 1e-11);
  CHECK(error_2 < 1e-11);
  CHECK(worst_imbalance(mechanism, motion) < 1e-13);
}

TEST_CASE("hydraulic cylinder: a driver of length lifts a boom") {
  // Law of cosines: L^2 = a^2 + b^2 - 2 a b cos(gamma), gamma the angle at the boom's pivot between
  // cylinder base (a away, straight below) and cylinder end (b along the boom).
  const double a = 0.6, b = 0.9, boom = 2.0, m = 120.0, W = 5000.0;
  const HarmonicDriver driver{1.05, 0.25, 1.5, 0.3, {}};
  const auto boom_of = [&](const DriverState& L) {
    const double cosine = (a * a + b * b - L.value * L.value) / (2.0 * a * b);
    const double gamma = std::acos(cosine), s = std::sin(gamma);
    const double rate = L.value * L.rate / (a * b * s);
    const double acceleration =
        (L.rate * L.rate + L.value * L.acceleration - a * b * cosine * rate * rate) / (a * b * s);
    return Rates{gamma - 0.5 * pi, rate, acceleration};
  };
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  mechanism.bodies = {bar("boom", boom, m, {0.0, 0.0}, boom_of(driver_at(driver, 0.0)).value)};
  mechanism.joints = {
      {"pivot", Pin{{0, {-0.5 * boom, 0.0}}, {ground, {0.0, 0.0}}}},
      {"cylinder",
       Driven{{0, {b - 0.5 * boom, 0.0}}, Coordinate::length, driver, {ground, {0.0, -a}}}}};
  mechanism.forces = {
      {"load",
       PointForce{{0, {0.5 * boom, 0.0}}, -0.5 * pi, false, HarmonicDriver{W, 0.0, 0.0, 0.0, {}}}}};
  const Motion motion = solve_motion(mechanism, 120);
  Errors errors;
  double force_error = 0.0, largest = 0.0;
  for (const State& state : motion.states) {
    const DriverState L = driver_at(driver, state.time);
    const Rates phi = boom_of(L);
    errors.add_angle(state, 0, phi);
    // F dL = (m l^2/3 phi'' + (m g l/2 + W l) cos(phi)) dphi, dphi/dL = L/(a b sin(gamma)).
    const double moment =
        m * boom * boom / 3.0 * phi.acceleration + (0.5 * m * g + W) * boom * std::cos(phi.value);
    const double force = moment * L.value / (a * b * std::sin(phi.value + 0.5 * pi));
    const Eigen::Vector2d along = (b * unit_of(phi.value) - Eigen::Vector2d(0.0, -a)) / L.value;
    const Reaction cylinder = reaction_on(mechanism, state, "cylinder", 0);
    force_error = std::max(force_error, (cylinder.force - force * along).norm());
    largest = std::max(largest, std::abs(force));
  }
  CHECK(errors.q < 1e-13);
  CHECK(errors.v < 1e-12);
  CHECK(errors.a < 1e-11);
  CHECK(force_error < 1e-12 * largest);
  CHECK(worst_imbalance(mechanism, motion) < 1e-13);
}

}  // namespace linkage_closed_form_test
