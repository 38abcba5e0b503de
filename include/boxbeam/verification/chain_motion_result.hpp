#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// Where a body is, how it turns, and what its inertia puts on the mechanism about its centre of
/// mass.
struct ChainBody {
  std::string name;
  Eigen::Vector3d position;           ///< of its origin, from that of the world [m]
  Eigen::Matrix3d rotation;           ///< columns: the body's axes
  Eigen::Vector3d omega, alpha;       ///< [rad/s], [rad/s^2]
  Eigen::Vector3d inertia_force;      ///< [N]
  Eigen::Vector3d inertia_moment;     ///< [N m]
  Eigen::Vector3d gyroscopic_moment;  ///< the part of it that spatial::InertiaLoad names [N m]
};

/// A named place: "A" where all points of that name are one place, else "body.A".
struct ChainPoint {
  std::string name;
  Eigen::Vector3d position, velocity, acceleration;  ///< from the origin of the world
};

/// What a joint does to a body, about the joint's point.
struct ChainJoint {
  std::string name;
  std::string on;          ///< the beam's body where it is in the joint, else the carried body
  Eigen::Vector3d force;   ///< [N]
  Eigen::Vector3d moment;  ///< [N m]
  /// Force or moment of the drive on the carried body along the joint's axis, so that times the
  /// rate of its coordinate it is the power [N, N m]; nothing for a fixed joint.
  std::optional<double> drive;
  /// What rubs, on the carried body or a closing joint's second one, along the joint's axis, a part
  /// of its force [N]; nothing where nothing does.
  std::optional<double> friction = {};
  /// Of what moves in the joint, an angle [rad], shift or length [m]; nothing where it has none.
  std::optional<DriverState> coordinate;
  bool turns = false;  ///< whether the coordinate is an angle
  /// Else joints that repeat each other share what it carries, and only their elasticity decides.
  bool unique = true;
};

struct ChainInstant {
  double time = 0.0;  ///< [s]
  std::vector<ChainBody> bodies;
  std::vector<ChainPoint> points;
  std::vector<ChainJoint> joints;  ///< those that carry bodies, then those that close loops
  /// Signs of the loops that the case names, and behind them, as "loops", that of the equations of
  /// all (`spatial::Loops::branch`); none without loops.
  std::vector<std::pair<std::string, int>> branch;
  double residual = 0.0;   ///< largest error of the loops' equations
  double condition = 1.0;  ///< of the loops' equations
};

/// A hand formula of the case beside what the program computes, world axes.
struct HandComparison {
  HandFormula formula;
  std::string of;  ///< the body, or the point
  Eigen::Vector3d computed;
};

/// What closes the loops of a mechanism in space, and what it decides.
struct ChainLoops {
  std::vector<std::string> closing;     ///< joints
  std::vector<std::string> not_unique;  ///< joints whose forces repeat each other
  std::size_t equations = 0;
  std::size_t freedoms = 0;   ///< coordinates that they decide
  std::size_t repeating = 0;  ///< equations that others imply
};

/// The motion of a mechanism in space alone.
struct ChainMotionResult {
  std::string axes;        ///< "world", or the body in whose axes the vectors are given
  std::size_t driven = 0;  ///< coordinates that drivers move
  std::size_t forced = 0;  ///< those that forces move
  std::optional<ChainLoops> loops = {};
  std::vector<ChainInstant> states;
  std::vector<HandComparison> hand_formulas;
  std::vector<StickingContact> sticking = {};  ///< contacts that can, from t = 0 on
};

/// The mechanism of a case in space at the given times [s], or at twelve instants of its span where
/// none is given; vectors in the axes of a body, or "world". Throws InputError where there is no
/// such body, AnalysisError where it is not known how long to look.
ChainMotionResult chain_motion_of(const Project& project, std::vector<double> times,
                                  const std::string& axes);

/// "omega", "acceleration", ...
const char* to_text(HandFormula::Quantity quantity);

}  // namespace boxbeam
