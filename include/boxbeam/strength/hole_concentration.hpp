#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/units.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {

/// Stress concentration of a round hole in a plate of finite width under membrane tension, on the
/// net section. a = d/w. Valid for a < 0.9.
///
///     K_t = 2 + 0.284 (1-a) - 0.600 (1-a)^2 + 1.32 (1-a)^3
///
/// On the gross section K_t/(1-a). At most 1.4 % below plane-stress finite elements up to a = 0.7;
/// in the mid-plane of a plate thicker than the hole is wide, three-dimensional solutions are up to
/// 2.3 % higher. Source: Peterson's Stress Concentration Factors, chart 4.1 (Howland's solution).
double membrane_concentration(double diameter_to_width);

/// K_t = 2.68750 exp(-0.7128 d/w), for comparison with the sledge-rig thesis only, which takes it
/// from Norton, Machine Design, for the out-of-plane bending of a plate with a hole.
double published_concentration(double diameter_to_width);

/// Stress concentration of a round hole in a plate bent out of its plane, on the nominal stress
/// 6M/[(w-d) h^2].
///
///     K_t = [1.79 + 0.25/(0.39 + d/h) + 0.81/(1 + (d/h)^2) - 0.26/(1 + (d/h)^3)]
///           * (1 - 1.04 a + 1.22 a^2)
///
/// a = d/w. From 3 (2.98) for a hole much narrower than the plate is thick to 1.79, the value
/// (5+3nu)/(3+nu) of Kirchhoff's plates, for a hole much wider. Valid for a < 0.3: nothing is
/// returned outside. Source: Roark's Formulas, table 17.1, by a secondary source; against NASA
/// TP-3192 +9 % to -2.4 % for d/h from 0.5 to 5.
std::optional<double> plate_bending_concentration(double diameter_to_thickness,
                                                  double diameter_to_width);

class Derivation;

/// Which of the problems called "a hole in a plate under bending" a hole is. They are different
/// problems with different factors; a hole is given its case, never a default.
enum class HoleCase {
  in_plane_bending,       ///< hole in a web that the bending of the beam strains across its depth
  membrane_tension,       ///< hole in a flange, strained evenly
  out_of_plane_bending,   ///< hole through a plate that lies flat and is bent out of its plane
  published_exponential,  ///< the sledge-rig thesis' formula (meant for out-of-plane plate bending)
};

const char* to_text(HoleCase hole_case);

/// Width of the plate in which the hole lies: clear depth of a web; clear width of a flange by the
/// holes across it at this station; for the published formula the height of the section, as there.
Length plate_width_of(const Section& section, const std::vector<Hole>& holes, const Hole& hole,
                      HoleCase hole_case);

/// The stresses around a hole in its wall, u along the wall across the beam.
struct AroundHole {
  double radius = 0.0;     ///< [m]
  double a = 0.0;          ///< d/w
  StressInfluence middle;  ///< at the centre, gross: normal stress and shear along u
  std::array<double, cut_force::count> gradient{};  ///< of the normal stress along u
};

/// A place on the edge of a hole and the local stress along the edge there.
struct HoleEdge {
  Length y, z;                ///< of the place; y in space only
  double angle = 0.0;         ///< seen from the hole's centre, from +x towards +z [rad]; webs only
  StressInfluence influence;  ///< stress per cut force, concentration included
  std::shared_ptr<const AroundHole> around = {};  ///< from which it follows; in webs and walls
};

