#include "boxbeam/verification/wall_search.hpp"

#include <algorithm>
#include <cmath>

#include "along_stretch.hpp"

namespace boxbeam {
namespace {

constexpr std::array criteria_of_walls{Criterion::yield, Criterion::fatigue,
                                       Criterion::shear_fatigue, Criterion::combined_fatigue,
                                       Criterion::stress_range};
constexpr CriterionSet all_of_walls{Criterion::yield, Criterion::fatigue, Criterion::shear_fatigue,
                                    Criterion::combined_fatigue, Criterion::stress_range};

/// The top of the parabola through a place of a grid and its neighbours, as far as they are there.
double parabola_over(const std::vector<double>& values, std::size_t k) {
  if (k == 0 || k + 1 == values.size()) {
    if (values.size() < 3) return values[k];
    k = k == 0 ? 1 : k - 1;
  }
  const double slope = 0.5 * (values[k + 1] - values[k - 1]);
  const double bend = values[k + 1] - 2.0 * values[k] + values[k - 1];
  const double largest = std::max({values[k - 1], values[k], values[k + 1]});
  if (bend >= 0.0 || std::abs(slope) > -bend) return largest;
  return std::max(largest, values[k] - 0.5 * slope * slope / bend);
}

}  // namespace

StretchUses::StretchUses(const StationSamples& samples, const StressPoint& point)
    : along_(std::make_shared<const AlongStretch>(point)), round_(point.stretch->wall.round) {
  // In the plane the flange of a section that mirrors itself is stressed evenly, and its shear
  // grows in proportion to the distance from its middle.
  if (point.stretch->only_end) {
    parts_ = {1.0};
  } else {
    const int steps = round_ ? 36 : 4;
    for (int k = 0; k <= steps; ++k) parts_.push_back(static_cast<double>(k) / steps);
  }
  judged_.reserve(parts_.size());
  for (const double part : parts_)
    judged_.push_back(samples.judge(point, along_->at(point, part), all_of_walls));
}

Extremum StretchUses::largest_near(std::size_t part, Criterion criterion,
                                   const StationSamples& samples, const StressPoint& point) const {
  for (const Top& top : tops_)
    if (top.part == part && top.criterion == criterion) return top.found;
  const double step = parts_[1] - parts_[0];
  const double low = part == 0 && !round_ ? 0.0 : parts_[part] - step;
  const double high = part + 1 == parts_.size() && !round_ ? 1.0 : parts_[part] + step;
  constexpr int bits = 10;
  const Extremum found = find_maximum(
      [&](double at) {
        return samples.judge(point, along_->at(point, at), {criterion}).of(criterion);
      },
      low, high, bits);
  tops_.push_back({part, criterion, found});
  return found;
}

std::vector<StretchUses> stretch_uses_of(const StationSamples& samples,
                                         std::span<const StressPoint> points) {
  std::vector<StretchUses> along;
  for (const StressPoint& point : points)
    if (point.stretch) along.emplace_back(samples, point);
  return along;
}

WallSearch::WallSearch(const StationSamples& samples, std::span<const StressPoint> points,
                       std::span<const StretchUses> along, const Utilisations& named) {
  for (const Criterion criterion : criteria_of_walls)
    worst_[static_cast<std::size_t>(criterion)].utilisation = named.of(criterion);
  auto next = along.begin();
  for (const StressPoint& point : points) {
    if (point.stretch) look_along(samples, point, *next++);
  }
}

void WallSearch::look_along(const StationSamples& samples, const StressPoint& point,
                            const StretchUses& along) {
  const std::vector<double>& parts = along.parts();
  std::vector<double> values(parts.size());
  for (const Criterion criterion : criteria_of_walls) {
    WorstOnWall& worst = worst_[static_cast<std::size_t>(criterion)];
    const auto take = [&](double part, double utilisation) {
      // What is not worse than round-off is not worth a place of its own.
      if (utilisation > worst.utilisation * (1.0 + 1e-9)) worst = {utilisation, &point, part};
    };
    for (std::size_t k = 0; k < parts.size(); ++k) {
      values[k] = along.at(k, criterion);
      take(parts[k], values[k]);
    }
    if (parts.size() == 1 || *std::max_element(values.begin(), values.end()) == 0.0) continue;
    for (const std::size_t k : local_maxima_of(values, along.round())) {
      if (values[k] == 0.0 || 1.02 * parabola_over(values, k) < worst.utilisation) continue;
      const Extremum found = along.largest_near(k, criterion, samples, point);
      take(found.at, found.value);
    }
  }
}

}  // namespace boxbeam
