// A double pendulum over 20 s, integrated with its constraints differentiated twice: without
// projection they drift apart (the negative control), with it they hold, and so does the energy.

#include <algorithm>
#include <cmath>
#include <iostream>

#include "benches.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "catch.hpp"

namespace constraint_drift_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

/// Two uniform rods of 1 m and 0.8 m, hanging from O; let go horizontally, the second upwards.
Mechanism double_pendulum() {
  Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81};
  mechanism.bodies = {test::rod("upper", {0.0, 0.0}, {1.0, 0.0}),
                      test::rod("lower", {1.0, 0.0}, {1.0, 0.8})};
  using test::on, test::on_ground;
  mechanism.joints = {{"O", Pin{on(0, -0.5), on_ground(0.0, 0.0)}},
                      {"A", Pin{on(0, 0.5), on(1, -0.4)}}};
  mechanism.duration.length = 20.0;
  return mechanism;
}

double energy_of(const Mechanism& mechanism, const State& state) {
  double energy = 0.0;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    const auto k = static_cast<Eigen::Index>(3 * i);
    energy += 0.5 * body.mass * state.v.segment<2>(k).squaredNorm() +
              0.5 * body.inertia * state.v[k + 2] * state.v[k + 2] -
              body.mass * mechanism.gravity.dot(state.q.segment<2>(k));
  }
  return energy;
}

struct Drift {
  double position = 0.0;  ///< of the pins [m]
  double velocity = 0.0;  ///< J v [m/s]
  double energy = 0.0;    ///< of the largest kinetic energy there can be
  int steps = 0;
};

Drift drift_of(double tolerance, bool project) {
  const Mechanism mechanism = double_pendulum();
  FreeSolver solver(mechanism, tolerance, project);
  ConstraintEquations equations(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  const double start = energy_of(mechanism, state);
  // Released upright at most, fallen to hanging: that much can become motion.
  const double exchanged = 9.81 * (10.0 * 1.0 * 0.5 * 2.0 + 8.0 * (1.0 + 0.4) * 2.0);
  Drift drift;
  Eigen::VectorXd phi(equations.rows());
  std::vector<double> values;
  for (int i = 1; i <= 400; ++i) {
    state = solver.advance(0.05 * i, state);
    equations.set_time(state.time);
    equations.set_position(state.q);
    equations.evaluate(phi, values);
    const Eigen::VectorXd rate = equations.pattern().dense(values) * state.v;
    drift.position = std::max(drift.position, phi.lpNorm<Eigen::Infinity>());
    drift.velocity = std::max(drift.velocity, rate.lpNorm<Eigen::Infinity>());
    drift.energy =
        std::max(drift.energy, std::abs(energy_of(mechanism, state) - start) / exchanged);
  }
  drift.steps = solver.steps();
  return drift;
}

void report(const std::string& name, const Drift& drift) {
  std::cout << "stability: double pendulum over 20 s, " << name << ", " << drift.steps
            << " steps: pins open by at most " << drift.position << " m, velocities by "
            << drift.velocity << " m/s, energy within " << drift.energy << "\n";
}

}  // namespace

TEST_CASE("with projection constraints and energy hold") {
  const Drift drift = drift_of(1e-11, true);
  report("projected", drift);
  CHECK(drift.position < 1e-12);
  CHECK(drift.velocity < 1e-11);
  CHECK(drift.energy < 1e-8);
}

TEST_CASE("without projection they drift (negative control)") {
  const Drift coarse = drift_of(1e-6, false);
  const Drift coarse_projected = drift_of(1e-6, true);
  const Drift fine = drift_of(1e-11, false);
  report("tolerance 1e-6 without projection", coarse);
  report("tolerance 1e-6 projected", coarse_projected);
  report("tolerance 1e-11 without projection", fine);
  CHECK(coarse.position > 1e-7);
  CHECK(coarse_projected.position < 1e-12);
  CHECK(fine.position > 1e-12);
}

}  // namespace constraint_drift_test
