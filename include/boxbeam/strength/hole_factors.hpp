#pragma once

#include <optional>

#include "boxbeam/core/units.hpp"

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

}  // namespace boxbeam
