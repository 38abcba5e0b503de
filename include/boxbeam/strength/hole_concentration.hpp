#pragma once

#include <array>

#include "boxbeam/section/point_stress.hpp"

namespace boxbeam {

/// Which of the problems called "a hole in a plate under bending" a hole is. They are different
/// problems with different factors; a hole is given its case, never a default.
enum class HoleCase {
  in_plane_bending,       ///< hole in a web that the bending of the beam strains across its depth
  membrane_tension,       ///< hole in a flange, strained evenly
  published_exponential,  ///< the sledge-rig thesis' formula (meant for out-of-plane plate bending)
};

const char* to_text(HoleCase hole_case);

/// Stress concentration of a round hole in a plate of finite width under membrane tension, on the
/// net section. a = d/w. Valid for a < 0.9.
///
///     K_t = 2 + 0.284 (1-a) - 0.600 (1-a)^2 + 1.32 (1-a)^3
///
/// Source: Peterson's Stress Concentration Factors, chart 4.1 (Howland's solution).
double membrane_concentration(double diameter_to_width);

/// K_t = 2.68750 exp(-0.7128 d/w), for comparison with the sledge-rig thesis only, which takes it
/// from Norton, Machine Design, for the out-of-plane bending of a plate with a hole.
double published_concentration(double diameter_to_width);

/// Width of the plate in which the hole lies: clear depth of a web, clear width of a flange per
/// hole across it; for the published formula the height of the section, as there.
Length plate_width_of(const Section& section, const Hole& hole, HoleCase hole_case);

/// Local stress at the two edges of a hole where it is highest under axial force and bending.
struct HoleEdge {
  Length z;           ///< level of the edge
  StressLevel level;  ///< local stress per cut force
};

/// In-plane bending (hole of radius r at level z_0 of a web): the membrane part, strained evenly,
/// on the gross section with K_g = K_t(a)/(1-a), and the gradient across the hole with factor 2:
///
///     sigma = K_g (N/A + M z_0/I) +- 2 M r/I_net
///
/// Membrane tension (flange): sigma = K_g (N/A + M z_f/I) at the flange's mid-plane, gross.
/// Published exponential: K_t times the nominal net stress at the edge's level.
/// Shear is not concentrated here. Source of the factor 2: Roark's Formulas, table 17.1, in-plane
/// bending of a plate with a central hole; conservative by 0 to 4 % for d/w up to 0.7.
std::array<HoleEdge, 2> hole_edges_of(const Section& section, const std::vector<Hole>& holes,
                                      const Hole& hole, HoleCase hole_case);

}  // namespace boxbeam
