#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"
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

/// The tension in a joint that keeps or drives the distance of two points [N]. Precondition:
/// `is_rod`.
double tension_in_joint(const Mechanism& mechanism, const State& state, std::size_t joint);

/// The tension in a spring between two points, with its damper [N]; zero where they are one.
/// Precondition: the force is a `Spring`.
double tension_in_spring(const Mechanism& mechanism, const State& state, std::size_t force);

/// A spring between two points as one that acts both ways and does about a state what it does
/// there: with the stiffness of an impact's law at its depth; nothing where it acts one way and not
/// now. Precondition: the force is a `Spring`.
std::optional<Spring> spring_in(const Mechanism& mechanism, const State& state, std::size_t force);

/// Which forces are springs that act in a state.
std::vector<bool> acting_springs(const Mechanism& mechanism, const State& state);

/// Whether a spring that acts one way is damped: while its ends part it may bear nothing.
bool has_damped_touches(const Mechanism& mechanism);

}  // namespace boxbeam::planar