/// Places around the edge of a hole among which the largest stress is looked for.
///
/// In-plane bending (web; radius r, centre at level z_0, angle theta): superposition of Kirsch's
/// solutions for the membrane part, the gradient across the hole and the shear, a = d/w:
///
///     sigma = K_g/3 (N/A + M z_0/I) (1 - 2 cos 2 theta) + (M r/I_net) (sin theta - sin 3 theta)
///             - 4/(1-a) tau_0 sin 2 theta
///     K_g = K_t(a)/(1-a),  tau_0 the shear at z_0 of the gross section, V S(z_0)/(I b) and the
///     taper
///
/// every 3 degrees, which misses at most 0.4 % of a peak between two. At theta = +-90 degrees
/// without shear: K_g times the membrane part and 2 M r/I_net. The factors of an infinite plate are
/// 3 and 4; 1/(1-a) raises the shear as the ligaments carry it. Membrane tension (flange): sigma =
/// K_g (N/A + M z/I) at the outer fibre, gross. Published exponential: K_t times the nominal net
/// stress at the two levels of the edge. Out-of-plane bending (solid plate, hole along z): K_t of
/// plate bending on the net nominal stress 6M/[(w-d) h^2] and K_g on N/A, at both faces; nothing is
/// returned where d/w is 0.3 or more. Source: Kirsch (1898) and Timoshenko and Goodier, Theory
/// of Elasticity, article 35; gradient: Airy function of kappa z^3/6 with the same boundary
/// conditions; the factor 2 also in Roark's Formulas, table 17.1 (conservative by 0 to 4 % for d/w
/// up to 0.7).
/// Bending in the plane of motion: M_z, V_y and T are not counted, see holes_in_walls_of.
std::vector<HoleEdge> hole_edges_of(const Section& section, const std::vector<Hole>& holes,
                                    const Taper& taper, const Hole& hole, HoleCase hole_case);

/// A hole in one of the walls that it goes through.
struct HoleInWall {
  std::string side;  ///< "+y", "-z", of two holes in a flange "+z +y"
  Length plate;      ///< thickness of the wall, as it decides the yield strength
  std::vector<HoleEdge> edges;
};

/// Places around the edges of a hole in each wall, under all six cut forces. Both in webs and in
/// flanges the superposition of hole_edges_of with u along the wall (z in webs, y in flanges),
/// theta from +x towards +u, sigma_0 the stress of the gross section at the hole's centre on the
/// wall's outer face, tau_0 that of the wall's shear flow there:
///
///     sigma = K_g/3 sigma_0 (1 - 2 cos 2 theta) + r dsigma/du (sin theta - sin 3 theta)
///             - 4/(1-a) tau_0 sin 2 theta
///     sigma_0 = N/A + M_y z/I_y - M_z y/I_z,  tau_0 of V_y, V_z, T
///
/// dsigma/du of the moments is of the net section. The stress at the outer face is taken for the
/// whole wall, and what varies over its thickness, bending out of its plane, with K_g, which is
/// more than its own factor: on the safe side. Valid for boxes and rectangular tubes, see
/// unknown_hole_stress_of. Source: as hole_edges_of.
std::vector<HoleInWall> holes_in_walls_of(const Section& section, const std::vector<Hole>& holes,
                                          const Taper& taper, const Hole& hole);

/// Why the stress at a hole's edge is not known under all six cut forces, or nothing.
std::optional<std::string> unknown_hole_stress_of(const Section& section, HoleCase hole_case);

/// What the stress at a place on a hole's edge follows from.
struct EdgeBasis {
  HoleCase hole_case = HoleCase::in_plane_bending;
  bool in_space = false;
  HoleWalls walls = HoleWalls::webs;
  Length diameter;
  Length plate_width;        ///< see plate_width_of
  Length position;           ///< of the hole's centre in its wall
  Length plate;              ///< thickness of a plate that lies flat
  double angle = 0.0;        ///< of the place, see HoleEdge
  Length y, z;               ///< of the place
  SectionProperties gross;   ///< without holes
  SectionProperties net;     ///< holes taken out
  SecondMoment effective_I;  ///< I_y of what shear lag leaves of that
  std::shared_ptr<const AroundHole> around = {};
};

/// The concentration at a place on a hole's edge and, where few letters say it, its stress per cut
/// force, "k_N" and the like, step by step.
void derive_edge_stress(Derivation& steps, const EdgeBasis& basis);

}  // namespace boxbeam
