// Four-bar linkages against hand formulas: positions, velocities, accelerations, and forces
// by virtual work. Every solved instant is also checked body by body by Newton and Euler.
// Source: Norton, Design of Machinery (closed loops, sections 4.5 and 7.3).

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/closed_forms.hpp"

namespace linkage_closed_form_test {

using namespace boxbeam;
using namespace boxbeam::planar;
using namespace test::closed_forms;

namespace {

/// Ground, crank, coupler and rocker of a Grashof linkage.
constexpr double d = 0.4, r = 0.1, l = 0.35, s = 0.25;

/// Crank 0 from the origin, coupler 1 and rocker 2; by mass and angle.
Mechanism four_bar(const std::array<double, 3>& masses, const std::array<double, 3>& angles,
                   const Driver& driver) {
  Mechanism mechanism;
  mechanism.bodies = {bar("crank", r, masses[0], {0.0, 0.0}, angles[0]),
                      bar("coupler", l, masses[1], r * unit_of(angles[0]), angles[1]),
                      bar("rocker", s, masses[2], {d, 0.0}, angles[2])};
  mechanism.joints = {{"O", Pin{{0, {-0.5 * r, 0.0}}, {ground, {0.0, 0.0}}}},
                      {"A", Pin{{0, {0.5 * r, 0.0}}, {1, {-0.5 * l, 0.0}}}},
                      {"B", Pin{{1, {0.5 * l, 0.0}}, {2, {0.5 * s, 0.0}}}},
                      {"D", Pin{{2, {-0.5 * s, 0.0}}, {ground, {d, 0.0}}}},
                      {"motor", Driven{{0}, Coordinate::angle, driver}}};
  return mechanism;
}

}  // namespace

TEST_CASE("four-bar: position by circles, rates by Norton's equations, moment by virtual work") {
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
      Mechanism mechanism = four_bar(
          {}, {start, std::atan2(B.y() - A.y(), B.x() - A.x()), std::atan2(B.y(), B.x() - d)},
          driver);
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
  const Mechanism mechanism = four_bar({0.3, 0.7, 0.5}, {0.0, 0.8, 1.5}, RateDriver{0.0, 15.0});
  const Motion motion = solve_motion(mechanism, 120);
  for (const State& state : motion.states) {
    const double t2 = state.q[2], t4 = state.q[8];
    const double K3 = (r * r - l * l + s * s + d * d) / (2.0 * r * s);
    CHECK(std::abs(d / r * std::cos(t4) - d / s * std::cos(t2) + K3 - std::cos(t2 - t4)) < 1e-13);
  }
  CHECK(worst_imbalance(mechanism, motion) < 1e-12);
}

TEST_CASE("distance joint: the same as a rod without mass") {
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

}  // namespace linkage_closed_form_test
