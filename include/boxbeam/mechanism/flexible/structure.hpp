#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
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
  /// What forces that keep their direction add to the stiffness against turning [N m/rad]: tension
  /// stiffens, compression softens.
  double turning = 0.0;
};

/// A spring-damping element (SDE) between two neighbouring rigid elements: how they shift and turn
/// against each other at its place under a force along the axis, a force across it and a couple.
struct SpringElement {
  double place = 0.0;           ///< on the link's axis [m]
  double from = 0.0, to = 0.0;  ///< the part whose elasticity it gathers [m]
  double axial = 0.0;           ///< flexibility along the axis [m/N]
  /// Flexibility of (shift across, turn) to (force across, couple) [m/N, 1/N; 1/N, rad/(N m)].
  Eigen::Matrix2d bending = Eigen::Matrix2d::Zero();
  /// Axial force at the start, in the middle and at the end of the part, that is there before
  /// anything moves [N].
  std::array<double, 3> tension{};
  /// Levers of the force across about the nodes, over the distances from them: 1/(1 + nu).
  double reach = 1.0;
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

/// Tension of a link along its axis, by the place and, where it jumps, the side of it [N].
using TensionAt = std::function<double(double, Side)>;

/// Gives a link the axial force N that it bears before anything moves. A part of length D whose
/// chord turns by theta feels the shear V - N theta. With f_11, f_22 its flexibilities about the
/// place where they do not couple, and nu = N f_11/D:
///
///     f_11' = f_11/(1 + nu),  levers of the force across times 1/(1 + nu),
///     t_0 phi_0^2 + t_1 phi_1^2 of its nodes' turns, 12 (1 + nu) t_0 = D (3 N_0 + 4 N_m - N_1)
///
/// so that a part that turns without strain feels exactly V = N theta. The moment of its spring
/// then is that of the nodes less N D^2/4EI of it, and the mean of the bowed part's less N
/// D^2/12EI:
///
///     f_22' = f_22 (1 + N D f_22/6)   to the first order of N
///
/// Of fourth order in D where N is continuous; N may jump at nodes. Where a part itself nearly
/// buckles (nu < -1/2) it is taken for no less, and the link does not stand. Precondition: the
/// corrected form; once only. Derived here from the beam-column; Timoshenko, Gere, Theory of
/// Elastic Stability (1961), section 1.11.
void load_axially(DividedLink& link, const TensionAt& tension);

/// t_0 and t_1 of a part.
std::array<double, 2> turning_of(const SpringElement& part);

/// Whether no part of a link buckles between its nodes.
bool parts_stand(const DividedLink& link);

/// Divides all links and finds what joints and loads take hold of. Of the exact form it is resolved
/// at the frequency of the loads, or at a square of omega.
Structure structure_of(const Mechanism& mechanism);
Structure structure_of(const Mechanism& mechanism, double square);

/// Into how many pieces the parts of the exact form are to be cut so that each is far from a
/// resonance of its own while its nodes are held, at a square of omega, and its power series
/// converge (`ExactPart`): then it is resolved. Of other forms one. Throws AnalysisError where that
/// takes more than can be.
int pieces_at(const Structure& structure, double square);

/// A structure of the exact form with the nodes of another among its own; its answers are the same.
/// Springs and masses of its parts are not known.
struct FinerStructure {
  Structure structure;
  int pieces = 1;  ///< equal ones, for each part of the other
};
FinerStructure cut(const Structure& structure, int pieces);

}  // namespace boxbeam::flexible
