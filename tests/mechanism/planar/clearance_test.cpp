// Stops and pins with clearance in the plane, against closed forms, conserved quantities and an
// integration of their own.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "catch.hpp"
#include "support/balance.hpp"

namespace clearance_test {

using namespace boxbeam;
using namespace boxbeam::planar;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr double pi = std::numbers::pi;

boxbeam::Body body_of(const char* name, double mass, double inertia, const Vector2d& at) {
  boxbeam::Body body;
  body.name = name;
  body.mass = mass;
  body.inertia = inertia;
  body.sketch.centre = at;
  return body;
}

/// A stop that pushes a body's centre away from a place on the ground, from 0.1 m on.
AppliedForce stop_at(const char* name, const Vector2d& place, int body, double k,
                     const Impact& impact) {
  return {name, Spring{{ground, place}, {body}, k, 0.1, 0.0, Acts::pushing, impact}};
}

/// A mass that flies along x between two stops, 1 m apart.
Mechanism between_stops(double m, double k, const Impact& impact) {
  Mechanism mechanism;
  mechanism.bodies = {body_of("mass", m, 0.1, {0.5, 0.0})};
  mechanism.forces = {stop_at("left", {-0.1, 0.0}, 0, k, impact),
                      stop_at("right", {1.1, 0.0}, 0, k, impact)};
  mechanism.duration.length = 1.0;
  return mechanism;
}

VectorXd vector_of(std::initializer_list<double> values) {
  VectorXd v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.begin());
  return v;
}

/// The sum of the forces on a body, by what acts at an instant.
Vector2d force_on(const Mechanism& mechanism, const State& state, int body) {
  Vector2d sum = Vector2d::Zero();
  for (const AppliedLoad& load :
       applied_loads_of(mechanism, state.time, state.q, state.v, state.touches))
    if (load.on == body) sum += load.vector;
  return sum;
}

}  // namespace

TEST_CASE("a mass between two stops loses the square of the restitution at each of them") {
  // Without gravity every impact is free: v_n = v e^n, and heights that it could rise to by e^2.
  constexpr double m = 3.0, v = 2.0;
  struct Case {
    double exponent, k, e;
    int impacts;
  };
  for (const Case& of : {Case{1.0, 1e6, 0.8, 12}, Case{1.5, 1e8, 0.8, 12}, Case{1.0, 1e7, 0.3, 4},
                         Case{1.5, 1e9, 0.1, 2}, Case{1.0, 1e6, 1.0, 20}}) {
    CAPTURE(of.exponent, of.k, of.e);
    const Mechanism mechanism = between_stops(m, of.k, {of.exponent, of.e});
    FreeSolver solver(mechanism);
    State state = solver.start(0.0, vector_of({0.5, 0.0, 0.0}), vector_of({v, 0.0, 0.0}));
    double expected = v;
    for (int n = 1; n <= of.impacts; ++n) {
      // To the next wall and on to the middle: a metre and what the impact takes.
      expected *= of.e;
      const double way = 0.5 / (expected / of.e) + 0.2 / expected;
      state = solver.advance(state.time + way, state);
      REQUIRE(solver.changes().size() == 2 * static_cast<std::size_t>(n));
      CHECK(state.v.squaredNorm() == Approx(expected * expected).epsilon(1e-7));
      const double to_middle = std::abs(0.5 - state.q[0]) / expected;
      state = solver.advance(state.time + to_middle, state);
      REQUIRE(state.q[0] == Approx(0.5).margin(1e-6));
    }
  }
}

TEST_CASE("an elastic impact has the peak and the duration of its closed form") {
  constexpr double m = 3.0, v = 2.0;
  const auto impact = [&](double exponent, double k) {
    const Mechanism mechanism = between_stops(m, k, {exponent, 1.0});
    FreeSolver solver(mechanism);
    const State begin = solver.start(0.0, vector_of({0.5, 0.0, 0.0}), vector_of({v, 0.0, 0.0}));
    static_cast<void>(solver.advance(0.4, begin));
    REQUIRE(solver.changes().size() == 2);
    const double touch = solver.changes()[0], part = solver.changes()[1];
    // What loses nothing is deepest half-way.
    const State deepest = solver.advance(0.5 * (touch + part), begin);
    CHECK(touch == Approx(0.5 / v).epsilon(1e-12));
    return std::pair(part - touch, force_on(mechanism, deepest, 0).norm());
  };
  {
    constexpr double k = 1e7;
    const auto [duration, peak] = impact(1.0, k);
    CHECK(duration == Approx(pi * std::sqrt(m / k)).epsilon(1e-8));
    CHECK(peak == Approx(v * std::sqrt(k * m)).epsilon(1e-8));
  }
  {
    // k d^2.5/2.5 = m v^2/2; half the duration is the integral of dx/sqrt(1 - x^2.5) from 0 to 1,
    // by d/v.
    constexpr double k = 4e8;
    const auto [duration, peak] = impact(1.5, k);
    CHECK(peak == Approx(std::pow(1.25 * m * v * v, 0.6) * std::pow(k, 0.4)).epsilon(1e-8));
    const double deepest = std::pow(1.25 * m * v * v / k, 0.4);
    const double integral = std::sqrt(pi) * std::tgamma(1.4) / std::tgamma(0.9);
    CHECK(duration == Approx(2.0 * integral * deepest / v).epsilon(1e-7));
  }
}

