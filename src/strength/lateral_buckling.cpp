#include "boxbeam/strength/lateral_buckling.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace boxbeam {
namespace {

constexpr double gauss = 0.5 - 0.5 / std::numbers::sqrt3;

/// Whether all pivots of K - alpha H - alpha^2 B are above zero. Linear shapes of phi; half of B
/// is lumped at the nodes, by which its error is of the fourth order.
bool stands_at(const TurningBeam& beam, std::span<const std::array<double, 2>> twisting,
               std::span<const double> tipping, double alpha) {
  const std::size_t count = beam.nodes.size();
  std::vector<double> diagonal(count), beside(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) diagonal[i] = -alpha * tipping[i];
  for (std::size_t e = 0; e + 1 < count; ++e) {
    const double length = beam.nodes[e + 1] - beam.nodes[e];
    const auto& GI = beam.turning_stiffness[e];
    const double k = 2.0 / (1.0 / GI[0] + 1.0 / GI[1]) / length;
    diagonal[e] += k;
    diagonal[e + 1] += k;
    beside[e] -= k;
    for (std::size_t g = 0; g < 2; ++g) {
      const double weight = 0.5 * length * alpha * alpha * twisting[e][g];
      const double second = g == 0 ? gauss : 1.0 - gauss, first = 1.0 - second;
      constexpr double lumped = 0.5;
      diagonal[e] -= weight * std::lerp(first * first, first, lumped);
      diagonal[e + 1] -= weight * std::lerp(second * second, second, lumped);
      beside[e] -= weight * (1.0 - lumped) * first * second;
    }
  }
  double before = 0.0;  // the pivot of the node before, zero where nothing passes
  for (std::size_t i = 0; i < count; ++i) {
    if (beam.held[i]) {
      before = 0.0;
      continue;
    }
    double pivot = diagonal[i];
    if (before > 0.0) pivot -= beside[i - 1] * beside[i - 1] / before;
    if (!(pivot > 0.0)) return false;
    before = pivot;
  }
  return true;
}

}  // namespace

std::array<double, 2> gauss_places(const TurningBeam& beam, std::size_t element) {
  const double from = beam.nodes[element], to = beam.nodes[element + 1];
  return {std::lerp(from, to, gauss), std::lerp(from, to, 1.0 - gauss)};
}

double lateral_buckling_part(const TurningBeam& beam,
                             std::span<const std::array<double, 2>> twisting,
                             std::span<const double> tipping, double known) {
  assert(twisting.size() + 1 == beam.nodes.size() && tipping.size() == beam.nodes.size());
  const auto stands = [&](double part) { return stands_at(beam, twisting, tipping, 1.0 / part); };
  if (std::none_of(beam.held.begin(), beam.held.end(), [](bool held) { return held; }))
    return std::numeric_limits<double>::infinity();
  constexpr double least = 1e-6, most = 1e30, close = 1e-5;
  double buckled = std::max(known, least), stable = buckled;
  if (stands(stable)) return known;
  while (!stands(stable *= 2.0)) {
    if (stable > most) return most;
    buckled = stable;
  }
  while (stable - buckled > close * stable) {
    const double middle = 0.5 * (stable + buckled);
    (stands(middle) ? stable : buckled) = middle;
  }
  return 0.5 * (stable + buckled);
}

}  // namespace boxbeam
