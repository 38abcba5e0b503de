#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/mechanism/planar/motion.hpp"

namespace boxbeam::planar {

/// What a joint or driver does to one of its bodies, at the joint's point.
struct Reaction {
  int joint = 0;
  int on = ground;                                  ///< the body that feels it
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< world axes [N]
  double moment = 0.0;  ///< about the joint's point, counter-clockwise [N m]
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< where, in the body's axes [m]
};

/// The reaction of every joint on every body it touches, friction included, from the multipliers:
/// the generalised force of a constraint on its bodies is -J^T lambda. Where a point slides along a
/// body, the force on that body stands at the place of the point, which changes.
/// Source: Haug (1989), section 6.6.
std::vector<Reaction> reactions_of(const Mechanism& mechanism, const State& state);

/// One reaction per joint, on `preferred` where that body is in the joint, else on the first body.
std::vector<Reaction> reactions_per_joint(const Mechanism& mechanism, const State& state,
                                          int preferred);

}  // namespace boxbeam::planar
