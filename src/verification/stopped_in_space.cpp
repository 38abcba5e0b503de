#include "stopped_in_space.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/frame/statics.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "even_beam.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Other bodies and joints beside the beams.
constexpr double stiffer = 1e4;

/// The frame that a stopped mechanism is, and what presses its members.
class StoppedFrame {
 public:
  StoppedFrame(const Project& project, const spatial::Chain& chain, const spatial::State& state,
               StoppedProfiles& known)
      : project_(&project),
        known_(&known),
        chain_(&chain),
        mechanism_(&chain.mechanism()),
        state_(&state),
        open_(spatial::open_state_of(*mechanism_)),
        giving_(project) {}

  /// Whether it can be made.
  bool make(const CutForceDiagram& diagram) {
    for (const spatial::Joint& joint : mechanism_->joints)
      if (spatial::is_forced(joint)) return false;  // forces move it
    find_places();
    member_of_.assign(mechanism_->bodies.size(), frame::ground);
    resting_ = resting_bodies(*mechanism_, elastic_placements(*project_, *mechanism_), giving_);
    const std::vector<ElasticMember> members = elastic_members(*project_, *mechanism_);
    for (const ElasticMember& member : members) add_stiffness(member);
    for (const ElasticMember& member : members) {
      const bool first = structure.members.empty();
      add_member(member, first ? diagram
                               : rigid_cut_forces(*chain_, *state_, member.body_in(*mechanism_),
                                                  wrenches()));
    }
    for (std::size_t i = 0; i < mechanism_->bodies.size(); ++i)
      if (member_of_[i] == frame::ground && !resting_[i]) add_body(static_cast<int>(i));
    for (std::size_t i = 0; i < mechanism_->joints.size(); ++i) add_joint(i);
    for (std::size_t k = 0; k < mechanism_->closing.size(); ++k) add_closing(k);
    for (std::size_t i = 0; i < mechanism_->springs.size(); ++i) add_spring(i);
    cut_what_bends();
    return true;
  }

  frame::Structure structure;
  std::vector<std::shared_ptr<const FlexibilityProfile>> profiles;  ///< of its first members
  frame::Equilibrium loaded;

 private:
  /// A rod that bows alone stretches, and is as stout as other bars.
  void add_member(const ElasticMember& of, const CutForceDiagram& diagram) {
    const auto body = static_cast<std::size_t>(of.placement.body);
    const Vector3d start = spatial::position_of(*state_, {of.placement.body, of.placement.start});
    const Matrix3d axes = state_->bodies[body].R_WB * of.placement.axes;
    const double length = of.beam->length().value();
    if (of.bows_alone) {
      const double area = properties_of(of.beam->segments.front().from).area.value();
      member_of_[body] =
          add_bar(start, start + length * axes.col(0), of.youngs_modulus * area / length);
      structure.members.back().axes = axes;
      loaded.members.back().cut = diagram;
      return;
    }
    member_of_[body] = static_cast<int>(structure.members.size());
    bending_.push_back(member_of_[body]);
    frame::Member& member = structure.members.emplace_back();
    member.name = "beam";
    member.beam = *of.beam;
    member.start = start;
    member.axes = axes;
    member.youngs_modulus = of.youngs_modulus;
    member.shear_modulus = of.shear_modulus;
    std::shared_ptr<const FlexibilityProfile>& profile = (*known_)[of.beam];
    if (!profile)
      profile =
          std::make_shared<const FlexibilityProfile>(*of.beam, of.youngs_modulus, of.shear_modulus);
    profiles.resize(structure.members.size());
    profiles.back() = profile;
    loaded.members.emplace_back().cut = diagram;
  }

  /// Of the stiffest place of a beam or rod, E A/L and E I/L.
  void add_stiffness(const ElasticMember& member) {
    const double length = member.beam->length().value();
    for (const Segment& segment : member.beam->segments) {
      for (const Section& section : {segment.from, segment.to}) {
        const SectionProperties of = properties_of(section);
        const double E = member.youngs_modulus;
        along_ = std::max(along_, E * of.area.value() / length);
        about_ = std::max(about_, E * of.I_1.value() / length);
      }
    }
  }

