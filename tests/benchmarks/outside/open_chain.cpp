// Bodies in a row in space, beside Pinocchio: positions, velocities, accelerations and the forces
// of all joints at one instant, by boxbeam (drivers, `Chain::at` and `joint_wrenches`) and by
// Pinocchio's `rnea`, the same bodies by turns in one process. open_chain.sh builds and runs it.

#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "support/random_tree.hpp"

namespace {

using namespace boxbeam;
using namespace boxbeam::spatial;

Mechanism row_of(int bodies) {
  test::Chance chance(7);
  Mechanism row;
  row.gravity = {0.0, 0.0, -9.81};
  for (int i = 0; i < bodies; ++i) {
    row.bodies.push_back({"", 3.0, chance.vector(0.3), chance.inertia(3.0, 0.4), {}});
    Joint joint{"", JointKind::revolute, i - 1, chance.vector(), {}, chance.rotation()};
    joint.axis = chance.direction();
    joint.driver = PolynomialDriver{{chance.any(), chance.any(), chance.any()}};
    row.joints.push_back(joint);
  }
  return row;
}

pinocchio::Model model_of(const Mechanism& row) {
  pinocchio::Model model;
  model.gravity.linear() = row.gravity;
  for (std::size_t i = 0; i < row.joints.size(); ++i) {
    const Joint& joint = row.joints[i];
    const Body& body = row.bodies[i];
    // Theirs is in the axes of the body.
    const Eigen::Vector3d axis = joint.turn.transpose() * joint.axis;
    const auto index =
        model.addJoint(i, pinocchio::JointModelRevoluteUnaligned(axis),
                       pinocchio::SE3(joint.turn, joint.at), "j" + std::to_string(i));
    model.appendBodyToJoint(index, pinocchio::Inertia(body.mass, body.centre, body.inertia));
  }
  return model;
}

using Clock = std::chrono::steady_clock;

/// Nanoseconds per body of one pass over some instants.
template <class Instant>
double time_of(const Instant& instant, int passes, int bodies) {
  const auto start = Clock::now();
  for (int i = 0; i < passes; ++i) instant(0.01 * (i % 100));
  const std::chrono::duration<double, std::nano> took = Clock::now() - start;
  return took.count() / passes / bodies;
}

double median_of(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

void compare(int bodies) {
  const Mechanism row = row_of(bodies);
  const Chain chain(row);
  const pinocchio::Model model = model_of(row);
  pinocchio::Data data(model);
  State state;
  std::vector<Wrench> wrenches;
  Eigen::VectorXd q(bodies), v(bodies), a(bodies);
  const auto ours = [&](double time) {
    chain.at(time, state);
    chain.joint_wrenches(state, wrenches);
  };
  const auto theirs = [&](double time) {
    for (int i = 0; i < bodies; ++i) {
      const DriverState of = driver_at(row.joints[static_cast<std::size_t>(i)].driver, time);
      q[i] = of.value;
      v[i] = of.rate;
      a[i] = of.acceleration;
    }
    pinocchio::rnea(model, data, q, v, a);
  };
  // Where both stand in the same instant: the forces of all joints.
  double difference = 0.0, largest = 0.0;
  ours(0.37);
  theirs(0.37);
  for (std::size_t i = 0; i < wrenches.size(); ++i) {
    const Eigen::Vector3d force = state.bodies[i].R_WB * data.f[i + 1].linear();
    difference = std::max(difference, (force - wrenches[i].force).cwiseAbs().maxCoeff());
    largest = std::max(largest, force.cwiseAbs().maxCoeff());
  }
  const int passes = std::max(10, 400000 / bodies);
  std::vector<double> by_us, by_them;
  for (int i = 0; i < 15; ++i) {
    by_us.push_back(time_of(ours, passes, bodies));
    by_them.push_back(time_of(theirs, passes, bodies));
  }
  const double us = median_of(by_us), them = median_of(by_them);
  std::printf("%6d %12.1f %12.1f %8.2f %12.1e\n", bodies, us, them, us / them,
              difference / largest);
}

}  // namespace

int main() {
  std::printf("%6s %12s %12s %8s %12s\n", "bodies", "boxbeam", "Pinocchio", "ratio", "forces");
  // Of more its data, with third derivatives, want gigabytes.
  std::printf("%6s %12s %12s %8s %12s\n", "", "ns/body", "ns/body", "", "differ by");
  for (const int bodies : {4, 40, 200}) compare(bodies);
}
