#include "bent_in_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "boxbeam/core/error.hpp"
#include "boxbeam/numerics/exact_memo.hpp"
#include "boxbeam/section/torsion.hpp"
#include "elastic_motion_in_space.hpp"
#include "members_in_space.hpp"
#include "sliding_joints.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// What stands on the members of a stopped scene, in its axes: the forces of joints, springs and
/// loads that keep their direction while bodies turn, and rods and springs as lines. Those in the
/// axes of a body that turns are left out. `members`: as of `members_of_scene`.
class StoppedStress {
 public:
  StoppedStress(const spatial::Chain& chain, const spatial::State& state,
                const spatial::BeamPlacement& first, const std::vector<int>& members)
      : mechanism_(&chain.mechanism()), state_(&state), member_(members) {
    const spatial::BodyMotion& own = state.bodies[static_cast<std::size_t>(first.body)];
    start_ = own.position + own.R_WB * first.start;
    R_BW_ = (own.R_WB * first.axes).transpose();
    const std::vector<spatial::Wrench> wrenches = chain.joint_wrenches(state);
    for (std::size_t i = 0; i < mechanism_->joints.size(); ++i) {
      const spatial::Joint& joint = mechanism_->joints[i];
      const int body = static_cast<int>(i);
      push(joint.parent, body, position({body, joint.point}), wrenches[i].force);
    }
    for (std::size_t k = 0; k < mechanism_->closing.size(); ++k)
      add_closing(mechanism_->closing[k], wrenches[mechanism_->joints.size() + k].force);
    for (std::size_t i = 0; i < mechanism_->springs.size(); ++i) {
      const spatial::Spring& spring = mechanism_->springs[i];
      if (spatial::acts(spring, state))
        add_line(spring.a, spring.b, spatial::force_of(*mechanism_, i, state));
    }
    for (const spatial::AppliedLoad& load : mechanism_->loads) {
      if (load.kind != spatial::LoadKind::force || load.axes != spatial::ground) continue;
      if (load.on == spatial::ground || load.at.body != load.on) continue;
      add(load.on, position(load.at), driver_at(load.size, state.time).value * load.direction);
    }
  }

  frame::SceneStress stress;

 private:
  Vector3d position(const spatial::Attachment& at) const {
    return spatial::position_of(*state_, at);
  }
  frame::Place place(int body, const Vector3d& world) const {
    return {body == spatial::ground ? frame::ground : member_[static_cast<std::size_t>(body)],
            R_BW_ * (world - start_)};
  }

  /// A force on a body, in the world.
  void add(int body, const Vector3d& at, const Vector3d& force) {
    if (body != spatial::ground) stress.forces.push_back({place(body, at), R_BW_ * force});
  }
  /// A force on b, and the opposite on a.
  void push(int a, int b, const Vector3d& at, const Vector3d& force) {
    add(a, at, -force);
    add(b, at, force);
  }

  /// `force`: on b.
  void add_line(const spatial::Attachment& a, const spatial::Attachment& b, const Vector3d& force) {
    const Vector3d from = position(a), to = position(b);
    stress.lines.push_back(
        {place(a.body, from), place(b.body, to), -(to - from).normalized().dot(force)});
    add(a.body, from, -force);
    add(b.body, to, force);
  }

  void add_closing(const spatial::ClosingJoint& joint, const Vector3d& force) {
    using Kind = spatial::ClosingKind;
    switch (joint.kind) {
      case Kind::distance: add_line(joint.a, joint.b, force); break;
      case Kind::fixed:
      case Kind::revolute:
      case Kind::prismatic:
      case Kind::cylindrical:
      case Kind::universal:
      case Kind::spherical:
      case Kind::planar:
      case Kind::slot:
      case Kind::screw:
      case Kind::gear:
      case Kind::rack:
        push(joint.a.body, joint.b.body, position(spatial::place_of(joint)), force);
        break;
    }
  }

  const spatial::Mechanism* mechanism_;
  const spatial::State* state_;
  Vector3d start_;
  Matrix3d R_BW_;
  std::vector<int> member_;  ///< of each body
};

/// Whether none of its sections is open, which warps.
bool is_closed(const TaperedBeam& beam) {
  const auto open = [](const Section& section) {
    return std::holds_alternative<ThinWalled>(section.outer) &&
           !(enclosed_area_of(section.outer).value() > 0.0);
  };
  return std::none_of(beam.segments.begin(), beam.segments.end(), [&](const Segment& segment) {
    return open(segment.from) || open(segment.to);
  });
}

}  // namespace

BentInSpace::BentInSpace(const Project& project, const spatial::Chain& chain, int parts)
    : chain_(&chain), stopped_(project, chain, parts, true) {
  for (const ElasticMember& member : elastic_members(project, chain.mechanism()))
    whole_.push_back(is_closed(*member.beam));
}

std::optional<frame::BentScene> BentInSpace::at(const spatial::State& state,
                                                const CutForceDiagram& rigid, double factor) {
  frame::SceneStress stress =
      StoppedStress(*chain_, state, stopped_.placements().front(), stopped_.members()).stress;
  const frame::VibratingScene scene = stopped_.scene_in(state, rigid);
  stress.whole = whole_;
  stress.whole.resize(scene.beams.size(), true);
  return frame::bent_scene_of(scene, stress, factor, ties_);
}

std::string obstacle_to_bending_in_space(const Project& project, const spatial::Chain& chain) {
  const spatial::Mechanism& mechanism = chain.mechanism();
  if (std::any_of(mechanism.joints.begin(), mechanism.joints.end(), spatial::is_forced))
    return "forces decide the motion";
  const std::vector<spatial::BeamPlacement> beams = elastic_placements(project, mechanism);
  for (const spatial::BeamPlacement& beam : beams) {
    const std::vector<std::string> sliding = joints_sliding_along(mechanism, beam.body);
    if (!sliding.empty())
      return fmt::format(
          "joint {} slides along an elastic beam, and is held at one place as it bends",
          sliding.front());
  }
  return obstacle_to_modes(mechanism, beams);
}

LoadsAt bent_statically_in_space(const Project& project, const spatial::Chain& chain,
                                 std::function<spatial::State(double)> states, int parts,
                                 LoadsAt rigid) {
  constexpr const char* otherwise =
      ": no elastic loads exist; use --model rigid to see those of rigid bodies";
  if (const std::string why = obstacle_to_bending_in_space(project, chain); !why.empty())
    refuse_vibration(why + otherwise);
  auto of = std::make_shared<BentInSpace>(project, chain, parts);
  const auto found = [of, otherwise, states = std::move(states),
                      rigid = std::move(rigid)](Time time) {
    BeamLoads loads = rigid(time);
    const auto bent = of->at(states(time.value()), cut_forces_of(loads), 1.0);
    if (!bent) refuse_vibration(std::string("the beam is free to move") + otherwise, time.value());
    if (bent->critical)
      refuse_vibration(std::string("the mechanism buckles as it stands") + otherwise, time.value());
    add_bending(bent->loads, loads);
    return loads;
  };
  // Instants are asked for again and again.
  return [found, known = std::make_shared<ExactMemo<1, BeamLoads>>()](Time time) {
    return known->of({time.value()}, [&] { return found(time); });
  };
}

}  // namespace boxbeam
