#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/mechanism/common/contact.hpp"
#include "boxbeam/mechanism/common/driver.hpp"
#include "boxbeam/mechanism/common/friction.hpp"
#include "boxbeam/mechanism/common/time_span.hpp"

/// Rigid bodies in space that joints carry one from another, a tree that begins at the ground, and
/// joints that close loops in it. SI units; world axes unless said otherwise.
namespace boxbeam::spatial {

/// Index of the fixed world.
inline constexpr int ground = -1;

/// A named point of a body, in the body's axes from its origin [m].
struct BodyPoint {
  std::string name;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// A rigid body. Without mass it is a frame that only turns or shifts what it carries.
struct Body {
  std::string name;
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass, body axes [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre, body axes [kg m^2]
  std::vector<BodyPoint> points;
};

enum class JointKind {
  fixed,
  revolute,
  prismatic,
  screw,  ///< turns about its axis and advances along it, a lead for every turn
};

const char* to_text(JointKind kind);

/// Whether the coordinate of a joint is an angle [rad]; else a length [m], or it has none.
bool is_angle(JointKind kind);

/// What decides the coordinate of a joint that moves.
enum class MovedBy {
  driver,  ///< its function of time
  loops,   ///< that closing joints close
  forces,  ///< and what is inert
};

/// A joint carries a body from another one that comes before it, or from the ground:
///
///     R_WB = R_WP turned(q),  p_B = p_P + R_WP (at + axis q) - R_WB point
///
/// where q turns about the axis (revolute), shifts along it (prismatic) or is absent (fixed). A
/// screw turns by q and shifts by lead q/(2 pi).
struct Joint {
  std::string name;
  JointKind kind = JointKind::fixed;
  int parent = ground;                                 ///< index of the body that carries
  Eigen::Vector3d at = Eigen::Vector3d::Zero();        ///< joint's point, axes of the parent [m]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     ///< the same, axes of the carried body [m]
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< R_PB where q is zero
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     ///< unit vector, axes of the parent
  Driver driver = PolynomialDriver{{0.0}};             ///< q over time [rad or m]
  std::string driver_name = {};                        ///< "" where it has none of its own
  MovedBy moved_by = MovedBy::driver;
  double start = 0.0;       ///< q at t = 0 by forces; by loops near which it is sought [rad or m]
  double start_rate = 0.0;  ///< by forces, at t = 0 [rad/s or m/s]
  double lead = 0.0;        ///< of a screw: its advance in a turn, right-handed [m]
  Friction friction = {};   ///< of a prismatic one
};

/// What a screw advances by a radian [m].
double pitch_of(double lead);

/// Whether a joint has a coordinate that its driver moves, or that forces move.
inline bool is_driven(const Joint& joint) {
  return joint.kind != JointKind::fixed && joint.moved_by == MovedBy::driver;
}
inline bool is_forced(const Joint& joint) {
  return joint.kind != JointKind::fixed && joint.moved_by == MovedBy::forces;
}

/// "retraction (joint hinge)", or the joint's name alone where its driver has none.
std::string driver_text(const Joint& joint);

/// A place that moves with a body.
struct Attachment {
  int body = ground;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< in the body's axes [m]
};

enum class ClosingKind {
  fixed,
  revolute,
  prismatic,
  cylindrical,  ///< turns about its axis and slides along it
  universal,    ///< turns about an axis of either body, which stay square
  spherical,
  planar,    ///< slides square to its axis, and turns about it
  slot,      ///< the place on b stays on the axis through the place on a
  distance,  ///< between the two places, which a driver may change: a rod, a cylinder
  screw,     ///< as cylindrical, and advances by a lead for every turn
  gear,      ///< two toothed wheels roll on each other
  rack,      ///< a toothed wheel rolls on a straight rack
};

const char* to_text(ClosingKind kind);

/// Whether it ties coordinates of joints that carry bodies by teeth.
inline bool has_teeth(ClosingKind kind) {
  return kind == ClosingKind::gear || kind == ClosingKind::rack;
}

/// Teeth that mesh: the coordinates that they tie, sum of factor q = offset, all lengths along the
/// pitch circle, and the force with which they do. `at` is fixed in the body that keeps the axes of
/// both wheels where they are: there both wheels move alike.
struct Mesh {
  struct Part {
    std::size_t joint = 0;  ///< index
    double factor = 0.0;    ///< [m/rad or 1]
  };
  std::vector<Part> parts;
  double offset = 0.0;  ///< [m]
  Attachment at;
  Eigen::Vector3d along = Eigen::Vector3d::Zero();  ///< of the pitch circles, unit, axes of `at`
  /// For every newton along, either way, what pushes b away from a by the pressure angle.
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();
};

/// A joint between two bodies that others carry already: it closes a loop.
struct ClosingJoint {
  std::string name;
  ClosingKind kind = ClosingKind::spherical;
  Attachment a, b;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< R_AB where nothing has turned in it
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     ///< unit vector, axes of a
  Eigen::Vector3d other = Eigen::Vector3d::UnitY();    ///< of a universal joint, axes of b
  Driver length = PolynomialDriver{{0.0}};             ///< of a distance, over time [m]
  std::string driver_name = {};                        ///< "" where its length does not change
  double lead = 0.0;                                   ///< of a screw, as that of a joint [m]
  Mesh mesh = {};                                      ///< of a gear or rack
  Friction friction = {};  ///< of a prismatic, cylindrical or slot joint, along its axis
};

/// Which of the assemblies of a loop is wanted at t = 0, by the sign of how far `to` lies from
/// `from` along a direction, or, with `via`, of how the way over the three turns about it,
/// right-handed: (via - from) x (to - from) . direction. Where branches meet later it may be zero.
struct Branch {
  std::string name;  ///< of the loop
  Attachment from, to;
  std::optional<Attachment> via;
  int axes = ground;  ///< the body in whose axes the direction is given
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector
  int sign = 1;                                          ///< that is wanted: +1 or -1
};

/// The place about which it is said what a closing joint does to its two bodies: that on b, or
/// where teeth mesh.
inline const Attachment& place_of(const ClosingJoint& joint) {
  return has_teeth(joint.kind) ? joint.mesh.at : joint.b;
}

std::string driver_text(const ClosingJoint& joint);

enum class LoadKind { force, couple };

/// A force or couple on a body. Place and direction may belong to other bodies: the ground's force
/// on a wheel stands under the axle, while the wheel turns.
struct AppliedLoad {
  std::string name;
  LoadKind kind = LoadKind::force;
  int on = ground;    ///< the body that feels it
  Attachment at;      ///< where; of a couple, where its moment enters
  int axes = ground;  ///< the body in whose axes the direction is given
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector
  Driver size = PolynomialDriver{{0.0}};                 ///< over time [N or N m]
};

/// A force per length on a straight stretch of a body, the same all along it.
struct LineForce {
  std::string name;
  int on = ground;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< axes of the body [m]
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  int axes = ground;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector
  Driver size = PolynomialDriver{{0.0}};                 ///< over time [N/m]
};

/// A spring with a damper beside it between two places: the force stiffness (length - free_length)
/// + damping length' draws them together; a cable or a stop acts one way only, where a stop may
/// part again by the law of an impact (`LineLaw`). A ball in a socket that is wider than it only
/// pulls its centre back to that of the socket, from the clearance on.
struct Spring {
  using Acts = boxbeam::Acts;