TEST_CASE("two bodies that collide keep their momentum and part with the restitution") {
  constexpr double m1 = 2.0, m2 = 5.0, u1 = 3.0, u2 = -1.0, e = 0.6;
  for (const double exponent : {1.0, 1.5}) {
    Mechanism mechanism;
    mechanism.bodies = {body_of("first", m1, 0.1, {0.0, 0.0}),
                        body_of("second", m2, 0.1, {1.0, 0.0})};
    mechanism.forces = {
        {"bumper", Spring{{0}, {1}, 1e7, 0.2, 0.0, Acts::pushing, Impact{exponent, e}}}};
    FreeSolver solver(mechanism);
    State state = solver.start(0.0, vector_of({0.0, 0.0, 0.0, 1.0, 0.0, 0.0}),
                               vector_of({u1, 0.0, 0.0, u2, 0.0, 0.0}));
    state = solver.advance(0.5, state);
    const double centre = (m1 * u1 + m2 * u2) / (m1 + m2);
    CHECK(state.v[0] == Approx(centre - m2 / (m1 + m2) * e * (u1 - u2)).epsilon(1e-8));
    CHECK(state.v[3] == Approx(centre + m1 / (m1 + m2) * e * (u1 - u2)).epsilon(1e-8));
    CHECK(std::abs(state.v[1]) + std::abs(state.v[4]) < 1e-12);
  }
}

TEST_CASE("a mass that is laid on a stop comes to rest where the stop bears it") {
  constexpr double m = 3.0, g = 9.81, k = 1e5;
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  mechanism.bodies = {body_of("mass", m, 0.1, {0.0, 0.1})};
  mechanism.forces = {stop_at("stop", {0.0, 0.0}, 0, k, {1.0, 0.5})};
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, vector_of({0.0, 0.1, 0.0}), VectorXd::Zero(3));
  state = solver.advance(8.0, state);
  CHECK(state.q[1] == Approx(0.1 - m * g / k).epsilon(1e-7));
  CHECK(std::abs(state.v[1]) < 1e-6);
}

namespace {

/// A mass under gravity in a bearing that is wider than it: an integration of its own, by Runge and
/// Kutta's method of order 4, whose steps end where it touches and parts.
struct InBearing {
  double m = 2.0, g = 9.81, c = 0.05, k = 2e5;
  Impact impact = {1.5, 0.7};
  Vector2d p = {0.0, 0.0}, v = {0.35, 0.0};
  double loss = 0.0, deepest = 0.0;
  bool on = false;
  int touches = 0;

  Vector2d acceleration(const Vector2d& at, const Vector2d& rate) const {
    Vector2d a(0.0, -g);
    if (!on) return a;
    const Vector2d u = at.normalized();
    const double d = at.norm() - c;
    const double elastic = k * std::copysign(std::pow(std::abs(d), impact.exponent), d);
    const double damped = d < deepest ? elastic : k * std::pow(deepest, impact.exponent);
    const double both = elastic + damped * loss * u.dot(rate);
    const double force = d > 0.0 ? std::max(0.0, both) : both;
    return a - force / m * u;
  }

  void step(double h) {
    const Vector2d p1 = v, v1 = acceleration(p, v);
    const Vector2d p2 = v + 0.5 * h * v1, v2 = acceleration(p + 0.5 * h * p1, p2);
    const Vector2d p3 = v + 0.5 * h * v2, v3 = acceleration(p + 0.5 * h * p2, p3);
    const Vector2d p4 = v + h * v3, v4 = acceleration(p + h * p3, p4);
    p += h / 6.0 * (p1 + 2.0 * p2 + 2.0 * p3 + p4);
    v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
  }

  bool changed() const { return on ? p.norm() < c : p.norm() > c; }

  void go(double until) {
    constexpr double h = 2e-6;
    double time = 0.0;
    while (time < until) {
      const InBearing before = *this;
      const double dt = std::min(h, until - time);
      step(dt);
      if (!changed()) {
        time += dt;
        continue;
      }
      double low = 0.0, high = dt;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        *this = before;
        step(middle);
        (changed() ? high : low) = middle;
      }
      *this = before;
      step(high);
      time += high;
      on = !on;
      if (!on) continue;
      ++touches;
      const double approach = v.dot(p.normalized());
      loss = hysteresis_of(impact.restitution) / approach;
      // m v^2/2 = k d^2.5/2.5.
      deepest = std::pow(1.25 * m * approach * approach / k, 0.4);
    }
  }
};

}  // namespace

