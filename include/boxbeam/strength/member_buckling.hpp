#pragma once

#include "boxbeam/strength/column_buckling.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// A beam as a member, by the largest of what acts anywhere on it, of the characteristic
/// resistances.
struct MemberLoad {
  double compressed = 0.0;  ///< N/(A f_y)
  double bent = 0.0;        ///< M/(W f_y)
  double critical = 0.0;    ///< 1/alpha_cr: N/N_cr, of lateral torsional buckling N/N_cr + M/M_cr
};

/// How far a member that bends under compression is used.
///
///     lambda = sqrt((N/(A f_y))^-1 N/N_cr),  chi by the curve
///     use    = gamma_M1 (N/(chi A f_y) + M/(W f_y))
///
/// M of the bent beam, second order included. Linear in N and M where all grow alike; with the
/// largest N and M of a beam, wherever they are, on the safe side, for N/(chi A f_y) grows with
/// N/(A f_y) and with N/N_cr. Source: EN 1993-1-1:2005, 6.3.1, 6.3.4(2) and (4) b.
double flexural_use(const MemberLoad& load, BucklingCurve curve, double gamma_M1);
Traced derive_flexural_use(Derivation& steps, const MemberLoad& load, BucklingCurve curve,
                           double gamma_M1);

/// How far a member that bends sideways and turns over is used.
///
///     alpha_ult = 1/(N/(A f_y) + M/(W f_y)),  lambda = sqrt(alpha_ult/alpha_cr)
///     use       = gamma_M1/(chi alpha_ult)
///
/// Source: EN 1993-1-1:2005, 6.3.4(2) to (4) a.
double lateral_use(const MemberLoad& load, BucklingCurve curve, double gamma_M1);
Traced derive_lateral_use(Derivation& steps, const MemberLoad& load, BucklingCurve curve,
                          double gamma_M1);

}  // namespace boxbeam
