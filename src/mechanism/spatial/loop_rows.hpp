#pragma once

#include <string>

#include "boxbeam/mechanism/spatial/loops.hpp"

namespace boxbeam::spatial {

/// The equations of all closing joints.
std::vector<LoopRow> rows_of(const Mechanism& mechanism);

/// What an equation leaves open, and its first two derivatives.
struct RowMotion {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

RowMotion motion_of(const Mechanism& mechanism, const LoopRow& row, const State& state);

/// What a multiplier of one does to body b, about its place there; to a the opposite about the same
/// place: the gradient of the equation.
Wrench wrench_of(const Mechanism& mechanism, const LoopRow& row, const State& state);

/// Calls `visit(joint, sign)` for the joints between the bodies of a closing one, on the ways from
/// them to the body that carries both: with 1 where it carries b, -1 where it carries a.
void each_between(const Mechanism& mechanism, const ClosingJoint& joint, const auto& visit) {
  int a = joint.a.body, b = joint.b.body;
  while (a != b) {  // parents come before the bodies that they carry
    int& farther = a > b ? a : b;
    visit(static_cast<std::size_t>(farther), a > b ? -1.0 : 1.0);
    farther = mechanism.joints[static_cast<std::size_t>(farther)].parent;
  }
}

/// What closing joints do to their bodies b by the multipliers of all rows, about their places
/// there.
std::vector<Wrench> closing_wrenches(const Mechanism& mechanism, const std::vector<LoopRow>& rows,
                                     const Eigen::VectorXd& multipliers, const State& state);

/// The same on both bodies of each.
std::vector<BodyWrench> on_both_bodies(const Mechanism& mechanism,
                                       const std::vector<Wrench>& closing, const State& state);

/// Whether a closing joint stands as it says and not turned by half a turn, which leaves its
/// equations zero as well.
bool stands_right(const ClosingJoint& joint, const State& state);

/// The equation in words for messages, "0.0031 m apart" or "0.02 rad askew".
std::string open_text(const LoopRow& row, double value);

}  // namespace boxbeam::spatial