  /// A bar between two places of the world, so much stiffer than the beams; its index.
  int add_bar(const Vector3d& from, const Vector3d& to, double stiffness_along) {
    const double length = (to - from).norm();
    frame::Member& bar = structure.members.emplace_back();
    bar.name = "bar";
    bar.start = from;
    bar.axes.col(0) = (to - from) / length;
    bar.axes.col(1) = bar.axes.col(0).unitOrthogonal();
    bar.axes.col(2) = bar.axes.col(0).cross(bar.axes.col(1));
    bar.beam.segments = {{"", {}, si<Length>(length), bar_section(length), bar_section(length)}};
    const double area = properties_of(bar_section(length)).area.value();
    bar.youngs_modulus = stiffness_along * length / area;
    bar.shear_modulus = bar.youngs_modulus / 2.6;
    loaded.members.emplace_back();
    return static_cast<int>(structure.members.size()) - 1;
  }

  /// As stout as a bar is whose bending does not count beside its length.
  static Section bar_section(double length) {
    return {Plate{si<Length>(0.5 * length), si<Length>(0.5 * length)}, {}};
  }

  /// Of so stout a bar E I/L is E A/L times its square over 48: so both are stiffer than the
  /// beam's.
  double stiff_bar(double length) const {
    return stiffer * std::max(along_, 48.0 * about_ / (length * length));
  }

  /// Of what slides where it is now: all that takes hold of a body lies along its bar.
  void find_places() {
    places_.resize(mechanism_->bodies.size());
    const auto add = [&](int body, const spatial::Attachment& place) {
      if (body == spatial::ground) return;
      const spatial::BodyMotion& of = state_->bodies[static_cast<std::size_t>(body)];
      places_[static_cast<std::size_t>(body)].push_back(
          of.R_WB.transpose() * (spatial::position_of(*state_, place) - of.position));
    };
    for (int i = 0; const spatial::Joint& joint : mechanism_->joints) {
      for (const int body : {i, joint.parent}) add(body, {i, joint.point});
      ++i;
    }
    for (const spatial::ClosingJoint& joint : mechanism_->closing) {
      if (spatial::has_teeth(joint.kind)) continue;
      for (const spatial::Attachment& end : {joint.a, joint.b}) add(end.body, end);
      if (joint.kind != spatial::ClosingKind::distance) add(joint.a.body, joint.b);
    }
    for (const spatial::Spring& spring : mechanism_->springs)
      for (const spatial::Attachment& end : {spring.a, spring.b}) add(end.body, end);
  }

  void add_body(int body) {
    const std::vector<Vector3d>& places = places_[static_cast<std::size_t>(body)];
    Vector3d from = places.front(), to = from;
    for (const Vector3d& a : places) {
      for (const Vector3d& b : places)
        if ((b - a).norm() > (to - from).norm()) from = a, to = b;
    }
    const double least = 1e-3 * project_->beam.length().value();
    if (!((to - from).norm() > least)) to = from + least * Vector3d::UnitX();
    EvenBeam& even = bodies_.emplace_back();
    even.set(*mechanism_, open_, body, from, to, bar_section((to - from).norm()));
    member_of_[static_cast<std::size_t>(body)] =
        add_bar(spatial::position_of(*state_, {body, from}),
                spatial::position_of(*state_, {body, to}), stiff_bar((to - from).norm()));
    // As the loads on it have them.
    structure.members.back().axes =
        state_->bodies[static_cast<std::size_t>(body)].R_WB * even.body.placement.axes;
    loaded.members.back().cut =
        cut_forces_of(spatial::beam_loads_of(*chain_, *state_, even.body, wrenches()));
  }

  bool is_ground(int body) const {
    return body == spatial::ground || resting_[static_cast<std::size_t>(body)];
  }
  /// A place of the world on a body, or on the ground.
  frame::Place place_on(int body, const Vector3d& at) const {
    if (is_ground(body)) return {frame::ground, at};
    return on_member(member_of_[static_cast<std::size_t>(body)], at);
  }
  frame::Place on_member(int member, const Vector3d& at) const {
    const frame::Member& of = structure.members[static_cast<std::size_t>(member)];
    Vector3d p = of.axes.transpose() * (at - of.start);
    p.x() = std::clamp(p.x(), 0.0, of.beam.length().value());
    return {member, p};
  }

  /// All six held; the first three along, the others about the axes.
  std::array<double, 6> held() const {
    const double k = stiffer * along_, turning = stiffer * about_;
    return {k, k, k, turning, turning, turning};
  }

