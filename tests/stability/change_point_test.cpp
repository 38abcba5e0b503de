// A parallelogram whose crank turns all round, through the two flat positions where it could go
// over into an anti-parallelogram: both branches are followed by what they are, and nothing else is
// taken for such a change point.

#include <algorithm>
#include <cmath>
#include <iostream>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace change_point_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double rate = 2.0;  // of the crank [rad/s]

/// The point of the second crank of an anti-parallelogram: that of the parallelogram, mirrored in
/// the diagonal from the first crank's tip to the second crank's pivot.
Eigen::Vector2d crossed_tip(double phi) {
  const Eigen::Vector2d A(std::cos(phi), std::sin(phi));
  const Eigen::Vector2d D(2.0, 0.0);
  const Eigen::Vector2d u = (D - A).normalized();
  const Eigen::Vector2d w = Eigen::Vector2d(2.0, 0.0);
  return A + 2.0 * u.dot(w) * u - w;
}

/// The flat positions of a turn that starts at `start`: how many, and how far the times reported
/// are from them.
double off_flat(const Motion& motion, double start) {
  double worst = 0.0;
  for (const double time : motion.change_points) {
    const double phi = start + rate * time;
    worst = std::max(worst, std::abs(std::remainder(phi, test::pi)));
  }
  return worst;
}

/// What turns through change points came to.
struct Turns {
  int turns = 0, refused = 0, passed = 0;
  double position = 0.0;  ///< largest error [m, rad]
  double rate = 0.0;      ///< largest error of velocities [m/s, rad/s]
};

/// `error_of`: of position and velocity of a state at a crank angle. `instants` 0: as many as the
/// solver takes.
template <class Error>
void turn_round(const Mechanism& mechanism, double start, int instants, const Error& error_of,
                Turns& all) {
  ++all.turns;
  Motion motion;
  try {
    motion = instants == 0 ? solve_motion(mechanism) : solve_motion(mechanism, instants);
  } catch (const AnalysisError& error) {
    ++all.refused;
    CHECK(error.failure().time.has_value());
    CHECK((instants == 24 || instants == 36));  // coarse steps may be refused, fine ones not
    return;
  }
  CHECK(motion.closed);
  CHECK(motion.change_points.size() >= 2);
  CHECK(off_flat(motion, start) < rate * motion.period / static_cast<double>(motion.states.size()));
  all.passed += static_cast<int>(motion.change_points.size());
  double position = 0.0;
  double velocity = 0.0;
  for (const State& state : motion.states) {
    const auto [of_position, of_velocity] = error_of(start + rate * state.time, state);
    position = std::max(position, of_position);
    velocity = std::max(velocity, of_velocity);
  }
  CHECK(position < 1e-9);
  CHECK(velocity < 1e-6);
  all.position = std::max(all.position, position);
  all.rate = std::max(all.rate, velocity);
}

void report(const std::string& what, const Turns& all) {
  std::cout << "stability: massless " << what << ", " << all.turns
            << " turns through its flat positions: " << all.refused << " refused, " << all.passed
            << " change points passed, positions off by at most " << all.position
            << ", velocities by at most " << all.rate << "\n";
}

}  // namespace

TEST_CASE("a massless parallelogram stays one over the whole turn") {
  Turns all;
  for (const double start : {0.3, 1.0, -2.0}) {
    for (const int instants : {24, 36, 97, 100, 360, 0}) {
      INFO("start " << start << ", " << instants << " instants");
      const Mechanism mechanism = test::parallel_cranks(2, RateDriver{start, rate}, start, true);
      turn_round(
          mechanism, start, instants,
          [](double phi, const State& state) {
            const double position = std::max({std::abs(std::remainder(state.q[2], 2.0 * test::pi)),
                                              std::abs(state.q[0] - 1.0 - std::cos(phi)),
                                              std::abs(state.q[1] - std::sin(phi))});
            return std::pair{position, std::max(std::abs(state.v[2]), std::abs(state.v[8] - rate))};
          },
          all);
    }
  }
  report("parallelogram", all);
  CHECK(all.refused == 0);
}

TEST_CASE("a massless anti-parallelogram stays crossed over the whole turn (mirrored point)") {
  Turns all;
  for (const double start : {0.3, 1.0, -2.0}) {
    for (const int instants : {24, 36, 97, 100, 360, 0}) {
      INFO("start " << start << ", " << instants << " instants");
      Mechanism mechanism = test::parallel_cranks(2, RateDriver{start, rate}, start, true);
      const Eigen::Vector2d A(std::cos(start), std::sin(start));
      const Eigen::Vector2d B = crossed_tip(start);
      mechanism.bodies[0].sketch = test::rod("coupler", A, B).sketch;
      mechanism.bodies[2].sketch = test::rod("crank 2", {2.0, 0.0}, B).sketch;
      turn_round(
          mechanism, start, instants,
          [](double phi, const State& state) {
            const Eigen::Vector2d e(std::cos(state.q[8]), std::sin(state.q[8]));
            const Eigen::Vector2d tip = state.q.segment<2>(6) + 0.5 * e;
            const Eigen::Vector2d tip_velocity =
                state.v.segment<2>(6) + 0.5 * state.v[8] * Eigen::Vector2d(-e.y(), e.x());
            const double h = 1e-5;  // of the central difference [rad]
            const Eigen::Vector2d velocity =
                rate * (crossed_tip(phi + h) - crossed_tip(phi - h)) / (2.0 * h);
            return std::pair{(tip - crossed_tip(phi)).norm(), (tip_velocity - velocity).norm()};
          },
          all);
    }
  }
  report("anti-parallelogram", all);
  // Its second crank turns three times as fast as the first where both are flat.
  CHECK(all.refused <= 6);
}

