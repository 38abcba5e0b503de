#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/numerics/chebyshev_points.hpp"
#include "boxbeam/verification/load_history.hpp"

/// The nodes of a bracket of a history, and how large the cut forces at them are.
namespace boxbeam {

using BracketPoints = ChebyshevPoints<LoadHistory::nodes>;

inline constexpr std::size_t last_node = BracketPoints::last;

inline double force_in(const CutForces& cut) {
  return std::max({std::abs(cut.N.value()), std::abs(cut.V_y.value()), std::abs(cut.V_z.value())});
}

inline double moment_in(const CutForces& cut) {
  return std::max({std::abs(cut.T.value()), std::abs(cut.M_y.value()), std::abs(cut.M_z.value())});
}

inline CutForces sum_of(const CutForces& a, double factor, const CutForces& b) {
  return {a.N + factor * b.N, a.V_y + factor * b.V_y, a.V_z + factor * b.V_z,
          a.T + factor * b.T, a.M_y + factor * b.M_y, a.M_z + factor * b.M_z};
}

inline double sum_of(double a, double factor, double b) { return a + factor * b; }

/// Value at u of the polynomial through the nodes.
template <class Value>
Value interpolate(const std::array<Value, LoadHistory::nodes>& values, double u) {
  const BracketPoints::Shares shares = BracketPoints::shares_at(u);
  Value result{};
  for (std::size_t k = 0; k <= last_node; ++k)
    result = sum_of(result, shares.weights[k], values[k]);
  return shares.sum == 1.0 ? result : sum_of(Value{}, 1.0 / shares.sum, result);
}

/// What the highest waves of the polynomial through the nodes are of what they may be, where it
/// describes the cut forces between these: forces and moments by their floors.
///
/// A wave of which the bracket is a quarter, the shortest that eight instants to a wave let pass,
/// has 2 J_k(pi/4) of itself in coefficient k: 3e-8 in the last, 6e-7 and 1e-5 in those before it.
/// Over a bend they fall with the square of their number only.
double defect_of(const std::array<CutForces, LoadHistory::nodes>& at, double force_floor,
                 double moment_floor);

}  // namespace boxbeam
