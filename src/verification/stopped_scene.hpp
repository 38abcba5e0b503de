#pragma once

#include <optional>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"
#include "members_in_space.hpp"

namespace boxbeam {

/// Where the elastic members of a case in space lie, the verified beam first.
std::vector<spatial::BeamPlacement> elastic_placements(const Project& project,
                                                       const spatial::Mechanism& mechanism);

/// The rigid bodies beside elastic members of a mechanism in space that is stopped in a state, and
/// how they and the members are tied, in the axes of the first of these: drives rigid, joints and
/// rods without mass rigid where they do not give way, other joints free as they are, springs
/// elastic.
struct StoppedScene {
  std::vector<frame::RigidMass> bodies;  ///< in the order of the mechanism, without the members'
  std::vector<frame::Tie> ties;
  /// Along springs that act from a length on, whether they do then or not, in their order: their
  /// gap is by how much they are longer.
  std::vector<frame::Tie> contacts;
};
/// `wrenches`: `spatial::Chain::joint_wrenches` then, where something gives way.
StoppedScene stopped_scene(const spatial::Mechanism& mechanism, const spatial::State& state,
                           const std::vector<spatial::BeamPlacement>& members,
                           const GivingWay& giving = {},
                           const std::vector<spatial::Wrench>& wrenches = {});

/// The axis of the movement before a joint's own where it lies across that, as in a universal
/// joint, in the world; nothing where it does not.
std::optional<Eigen::Vector3d> axis_across(const spatial::Mechanism& mechanism,
                                           const spatial::State& state,
                                           const spatial::Joint& joint);

/// Which bodies drivers and fixed joints that do not give way hold to the ground, none of these
/// beams between: in a stopped mechanism they are at rest.
std::vector<bool> resting_bodies(const spatial::Mechanism& mechanism,
                                 const std::vector<spatial::BeamPlacement>& beams,
                                 const GivingWay& giving);

/// The member of a scene that each body is: the beam that it is, one of the bodies behind the
/// beams, or the ground where it rests.
std::vector<int> members_of_scene(const std::vector<bool>& resting,
                                  const std::vector<spatial::BeamPlacement>& beams);

/// What rests is the ground of what moves. `members`: as `members_of_scene` has them behind so many
/// beams.
void leave_out_resting(const std::vector<int>& members, std::size_t beams, StoppedScene& scene);

}  // namespace boxbeam