TEST_CASE("a pin in its clearance moves as an own integration says") {
  InBearing own;
  own.go(0.6);
  REQUIRE(own.touches >= 3);
  Mechanism mechanism;
  mechanism.gravity = {0.0, -own.g};
  mechanism.bodies = {body_of("pin", own.m, 0.01, {0.0, 0.0})};
  mechanism.bodies[0].start_velocity = {0.35, 0.0, 0.0};
  mechanism.forces = {{"bearing", PinWithClearance{{ground}, {0}, own.c, own.k, own.impact}}};
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, VectorXd::Zero(3), vector_of({0.35, 0.0, 0.0}));
  state = solver.advance(0.6, state);
  CHECK(state.q[0] == Approx(own.p.x()).margin(1e-6 * own.c));
  CHECK(state.q[1] == Approx(own.p.y()).margin(1e-6 * own.c));
  CHECK(state.v[0] == Approx(own.v.x()).margin(1e-6));
  CHECK(state.v[1] == Approx(own.v.y()).margin(1e-6));
  CHECK(solver.changes().size() == 2 * static_cast<std::size_t>(own.touches) - (own.on ? 1u : 0u));
}

namespace {

/// A slider-crank whose crank turns evenly, of the size of the one on which joints with clearance
/// are tried (Flores, Ambrosio, Claro and Lankarani, 2008): crank 50 mm, rod 120 mm; 0.21 kg, 0.14
/// kg. The rod's pin in the slider has the clearance; it fits where that is zero.
struct SliderCrank {
  static constexpr double r = 0.05, l = 0.12, omega = 60.0, slider = 0.14;

  static Mechanism mechanism(double clearance, double e = 0.5, double k = 1e7) {
    Mechanism of;
    const double start = 0.4, angle = -std::asin(r * std::sin(start) / l);
    const Vector2d crank_pin(r * std::cos(start), r * std::sin(start));
    const Vector2d along(std::cos(angle), std::sin(angle));
    of.bodies = {body_of("crank", 0.3, 1e-4, 0.5 * crank_pin),
                 body_of("rod", 0.21, 2.5e-4, crank_pin + 0.5 * l * along),
                 body_of("slider", slider, 1e-4, crank_pin + l * along)};
    of.bodies[0].sketch.angle = start;
    of.bodies[1].sketch.angle = angle;
    of.joints = {{"O", Pin{{0, {-0.5 * r, 0.0}}, {}}},
                 {"A", Pin{{0, {0.5 * r, 0.0}}, {1, {-0.5 * l, 0.0}}}},
                 {"rail", Slider{{2}, {}, 0.0, 0.0}},
                 {"crank", Driven{{0}, Coordinate::angle, RateDriver{start, omega}}}};
    const Attachment of_rod{1, {0.5 * l, 0.0}}, of_slider{2};
    if (clearance > 0.0)
      of.forces = {{"B", PinWithClearance{of_slider, of_rod, clearance, k, {1.0, e}}}};
    else
      of.joints.push_back({"B", Pin{of_slider, of_rod}});
    of.duration.length = 2.0 * pi / omega;
    return of;
  }
};

/// The power of all forces, drivers and inertia at an instant by the largest of them [W].
double power_left(const Mechanism& mechanism, const State& state) {
  double sum = 0.0, largest = 1e-300;
  const auto add = [&](double power) {
    sum += power;
    largest = std::max(largest, std::abs(power));
  };
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(3 * i);
    const boxbeam::Body& body = mechanism.bodies[i];
    add(-body.mass * state.a.segment<2>(k).dot(state.v.segment<2>(k)));
    add(-body.inertia * state.a[k + 2] * state.v[k + 2]);
  }
  const auto act = [&](int on, const Vector2d& force, double moment, const Vector2d& at) {
    if (on == ground) return;
    add(force.dot(velocity_of({on, at}, state.q, state.v)));
    add(moment * state.v[3 * on + 2]);
  };
  for (const Reaction& of : reactions_of(mechanism, state))
    act(of.on, of.force, of.moment, of.point);
  for (const AppliedLoad& of :
       applied_loads_of(mechanism, state.time, state.q, state.v, state.touches))
    act(of.on, of.vector, of.moment, of.point);
  return sum / largest;
}

}  // namespace

