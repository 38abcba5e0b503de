#pragma once

#include <Eigen/Core>
#include <vector>

namespace boxbeam {

/// The probability that two standard normal variables of a correlation are both below -a and -b.
///
///     Phi_2(-a, -b; rho) = Phi(-a) Phi(-b) + integral from 0 to rho of phi_2(a, b; r) dr
///
/// by Gauss-Legendre quadrature over the angle arcsin r, which takes the root at r = 1 away.
/// Source: Plackett, Biometrika 41 (1954).
double both_below(double a, double b, double rho);

struct Bounds {
  double low = 0.0, high = 0.0;
};

/// A half-space of failure: beyond a distance from the origin along a direction of length 1.
struct HalfSpace {
  double beta = 0.0;
  Eigen::VectorXd alpha;
};

/// Of the probability that a design lies in any of several half-spaces.
///
///     low  = P_1 + sum max(0, P_i - sum_{j<i} P_ij)
///     high = sum P_i - sum_{i>1} max_{j<i} P_ij
///
/// Source: Ditlevsen, Journal of Structural Mechanics 7 (1979).
Bounds probability_of_any(std::vector<HalfSpace> of);

}  // namespace boxbeam
