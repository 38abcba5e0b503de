#include "boxbeam/mechanism/spatial/chain.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "boxbeam/core/error.hpp"

namespace boxbeam::spatial {
namespace {

/// What drivers alone move does not part by itself.
void require_no_impact(const Mechanism& mechanism) {
  for (const Spring& spring : mechanism.springs) {
    if (!spring.impact) continue;
    throw AnalysisError(
        {spring.clearance
             ? "drivers and loops decide the whole motion, and leave the clearance nothing to do; "
               "let forces move what it leaves free: moved_by = \"forces\" in the joints that "
               "carry it"
             : "drivers decide the whole motion, and nothing parts from a stop by itself; write "
               "damping instead of restitution, or let forces move what it stops",
         (spring.clearance ? "joint " : "force ") + spring.name});
  }
}

}  // namespace

Chain::Chain(const Mechanism& mechanism)
    : tree_(mechanism), contacts_(friction_contacts_of(mechanism)) {
  if (!mechanism.closing.empty()) loops_ = std::make_shared<Loops>(tree_);
  if (loops_) require_known_pressure(mechanism, *loops_, contacts_);
  const bool forced = std::any_of(mechanism.joints.begin(), mechanism.joints.end(), is_forced);
  if (!forced) require_no_impact(mechanism);
  if (forced) forced_ = std::make_shared<const ForcedMotion>(tree_, loops_.get());
  if (!loops_) return;
  loops_->follow(tree_, forced_.get());
  require_known_pressure(mechanism, *loops_, contacts_);
}

State Chain::at(double time) const {
  State state;
  at(time, state);
  return state;
}

void Chain::at(double time, State& state) const {
  tree_.drive(state, time);
  if (forced_) forced_->set(tree_, state);
  Loops::Sample closed;
  if (loops_)
    closed = loops_->close(tree_, state);
  else
    tree_.move(state);
  if (forced_)
    forced_->accelerate(tree_, state, closed);
  else
    state.friction = friction_forces_of(tree_, loops_.get(), state, contacts_);
}

std::vector<Wrench> Chain::joint_wrenches(const State& state) const {
  std::vector<Wrench> joints;
  joint_wrenches(state, joints);
  return joints;
}

void Chain::joint_wrenches(const State& state, std::vector<Wrench>& joints) const {
  const Mechanism& mechanism = tree_.mechanism();
  wrenches_beside_friction(tree_, loops_.get(), state, contacts_, state.friction, joints);
  for (std::size_t j = 0; j < state.friction.size(); ++j)
    joints[contacts_[j].joint].force +=
        state.friction[j] * axis_of_contact(mechanism, contacts_[j], state);
}

std::vector<double> Chain::friction_by_joint(const State& state) const {
  std::vector<double> forces(mechanism().joints.size() + mechanism().closing.size(), 0.0);
  for (std::size_t j = 0; j < state.friction.size(); ++j)
    forces[contacts_[j].joint] = state.friction[j];
  return forces;
}

double Chain::along_axis(const State& state, std::size_t joint, const Wrench& wrench) const {
  const Joint& of = mechanism().joints[joint];
  const Eigen::Vector3d axis = in_world(state, of.parent, of.axis);
  const double all = along_coordinate(of, axis, wrench);
  return of.kind == JointKind::prismatic ? all - friction_by_joint(state)[joint] : all;
}

InertiaLoad inertia_of(const Mechanism& mechanism, const State& state, std::size_t body) {
  const Body& of = mechanism.bodies[body];
  const BodyMotion& motion = state.bodies[body];
  const Eigen::Matrix3d inertia = motion.R_WB * of.inertia * motion.R_WB.transpose();
  const Eigen::Vector3d carrier = motion_of(state, mechanism.joints[body].parent).omega;
  const Eigen::Vector3d own = motion.omega - carrier;
  InertiaLoad load;
  load.force = -of.mass * acceleration_of(state, {static_cast<int>(body), of.centre});
  load.moment = -(inertia * motion.alpha + motion.omega.cross(inertia * motion.omega));
  load.gyroscopic = -(inertia * carrier.cross(own) + carrier.cross(inertia * own) +
                      own.cross(inertia * carrier) + own.cross(inertia * own));
  return load;
}

}  // namespace boxbeam::spatial