  /// Where the joint gives way it is as stiff as it says: in series with what is held.
  std::array<double, 6> held(const WaysToGive& ways) const {
    std::array<double, 6> stiffness = held();
    const std::array<const Give*, 6> given{&ways.along, &ways.across,     &ways.across,
                                           &ways.about, &ways.first_tilt, &ways.second_tilt};
    for (std::size_t way = 0; way < 6; ++way)
      if (!std::isinf(given[way]->stiffness)) stiffness[way] = given[way]->stiffness;
    return stiffness;
  }

  static Matrix3d axes_with(const Vector3d& x) { return axes_with(x, x.unitOrthogonal()); }
  static Matrix3d axes_with(const Vector3d& x, const Vector3d& y) {
    Matrix3d axes;
    axes << x, y, x.cross(y);
    return axes;
  }

  /// A screw that loops move is free to turn and to slide, by itself either way: held by less than
  /// it is.
  void add_joint(std::size_t i) {
    const spatial::Joint& of = mechanism_->joints[i];
    const int body = static_cast<int>(i);
    if (is_ground(of.parent) && is_ground(body)) return;
    const Vector3d at = spatial::position_of(*state_, {body, of.point});
    frame::Joint& joint = structure.joints.emplace_back();
    joint.name = of.name;
    joint.a = place_on(of.parent, at);
    joint.b = place_on(body, at);
    const Vector3d axis = spatial::in_world(*state_, of.parent, of.axis);
    joint.axes =
        axes_with(axis, axis_across(*mechanism_, *state_, of).value_or(axis.unitOrthogonal()));
    joint.stiffness = held(giving_.of(of));
    if (!spatial::is_driven(of)) {
      switch (of.kind) {
        case spatial::JointKind::fixed: break;
        case spatial::JointKind::revolute: joint.stiffness[3] = 0.0; break;
        case spatial::JointKind::prismatic: joint.stiffness[0] = 0.0; break;
        case spatial::JointKind::screw: joint.stiffness[0] = joint.stiffness[3] = 0.0; break;
      }
    }
    for (const spatial::TorsionSpring& spring : mechanism_->torsion_springs)
      if (spring.joint == body && !spatial::is_driven(of)) joint.stiffness[3] += spring.stiffness;
  }

  void add_closing(std::size_t k) {
    using Kind = spatial::ClosingKind;
    const spatial::ClosingJoint& of = mechanism_->closing[k];
    if (is_ground(of.a.body) && is_ground(of.b.body)) return;
    const Vector3d at = spatial::position_of(*state_, spatial::place_of(of));
    if (of.kind == Kind::distance) {
      const Vector3d from = spatial::position_of(*state_, of.a);
      const double tension =
          -(at - from).normalized().dot(wrenches()[mechanism_->joints.size() + k].force);
      const double length = (at - from).norm(), given = giving_.of(of, length).along.stiffness;
      add_rod(of.name, of.a.body, of.b.body, from, at,
              std::isinf(given) ? stiff_bar(length) : given, tension);
      return;
    }
    frame::Joint& joint = structure.joints.emplace_back();
    joint.name = of.name;
    joint.a = place_on(of.a.body, at);
    joint.b = place_on(of.b.body, at);
    joint.axes = axes_with(spatial::in_world(*state_, of.a.body, of.axis));
    joint.stiffness = held(giving_.of(of, 0.0));
    const auto free = [&](std::initializer_list<std::size_t> ways) {
      for (const std::size_t way : ways) joint.stiffness[way] = 0.0;
    };
    switch (of.kind) {
      case Kind::fixed: break;
      case Kind::revolute: free({3}); break;
      case Kind::prismatic: free({0}); break;
      case Kind::cylindrical: free({0, 3}); break;
      case Kind::universal: {
        const Vector3d other = spatial::in_world(*state_, of.b.body, of.other);
        joint.axes.col(1) = other;
        joint.axes.col(2) = joint.axes.col(0).cross(other);
        free({3, 4});
        break;
      }
      case Kind::spherical: free({3, 4, 5}); break;
      case Kind::planar: free({1, 2, 3}); break;
      case Kind::slot: free({0, 3, 4, 5}); break;
      case Kind::distance: break;
      case Kind::screw: free({0, 3}); break;
      case Kind::gear:
      case Kind::rack:
        joint.axes = axes_with(spatial::in_world(*state_, of.mesh.at.body, of.mesh.along));
        free({1, 2, 3, 4, 5});
        break;
    }
  }

