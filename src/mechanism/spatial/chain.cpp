#include "boxbeam/mechanism/spatial/chain.hpp"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>

namespace boxbeam::spatial {
namespace {

const BodyMotion& world() {
  static const BodyMotion at_rest{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                                  Eigen::Vector3d::Zero(),     Eigen::Vector3d::Zero(),
                                  Eigen::Vector3d::Zero(),     Eigen::Vector3d::Zero()};
  return at_rest;
}

const BodyMotion& motion_of(const State& state, int body) {
  return body == ground ? world() : state.bodies[static_cast<std::size_t>(body)];
}

/// Acceleration of a point fixed to a body, r from its origin in world axes.
Eigen::Vector3d acceleration_at(const BodyMotion& body, const Eigen::Vector3d& r) {
  return body.acceleration + body.alpha.cross(r) + body.omega.cross(body.omega.cross(r));
}

/// Rate of change of the angular momentum about the centre of mass, world axes.
Eigen::Vector3d spin_change(const Body& body, const BodyMotion& motion) {
  const Eigen::Vector3d omega = motion.R_WB.transpose() * motion.omega;
  const Eigen::Vector3d alpha = motion.R_WB.transpose() * motion.alpha;
  return motion.R_WB * (body.inertia * alpha + omega.cross(body.inertia * omega));
}

}  // namespace

Chain::Chain(const Mechanism& mechanism) : mechanism_(&mechanism) {
  assert(mechanism.joints.size() == mechanism.bodies.size());
  for (const Joint& joint : mechanism.joints) {
    Link link{joint.turn, Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
    if (joint.kind == JointKind::revolute) {
      // Rodrigues: a a^T + cos q (I - a a^T) + sin q [a]x, about the axis in the parent's axes.
      const Eigen::Matrix3d along = joint.axis * joint.axis.transpose();
      Eigen::Matrix3d across;
      for (int k = 0; k < 3; ++k) across.col(k) = joint.axis.cross(Eigen::Vector3d::Unit(k));
      link.fixed = along * joint.turn;
      link.along_cosine = joint.turn - link.fixed;
      link.along_sine = across * joint.turn;
    }
    links_.push_back(link);
  }
}

State Chain::at(double time) const {
  State state;
  at(time, state);
  return state;
}

void Chain::at(double time, State& state) const {
  state.time = time;
  state.bodies.resize(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Joint& joint = mechanism_->joints[i];
    const Link& link = links_[i];
    const BodyMotion& parent = motion_of(state, joint.parent);
    BodyMotion& body = state.bodies[i];
    DriverState q;
    if (joint.kind != JointKind::fixed) q = driver_at(joint.driver, time);

    const Eigen::Vector3d axis = parent.R_WB * joint.axis;
    Eigen::Vector3d arm = parent.R_WB * joint.at;
    Eigen::Vector3d slide_velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d slide_acceleration = Eigen::Vector3d::Zero();
    body.omega = parent.omega;
    body.alpha = parent.alpha;
    if (joint.kind == JointKind::revolute) {
      body.R_WB = parent.R_WB * (link.fixed + std::cos(q.value) * link.along_cosine +
                                 std::sin(q.value) * link.along_sine);
      const Eigen::Vector3d u = q.rate * axis;
      body.omega += u;
      body.alpha += q.acceleration * axis + parent.omega.cross(u);
    } else {
      body.R_WB = parent.R_WB * link.fixed;
      if (joint.kind == JointKind::prismatic) {
        arm += q.value * axis;
        slide_velocity = q.rate * axis;
        slide_acceleration = q.acceleration * axis + 2.0 * q.rate * parent.omega.cross(axis);
      }
    }
    // From the parent's origin to the joint, and from there to the body's own origin.
    const Eigen::Vector3d back = -(body.R_WB * joint.point);
    body.position = parent.position + arm + back;
    body.velocity =
        parent.velocity + parent.omega.cross(arm) + slide_velocity + body.omega.cross(back);
    body.acceleration = acceleration_at(parent, arm) + slide_acceleration + body.alpha.cross(back) +
                        body.omega.cross(body.omega.cross(back));
  }
}

std::vector<Wrench> Chain::joint_wrenches(const State& state) const {
  std::vector<Wrench> joints;
  joint_wrenches(state, joints);
  return joints;
}

void Chain::joint_wrenches(const State& state, std::vector<Wrench>& joints) const {
  const Mechanism& mechanism = *mechanism_;
  // First what the joints must give each body alone, about its origin.
  joints.resize(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    const BodyMotion& motion = state.bodies[i];
    Wrench& needed = joints[i];
    needed = {};
    if (body.mass == 0.0) continue;
    const Eigen::Vector3d centre = motion.R_WB * body.centre;
    needed.force = body.mass * (acceleration_at(motion, centre) - mechanism.gravity);
    needed.moment = spin_change(body, motion) + centre.cross(needed.force);
  }
  for (const AppliedLoad& load : mechanism.loads) {
    const Eigen::Vector3d vector =
        driver_at(load.size, state.time).value * in_world(state, load.axes, load.direction);
    Wrench& needed = joints[static_cast<std::size_t>(load.on)];
    if (load.kind == LoadKind::couple) {
      needed.moment -= vector;
      continue;
    }
    needed.force -= vector;
    needed.moment -=
        (position_of(state, load.at) - motion_of(state, load.on).position).cross(vector);
  }
  for (const LineForce& line : mechanism.line_forces) {
    const BodyMotion& motion = motion_of(state, line.on);
    const Eigen::Vector3d force = driver_at(line.size, state.time).value *
                                  (line.to - line.from).norm() *
                                  in_world(state, line.axes, line.direction);
    Wrench& needed = joints[static_cast<std::size_t>(line.on)];
    needed.force -= force;
    needed.moment -= (motion.R_WB * (0.5 * (line.from + line.to))).cross(force);
  }
  // Then inwards: each joint gives its body's need and passes on what the joints beyond take.
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Joint& joint = mechanism.joints[i];
    Wrench& wrench = joints[i];
    const Eigen::Vector3d arm = state.bodies[i].R_WB * joint.point;
    wrench.moment -= arm.cross(wrench.force);
    if (joint.parent == ground) continue;
    Wrench& parent = joints[static_cast<std::size_t>(joint.parent)];
    const Eigen::Vector3d from_parent =
        state.bodies[i].position + arm - motion_of(state, joint.parent).position;
    parent.force += wrench.force;
    parent.moment += wrench.moment + from_parent.cross(wrench.force);
  }
}

Eigen::Vector3d position_of(const State& state, const Attachment& at) {
  const BodyMotion& body = motion_of(state, at.body);
  return body.position + body.R_WB * at.p;
}

Eigen::Vector3d velocity_of(const State& state, const Attachment& at) {
  const BodyMotion& body = motion_of(state, at.body);
  return body.velocity + body.omega.cross(body.R_WB * at.p);
}

Eigen::Vector3d acceleration_of(const State& state, const Attachment& at) {
  const BodyMotion& body = motion_of(state, at.body);
  return acceleration_at(body, body.R_WB * at.p);
}

Eigen::Vector3d in_world(const State& state, int axes, const Eigen::Vector3d& vector) {
  return axes == ground ? vector : motion_of(state, axes).R_WB * vector;
}

Eigen::Vector3d in_axes(const State& state, int axes, const Eigen::Vector3d& vector) {
  return axes == ground ? vector : motion_of(state, axes).R_WB.transpose() * vector;
}

InertiaLoad inertia_of(const Mechanism& mechanism, const State& state, std::size_t body) {
  const Body& of = mechanism.bodies[body];
  const BodyMotion& motion = state.bodies[body];
  const Eigen::Matrix3d inertia = motion.R_WB * of.inertia * motion.R_WB.transpose();
  const Eigen::Vector3d carrier = motion_of(state, mechanism.joints[body].parent).omega;
  const Eigen::Vector3d own = motion.omega - carrier;
  InertiaLoad load;
  load.force = -of.mass * acceleration_at(motion, motion.R_WB * of.centre);
  load.moment = -spin_change(of, motion);
  load.gyroscopic = -(inertia * carrier.cross(own) + carrier.cross(inertia * own) +
                      own.cross(inertia * carrier) + own.cross(inertia * own));
  return load;
}

}  // namespace boxbeam::spatial
