#include "stopped_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "sliding_joints.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The placement of the beam that this body is; the end where it is none.
auto member_on(int body, const std::vector<spatial::BeamPlacement>& beams) {
  return std::find_if(beams.begin(), beams.end(),
                      [&](const spatial::BeamPlacement& of) { return of.body == body; });
}

/// How the bodies of a stopped mechanism are tied to each other, in beam axes.
class StoppedTies {
 public:
  StoppedTies(const spatial::Mechanism& mechanism, const spatial::State& state,
              const std::vector<spatial::BeamPlacement>& beams, const GivingWay& giving,
              const std::vector<spatial::Wrench>& wrenches)
      : mechanism_(&mechanism), state_(&state), giving_(&giving), wrenches_(&wrenches) {
    const spatial::BeamPlacement& first = beams.front();
    const spatial::BodyMotion& own = state.bodies[static_cast<std::size_t>(first.body)];
    start_ = own.position + own.R_WB * first.start;
    R_BW_ = (own.R_WB * first.axes).transpose();
    int next = static_cast<int>(beams.size());
    for (std::size_t i = 0; i < mechanism_->bodies.size(); ++i) {
      const auto beam = member_on(static_cast<int>(i), beams);
      if (beam != beams.end()) {
        member_.push_back(static_cast<int>(beam - beams.begin()));
        continue;
      }
      member_.push_back(next++);
      const spatial::Body& body = mechanism_->bodies[i];
      const Matrix3d R = R_BW_ * state.bodies[i].R_WB;
      bodies.push_back({body.mass,
                        in_beam(spatial::position_of(state, {static_cast<int>(i), body.centre})),
                        R * body.inertia * R.transpose()});
    }
    for (std::size_t i = 0; i < mechanism_->joints.size(); ++i) add_joint(i);
    for (std::size_t k = 0; k < mechanism_->closing.size(); ++k) add_closing(k);
    for (const spatial::Spring& spring : mechanism_->springs) add_spring(spring);
    for (const spatial::TorsionSpring& spring : mechanism_->torsion_springs) add_spring(spring);
  }

  std::vector<frame::RigidMass> bodies;
  std::vector<frame::Tie> ties, contacts;

 private:
  static frame::Vector6 force(const Vector3d& along) {
    frame::Vector6 of = frame::Vector6::Zero();
    of.head<3>() = along;
    return of;
  }
  static frame::Vector6 couple(const Vector3d& about) {
    frame::Vector6 of = frame::Vector6::Zero();
    of.tail<3>() = about;
    return of;
  }

  Vector3d in_beam(const Vector3d& world) const { return R_BW_ * (world - start_); }
  Vector3d turned(int axes, const Vector3d& vector) const {
    return R_BW_ * spatial::in_world(*state_, axes, vector);
  }
  int member_of(int body) const {
    return body == spatial::ground ? frame::ground : member_[static_cast<std::size_t>(body)];
  }
  frame::Tie::End end(int body, const Vector3d& at, const frame::Vector6& per) const {
    return {{member_of(body), at}, per};
  }

  frame::Tie& new_tie() {
    frame::Tie& of = ties.emplace_back();
    of.name = name_;
    return of;
  }
  /// b against a at one place of both.
  frame::Tie& tie(int a, int b, const Vector3d& at, const frame::Vector6& per) {
    frame::Tie& of = new_tie();
    of.ends = {end(a, at, -per), end(b, at, per)};
    of.ends.front().slides = slides_;
    return of;
  }
  /// The same of the joint that is being tied, which may give way there.
  void tie(int a, int b, const Vector3d& at, const frame::Vector6& per, const Give& give) {
    give_way(tie(a, b, at, per), give);
  }
  void give_way(frame::Tie& of, const Give& give) const {
    if (std::isinf(give.stiffness)) return;
    of.stiffness = give.stiffness;
    of.damping = give.damping;
    const spatial::Wrench& on_b = (*wrenches_)[wrench_];
    const frame::Vector6& per = of.ends.back().per;
    // In a thread the couple follows from the force.
    of.rigid = of.way() == 0 ? -(R_BW_ * on_b.force).dot(per.head<3>())
                             : -(R_BW_ * on_b.moment).dot(per.tail<3>());
  }

  void hold_across(int a, int b, const Vector3d& at, const Vector3d& axis, const Give& give) {
    const Vector3d u = axis.unitOrthogonal();
    tie(a, b, at, force(u), give);
    tie(a, b, at, force(axis.cross(u)), give);
  }
  /// About the first of two directions across the axis and about the other.
  void hold_tilt(int a, int b, const Vector3d& at, const Vector3d& axis, const Vector3d& first,
                 const WaysToGive& ways) {
    tie(a, b, at, couple(first), ways.first_tilt);
    tie(a, b, at, couple(axis.cross(first)), ways.second_tilt);
  }
  /// A thread advances by so much a radian.
  void hold_thread(int a, int b, const Vector3d& at, const Vector3d& axis, double pitch,
                   const Give& give) {
    tie(a, b, at, force(axis) - pitch * couple(axis), give);
  }
  Vector3d first_across(const spatial::Joint& of, const Vector3d& axis) const {
    const auto before = axis_across(*mechanism_, *state_, of);
    return before ? Vector3d(R_BW_ * *before) : axis.unitOrthogonal();
  }

