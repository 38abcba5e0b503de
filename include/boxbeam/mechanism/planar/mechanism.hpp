#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "boxbeam/mechanism/common/body.hpp"
#include "boxbeam/mechanism/common/driver.hpp"

/// Planar mechanisms of rigid bodies. World axes: x right, y up, angles counter-clockwise.
/// Coordinates q: (x, y, angle) of each body's centre of mass, body after body.
namespace boxbeam::planar {

inline constexpr int ground = -1;  ///< the body index of the world

/// A point fixed to a body (in its axes, from its centre of mass) or to the ground (world axes).
struct Attachment {
  int body = ground;
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
};

/// Two points coincide: p_a = p_b.
struct Pin {
  Attachment a, b;
};

/// A point of a body stays on a line of the world and the body keeps its angle:
/// n . (p - through) = 0, phi = angle.
struct Slider {
  Attachment point;  ///< on the body that slides
  Eigen::Vector2d through = Eigen::Vector2d::Zero();
  double direction = 0.0;  ///< of the line against world x [rad]
  double angle = 0.0;      ///< of the body [rad]
};

/// phi_a = ratio * phi_b + offset. The points say where the coupling's moments act on its bodies.
struct AngleCoupling {
  Attachment a, b;
  double ratio = 1.0;
  double offset = 0.0;
};

enum class Coordinate { x, y, angle };

/// A coordinate of a body's point (or the body's angle, the moment acting at the point) follows a
/// driver.
struct Driven {
  Attachment point;
  Coordinate coordinate = Coordinate::x;
  HarmonicDriver driver;
};

using JointKind = std::variant<Pin, Slider, AngleCoupling, Driven>;

/// A joint or a driver: a named set of constraint equations.
struct Joint {
  std::string name;
  JointKind kind;
};

/// How many equations a joint contributes: 2 for pin and slider, 1 for coupling and driver.
int equations_of(const Joint& joint);

/// A loop whose two assemblies are told apart by the sense of turn of three points:
/// sign of the area of the triangle from -> via -> to, counter-clockwise positive.
struct TurnSign {
  Attachment from, via, to;
};

/// A loop whose two assemblies are told apart by the sense of a vector along a slider's line:
/// sign of (to - from) . direction.
struct AlongSign {
  Attachment from, to;
  double direction = 0.0;  ///< of the line [rad]
};

/// A closed loop and the branch of it that is wanted. The measure goes through zero only where the
/// two assemblies meet (a dead point).
struct Loop {
  std::string name;
  std::variant<TurnSign, AlongSign> measure;
  int sign = 1;  ///< +1 or -1
};

struct Mechanism {
  std::vector<Body> bodies;
  std::vector<Joint> joints;  ///< drivers among them
  std::vector<Loop> loops;
  Eigen::Vector2d gravity = Eigen::Vector2d::Zero();  ///< [m/s^2]

  Eigen::Index coordinates() const { return 3 * static_cast<Eigen::Index>(bodies.size()); }
  Eigen::Index equations() const;
};

/// Index of a body or joint by name, or -1.
int body_index(const Mechanism& mechanism, std::string_view name);
int joint_index(const Mechanism& mechanism, std::string_view name);

/// The coordinates of the rough positions given with the bodies.
Eigen::VectorXd sketch_of(const Mechanism& mechanism);

/// The time after which all drivers repeat [s]. All drivers share one frequency (the reader of a
/// case sees to it); 0 where there is none.
double period_of(const Mechanism& mechanism);

}  // namespace boxbeam::planar
