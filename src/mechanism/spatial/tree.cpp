#include "boxbeam/mechanism/spatial/tree.hpp"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>

namespace boxbeam::spatial {
namespace {

const BodyMotion& world() {
  static const BodyMotion at_rest{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                                  Eigen::Vector3d::Zero(),     Eigen::Vector3d::Zero(),
                                  Eigen::Vector3d::Zero(),     Eigen::Vector3d::Zero(),
                                  Eigen::Vector3d::Zero()};
  return at_rest;
}

/// What a body's turning adds to the acceleration of its origin at a point, r from there in world
/// axes.
inline Eigen::Vector3d turning_acceleration(const BodyMotion& body, const Eigen::Vector3d& r) {
  return body.alpha.cross(r) + body.omega.cross(body.omega.cross(r));
}

/// Rate of change of the angular momentum about the centre of mass, world axes.
inline Eigen::Vector3d spin_change(const Body& body, const BodyMotion& motion) {
  const Eigen::Vector3d omega = motion.R_WB.transpose() * motion.omega;
  const Eigen::Vector3d alpha = motion.R_WB.transpose() * motion.alpha;
  return motion.R_WB * (body.inertia * alpha + omega.cross(body.inertia * omega));
}

}  // namespace

const BodyMotion& motion_of(const State& state, int body) {
  return body == ground ? world() : state.bodies[static_cast<std::size_t>(body)];
}

Tree::Tree(const Mechanism& mechanism) : mechanism_(&mechanism) {
  assert(mechanism.joints.size() == mechanism.bodies.size());
  for (const Joint& joint : mechanism.joints) {
    assert(joint.parent < static_cast<int>(links_.size()));
    Link link{joint.turn,
              Eigen::Matrix3d::Zero(),
              Eigen::Matrix3d::Zero(),
              joint.at,
              joint.axis,
              joint.point,
              joint.kind == JointKind::prismatic ? 1.0 : pitch_of(joint.lead),
              joint.parent,
              is_angle(joint.kind),
              !joint.point.isZero(0.0)};
    if (is_angle(joint.kind)) {
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
  for ([[maybe_unused]] const AppliedLoad& load : mechanism.loads) assert(load.on != ground);
  for ([[maybe_unused]] const LineForce& line : mechanism.line_forces) assert(line.on != ground);
}

void Tree::drive(State& state, double time) const {
  state.time = time;
  state.coordinates.resize(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Joint& joint = mechanism_->joints[i];
    if (is_driven(joint)) state.coordinates[i] = driver_at(joint.driver, time);
  }
}

void Tree::begin(State& state) const {
  drive(state, 0.0);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Joint& joint = mechanism_->joints[i];
    if (is_forced(joint)) state.coordinates[i] = {joint.start, joint.start_rate, 0.0};
  }
}

template <bool positions, bool velocities, bool accelerations>
void Tree::move_outwards(State& state) const {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const BodyMotion& parent = motion_of(state, link.parent);
    BodyMotion& body = state.bodies[i];
    const DriverState& q = state.coordinates[i];
    const Eigen::Vector3d axis = parent.R_WB * link.axis;
    Eigen::Vector3d arm = parent.R_WB * link.at;
    if (link.advance != 0.0) arm += link.advance * q.value * axis;
    if constexpr (positions) {
      body.position = body.joint = parent.position + arm;
      if (link.turns)
        body.R_WB = parent.R_WB * (link.fixed + std::cos(q.value) * link.along_cosine +
                                   std::sin(q.value) * link.along_sine);
      else
        body.R_WB = parent.R_WB * link.fixed;
    }
    const Eigen::Vector3d u = q.rate * axis;
    if constexpr (velocities) {
      body.omega = parent.omega;
      if (link.turns) body.omega += u;
      body.velocity = parent.velocity + parent.omega.cross(arm);
      if (link.advance != 0.0) body.velocity += link.advance * u;
    }
    if constexpr (accelerations) {
      body.alpha = parent.alpha;
      if (link.turns) body.alpha += q.acceleration * axis + parent.omega.cross(u);
      body.acceleration = parent.acceleration + turning_acceleration(parent, arm);
      if (link.advance != 0.0)
        body.acceleration +=
            link.advance * q.acceleration * axis + 2.0 * parent.omega.cross(link.advance * u);
    }
    // From the joint to the body's own origin.
    if (!link.shifted) continue;
    const Eigen::Vector3d back = -(body.R_WB * link.point);
    if constexpr (positions) body.position += back;
    if constexpr (velocities) body.velocity += body.omega.cross(back);
    if constexpr (accelerations) body.acceleration += turning_acceleration(body, back);
  }
}

void Tree::move(State& state) const {
  state.bodies.resize(links_.size());
  move_outwards<true, true, true>(state);
}

void Tree::place(State& state) const {
  if (state.bodies.size() != links_.size()) state.bodies.assign(links_.size(), world());
  move_outwards<true, false, false>(state);
}

void Tree::move_at_rates(State& state) const { move_outwards<false, true, false>(state); }

void Tree::accelerate(State& state) const { move_outwards<false, false, true>(state); }

// Cost of a body: about 240 additions and multiplications for its motion and 200 for its forces, on
// 0.8 kB, beside a sine and a cosine: 20 ns at the peak of SSE2, twice that in single numbers, for
// vectors of three do not fill pairs.
void Tree::wrenches(const State& state, std::span<const BodyWrench> others,
                    std::vector<Wrench>& joints) const {
  const Mechanism& mechanism = *mechanism_;
  // First what the loads leave to the joints, about the origin of the body that feels them.
  joints.assign(links_.size(), Wrench{});
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
  const auto act = [&](int on, const Eigen::Vector3d& place, const Wrench& wrench) {
    if (on == ground) return;
    Wrench& needed = joints[static_cast<std::size_t>(on)];
    needed.force -= wrench.force;
    needed.moment -= wrench.moment + (place - motion_of(state, on).position).cross(wrench.force);
  };
  for (std::size_t i = 0; i < mechanism.springs.size(); ++i) {
    const Spring& spring = mechanism.springs[i];
    const Eigen::Vector3d force = force_of(mechanism, i, state);
    act(spring.b.body, position_of(state, spring.b), {force, Eigen::Vector3d::Zero()});
    act(spring.a.body, position_of(state, spring.a), {-force, Eigen::Vector3d::Zero()});
  }
  for (const TorsionSpring& spring : mechanism.torsion_springs) {
    const Eigen::Vector3d couple = couple_of(mechanism, spring, state);
    const int parent = mechanism.joints[static_cast<std::size_t>(spring.joint)].parent;
    joints[static_cast<std::size_t>(spring.joint)].moment -= couple;
    if (parent != ground) joints[static_cast<std::size_t>(parent)].moment += couple;
  }
  for (const BodyWrench& other : others) act(other.on, other.place, other.wrench);
  // Then inwards: each joint gives also what its body's motion needs, and passes on what the joints
  // beyond take.
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Body& body = mechanism.bodies[i];
    const BodyMotion& motion = state.bodies[i];
    Wrench& wrench = joints[i];
    if (body.mass != 0.0) {
      const Eigen::Vector3d centre = motion.R_WB * body.centre;
      const Eigen::Vector3d acceleration =
          motion.acceleration + turning_acceleration(motion, centre);
      const Eigen::Vector3d force = body.mass * (acceleration - mechanism.gravity);
      wrench.force += force;
      wrench.moment += spin_change(body, motion) + centre.cross(force);
    }
    if (links_[i].shifted) wrench.moment -= (motion.joint - motion.position).cross(wrench.force);
    if (links_[i].parent == ground) continue;
    const auto carrier = static_cast<std::size_t>(links_[i].parent);
    const Eigen::Vector3d arm = motion.joint - state.bodies[carrier].position;
    joints[carrier].force += wrench.force;
    joints[carrier].moment += wrench.moment + arm.cross(wrench.force);
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
  return body.acceleration + turning_acceleration(body, body.R_WB * at.p);
}

Tension tension_of(const Spring& spring, const State& state) {
  const Eigen::Vector3d d = position_of(state, spring.b) - position_of(state, spring.a);
  const double length = d.norm();
  const Eigen::Vector3d v = velocity_of(state, spring.b) - velocity_of(state, spring.a);
  if (length == 0.0) return {-spring.stiffness * spring.free_length, 0.0};
  const double rate = d.dot(v) / length;
  const Eigen::Vector3d a = acceleration_of(state, spring.b) - acceleration_of(state, spring.a);
  const double second = (v.squaredNorm() + d.dot(a) - rate * rate) / length;
  return {spring.stiffness * (length - spring.free_length) + spring.damping * rate,
          spring.stiffness * rate + spring.damping * second};
}

Eigen::Vector3d force_of(const Mechanism& mechanism, std::size_t i, const State& state) {
  const Spring& spring = mechanism.springs[i];
  const Eigen::Vector3d d = position_of(state, spring.b) - position_of(state, spring.a);
  const double length = d.norm();
  // Without a length it has no direction; nor has what it does one.
  if (length == 0.0) return Eigen::Vector3d::Zero();
  if (!acts(spring, state)) return Eigen::Vector3d::Zero();
  double tension = 0.0;
  if (spring.impact) {
    const Eigen::Vector3d v = velocity_of(state, spring.b) - velocity_of(state, spring.a);
    Touch touch = state.touches.empty() ? Touch{} : state.touches[i];
    touch.on = true;
    tension = boxbeam::tension_of(law_of(spring), length, d.dot(v) / length, touch);
  } else {
    tension = tension_of(spring, state).value;
  }
  return -tension / length * d;
}

double along_coordinate(const Joint& joint, const Eigen::Vector3d& axis, const Wrench& wrench) {
  switch (joint.kind) {
    case JointKind::fixed: return 0.0;
    case JointKind::revolute: return axis.dot(wrench.moment);
    case JointKind::prismatic: return axis.dot(wrench.force);
    case JointKind::screw:
      return axis.dot(wrench.moment) + pitch_of(joint.lead) * axis.dot(wrench.force);
  }
  return 0.0;
}

namespace {

/// Whether a spring has a length at which it begins to act, besides its tension: without damping
/// both are the same, and a damper without a free length has none.
bool begins_at_length(const Spring& spring) {
  return spring.damping != 0.0 && (spring.stiffness != 0.0 || spring.free_length != 0.0);
}

}  // namespace

std::vector<Spring> switches_of(const Spring& spring) {
  if (spring.acts == Spring::Acts::both) return {};
  std::vector<Spring> switches{spring};
  if (!begins_at_length(spring)) return switches;
  Spring& longer = switches.emplace_back(spring);
  longer.stiffness = 1.0;
  longer.damping = 0.0;
  return switches;
}

bool acts(const Spring& spring, const State& state) {
  if (spring.acts == Spring::Acts::both) return true;
  const double sign = spring.acts == Spring::Acts::pushing ? -1.0 : 1.0;
  if (!(sign * tension_of(spring, state).value > 0.0)) return false;
  if (!begins_at_length(spring)) return true;
  const double length = (position_of(state, spring.b) - position_of(state, spring.a)).norm();
  return sign * (length - spring.free_length) > 0.0;
}

Eigen::Vector3d couple_of(const Mechanism& mechanism, const TorsionSpring& spring,
                          const State& state) {
  const auto i = static_cast<std::size_t>(spring.joint);
  const Joint& joint = mechanism.joints[i];
  const DriverState& q = state.coordinates[i];
  return -(spring.stiffness * (q.value - spring.free_angle) + spring.damping * q.rate) *
         in_world(state, joint.parent, joint.axis);
}

Eigen::Vector3d in_world(const State& state, int axes, const Eigen::Vector3d& vector) {
  return axes == ground ? vector : motion_of(state, axes).R_WB * vector;
}

Eigen::Vector3d in_axes(const State& state, int axes, const Eigen::Vector3d& vector) {
  return axes == ground ? vector : motion_of(state, axes).R_WB.transpose() * vector;
}

}  // namespace boxbeam::spatial
