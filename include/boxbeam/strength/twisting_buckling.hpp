#pragma once

namespace boxbeam {

/// How much of what a compressed bar bears by bending alone about its axes, and by twisting alone
/// about its shear centre, acts, and what couples them.
struct TwistingLoad {
  double about_y = 0.0, about_z = 0.0;  ///< N/N_cr of bending
  double twisting = 0.0;                ///< N/N_cr,T
  double y_0 = 0.0, z_0 = 0.0;          ///< from centroid to shear centre, over i_0
  double coupling = 0.0;                ///< I_yz/sqrt(I_y I_z)
};

/// N/N_cr,T per compression [1/N].
///
///     N_cr,T = (G I_T + pi^2 E I_w/L_T^2)/i_0^2,  i_0^2 = i_y^2 + i_z^2 + y_0^2 + z_0^2
///
/// SI. L_T  between places held against turning that do not hold warping; infinite where there is
/// but one. Source: Timoshenko, Gere, Theory of Elastic Stability (1961), section 5.4.
double twisting_per_force(double GI_T, double EI_w, double L_T, double radius_squared);

/// N/N_cr of bending about both axes and twisting at once, the largest x that makes singular
///
///     | n_z - x    -r x       z_0 sqrt(n_z n_T) |
///     | -r x       n_y - x   -y_0 sqrt(n_y n_T) |
///     | ..         ..         n_T - x           |
///
/// r  I_yz/sqrt(I_y I_z), of either sign. Exact where all three bow alike; modes of unlike shapes
/// couple less, so that x is never too small. Where y and z are principal axes it is the cubic
/// (N - N_y)(N - N_z)(N - N_T) - N^2 z_0^2/i_0^2 (N - N_y) - N^2 y_0^2/i_0^2 (N - N_z) = 0 of
/// 1/x = N_cr/N. Source: Timoshenko, Gere, section 5.4, equation 5-37; EN 1993-1-1:2005, 6.3.1.4.
double twisting_part(const TwistingLoad& load);

}  // namespace boxbeam
