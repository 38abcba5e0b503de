#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "boxbeam/mechanism/common/body.hpp"
#include "boxbeam/mechanism/common/time_span.hpp"
#include "boxbeam/numerics/polynomial.hpp"

/// Mechanisms of elastic links in the plane, in a given posture, small vibrations about it, by
/// rigid finite elements. Source: Kruszewski et al., Metoda sztywnych elementów skończonych (1975);
/// Wojnarowski, Wojciech, Płosa, Płoski, Mechanika 85 (1987).
namespace boxbeam::flexible {

inline constexpr int ground = -1;

/// Which deformations of a link count.
enum class LinkKind {
  rigid,    ///< none: one rigid element
  bending,  ///< bending and shear; rigid along its axis
  axial,    ///< along its axis; rigid across it
  full,     ///< bending, shear and along its axis
};

/// How the elasticity and the mass of a part are gathered.
enum class Element {
  classical,  ///< EA/D, GA/D, EI/D in a part's middle; every rigid element has its piece's mass
  corrected,  ///< statically exact springs; masses gathered in the nodes
  exact,      ///< the continuous link at the frequency at hand: its division leaves no error
};

/// Stiffness and mass per length on a stretch of a link, as polynomials of the distance from the
/// stretch's start.
struct LinkStretch {
  double start = 0.0;    ///< along the link's axis [m]
  double length = 0.0;   ///< [m]
  Polynomial<4> EA;      ///< [N]
  Polynomial<4> GA;      ///< with the shear area [N]
  Polynomial<4> EI;      ///< [N m^2]
  Polynomial<2> mass;    ///< [kg/m]
  Polynomial<4> rotary;  ///< rho I [kg m]
};

/// Whether nothing changes along a stretch.
bool is_uniform(const LinkStretch& of);

/// Mass of a rigid link.
struct RigidMass {
  double mass = 0.0;                                 ///< [kg]
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the link's axes [m]
  double inertia = 0.0;                              ///< about the centre [kg m^2]
};

/// A link in its unstressed posture. Its axes: x along it from its origin, y to its left.
struct Link {
  std::string name;
  LinkKind kind = LinkKind::full;
  /// At least so many springs; none in a rigid link. As many as leave below a thousandth of the
  /// first three frequencies of a cantilever.
  int parts = 16;
  /// Kelvin-Voigt damping: viscosity over modulus, the same in all directions [s]. An elasticity c
  /// becomes c (1 + i omega tau).
  double retardation = 0.0;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< world [m]
  double angle = 0.0;                                ///< of its x, from the world's [rad]
  double length = 0.0;                               ///< [m]
  RigidMass rigid;                                   ///< of a rigid link only
  /// In order, without gaps. A rigid link may have them, to tell how its mass lies.
  std::vector<LinkStretch> stretches;
  std::vector<BodyPoint> points = {};  ///< its named places, in its axes from its origin
};

/// A place of a link, in its axes from its origin, or of the ground, in world axes [m].
struct Attachment {
  int link = ground;
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
};

/// An elastic connection of a place of one link with one of another link or of the ground.
///
/// Its gap is the motion of b less that of a: along its first axis, along its second (to the left
/// of the first) and about it. What it does to a is stiffness times gap, to b the opposite.
/// Infinite stiffness is a rigid connection, zero none. A revolute joint has equal stiffness along
/// both axes, a sliding contact only along the second.
struct Joint {
  std::string name;
  Attachment a, b;
  double angle = 0.0;                 ///< of its first axis, from the world's x [rad]
  std::array<double, 3> stiffness{};  ///< [N/m, N/m, N m/rad]
  std::array<double, 3> damping{};    ///< viscous [N s/m, N s/m, N m s/rad]
};

/// A force and a couple on a link, world axes: constant + amplitude sin(omega t + phase).
struct Load {
  std::string name;
  Attachment at;
  Eigen::Vector3d constant = Eigen::Vector3d::Zero();   ///< x, y, couple [N, N m]
  Eigen::Vector3d amplitude = Eigen::Vector3d::Zero();  ///< [N, N m]
  double phase = 0.0;                                   ///< [rad]
};

/// A mechanism of elastic links in a posture, with its loads.
struct Mechanism {
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Load> loads;
  Eigen::Vector2d gravity = Eigen::Vector2d::Zero();  ///< [m/s^2]
  Element element = Element::corrected;
  /// Whether divisions have nodes where joints and loads act; else all parts of a link are equal
  /// and a joint acts on the rigid element that holds its place (at a border the one nearer the
  /// origin).
  bool nodes_at_joints = true;
  double frequency = 0.0;  ///< of the harmonic loads [Hz]; zero where there are none
  Duration duration;       ///< not used: a harmonic response is looked at for one period
};

/// The place of an attachment in the world, unstressed.
Eigen::Vector2d in_world(const Mechanism& mechanism, const Attachment& at);

/// A link of infinite stiffness that has the mass of another.
RigidMass rigid_mass_of(const Link& link);

}  // namespace boxbeam::flexible
