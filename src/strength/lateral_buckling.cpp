#include "boxbeam/strength/lateral_buckling.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace boxbeam {
namespace {

constexpr double gauss = 0.5 - 0.5 / std::numbers::sqrt3;

/// A symmetric matrix of which each row reaches three places to the left, row by row.
class Banded {
 public:
  explicit Banded(std::size_t count) : rows_(count) {}

  /// Nothing of what is held, -1.
  void add(int i, int j, double value) {
    if (i < 0 || j < 0) return;
    const auto [low, high] = std::minmax(i, j);
    rows_[static_cast<std::size_t>(high)][static_cast<std::size_t>(reach - high + low)] += value;
  }

  /// Whether all pivots are above zero.
  bool is_definite() && {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      auto& row = rows_[i];
      const std::size_t first = i < reach ? reach - i : 0;
      for (std::size_t j = first; j < reach; ++j) {
        const auto& other = rows_[i + j - reach];
        for (std::size_t k = first; k < j; ++k) {
          const std::size_t of_other = k + reach - j;
          row[j] -= row[k] * other[of_other] * rows_[i + k - reach][reach];
        }
        row[j] /= other[reach];
      }
      for (std::size_t k = first; k < reach; ++k)
        row[reach] -= row[k] * row[k] * rows_[i + k - reach][reach];
      if (!(row[reach] > 0.0)) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t reach = 3;
  std::vector<std::array<double, reach + 1>> rows_;
};

/// The unknowns of a beam: how its nodes turn, and phi' on both sides of those that bound an
/// element with E I_w, one where it is the same on both.
struct Unknowns {
  std::vector<int> phi, before, behind;
  int count = 0;
};

double warping_in(const TurningBeam& beam, std::size_t element) {
  return beam.warping_stiffness.empty() ? 0.0 : beam.warping_stiffness[element];
}

Unknowns unknowns_of(const TurningBeam& beam) {
  const std::size_t count = beam.nodes.size();
  Unknowns of{std::vector<int>(count, -1), std::vector<int>(count, -1), std::vector<int>(count, -1),
              0};
  for (std::size_t i = 0; i < count; ++i) {
    const double before = i > 0 ? warping_in(beam, i - 1) : 0.0;
    const double behind = i + 1 < count ? warping_in(beam, i) : 0.0;
    constexpr double round_off = 1e-9;
    const bool parted = !beam.parted.empty() && beam.parted[i];
    const bool on = !parted && std::abs(before - behind) <= round_off * std::max(before, behind);
    if (before > 0.0 && !on) of.before[i] = of.count++;
    if (!beam.held[i]) of.phi[i] = of.count++;
    if (behind > 0.0) of.behind[i] = of.count++;
    if (before > 0.0 && on) of.before[i] = of.behind[i];
  }
  return of;
}

/// Linear shapes of phi; half of B is lumped at the nodes, by which its error is of the fourth
/// order.
void add_linear(const std::array<double, 2>& GI, const std::array<double, 2>& twists, double length,
                const std::array<int, 2>& at, Banded& matrix) {
  const double k = 2.0 / (1.0 / GI[0] + 1.0 / GI[1]) / length;
  matrix.add(at[0], at[0], k);
  matrix.add(at[1], at[1], k);
  matrix.add(at[0], at[1], -k);
  for (std::size_t g = 0; g < 2; ++g) {
    const double weight = 0.5 * length * twists[g];
    const double second = g == 0 ? gauss : 1.0 - gauss, first = 1.0 - second;
    constexpr double lumped = 0.5;
    matrix.add(at[0], at[0], -weight * std::lerp(first * first, first, lumped));
    matrix.add(at[1], at[1], -weight * std::lerp(second * second, second, lumped));
    matrix.add(at[0], at[1], -weight * (1.0 - lumped) * first * second);
  }
}

/// Cubic shapes of phi. Three places of integration, for two would leave a shape without phi' at
/// both; what is known at two is taken for linear.
void add_cubic(const std::array<double, 2>& GI, double EI_w, const std::array<double, 2>& twists,
               double length, const std::array<int, 4>& at, Banded& matrix) {
  struct Place {
    double x, weight;
  };
  const double off = 0.5 * std::sqrt(0.6);
  for (const auto& [x, weight] :
       {Place{0.5 - off, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.5 + off, 5.0 / 18.0}}) {
    const double part = (x - gauss) / (1.0 - 2.0 * gauss);
    const double stiff = std::lerp(GI[0], GI[1], part),
                 twist = std::lerp(twists[0], twists[1], part);
    const std::array phi{1.0 - x * x * (3.0 - 2.0 * x), length * x * (1.0 - x) * (1.0 - x),
                         -length * x * x * (1.0 - x), x * x * (3.0 - 2.0 * x)};
    const double slope = 6.0 * x * (1.0 - x) / length, bend = (6.0 - 12.0 * x) / (length * length);
    const std::array first{-slope, 1.0 - x * (4.0 - 3.0 * x), x * (3.0 * x - 2.0), slope};
    const std::array second{-bend, (6.0 * x - 4.0) / length, (6.0 * x - 2.0) / length, bend};
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        matrix.add(at[i], at[j],
                   weight * length *
                       (stiff * first[i] * first[j] + EI_w * second[i] * second[j] -
                        twist * phi[i] * phi[j]));
      }
    }
  }
}

/// Whether all pivots of K - alpha H - alpha^2 B are above zero.
bool stands_at(const TurningBeam& beam, const Unknowns& unknowns,
               std::span<const std::array<double, 2>> twisting, std::span<const double> tipping,
               double alpha) {
  Banded matrix(static_cast<std::size_t>(unknowns.count));
  for (std::size_t i = 0; i < beam.nodes.size(); ++i)
    matrix.add(unknowns.phi[i], unknowns.phi[i], -alpha * tipping[i]);
  for (std::size_t e = 0; e + 1 < beam.nodes.size(); ++e) {
    const double length = beam.nodes[e + 1] - beam.nodes[e], EI_w = warping_in(beam, e);
    const std::array<double, 2>& GI = beam.turning_stiffness[e];
    const std::array twists{alpha * alpha * twisting[e][0], alpha * alpha * twisting[e][1]};
    if (EI_w > 0.0) {
      add_cubic(GI, EI_w, twists, length,
                {unknowns.phi[e], unknowns.behind[e], unknowns.before[e + 1], unknowns.phi[e + 1]},
                matrix);
      continue;
    }
    if (!(GI[0] > 0.0 && GI[1] > 0.0)) return false;
    add_linear(GI, twists, length, {unknowns.phi[e], unknowns.phi[e + 1]}, matrix);
  }
  return std::move(matrix).is_definite();
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
  const Unknowns unknowns = unknowns_of(beam);
  const auto stands = [&](double part) {
    return stands_at(beam, unknowns, twisting, tipping, 1.0 / part);
  };
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
