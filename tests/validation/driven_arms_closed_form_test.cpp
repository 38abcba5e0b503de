// Arms that turn, by a crank in their slot, by an angle between two bodies or by a cylinder,
// against hand formulas. Every solved instant is also checked body by body by Newton and Euler.
// Source: Craig, Introduction to Robotics (two-link arm, section 6.7).

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/closed_forms.hpp"

namespace driven_arms_closed_form_test {

using namespace boxbeam;
using namespace boxbeam::planar;
using namespace test::closed_forms;

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

}  // namespace driven_arms_closed_form_test
