#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "boxbeam/mechanism/flexible/mechanism.hpp"

namespace boxbeam::flexible {

/// A rigid finite element (RFE). Its motion (u, w, phi) is that of its node: along the link's
/// axis, across it and counter-clockwise.
struct RigidElement {
  double node = 0.0;  ///< on the link's axis [m]
  double mass = 0.0;  ///< [kg]
  /// Static moment of the mass about the node, along the axis and across it [kg m].
  Eigen::Vector2d first_moment = Eigen::Vector2d::Zero();
  double inertia = 0.0;  ///< about the node [kg m^2]
};

/// A spring-damping element (SDE) between two neighbouring rigid elements: how they shift and turn
/// against each other at its place under a force along the axis, a force across it and a couple.
struct SpringElement {
  double place = 0.0;           ///< on the link's axis [m]
  double from = 0.0, to = 0.0;  ///< the part whose elasticity it gathers [m]
  double axial = 0.0;           ///< flexibility along the axis [m/N]
  /// Flexibility of (shift across, turn) to (force across, couple) [m/N, 1/N; 1/N, rad/(N m)].
  Eigen::Matrix2d bending = Eigen::Matrix2d::Zero();
};

/// A link divided into rigid elements and the springs between them, one fewer.
struct DividedLink {
  std::vector<RigidElement> elements;
  std::vector<SpringElement> springs;
};

/// How a joint or a load takes hold of a link: of one rigid element, at a distance from its node.
struct Grip {
  int link = ground;
  std::size_t element = 0;
  /// (x, y, phi) of the world at the place, from (u, w, phi) of the element.
  Eigen::Matrix3d motion = Eigen::Matrix3d::Identity();
};

/// A mechanism divided into rigid elements. Looks at its mechanism.
struct Structure {
  const Mechanism* mechanism = nullptr;
  std::vector<DividedLink> links;
  struct Ends {
    Grip a, b;
    /// Rows: motion along the joint's axes and about it, from (x, y, phi) in the world.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  };
  std::vector<Ends> joints;  ///< as those of the mechanism
  std::vector<Grip> loads;   ///< likewise

  std::size_t elements() const;  ///< of all links
};

/// The mass of a part of the corrected form, as it is gathered in the nodes at its two ends: masses
/// [kg], static moments about their nodes [kg m] and rotary inertia [kg m^2].
///
///     S_0 = mu_0 D^2/12,  S_1 = -mu_1 D^2/12,  m_0 + m_1 and the static moment those of the part
///
/// so that loads in proportion to the mass are taken to the nodes as their fixed-end forces are, by
/// Euler and Maclaurin's formula. Uniform and linear accelerations are exact.
struct PartLumps {
  std::array<double, 2> mass{}, first_moment{}, rotary{};
};
PartLumps lumps_of(const Link& link, double from, double to);

/// Divides a link. `nodes`: places that must be nodes; stretches between them and the ends of the
/// link's stretches get parts in proportion to their length, in all at least the link's `parts`.
///
/// Classical: a part of length D gives axial EA/D, shear GA/D and bending EI/D, taken in its
/// middle; each rigid element has mass and inertia of its piece, from middle to middle.
/// Corrected: the springs are the exact flexibility of the part about its middle (integrals of
/// 1/EA, 1/GA + x^2/EI, x/EI, 1/EI); masses as `lumps_of` gathers them, whose static moments cancel
/// between equal parts and put the mass of a free end D/6 inside. There the inertia is at least
/// that of this mass; not at an end that is `held` and does not move across the axis. Sources:
/// Wittbrodt, Adamiec-Wójcik, Wojciech, Dynamics of Flexible Multibody Systems (2006);
/// Przemieniecki, Theory of Matrix Structural Analysis (1968), section 5.6; Euler and Maclaurin's
/// formula.
struct HeldEnds {
  bool start = false, end = false;
};
DividedLink divide(const Link& link, std::vector<double> nodes, Element element,
                   const HeldEnds& held = {});

/// What takes hold of a place: the element whose node is nearest, or, where divisions do not follow
/// the joints, the one that holds the place.
Grip grip_of(const Structure& structure, const Attachment& at);

/// Divides all links and finds what joints and loads take hold of.
Structure structure_of(const Mechanism& mechanism);

}  // namespace boxbeam::flexible