  void add_joint(std::size_t i) {
    const spatial::Joint& of = mechanism_->joints[i];
    name_ = of.name;
    slides_ = slides_along(of.kind);
    const int a = of.parent, b = static_cast<int>(i);
    const Vector3d at = in_beam(spatial::position_of(*state_, {b, of.point}));
    const Vector3d axis = turned(of.parent, of.axis);
    const WaysToGive ways = giving_->of(of);
    wrench_ = i;
    hold_across(a, b, at, axis, ways.across);
    hold_tilt(a, b, at, axis, first_across(of, axis), ways);
    const bool moves = of.kind != spatial::JointKind::fixed && !spatial::is_driven(of);
    if (!moves) {
      tie(a, b, at, force(axis), ways.along);
      tie(a, b, at, couple(axis), ways.about);
      return;
    }
    switch (of.kind) {
      case spatial::JointKind::fixed: break;
      case spatial::JointKind::revolute: tie(a, b, at, force(axis), ways.along); break;
      case spatial::JointKind::prismatic: tie(a, b, at, couple(axis), ways.about); break;
      case spatial::JointKind::screw:
        hold_thread(a, b, at, axis, spatial::pitch_of(of.lead), ways.along);
        break;
    }
  }

  void add_closing(std::size_t k) {
    using Kind = spatial::ClosingKind;
    const spatial::ClosingJoint& of = mechanism_->closing[k];
    name_ = of.name;
    slides_ = slides_along(of.kind);
    wrench_ = mechanism_->joints.size() + k;
    const int a = of.a.body, b = of.b.body;
    if (spatial::has_teeth(of.kind)) {
      add_mesh(of.mesh);
      return;
    }
    const Vector3d at = in_beam(spatial::position_of(*state_, of.b));
    const Vector3d axis = turned(a, of.axis);
    const double length =
        (spatial::position_of(*state_, of.b) - spatial::position_of(*state_, of.a)).norm();
    const WaysToGive ways = giving_->of(of, length);
    const auto across = [&] { hold_across(a, b, at, axis, ways.across); };
    const auto tilt = [&] { hold_tilt(a, b, at, axis, axis.unitOrthogonal(), ways); };
    const auto along = [&] { tie(a, b, at, force(axis), ways.along); };
    const auto about = [&] { tie(a, b, at, couple(axis), ways.about); };
    switch (of.kind) {
      case Kind::fixed:
        across();
        tilt();
        along();
        about();
        break;
      case Kind::revolute:
        across();
        tilt();
        along();
        break;
      case Kind::prismatic:
        across();
        tilt();
        about();
        break;
      case Kind::cylindrical:
        across();
        tilt();
        break;
      case Kind::universal:
        across();
        along();
        tie(a, b, at, couple(axis.cross(turned(b, of.other)).normalized()), ways.second_tilt);
        break;
      case Kind::spherical:
        across();
        along();
        break;
      case Kind::planar:
        along();
        tilt();
        break;
      case Kind::slot: across(); break;
      case Kind::distance: give_way(along_line(of.a, of.b), ways.along); break;
      case Kind::screw:
        across();
        tilt();
        hold_thread(a, b, at, axis, spatial::pitch_of(of.lead), ways.along);
        break;
      case Kind::gear:
      case Kind::rack: break;
    }
  }

  /// The sum of factor q of the coordinates that teeth tie.
  void add_mesh(const spatial::Mesh& mesh) {
    frame::Tie& of = new_tie();
    for (const spatial::Mesh::Part& part : mesh.parts) {
      const spatial::Joint& joint = mechanism_->joints[part.joint];
      const int body = static_cast<int>(part.joint);
      const Vector3d at = in_beam(spatial::position_of(*state_, {body, joint.point}));
      const Vector3d axis = part.factor * turned(joint.parent, joint.axis);
      const frame::Vector6 per = spatial::is_angle(joint.kind) ? couple(axis) : force(axis);
      of.ends.push_back(end(body, at, per));
      of.ends.push_back(end(joint.parent, at, -per));
    }
  }

  frame::Tie& along_line(const spatial::Attachment& a, const spatial::Attachment& b) {
    const Vector3d from = in_beam(spatial::position_of(*state_, a)),
                   to = in_beam(spatial::position_of(*state_, b));
    const Vector3d along = (to - from).normalized();
    frame::Tie& of = new_tie();
    of.ends = {end(a.body, from, force(-along)), end(b.body, to, force(along))};
    return of;
  }