  /// A bar between two places on bodies that turns freely at both but about its own axis at one.
  void add_rod(const std::string& name, int a, int b, const Vector3d& from, const Vector3d& to,
               double stiffness, double tension) {
    const int bar = add_bar(from, to, stiffness);
    const Matrix3d axes = structure.members.back().axes;
    BeamLoads loads;
    const double length = (to - from).norm();
    loads.points.resize(2);
    loads.points[0].force.x() = -tension;
    loads.points[1].force.x() = tension;
    loads.points[1].s = si<Length>(length);
    loads.lines = unloaded_lines(structure.members.back().beam);
    loaded.members.back().cut = cut_forces_of(loads);
    const auto end = [&](int body, const Vector3d& at, bool turns) {
      frame::Joint& joint = structure.joints.emplace_back();
      joint.name = name;
      joint.a = place_on(body, at);
      joint.b = on_member(bar, at);
      joint.axes = axes;
      joint.stiffness = held();
      joint.stiffness[4] = joint.stiffness[5] = 0.0;
      if (turns) joint.stiffness[3] = 0.0;
    };
    end(a, from, false);
    end(b, to, true);
  }

  void add_spring(std::size_t i) {
    const spatial::Spring& spring = mechanism_->springs[i];
    if (is_ground(spring.a.body) && is_ground(spring.b.body)) return;
    const Vector3d from = spatial::position_of(*state_, spring.a),
                   to = spatial::position_of(*state_, spring.b);
    const double tension =
        -(to - from).normalized().dot(spatial::force_of(*mechanism_, i, *state_));
    // Slack cables and stops that are not touched hold nothing, nor do dampers, nor does what parts
    // again.
    if (tension == 0.0 || spring.impact || !(spring.stiffness > 0.0)) return;
    bending_.push_back(static_cast<int>(structure.members.size()));
    add_rod(spring.name, spring.a.body, spring.b.body, from, to, spring.stiffness, tension);
  }

  /// What is far stiffer than the beams stays straight between its joints: only what may bend is
  /// cut between them, by joints that hold nothing.
  void cut_what_bends() {
    constexpr int parts =
        4;  // of each stretch: N_cr is 0.8 % high of one fixed at both ends, else 0.05 %
    for (const int member : bending_) {
      const double length =
          structure.members[static_cast<std::size_t>(member)].beam.length().value();
      std::vector<double> held{0.0, length};
      for (const frame::Joint& joint : structure.joints)
        for (const frame::Place* at : {&joint.a, &joint.b})
          if (at->member == member) held.push_back(at->p.x());
      std::sort(held.begin(), held.end());
      for (std::size_t k = 1; k < held.size(); ++k) {
        if (held[k] - held[k - 1] < 1e-9 * length) continue;
        for (int part = 1; part < parts; ++part) {
          const double s = held[k - 1] + (held[k] - held[k - 1]) * part / parts;
          structure.joints.emplace_back().b = {member, {s, 0.0, 0.0}};
        }
      }
    }
  }

  const std::vector<spatial::Wrench>& wrenches() {
    if (wrenches_.empty()) chain_->joint_wrenches(*state_, wrenches_);
    return wrenches_;
  }

  const Project* project_;
  StoppedProfiles* known_;
  const spatial::Chain* chain_;
  const spatial::Mechanism* mechanism_;
  const spatial::State* state_;
  spatial::State open_;
  GivingWay giving_;
  double along_ = 0.0, about_ = 0.0;           ///< largest E A/L, E I/L of the beams [N/m, N m]
  std::vector<int> member_of_;                 ///< of each body that does not rest
  std::vector<int> bending_;                   ///< members that are not far stiffer than the beams
  std::vector<bool> resting_;                  ///< bodies that are as the ground
  std::vector<std::vector<Vector3d>> places_;  ///< on each body where others are joined
  std::deque<EvenBeam> bodies_;
  std::vector<spatial::Wrench> wrenches_;
};

}  // namespace

std::optional<double> critical_factor_in_space(const Project& project, const spatial::Chain& chain,
                                               const spatial::State& state,
                                               const CutForceDiagram& diagram, double most,
                                               StoppedProfiles& profiles) {
  try {
    StoppedFrame frame(project, chain, state, profiles);
    if (!frame.make(diagram)) return {};
    const frame::Statics statics(frame.structure, 1, frame.profiles);
    return statics.critical_factor(statics.axial_forces(frame.loaded), most);
  } catch (const AnalysisError&) {
    return {};  // it is free to move, or a torsion constant is not known
  }
}

}  // namespace boxbeam
