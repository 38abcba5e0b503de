#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "boxbeam/mechanism/common/body.hpp"
#include "boxbeam/mechanism/common/contact.hpp"
#include "boxbeam/mechanism/common/driver.hpp"
#include "boxbeam/mechanism/common/friction.hpp"
#include "boxbeam/mechanism/common/time_span.hpp"

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

using boxbeam::Friction;

/// A point of a body stays on a line of another (or of the ground) and the bodies keep their angle:
/// n . (p - p_guide) = 0, phi - phi_guide = angle.
struct Slider {
  Attachment point;        ///< on the body that slides
  Attachment guide;        ///< a point of the line, on the body that carries it
  double direction = 0.0;  ///< of the line in the axes of the guide's body [rad]
  double angle = 0.0;      ///< of the sliding body against the guide's body [rad]
  Friction friction = {};
};

/// A point of a body stays on a line of another, which may turn about it: n . (p - p_guide) = 0.
struct PinInSlot {
  Attachment point;
  Attachment guide;
  double direction = 0.0;  ///< of the slot in the axes of its body [rad]
  Friction friction = {};
};

/// Two bodies move as one: p_a = p_b, phi_a - phi_b = angle.
struct Rigid {
  Attachment a, b;
  double angle = 0.0;
};

/// A rod without mass: |p_a - p_b| = length > 0.
struct Distance {
  Attachment a, b;
  double length = 1.0;
};

/// phi_a = ratio * phi_b + offset, by moments alone (a gearbox whose housing, on the ground, takes
/// their difference). The points say where the moments act on the bodies.
struct AngleCoupling {
  Attachment a, b;
  double ratio = 1.0;
  double offset = 0.0;
};

/// Two toothed wheels in mesh, turning about `a` and `b` on whatever keeps these at the distance of
/// the radii's sum:
///
///     r_a (phi_a - theta) + r_b (phi_b - theta) = offset,  theta the direction of p_b - p_a
///
/// up to whole turns of theta. The multiplier is the tooth force along the pitch circles; the part
/// of the force that a pressure angle adds along the line of centres is left out. An annulus has a
/// negative radius.
struct Gear {
  Attachment a, b;
  double radius_a = 1.0;
  double radius_b = 1.0;
  double offset = 0.0;  ///< [m]
};

/// A toothed wheel about `pinion` rolls on a straight rack: e . (p_pinion - p_rack) +
/// r (phi_pinion - phi_rack) = offset, with e the rack's direction; positive r: the wheel lies to
/// the left of the direction. The multiplier is the force along the pitch line.
struct Rack {
  Attachment pinion, rack;
  double direction = 0.0;  ///< of the pitch line in the rack body's axes [rad]
  double radius = 1.0;
  double offset = 0.0;  ///< [m]
};

enum class Coordinate {
  x,       ///< of the point, in the world
  y,       ///< of the point, in the world
  angle,   ///< of the point's body against the other's
  length,  ///< from the point to the other point
};

/// A coordinate follows a driver. `other` is the ground unless an angle or a length between bodies
/// is driven; the moment of a driven angle acts at the points.
struct Driven {
  Attachment point;
  Coordinate coordinate = Coordinate::x;
  Driver driver;
  Attachment other = {};
};

using JointKind =
    std::variant<Pin, Slider, PinInSlot, Rigid, Distance, AngleCoupling, Gear, Rack, Driven>;

/// A joint or a driver: a named set of constraint equations.
struct Joint {
  std::string name;
  JointKind kind;
};

/// How many equations a joint contributes: 3 for rigid, 2 for pin and slider, 1 for the others.
int equations_of(const Joint& joint);

/// Whether a joint keeps the distance of its two points, or drives it, and nothing else: its
/// multiplier is the tension between them.
bool is_rod(const Joint& joint);

/// Whether equation `row` of a joint is one of lengths [m]; otherwise of angles [rad].
bool is_length_equation(const Joint& joint, int row);

inline bool is_driver(const Joint& joint) { return std::holds_alternative<Driven>(joint.kind); }

/// The two attachments of a joint; of a driven coordinate of the world the second is the ground.
std::pair<Attachment, Attachment> ends_of(const Joint& joint);

/// The same where they stand in the joint, to be changed.
std::pair<Attachment*, Attachment*> ends_in(Joint& joint);
std::pair<const Attachment*, const Attachment*> ends_in(const Joint& joint);

