#include "bracket_nodes.hpp"

#include <numbers>
#include <utility>

namespace boxbeam {
namespace {

using Shares = std::array<double, LoadHistory::nodes>;

/// What each node counts in a coefficient, by its degree.
std::array<Shares, LoadHistory::nodes> shares_by_degree() {
  std::array<Shares, LoadHistory::nodes> shares{};
  for (std::size_t degree = 0; degree <= last_node; ++degree) {
    for (std::size_t k = 0; k <= last_node; ++k) {
      // The point is the cos of the angle pi - pi k/n
      const double angle = std::numbers::pi *
                           (1.0 - static_cast<double>(k) / static_cast<double>(last_node)) *
                           static_cast<double>(degree);
      const double share = (k == 0 || k == last_node) ? 0.5 : 1.0;
      shares[degree][k] = share * std::cos(angle);
    }
  }
  return shares;
}

/// The last coefficients of the Chebyshev series of the polynomial through the nodes: how much of
/// it the highest waves are.
CutForces chebyshev_coefficient(const std::array<CutForces, LoadHistory::nodes>& values,
                                std::size_t degree) {
  static const auto shares = shares_by_degree();
  CutForces sum{};
  for (std::size_t k = 0; k <= last_node; ++k) sum = sum_of(sum, shares[degree][k], values[k]);
  const double all = static_cast<double>(last_node) * (degree == last_node ? 2.0 : 1.0);
  return sum_of({}, 2.0 / all, sum);
}

}  // namespace

double defect_of(const std::array<CutForces, LoadHistory::nodes>& at, double force_floor,
                 double moment_floor) {
  double defect = 0.0;
  for (const auto& [degree, part] :
       {std::pair{last_node, 1e-7}, {last_node - 1, 1.5e-6}, {last_node - 2, 2e-5}}) {
    const CutForces last = chebyshev_coefficient(at, degree);
    if (force_in(last) > 0.0) defect = std::max(defect, force_in(last) / (part * force_floor));
    if (moment_in(last) > 0.0) defect = std::max(defect, moment_in(last) / (part * moment_floor));
  }
  return defect;
}

}  // namespace boxbeam
