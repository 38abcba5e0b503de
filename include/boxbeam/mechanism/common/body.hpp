#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace boxbeam {

/// Where a body is in the plane: its centre of mass in world axes [m] and the angle of its own x
/// axis against the world's, counter-clockwise [rad].
struct Posture {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double angle = 0.0;
};

/// A named point of a body, in the body's axes from its centre of mass [m].
struct BodyPoint {
  std::string name;
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
};

/// A rigid body in the plane. A body without mass passes forces on and takes none for itself.
struct Body {
  std::string name;
  double mass = 0.0;     ///< [kg]
  double inertia = 0.0;  ///< about the centre of mass [kg m^2]
  std::vector<BodyPoint> points;
  Posture sketch;  ///< rough position from which the assembly starts
  /// Rough velocity (x, y, angle) at the start of a motion that forces decide [m/s, rad/s].
  Eigen::Vector3d start_velocity = Eigen::Vector3d::Zero();
};

}  // namespace boxbeam