  void add_spring(const spatial::Spring& spring) {
    name_ = spring.name;
    frame::Tie& of = along_line(spring.a, spring.b);
    if (begins_at_length(law_of(spring))) contacts.push_back(of);
    if (!spatial::acts(spring, *state_)) {
      ties.pop_back();
      return;
    }
    const double length =
        (spatial::position_of(*state_, spring.b) - spatial::position_of(*state_, spring.a)).norm();
    of.stiffness = stiffness_at(law_of(spring), length);
    of.damping = spring.damping;
  }

  void add_spring(const spatial::TorsionSpring& spring) {
    const spatial::Joint& joint = mechanism_->joints[static_cast<std::size_t>(spring.joint)];
    if (spatial::is_driven(joint)) return;
    name_ = spring.name;
    slides_ = slides_along(joint.kind);
    const Vector3d at = in_beam(spatial::position_of(*state_, {spring.joint, joint.point}));
    frame::Tie& of = tie(joint.parent, spring.joint, at, couple(turned(joint.parent, joint.axis)));
    of.stiffness = spring.stiffness;
    of.damping = spring.damping;
  }

  const spatial::Mechanism* mechanism_;
  const spatial::State* state_;
  const GivingWay* giving_;
  const std::vector<spatial::Wrench>* wrenches_;
  std::size_t wrench_ = 0;  ///< of the joint that is being tied
  Vector3d start_;
  Matrix3d R_BW_;
  std::vector<int> member_;
  std::string_view name_;  ///< of what is being tied
  bool slides_ = false;    ///< whether it does along its first body
};

}  // namespace

std::optional<Vector3d> axis_across(const spatial::Mechanism& mechanism,
                                    const spatial::State& state, const spatial::Joint& joint) {
  if (joint.parent == spatial::ground) return std::nullopt;
  const spatial::Joint& before = mechanism.joints[static_cast<std::size_t>(joint.parent)];
  const Vector3d axis = spatial::in_world(state, joint.parent, joint.axis),
                 other = spatial::in_world(state, before.parent, before.axis);
  constexpr double square = 1e-9;
  return std::abs(axis.dot(other)) < square ? std::optional(other) : std::nullopt;
}

std::vector<spatial::BeamPlacement> elastic_placements(const Project& project,
                                                       const spatial::Mechanism& mechanism) {
  std::vector<spatial::BeamPlacement> placements;
  for (const ElasticMember& member : elastic_members(project, mechanism))
    placements.push_back(member.placement);
  return placements;
}

StoppedScene stopped_scene(const spatial::Mechanism& mechanism, const spatial::State& state,
                           const std::vector<spatial::BeamPlacement>& members,
                           const GivingWay& giving, const std::vector<spatial::Wrench>& wrenches) {
  StoppedTies of(mechanism, state, members, giving, wrenches);
  return {std::move(of.bodies), std::move(of.ties), std::move(of.contacts)};
}

std::vector<bool> resting_bodies(const spatial::Mechanism& mechanism,
                                 const std::vector<spatial::BeamPlacement>& beams,
                                 const GivingWay& giving) {
  std::vector<bool> resting;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    const bool carried =
        joint.parent == spatial::ground || resting[static_cast<std::size_t>(joint.parent)];
    const bool held = joint.kind == spatial::JointKind::fixed || spatial::is_driven(joint);
    resting.push_back(carried && held && !spatial::is_forced(joint) &&
                      !gives_way(giving.of(joint)) &&
                      member_on(static_cast<int>(i), beams) == beams.end());
  }
  return resting;
}

std::vector<int> members_of_scene(const std::vector<bool>& resting,
                                  const std::vector<spatial::BeamPlacement>& beams) {
  std::vector<int> members;
  auto next = static_cast<int>(beams.size());
  for (std::size_t i = 0; i < resting.size(); ++i) {
    const auto beam = member_on(static_cast<int>(i), beams);
    if (beam != beams.end())
      members.push_back(static_cast<int>(beam - beams.begin()));
    else
      members.push_back(resting[i] ? frame::ground : next++);
  }
  return members;
}

void leave_out_resting(const std::vector<int>& members, std::size_t beams, StoppedScene& scene) {
  std::vector<int> member;  // of each body of the scene
  std::vector<frame::RigidMass> moving;
  const auto count = static_cast<int>(beams);
  for (const int of : members) {
    if (of != frame::ground && of < count) continue;
    if (of != frame::ground) moving.push_back(scene.bodies[member.size()]);
    member.push_back(of);
  }
  scene.bodies = std::move(moving);
  for (std::vector<frame::Tie>* const all : {&scene.ties, &scene.contacts}) {
    for (frame::Tie& tie : *all)
      for (frame::Tie::End& end : tie.ends)
        if (end.at.member >= count)
          end.at.member = member[static_cast<std::size_t>(end.at.member - count)];
  }
  std::erase_if(scene.ties, [](const frame::Tie& tie) {
    return std::all_of(tie.ends.begin(), tie.ends.end(),
                       [](const frame::Tie::End& end) { return end.at.member == frame::ground; });
  });
}

}  // namespace boxbeam
