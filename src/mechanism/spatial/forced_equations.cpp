#include "boxbeam/mechanism/spatial/forced_equations.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/common/sticking.hpp"
#include "loop_rows.hpp"

namespace boxbeam::spatial {
namespace {

/// Pivots of the inertia matrix without units: below it an acceleration is not determined.
constexpr double no_mass = 1e-12;

}  // namespace

ForcedEquations::ForcedEquations(const Mechanism& mechanism, const Loops* loops, double tolerance)
    : loops_(loops),
      contacts_(friction_contacts_of(mechanism)),
      rest_(100.0 * tolerance * size_of(mechanism)) {
  for (const FrictionContact& contact : contacts_) {
    laws_.push_back(contact.law);
    names_.push_back(name_of_contact(mechanism, contact));
  }
  sticking_ = std::any_of(laws_.begin(), laws_.end(), can_stick);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (!is_forced(joint)) continue;
    joints_.push_back(i);
    scales_.push_back(is_angle(joint.kind) ? 1.0 : size_of(mechanism));
  }
}

std::vector<double> ForcedEquations::start_of(const Mechanism& mechanism) const {
  std::vector<double> y;
  for (std::size_t k = 0; k < joints_.size(); ++k)
    y.push_back(mechanism.joints[joints_[k]].start / scales_[k]);
  for (std::size_t k = 0; k < joints_.size(); ++k)
    y.push_back(mechanism.joints[joints_[k]].start_rate / scales_[k]);
  return y;
}

std::optional<Loops::Sample> ForcedEquations::place(const Tree& tree, const std::vector<double>& y,
                                                    double time, const Loops::Sample& near,
                                                    State& state) const {
  tree.drive(state, time);
  set(state, y);
  if (loops_ != nullptr) return loops_->close_beside(near, tree, state);
  tree.move(state);
  return Loops::Sample{};
}

void ForcedEquations::set(State& state, const std::vector<double>& y) const {
  for (std::size_t k = 0; k < joints_.size(); ++k)
    state.coordinates[joints_[k]] = {scales_[k] * y[k], scales_[k] * y[joints_.size() + k], 0.0};
}

void ForcedEquations::move(const Tree& tree, State& state, const Loops::Sample& closed,
                           const Eigen::VectorXd& accelerations) const {
  for (std::size_t k = 0; k < joints_.size(); ++k)
    state.coordinates[joints_[k]].acceleration = accelerations[static_cast<Eigen::Index>(k)];
  if (loops_ != nullptr && loops_->freedoms() > 0) {
    const Eigen::VectorXd led = closed.following * accelerations;
    for (std::size_t f = 0; f < loops_->joints().size(); ++f)
      state.coordinates[loops_->joints()[f]].acceleration += led[static_cast<Eigen::Index>(f)];
  }
  tree.accelerate(state);
}

/// The rates of all bodies and contacts, and the momentum of the bodies, per rate of each
/// coordinate, a column each, and what is asked of them without their accelerations.
struct ForcedEquations::Directions {
  Eigen::MatrixXd velocity, momentum, sliding;
  Eigen::VectorXd asked;
};

