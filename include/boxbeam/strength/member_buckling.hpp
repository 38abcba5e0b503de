#pragma once

#include "boxbeam/strength/column_buckling.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// Compression below which a code lets buckling be ignored, N/N_cr: EN 1993-1-1:2005, 6.3.1.2(4).
inline constexpr double no_buckling_below = 0.04;
/// Of M/M_cr: 6.3.2.2(4) with lambda_LT,0 = 0.2, the plateau of its curves; 6.3.2.3 has 0.4.
inline constexpr double no_turning_over_below = 0.04;

/// A beam as a member, by the largest of what acts anywhere on it, of the characteristic
/// resistances.
struct MemberLoad {
  double compressed = 0.0;  ///< N/(A f_y)
  double bent = 0.0;        ///< M/(W f_y), of the bent beam
  double critical = 0.0;    ///< 1/alpha_cr: N/N_cr, of lateral torsional buckling N/N_cr + M/M_cr
  /// What equations 6.61 and 6.62 ask for besides, of a member that bends.
  struct Straight {
    bool about_z = false;           ///< it buckles across, about z; else in the plane, about y
    bool twists = false;            ///< of open walls, table B.2; else table B.1
    bool lies = false;              ///< z is the stronger axis, as y is else
    double m_y = 0.0;               ///< M_y/(W_y f_y) of the straight beam
    double m_z = 0.0;               ///< M_z/(W_z f_y)
    double other = 0.0;             ///< N/N_cr in the other plane
    double turning = 0.0;           ///< M/M_cr, of the moment about the stronger axis
    double C_my = 1.0, C_mz = 1.0;  ///< equivalent uniform moment factors, table B.3
  } straight = {};
};

/// How far a member that bends under compression is used.
///
///     lambda = sqrt((N/(A f_y))^-1 N/N_cr),  chi by the curve
///     use    = gamma_M1 (N/(chi A f_y) + max(m, k_yy m_y/chi_LT + k_yz m_z))
///
/// m = M/(W f_y) of the bent beam, second order included, m_y and m_z of the straight one. k of
/// class 3 and 4:
///
///     k_yy = C_my (1 + 0.6 min(1, lambda_y) n_y),  n_y = gamma_M1 N/(chi_y A f_y),  k_yz = k_zz;
///
/// across the plane k_zz m_z and k_zy m_y/chi_LT, k_zy = 0.8 k_yy, of open walls 1, which table B.2
/// does not exceed. y is the stronger axis, as the code has it; of a section that lies y and z
/// change places. chi_LT by curve d, 1 up to M/M_cr = 0.04; N/N_cr up to 0.04 counts as no
/// buckling in the other plane. The code has it for uniform members; with the largest N, M, N/N_cr
/// and M/M_cr of a beam, wherever they are, it is on the safe side, for each term grows with each
/// of them. Source: EN 1993-1-1:2005, 6.3.1, 6.3.2.2, 6.3.3, equations 6.61 and 6.62, tables B.1
/// and B.2; of the bent beam 6.3.4(2) and (4) b.
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