/// What a joint wants of a body at one of its ends.
enum class Hold {
  place,  ///< a place, across the body's axis at least
  angle,  ///< the angle of the body there
  clamp,  ///< both
  guide,  ///< a line along which a point of another body slides
  teeth,  ///< a line on which a wheel of another body rolls
};

/// What a joint wants of the bodies at its two ends.
std::pair<Hold, Hold> holds_of(const Joint& joint);

/// A spring and a damper between two points, pulling them together with
/// stiffness (d - free_length) + damping d', d their distance; a cable or a stop one way only,
/// where a stop may part again by the law of an impact (`LineLaw`).
struct Spring {
  Attachment a, b;
  double stiffness = 0.0;    ///< [N/m, of an impact N/m^n]
  double free_length = 0.0;  ///< [m]
  double damping = 0.0;      ///< [N s/m]
  Acts acts = Acts::both;
  std::optional<Impact> impact = {};
};

/// A pin whose bearing is wider than it: within its clearance nothing holds it, beyond that the
/// bearing pushes it back along the line of centres. It has no equations: what it leaves free,
/// forces move. Source: Flores, Ambrosio, Claro and Lankarani, Kinematics and Dynamics of Multibody
/// Systems with Imperfect Joints (2008), chapter 3.
struct PinWithClearance {
  Attachment a, b;         ///< centres of the bearing and of the pin
  double clearance = 0.0;  ///< radius of the bearing less that of the pin [m]
  double stiffness = 0.0;  ///< [N/m^n]
  Impact impact = {};
  /// Where the pin's centre is at the beginning, from that of the bearing in the axes of its body;
  /// at rest against it [m].
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
};

/// A spring that only pulls, from the clearance on.
inline Spring spring_of(const PinWithClearance& pin) {
  return {pin.a, pin.b, pin.stiffness, pin.clearance, 0.0, Acts::pulling, pin.impact};
}

/// The same between two angles: the moment stiffness (phi_a - phi_b - free_angle) + damping
/// (omega_a - omega_b) turns them together.
struct TorsionSpring {
  Attachment a, b;
  double stiffness = 0.0;   ///< [N m/rad]
  double free_angle = 0.0;  ///< [rad]
  double damping = 0.0;     ///< [N m s/rad]
};

/// A force on a point, of a size that follows a function of time.
struct PointForce {
  Attachment at;
  double direction = 0.0;  ///< against world x, or against the body's x if `turns` [rad]
  bool turns = false;      ///< whether it turns with the body
  Driver size;             ///< [N]
};

/// A moment on `a` and its opposite on `b`.
struct Couple {
  Attachment a, b;
  Driver size;  ///< counter-clockwise on a [N m]
};

using ForceKind = std::variant<Spring, TorsionSpring, PointForce, Couple, PinWithClearance>;

struct AppliedForce {
  std::string name;
  ForceKind kind;
};

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
  std::vector<AppliedForce> forces;
  std::vector<Loop> loops;
  Eigen::Vector2d gravity = Eigen::Vector2d::Zero();  ///< [m/s^2]
  Duration duration;

  Eigen::Index coordinates() const { return 3 * static_cast<Eigen::Index>(bodies.size()); }
  Eigen::Index equations() const;
};

/// Index of a body or joint by name, or -1.
int body_index(const Mechanism& mechanism, std::string_view name);
int joint_index(const Mechanism& mechanism, std::string_view name);

std::vector<std::string> names_of_joints(const Mechanism& mechanism,
                                         const std::vector<int>& joints);

/// The coordinates of the rough positions given with the bodies.
Eigen::VectorXd sketch_of(const Mechanism& mechanism);

/// The rough velocities given with the bodies.
Eigen::VectorXd start_velocity_of(const Mechanism& mechanism);

/// The length by which equations of lengths and coordinates are made comparable with angles: the
/// largest distance of a joint's point from its body's centre of mass, or between points of the
/// ground; 1 where there is none. Changes with the unit of length as every length does.
double size_of(const Mechanism& mechanism);

/// The functions of time of all drivers and forces.
std::vector<DriverUse> functions_of(const Mechanism& mechanism);

/// The mechanism with pins that fit in place of those with clearance, each where its pin begins;
/// nothing where all fit.
std::optional<Mechanism> without_clearance(const Mechanism& mechanism);

/// How long the motion is looked at. Throws AnalysisError where it is not known.
TimeSpan time_span_of(const Mechanism& mechanism);

}  // namespace boxbeam::planar