ForcedEquations::Directions ForcedEquations::directions_in(const Tree& tree, const State& state,
                                                           const Loops::Sample& closed) const {
  const Mechanism& mechanism = tree.mechanism();
  const auto n = static_cast<Eigen::Index>(joints_.size());
  const auto rubbing = static_cast<Eigen::Index>(contacts_.size());
  const auto bodies = static_cast<Eigen::Index>(mechanism.bodies.size());
  std::vector<Wrench> wrenches;
  tree.wrenches(state, {}, wrenches);
  Directions of{Eigen::MatrixXd(6 * bodies, n), Eigen::MatrixXd(6 * bodies, n),
                Eigen::MatrixXd(rubbing, n), Eigen::VectorXd::Zero(n)};
  State moving = state;
  for (DriverState& coordinate : moving.coordinates) coordinate.rate = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t own = joints_[static_cast<std::size_t>(k)];
    const double scale = scales_[static_cast<std::size_t>(k)];
    const auto turn = [&](std::size_t i, double rate) {
      moving.coordinates[i].rate = rate;
      const Joint& joint = mechanism.joints[i];
      const Eigen::Vector3d axis = in_world(state, joint.parent, joint.axis);
      of.asked[k] += rate * along_coordinate(joint, axis, wrenches[i]);
    };
    turn(own, scale);
    if (loops_ != nullptr) {
      for (std::size_t f = 0; f < loops_->joints().size(); ++f)
        turn(loops_->joints()[f], scale * closed.following(static_cast<Eigen::Index>(f), k));
    }
    tree.move_at_rates(moving);
    for (Eigen::Index b = 0; b < bodies; ++b) {
      const Body& body = mechanism.bodies[static_cast<std::size_t>(b)];
      const BodyMotion& motion = moving.bodies[static_cast<std::size_t>(b)];
      const Eigen::Vector3d centre = velocity_of(moving, {static_cast<int>(b), body.centre});
      const Eigen::Vector3d omega = motion.R_WB.transpose() * motion.omega;
      of.velocity.col(k).segment<6>(6 * b) << centre, omega;
      of.momentum.col(k).segment<6>(6 * b) << body.mass * centre, body.inertia * omega;
    }
    for (Eigen::Index j = 0; j < rubbing; ++j)
      of.sliding(j, k) =
          sliding_velocity_of(mechanism, contacts_[static_cast<std::size_t>(j)], moving);
    moving.coordinates[own].rate = 0.0;
  }
  return of;
}

ForcedEquations::Response ForcedEquations::response_in(const Tree& tree, const State& state,
                                                       const Loops::Sample& closed) const {
  const auto n = static_cast<Eigen::Index>(joints_.size());
  const Directions directions = directions_in(tree, state, closed);
  const Eigen::MatrixXd inertia = directions.velocity.transpose() * directions.momentum;
  Response of;
  of.accelerations = Eigen::VectorXd::Zero(n);
  Eigen::Index least = 0;
  if (!inertia.allFinite() || !(inertia.diagonal().minCoeff(&least) > 0.0)) {
    of.unsolved = {joints_[static_cast<std::size_t>(least)], false};
    return of;
  }
  const Eigen::VectorXd root = inertia.diagonal().cwiseSqrt();
  const Eigen::LDLT<Eigen::MatrixXd> pivots(root.cwiseInverse().asDiagonal() * inertia *
                                            root.cwiseInverse().asDiagonal());
  Eigen::VectorXi order =
      Eigen::VectorXi::LinSpaced(static_cast<int>(n), 0, static_cast<int>(n) - 1);
  order = pivots.transpositionsP() * order;
  if (!(pivots.vectorD().minCoeff(&least) > no_mass)) {
    of.unsolved = {joints_[static_cast<std::size_t>(order[least])], false};
    return of;
  }
  const auto moved_by = [&](const Eigen::VectorXd& power) -> Eigen::VectorXd {
    return pivots.solve(power.cwiseQuotient(root)).cwiseQuotient(root);
  };
  of.accelerations = moved_by(-directions.asked);
  of.of = FrictionResponse(contacts_.size());
  of.by_friction.resize(n, directions.sliding.rows());
  for (Eigen::Index j = 0; j < directions.sliding.rows(); ++j)
    of.by_friction.col(j) = moved_by(directions.sliding.row(j).transpose());
  if (contacts_.empty()) return of;
  of.of.rate = directions.sliding * of.by_friction;
  know_friction(tree, state, closed, of);
  return of;
}

