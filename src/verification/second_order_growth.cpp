#include "second_order_growth.hpp"

#include <algorithm>
#include <limits>

#include "boxbeam/verification/vibrating_stress.hpp"

namespace boxbeam {
namespace {

/// A range below this part of the largest stress is none, as where nothing moves.
constexpr double no_range = 1e-3;

/// A range so much smaller than the largest of all situations does no damage beside it.
constexpr double counts = 0.1;

/// The largest of so many of each place.
Eigen::ArrayXd by_place(const Eigen::ArrayXd& all, Eigen::Index of_place) {
  const Eigen::Index places = all.size() / of_place;
  return all.reshaped(of_place, places).colwise().maxCoeff().transpose();
}

Eigen::ArrayXd peaks_of(const Eigen::MatrixXd& stresses, Eigen::Index of_place) {
  return by_place(stresses.cwiseAbs().colwise().maxCoeff().transpose().array(), of_place);
}

Eigen::ArrayXd ranges_of(const Eigen::MatrixXd& stresses, Eigen::Index of_place) {
  return by_place(
      (stresses.colwise().maxCoeff() - stresses.colwise().minCoeff()).transpose().array(),
      of_place);
}

/// What is less than `least` counts as much.
double excess(double bent, double straight, double least) {
  return std::max(0.0, (bent - straight) / std::max(straight, least));
}

}  // namespace

void Compared::add(const Eigen::ArrayXd& of_straight, const Eigen::ArrayXd& of_change) {
  const Eigen::Index row = straight.rows();
  straight.conservativeResize(row + 1, of_straight.size());
  change.conservativeResize(row + 1, of_change.size());
  straight.row(row) = of_straight.transpose();
  change.row(row) = of_change.transpose();
}

double Compared::relative() const {
  const Eigen::MatrixXd bent = straight + change;
  const double peak = bent.cwiseAbs().maxCoeff();
  if (peak == 0.0) return 0.0;
  const double range = std::max(largest_range(bent), no_range * peak);
  return std::max(change.cwiseAbs().maxCoeff() / peak, largest_range(change) / range);
}

void GrowthByPlace::add(const Compared& of, const Compared& once, double factor) {
  if (of.straight.rows() == 0) return;
  const Eigen::MatrixXd bent = once.straight + once.change;
  const Situation here{factor * peaks_of(of.straight, of_place_),
                       factor * peaks_of(of.straight + of.change, of_place_),
                       ranges_of(once.straight, of_place_), ranges_of(bent, of_place_)};
  const auto join = [](Eigen::MatrixXd& all, const Eigen::MatrixXd& rows) {
    const Eigen::Index known = all.rows();
    all.conservativeResize(known + 2, rows.cols());
    all.row(known) = rows.colwise().minCoeff();
    all.row(known + 1) = rows.colwise().maxCoeff();
  };
  join(straight_, once.straight);
  join(bent_, bent);
  situations_.push_back(here);
}

void GrowthByPlace::add_to(std::vector<StressGrowth>& growth) const {
  if (situations_.empty()) return;
  Situation all{situations_.front().straight, situations_.front().bent,
                ranges_of(straight_, of_place_), ranges_of(bent_, of_place_)};
  for (const Situation& of : situations_) {
    all.straight = all.straight.max(of.straight);
    all.bent = all.bent.max(of.bent);
  }
  const double most = all.straight.maxCoeff();
  const double most_range = std::max(all.range.maxCoeff(), no_range * most);
  for (std::size_t k = 0; k < growth.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    growth[k].stress += excess(all.bent[at], all.straight[at], no_range * most);
    double range = excess(all.bent_range[at], all.range[at], no_range * most_range);
    for (const Situation& of : situations_)
      range = std::max(range, excess(of.bent_range[at], of.range[at], counts * most_range));
    growth[k].range += range;
  }
}

void raise_to(const std::vector<StressGrowth>& other, std::vector<StressGrowth>& growth) {
  for (std::size_t k = 0; k < std::min(other.size(), growth.size()); ++k) {
    growth[k].stress = std::max(growth[k].stress, other[k].stress);
    growth[k].range = std::max(growth[k].range, other[k].range);
  }
}

double second_order_growth_at(const SecondOrderEstimate& of, Length s, bool of_range) {
  if (!of.change) return std::numeric_limits<double>::infinity();
  double most = 0.0;
  const auto look = [&](const StressGrowth& at) {
    most = std::max(most, of_range ? at.range : at.stress);
  };
  for (std::size_t k = 0; k < of.growth.size(); ++k) {
    const Length here = of.growth[k].station.s;
    const bool before = here <= s && (k + 1 == of.growth.size() || of.growth[k + 1].station.s > s);
    const bool behind = here >= s && (k == 0 || of.growth[k - 1].station.s < s);
    if (before || behind) look(of.growth[k]);
  }
  return of_range ? most : std::max(most, of.sway);
}

}  // namespace boxbeam
