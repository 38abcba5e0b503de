#pragma once

#include "joint_tree.hpp"

namespace boxbeam::readers {

/// [drivers] of joints that carry and of cylinders that close. What no driver moves is left to the
/// loops: notes joints that stand still in a tree without loops, and distances whose length is not
/// said once. `has_length`: of closing joints.
void read_joint_drivers(TableReader& root, const std::vector<bool>& has_length, TimeTables& tables,
                        spatial::Mechanism& mechanism);

}  // namespace boxbeam::readers