void ForcedEquations::know_friction(const Tree& tree, const State& state,
                                    const Loops::Sample& closed, Response& of) const {
  const Mechanism& mechanism = tree.mechanism();
  const auto n = static_cast<Eigen::Index>(joints_.size());
  const auto rubbing = static_cast<Eigen::Index>(contacts_.size());
  State moving;
  std::vector<Wrench> wrenches;
  const Eigen::Map<const Eigen::VectorXd> scales(scales_.data(), n);
  std::vector<double> forces(contacts_.size(), 0.0);
  // What guides carry where it is accelerated so.
  const auto loaded = [&](const Eigen::VectorXd& accelerations) {
    moving = state;
    move(tree, moving, closed, scales.cwiseProduct(accelerations));
    wrenches_beside_friction(tree, loops_, moving, contacts_, forces, wrenches);
    Eigen::VectorXd loads(6 * rubbing);
    for (Eigen::Index j = 0; j < rubbing; ++j)
      loads.segment<6>(6 * j) =
          guide_load_of(mechanism, contacts_[static_cast<std::size_t>(j)], moving, wrenches);
    return loads;
  };
  of.of.load_0 = loaded(of.accelerations);
  for (Eigen::Index j = 0; j < rubbing; ++j) {
    const FrictionContact& contact = contacts_[static_cast<std::size_t>(j)];
    of.of.velocity[j] = sliding_velocity_of(mechanism, contact, state);
    of.of.rate_0[j] = sliding_acceleration_of(mechanism, contact, moving);
  }
  // Per unit of each friction force; of the size of what acts without them.
  double unit = 1.0;
  for (const Wrench& joint : wrenches) unit = std::max(unit, joint.force.norm());
  for (Eigen::Index j = 0; j < rubbing; ++j) {
    forces[static_cast<std::size_t>(j)] = unit;
    of.of.load.col(j) =
        (loaded(of.accelerations + unit * of.by_friction.col(j)) - of.of.load_0) / unit;
    forces[static_cast<std::size_t>(j)] = 0.0;
  }
}

ForcedEquations::Solution ForcedEquations::solve(const Tree& tree, const State& state,
                                                 const Loops::Sample& closed,
                                                 const std::vector<Slip>& slips) const {
  const Response response = response_in(tree, state, closed);
  Solution of{response.accelerations, {}, true, response.unsolved};
  if (of.unsolved) return of;
  const auto n = static_cast<Eigen::Index>(joints_.size());
  if (!contacts_.empty()) {
    const auto friction = solve_friction(laws_, slips, response.of);
    if (!friction) {
      of.unsolved = {0, true};
      return of;
    }
    of.friction.assign(friction->begin(), friction->end());
    of.accelerations += response.by_friction * *friction;
    if (sticking_) {
      const Eigen::VectorXd load = response.of.load_0 + response.of.load * *friction;
      Eigen::VectorXd pressure(friction->size());
      for (Eigen::Index j = 0; j < pressure.size(); ++j)
        pressure[j] = pressure_of(laws_[static_cast<std::size_t>(j)], load.segment<6>(6 * j));
      of.go_on = slips_go_on(laws_, slips, response.of.velocity, *friction, pressure,
                             turning_back * rest_);
    }
  }
  for (Eigen::Index k = 0; k < n; ++k) of.accelerations[k] *= scales_[static_cast<std::size_t>(k)];
  return of;
}

void ForcedEquations::accelerate(const Tree& tree, State& state, const Loops::Sample& closed,
                                 const std::vector<Slip>& slips) const {
  Solution of = solve(tree, state, closed, slips);
  if (of.unsolved) say_unsolved(tree, state.time, *of.unsolved);
  state.friction = std::move(of.friction);
  move(tree, state, closed, of.accelerations);
}

void ForcedEquations::say_unsolved(const Tree& tree, double time, const Unsolved& why) const {
  if (why.locked) say_locked_contacts(tree.mechanism(), contacts_, time);
  const std::string& name = tree.mechanism().joints[why.massless].name;
  throw AnalysisError(
      {fmt::format(
           "how forces move joint \"{}\" is not determined: nothing that it moves has a mass "
           "or inertia there, or two of its turns lie in line (give its axes another order); a "
           "beam has an "
           "inertia about its own axis with rotary_inertia = true",
           name),
       "joint " + name, time});
}

}  // namespace boxbeam::spatial
