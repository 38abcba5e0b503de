#pragma once

#include <vector>

#include "read_gearing.hpp"
#include "readers.hpp"

/// Joints of a mechanism in space as written, and the tree that they make of its bodies.
namespace boxbeam::readers {

/// A joint as written, with the bodies that it connects.
struct JointDraft {
  spatial::Joint joint;
  int carried = spatial::ground;
};

/// What [joints] says: joints that carry bodies, and joints that close loops; bodies in the order
/// of the file.
struct JointDrafts {
  std::vector<JointDraft> carrying;
  std::vector<spatial::ClosingJoint> closing;
  std::vector<bool> has_length;  ///< of the closing ones
  std::vector<GearingDraft> gearings;
  std::vector<spatial::Spring> loose;  ///< balls with clearance in their sockets
  std::vector<NamedElasticJoint> giving_way;
};

/// Puts every body behind the one that carries it, its joint at its place, and the closing joints
/// on them. False where there is no such order: notes bodies that no joint carries or that two
/// carry, and bodies that carry each other in a ring.
bool sort_tree(TableReader& root, const JointDrafts& drafts, spatial::Mechanism& mechanism);

}  // namespace boxbeam::readers