TEST_CASE("a slider-crank with clearance begins as the ideal one, and two freedoms are left") {
  const Mechanism loose = SliderCrank::mechanism(0.5e-3), tight = SliderCrank::mechanism(0.0);
  StateSolver solver(loose), fitting(tight);
  CHECK(solver.integrates());
  CHECK(solver.freedom().undriven == 2);
  CHECK(solver.freedom().by_rank == 3);
  CHECK(!fitting.integrates());
  const State begin = solver.start(), ideal = fitting.start();
  CHECK((begin.q - ideal.q).norm() < 1e-12);
  CHECK((begin.v - ideal.v).norm() < 1e-9);
  CHECK(force_on(loose, begin, 2).norm() == 0.0);
  // Where it is said to begin elsewhere it touches there.
  Mechanism aside = loose;
  std::get<PinWithClearance>(aside.forces[0].kind).start = {0.0, -0.3e-3};
  const State off = StateSolver(aside).start();
  const auto at = [&](const Attachment& of) { return position_of(of, off.q); };
  CHECK((at({1, {0.5 * SliderCrank::l, 0.0}}) - at({2}) - Vector2d(0.0, -0.3e-3)).norm() < 1e-12);
}

TEST_CASE("a slider-crank with clearance keeps its power balance, and its pin in the bearing") {
  constexpr double c = 0.5e-3, k = 1e7;
  const Mechanism mechanism = SliderCrank::mechanism(c, 0.8, k);
  StateSolver solver(mechanism);
  State state = solver.start();
  constexpr int steps = 2000;
  int touching = 0, apart = 0;
  for (int i = 1; i <= steps; ++i) {
    state = solver.near(mechanism.duration.length * i / steps, state);
    CHECK(std::abs(power_left(mechanism, state)) < 1e-8);
    CHECK(test::imbalance_of(mechanism, state) < 1e-9);
    const double off =
        (position_of({1, {0.5 * SliderCrank::l, 0.0}}, state.q) - position_of({2}, state.q)).norm();
    const double force = force_on(mechanism, state, 2).norm();
    (force > 0.0 ? touching : apart) += 1;
    CHECK(off < c + 1e-4);
    if (force == 0.0) CHECK(off < c + 1e-12);
  }
  CHECK(touching > 10);
  CHECK(apart > 10);
  CHECK(solver.changes().size() > 4);
}

TEST_CASE("with less clearance a slider-crank comes nearer to the ideal one") {
  // The slider's momentum says the mean of the contact force over a part of the turn: m dv/dt.
  const Mechanism tight = SliderCrank::mechanism(0.0);
  StateSolver fitting(tight);
  const State ideal_start = fitting.start();
  const double turn = 2.0 * pi / SliderCrank::omega;
  double before = 1e300;
  for (const double c : {0.5e-3, 0.05e-3, 0.005e-3}) {
    CAPTURE(c);
    const Mechanism mechanism = SliderCrank::mechanism(c, 0.3);
    StateSolver solver(mechanism);
    State state = solver.start(), ideal = ideal_start;
    double off = 0.0, largest = 0.0;
    double v = 0.0, v_ideal = 0.0;
    for (int i = 0; i <= 8; ++i) {
      const double time = turn * (0.2 + 0.1 * i);
      state = solver.near(time, state);
      ideal = fitting.near(time, ideal);
      if (i > 0) {
        off = std::max(off, std::abs((state.v[6] - v) - (ideal.v[6] - v_ideal)));
        largest = std::max(largest, std::abs(ideal.v[6] - v_ideal));
      }
      v = state.v[6];
      v_ideal = ideal.v[6];
      CHECK(std::abs(state.q[6] - ideal.q[6]) < 2.0 * c + 1e-5);
    }
    CHECK(off / largest < before);
    before = off / largest;
  }
  CHECK(before < 0.02);
}

TEST_CASE("a motion stops at its changes, and says those that are too many") {
  const Mechanism mechanism = SliderCrank::mechanism(0.5e-3, 0.5);
  const Motion motion = solve_motion(mechanism);
  REQUIRE(motion.changes.size() >= 2);
  CHECK(std::is_sorted(motion.changes.begin(), motion.changes.end()));
  StateFinder finder(mechanism, motion);
  // Behind a touch it presses, before it not.
  const double touch = motion.changes[0], part = motion.changes[1];
  CHECK(force_on(mechanism, finder.at(touch - 1e-9), 2).norm() == 0.0);
  CHECK(force_on(mechanism, finder.at(0.5 * (touch + part)), 2).norm() > 0.0);
}

TEST_CASE("stops and clearance that drivers leave nothing to do are refused") {
  Mechanism mechanism = SliderCrank::mechanism(0.0);
  mechanism.forces = {stop_at("buffer", {0.25, 0.0}, 2, 1e6, {1.0, 0.5})};
  std::string said;
  try {
    StateSolver solver(mechanism);
  } catch (const AnalysisError& error) {
    said = error.what();
  }
  CHECK(said.find("drivers decide the whole motion") != std::string::npos);
  CHECK(said.find("buffer") != std::string::npos);
}

}  // namespace clearance_test
