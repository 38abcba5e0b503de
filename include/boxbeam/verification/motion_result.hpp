#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/common/sticking.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// A body's centre of mass: (x, y, angle) and its derivatives [m, rad; s].
struct BodyMotion {
  std::string name;
  Eigen::Vector3d position, velocity, acceleration;
};

/// A named point "body.point" in world axes.
struct PointMotion {
  std::string name;
  Eigen::Vector2d position, velocity, acceleration;
};

/// What a joint or driver does to a body, world axes [N, N m].
struct JointReaction {
  std::string joint;
  std::string on;
  Eigen::Vector2d force;
  double moment = 0.0;  ///< counter-clockwise, about the joint's point
  bool unique = true;   ///< else joints that repeat each other share it in an unknown way
};

/// What the Newton chain has carried up to a step, world axes.
struct ChainStepLoad {
  std::string step;
  Eigen::Vector2d force;         ///< [N]
  std::optional<double> moment;  ///< [N m], see planar::chain_moments_at
};

/// The Newton chain of a case at an instant.
struct ChainResult {
  std::vector<ChainStepLoad> steps;
  double sought_mass = 0.0;  ///< of the last body [kg]
};

/// Everything of one instant.
struct InstantResult {
  double time = 0.0;                                ///< [s]
  std::vector<std::pair<std::string, int>> branch;  ///< loop and its sign
  double residual = 0.0;                            ///< largest error of the constraints [m, rad]
  double condition = 0.0;                           ///< of the scaled Jacobian; 0 if integrated
  double digits = 0.0;                              ///< of velocities that are left
  std::vector<BodyMotion> bodies;
  std::vector<PointMotion> points;
  std::vector<JointReaction> reactions;
  std::optional<ChainResult> chain;  ///< where the case has one
};

/// The mechanism alone.
struct MotionResult {
  planar::DegreesOfFreedom freedom;
  std::vector<std::string> redundant;  ///< joints that repeat others
  std::vector<double> change_points;   ///< times at which two branches cross [s]
  std::vector<InstantResult> states;
  std::vector<StickingContact> sticking = {};  ///< contacts that can, until the last of the states
};

/// Solves the mechanism of a case at the given times [s], or at twelve instants of its period where
/// none is given. Throws AnalysisError.
MotionResult motion_of(const Project& project, std::vector<double> times);

/// One way to assemble the mechanism at an instant.
struct AssemblyResult {
  std::vector<std::pair<std::string, int>> branch;
  std::vector<std::pair<std::string, Eigen::Vector3d>> bodies;  ///< centre of mass and angle
};

/// The assemblies of a case's mechanism at an instant [s].
std::vector<AssemblyResult> assemblies_of(const Project& project, double time);

}  // namespace boxbeam
