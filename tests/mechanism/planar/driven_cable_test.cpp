#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"

// A crank of radius r turned at a constant rate, and a spring that acts one way from its end to a
// place on the ground at a distance D from its centre: l^2 = D^2 + r^2 - 2 D r cos(w t).
namespace boxbeam::planar {
namespace {

constexpr double radius = 0.5, distance = 2.0, rate = 3.0;

Mechanism crank_with(const Spring& spring, double start = 0.0) {
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0};
  Body crank;
  crank.mass = 7.0;
  crank.inertia = 0.4;
  mechanism.bodies.push_back(crank);
  mechanism.joints.push_back({"O", Pin{{0, {0.0, 0.0}}, {ground, {0.0, 0.0}}}});
  AppliedForce force{"cable", spring};
  mechanism.forces.push_back(force);
  mechanism.joints.push_back(
      {"motor", Driven{{0, {0.0, 0.0}}, Coordinate::angle, RateDriver{start, rate}}});
  return mechanism;
}

Spring spring_of(Acts acts, double free_length, double damping) {
  Spring spring;
  spring.a = {0, {radius, 0.0}};
  spring.b = {ground, {distance, 0.0}};
  spring.stiffness = 900.0;
  spring.free_length = free_length;
  spring.damping = damping;
  spring.acts = acts;
  return spring;
}

double length_at(double time) {
  return std::sqrt(distance * distance + radius * radius -
                   2.0 * distance * radius * std::cos(rate * time));
}

/// dl/d(angle)
double arm_at(double time) { return distance * radius * std::sin(rate * time) / length_at(time); }

/// The tension by the law of springs that act one way, written anew.
double tension_at(const Spring& spring, double time) {
  const double sign = spring.acts == Acts::pulling ? 1.0 : -1.0;
  const double d = sign * (length_at(time) - spring.free_length);
  if (d <= 0.0) return 0.0;
  return sign * std::max(0.0, spring.stiffness * d + spring.damping * sign * arm_at(time) * rate);
}

}  // namespace

TEST_CASE("a cable in a motion that drivers decide: when it acts, and what it asks of the motor") {
  const double free_length = 1.8;
  const double angle =
      std::acos((distance * distance + radius * radius - free_length * free_length) /
                (2.0 * distance * radius));
  for (const Acts acts : {Acts::pulling, Acts::pushing}) {
    const Spring spring = spring_of(acts, free_length, 0.0);
    const Mechanism mechanism = crank_with(spring);
    const Motion motion = solve_motion(mechanism);
    REQUIRE(motion.closed);
    REQUIRE(motion.changes.size() == 2);
    CHECK(motion.changes[0] == Approx(angle / rate).epsilon(1e-12));
    CHECK(motion.changes[1] == Approx((2.0 * std::numbers::pi - angle) / rate).epsilon(1e-12));
    double work = 0.0;
    for (const State& state : motion.states) {
      const double moment = tension_at(spring, state.time) * arm_at(state.time);
      const double driver = state.lambda[state.lambda.size() - 1];
      CHECK(std::abs(driver) == Approx(std::abs(moment)).margin(1e-9));
      work += driver;
    }
    // A cable gives back what it takes.
    CHECK(std::abs(work) < 1e-6 * spring.stiffness);
  }
}

TEST_CASE(
    "a cable with a damper goes slack before it is short, and a damper alone where it turns") {
  const Spring both = spring_of(Acts::pulling, 1.8, 60.0);
  const Motion motion = solve_motion(crank_with(both));
  // It begins at its length, and ends where k d + c d' is none: by halving the closed form.
  double low = std::numbers::pi / rate, high = 2.0 * low;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const double force = both.stiffness * (length_at(middle) - both.free_length) +
                         both.damping * arm_at(middle) * rate;
    (force > 0.0 ? low : high) = middle;
  }
  const auto has = [](const Motion& of, double time) {
    return std::any_of(of.changes.begin(), of.changes.end(),
                       [&](double at) { return std::abs(at - time) < 1e-10; });
  };
  CHECK(length_at(low) > both.free_length);
  CHECK(has(motion, low));
  CHECK(has(motion, std::acos((distance * distance + radius * radius - 1.8 * 1.8) /
                              (2.0 * distance * radius)) /
                        rate));

  Spring damper = spring_of(Acts::pulling, 0.0, 60.0);
  damper.stiffness = 0.0;
  const Motion damped = solve_motion(crank_with(damper));
  CHECK(has(damped, std::numbers::pi / rate));
}

TEST_CASE("a cable that is tight for a moment between two looks is seen") {
  for (const double tight : {1e-6, 1e-9, 1e-12}) {
    Spring spring = spring_of(Acts::pulling, distance + radius - tight, 0.0);
    // Off the grid of looks.
    const Motion motion = solve_motion(crank_with(spring, 0.3217));
    REQUIRE(motion.changes.size() == 2);
    // l = D + r - D r (angle - pi)^2/(2 (D + r)) there.
    const double half = std::sqrt(2.0 * tight * (distance + radius) / (distance * radius));
    CHECK(motion.changes[1] - motion.changes[0] == Approx(2.0 * half / rate).epsilon(1e-3));
    CHECK(0.5 * (motion.changes[0] + motion.changes[1]) ==
          Approx((std::numbers::pi - 0.3217) / rate).epsilon(1e-7));
  }
}

TEST_CASE("a damper that would pull for a moment before the cable is long enough is seen") {
  // l + c/k l' rises above l_0 by `tight` alone, where l has not got there.
  Spring spring = spring_of(Acts::pulling, 0.0, 60.0);
  const auto by_force = [&](double time) {
    return length_at(time) + spring.damping / spring.stiffness * arm_at(time) * rate;
  };
  const double h = 1e-4;
  double low = 0.5 * std::numbers::pi / rate, high = std::numbers::pi / rate;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (by_force(middle + h) > by_force(middle - h) ? low : high) = middle;
  }
  const double bend = (by_force(low + h) - 2.0 * by_force(low) + by_force(low - h)) / (h * h);
  for (const double tight : {1e-7, 1e-9}) {
    spring.free_length = by_force(low) - tight;
    REQUIRE(spring.free_length > distance + radius);
    const Motion motion = solve_motion(crank_with(spring));
    REQUIRE(motion.changes.size() == 2);
    CHECK(motion.changes[1] - motion.changes[0] ==
          Approx(2.0 * std::sqrt(-2.0 * tight / bend)).epsilon(1e-3));
    CHECK(0.5 * (motion.changes[0] + motion.changes[1]) == Approx(low).epsilon(1e-6));
  }
}

TEST_CASE("an impact in a motion that drivers decide is refused by its name") {
  Spring spring = spring_of(Acts::pushing, 1.8, 0.0);
  spring.impact = Impact{1.0, 0.5};
  CHECK_THROWS_WITH(
      solve_motion(crank_with(spring)),
      Catch::Contains("nothing parts from a stop by itself") && Catch::Contains("force cable"));
}

}  // namespace boxbeam::planar
