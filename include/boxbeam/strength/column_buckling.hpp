#pragma once

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Buckling curve by which a section is judged: hot-finished hollow sections a, welded boxes b
/// (thick welds in stout boxes c), cold-formed hollow sections c, solid sections c (S235 to S450).
/// Source: EN 1993-1-1:2005, table 6.2.
enum class BucklingCurve { a0, a, b, c, d };

/// "a0".
const char* to_text(BucklingCurve curve);

/// alpha = 0.13, 0.21, 0.34, 0.49, 0.76 for a0, a, b, c, d. Source: EN 1993-1-1:2005, table 6.1.
double imperfection_factor(BucklingCurve curve);

/// Elastic critical force of a bar, N_cr = pi^2 E I/L_cr^2.
/// L_cr  buckling length in the plane of bending. Source: Euler.
Force euler_force(Stress youngs_modulus, SecondMoment inertia, Length buckling_length);

}  // namespace boxbeam
