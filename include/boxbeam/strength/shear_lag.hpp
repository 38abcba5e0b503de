#pragma once

#include <string_view>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// Where on the beam a flange is, for its part that works in spite of shear lag.
enum class BendingRegion { sagging, hogging, end_support, cantilever };

/// Whether shear lag must be taken into account: b_0 >= L_e/50.
///
/// b_0  half of the width between the webs, or the outstand
/// L_e  length between the points of zero moment
///
/// Source: EN 1993-1-5:2006, 3.1(1).
bool shear_lag_counts(Length b_0, Length L_e);

/// kappa = alpha_0 b_0/L_e, alpha_0 = sqrt(1 + A_sl/(b_0 t)).
///
/// A_sl  area of all longitudinal stiffeners within b_0
/// t     thickness of the flange
///
/// Source: EN 1993-1-5:2006, 3.2.1, table 3.1.
double shear_lag_kappa(Length b_0, Length thickness, Area stiffeners, Length L_e);

/// Share beta of the width b_0 that works with the stress at the web, elastic: b_eff = beta b_0.
/// It is the factor for fatigue and serviceability.
///
///     kappa <= 0.02:         1
///     0.02 < kappa <= 0.70:  beta_1 = 1/(1 + 6.4 kappa^2)                         sagging
///                            beta_2 = 1/[1 + 6 (kappa - 1/(2500 kappa)) + 1.6 kappa^2]  hogging
///     kappa > 0.70:          beta_1 = 1/(5.9 kappa),  beta_2 = 1/(8.6 kappa)
///     end support:           beta_0 = (0.55 + 0.025/kappa) beta_1 <= beta_1
///     cantilever:            beta_2, at the support and at the end
///
/// As printed, the branches miss each other: beta_1 by -0.26 % at 0.02 and +0.15 % at 0.70, beta_2
/// by -0.06 % and -0.65 %. Source: EN 1993-1-5:2006, 3.2.1, table 3.1.
double shear_lag_factor(double kappa, BendingRegion region);

/// A flange, or a web as the flange of the other bending, and where it is.
struct WidePlate {
  Length b_0, thickness;
  Area stiffeners;  ///< A_sl, within b_0
  Length effective_length;
  BendingRegion region = BendingRegion::sagging;
};

/// beta of a plate, step by step. `of`: "flanges"; `index`: behind its symbols, "_web".
Traced derive_shear_lag(Derivation& steps, const WidePlate& plate, std::string_view of,
                        std::string_view index);

}  // namespace boxbeam
