#pragma once

#include "joint_tree.hpp"

namespace boxbeam::readers {

/// The kind of joint that closes nothing and leaves its body free, behind those of closing joints.
inline constexpr std::size_t free_body = 12;

/// One movement of a joint that carries a body.
struct Movement {
  spatial::JointKind kind;
  Eigen::Vector3d axis;
};

/// The movements of a kind of joint one after the other.
std::vector<Movement> movements_of(std::size_t kind, const std::vector<Eigen::Vector3d>& axes);

/// Adds a joint that carries a body; of several movements one after the other, with frames without
/// mass between them: "ball.1" to "ball.3".
void add_carrying(TableReader& table, const JointDraft& whole,
                  const std::vector<Movement>& movements, spatial::Mechanism& mechanism,
                  std::vector<JointDraft>& drafts);

/// [drivers] of joints that carry and of cylinders that close. What no driver moves is left to the
/// loops: notes joints that stand still in a tree without loops, and distances whose length is not
/// said once. `has_length`: of closing joints.
void read_joint_drivers(TableReader& root, const std::vector<bool>& has_length, TimeTables& tables,
                        spatial::Mechanism& mechanism);

}  // namespace boxbeam::readers
