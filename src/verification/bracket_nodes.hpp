#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/verification/load_history.hpp"

/// The nodes of a bracket of a history, and how large the cut forces at them are.
namespace boxbeam {

inline constexpr std::size_t last_node = LoadHistory::nodes - 1;

/// Chebyshev point of the second kind, ascending in [-1, 1]. Every value between instants asks for
/// all of them: their cosines are taken once.
inline double node(std::size_t k) {
  static const auto nodes = [] {
    std::array<double, LoadHistory::nodes> of;
    for (std::size_t i = 0; i < of.size(); ++i)
      of[i] = -std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(last_node));
    return of;
  }();
  return nodes[k];
}

/// The place of a node between two times; exactly the ends, and the middle.
inline double node_between(double from, double to, std::size_t k) {
  if (k == 0) return from;
  if (k == last_node) return to;
  const double middle = 0.5 * (from + to);
  return 2 * k == last_node ? middle : middle + 0.5 * (to - from) * node(k);
}

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

/// Value at u of the polynomial through the nodes. Barycentric formula; weights of Chebyshev points
/// alternate in sign and are halved at the ends. Source: Berrut and Trefethen, SIAM Review 46
/// (2004).
template <class Value>
Value interpolate(const std::array<Value, LoadHistory::nodes>& values, double u) {
  double sum = 0.0;
  Value result{};
  for (std::size_t k = 0; k <= last_node; ++k) {
    const double distance = u - node(k);
    if (distance == 0.0) return values[k];
    double weight = (k % 2 == 0 ? 1.0 : -1.0) / distance;
    if (k == 0 || k == last_node) weight *= 0.5;
    sum += weight;
    result = sum_of(result, weight, values[k]);
  }
  return sum_of(Value{}, 1.0 / sum, result);
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