  std::string name;
  Attachment a, b;
  double stiffness = 0.0;    ///< [N/m]
  double free_length = 0.0;  ///< [m]
  double damping = 0.0;      ///< [N s/m]
  Acts acts = Acts::both;
  std::optional<Impact> impact = {};
  bool clearance = false;  ///< a ball in its socket: the free length is its clearance
};

/// A spring with a damper beside it that turns a revolute joint back: its couple on the carried
/// body, about the joint's axis, is -stiffness (q - free_angle) - damping q'.
struct TorsionSpring {
  std::string name;
  int joint = -1;           ///< its index
  double stiffness = 0.0;   ///< [N m/rad]
  double free_angle = 0.0;  ///< [rad]
  double damping = 0.0;     ///< [N m s/rad]
};

/// Joint i carries body i; parents come before the bodies that they carry.
struct Mechanism {
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<ClosingJoint> closing;
  std::vector<Branch> branches;
  std::vector<AppliedLoad> loads;
  std::vector<LineForce> line_forces;
  std::vector<Spring> springs;
  std::vector<TorsionSpring> torsion_springs;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s^2]
  Duration duration;
};

/// The body that carries a ball of which this joint is the last of three turns about one point, as
/// balls carry bodies; nothing of other joints.
std::optional<int> carrier_of_ball(const Mechanism& mechanism, int joint);

/// Index of a body or joint by name, or -1.
int body_index(const Mechanism& mechanism, std::string_view name);
int joint_index(const Mechanism& mechanism, std::string_view name);

/// The functions of time of all drivers and loads.
std::vector<DriverUse> functions_of(const Mechanism& mechanism);

/// The largest arm of a joint [m].
double size_of(const Mechanism& mechanism);

/// How long the motion is looked at; what forces move does not repeat. Throws AnalysisError where
/// it is not known.
TimeSpan time_span_of(const Mechanism& mechanism);

}  // namespace boxbeam::spatial