TEST_CASE("a start in a flat position is led off on one of the two motions, for the whole turn") {
  // Nothing in such a sketch says which of them.
  int parallel = 0, crossed = 0, refused = 0, mixed = 0;
  double worst = 0.0;
  for (const double start : {0.0, test::pi}) {
    for (const int instants : {24, 36, 48, 96, 97, 360, 0}) {
      INFO("start " << start << ", " << instants << " instants");
      const Mechanism mechanism = test::parallel_cranks(2, RateDriver{start, rate}, start, true);
      Motion motion;
      try {
        motion = instants == 0 ? solve_motion(mechanism) : solve_motion(mechanism, instants);
      } catch (const AnalysisError&) {
        ++refused;
        continue;
      }
      double off_parallel = 0.0, off_crossed = 0.0, residual = 0.0;
      for (const State& state : motion.states) {
        const double phi = start + rate * state.time;
        const Eigen::Vector2d e(std::cos(state.q[8]), std::sin(state.q[8]));
        const Eigen::Vector2d tip = state.q.segment<2>(6) + 0.5 * e;
        const Eigen::Vector2d beside(2.0 + std::cos(phi), std::sin(phi));
        off_parallel = std::max(off_parallel, (tip - beside).norm());
        off_crossed = std::max(off_crossed, (tip - crossed_tip(phi)).norm());
        residual = std::max(residual, state.residual);
      }
      // Where an instant stands in the flat position itself it is interpolated.
      const double off = std::min(off_parallel, off_crossed);
      CHECK(off < 1e-6);
      CHECK(off < 1e-9 + 10.0 * residual);
      worst = std::max(worst, off);
      mixed += off < 1e-6 ? 0 : 1;
      (off_parallel < off_crossed ? parallel : crossed) += 1;
    }
  }
  CHECK(mixed == 0);
  CHECK(parallel + crossed > refused);
  std::cout << "stability: 14 turns that start flat: " << parallel << " parallel, " << crossed
            << " crossed, " << refused << " refused, " << mixed
            << " neither; positions off by at most " << worst << " m\n";
}

TEST_CASE("masses that the flat position must hold are refused with their reason") {
  int refused = 0;
  for (const double start : {0.0, test::pi, 0.3}) {
    const Mechanism mechanism = test::parallel_cranks(2, RateDriver{start, rate}, start, false);
    INFO("start " << start);
    try {
      // 0.3: no instant stands in the flat position; peaks that never end are refused all the same.
      const Motion motion = start == 0.3 ? solve_motion(mechanism) : solve_motion(mechanism, 36);
      FAIL_CHECK("must be refused, not solved with " << motion.states.size() << " instants");
    } catch (const AnalysisError& error) {
      INFO(error.what());
      const std::string& what = error.failure().what;
      CHECK((what.find("grow without bound") != std::string::npos ||
             what.find("change too fast") != std::string::npos ||
             what.find("dead point") != std::string::npos));
      CHECK(error.failure().time.has_value());
      if (start != 0.3) CHECK(what.find("grow without bound") != std::string::npos);
      ++refused;
    }
  }
  Mechanism guided = test::parallel_cranks(2, RateDriver{0.3, rate}, 0.3, false);
  // A gear wheel between the cranks: the second turns as the first, whatever the coupler does.
  guided.joints.push_back({"gears", AngleCoupling{test::on(2, 0.0), test::on(1, 0.0), 1.0, 0.0}});
  const Motion motion = solve_motion(guided, 36);
  CHECK(motion.change_points.empty());
  for (const State& state : motion.states) CHECK(std::abs(state.q[2]) < 1e-12);
  std::cout << "stability: parallelogram with masses: " << refused
            << " of 3 turns refused; guided by a gear it needs no refusal and has "
            << motion.change_points.size() << " change points\n";
}

TEST_CASE("a stroke too long by nanometres is refused, not passed as a change point") {
  const double stroke = std::sqrt(3.5 * 3.5 - 9.0) - 0.5;
  const test::FourBar bar;
  const auto limit = static_cast<double>(bar.limit());
  int refused = 0;
  int passed = 0;
  const auto ask = [&](const Mechanism& mechanism, int instants) {
    try {
      solve_motion(mechanism, instants);
      ++passed;
      CHECK_FALSE("solved");
    } catch (const AnalysisError& error) {
      CHECK_FALSE(error.failure().what.empty());
      ++refused;
    }
  };
  for (const double beyond : {1e-3, 1e-6, 1e-8, 1e-9}) {
    for (const int instants : {24, 36, 96, 97, 101}) {
      for (const bool named : {true, false}) {
        INFO("beyond by " << beyond << ", " << instants << " instants, loops "
                          << (named ? "named" : "not named"));
        Mechanism rig = planar_of(test::rig());
        test::exciter_of(rig).amplitude = stroke + beyond;
        if (!named) {
          const Eigen::VectorXd q = test::rig_state(0.0).q;
          for (std::size_t i = 0; i < rig.bodies.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(3 * i);
            rig.bodies[i].sketch = {q.segment<2>(k), q[k + 2]};
          }
          rig.loops.clear();
        }
        ask(rig, instants);
        HarmonicDriver driver;
        driver.mean = 0.7;
        driver.amplitude = limit + beyond - driver.mean;
        driver.omega = 2.0 * test::pi;
        Mechanism four_bar = test::four_bar(bar, driver, 0.7, 1, true);
        if (!named) four_bar.loops.clear();
        ask(four_bar, instants);
      }
    }
  }
  std::cout << "stability: rig and four-bar 1e-9 .. 1e-3 m (rad) beyond their reach, 80 motions: "
            << refused << " refused, " << passed << " passed as if they could\n";
}

}  // namespace change_point_test
