#include "level_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace boxbeam::plot {
namespace {

std::vector<double> once_each(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

double between(const std::vector<double>& of, double place) {
  const auto k = static_cast<std::size_t>(
      std::clamp(std::floor(place), 0.0, static_cast<double>(of.size() - 2)));
  return of[k] + (place - static_cast<double>(k)) * (of[k + 1] - of[k]);
}

}  // namespace

double GridOfValues::at(double column, double row) const {
  const auto i = std::min(static_cast<std::size_t>(column), x.size() - 2);
  const auto j = std::min(static_cast<std::size_t>(row), y.size() - 2);
  const double s = column - static_cast<double>(i), t = row - static_cast<double>(j);
  const auto value = [&](std::size_t a, std::size_t b) { return values[b * x.size() + a]; };
  return (1.0 - t) * ((1.0 - s) * value(i, j) + s * value(i + 1, j)) +
         t * ((1.0 - s) * value(i, j + 1) + s * value(i + 1, j + 1));
}

Eigen::Vector2d GridOfValues::place(double column, double row) const {
  return {between(x, column), between(y, row)};
}

std::optional<GridOfValues> grid_of(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& values) {
  GridOfValues grid{once_each(x), once_each(y), {}};
  const std::size_t places = grid.x.size() * grid.y.size();
  if (grid.x.size() < 3 || grid.y.size() < 3 || places != values.size()) return std::nullopt;
  std::vector<bool> taken(places, false);
  grid.values.resize(places);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto index = [](const std::vector<double>& of, double value) {
      return static_cast<std::size_t>(std::lower_bound(of.begin(), of.end(), value) - of.begin());
    };
    const std::size_t at = index(grid.y, y[k]) * grid.x.size() + index(grid.x, x[k]);
    if (taken[at]) return std::nullopt;
    taken[at] = true;
    grid.values[at] = values[k];
  }
  return grid;
}

std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> level_lines(const GridOfValues& of,
                                                                     double level) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines;
  for (std::size_t j = 0; j + 1 < of.y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < of.x.size(); ++i) {
      const std::array<std::pair<std::size_t, std::size_t>, 4> corners{
          {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      std::array<double, 4> values{};
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        values[k] = of.values[corners[k].second * of.x.size() + corners[k].first];
        sum += values[k];
      }
      if (!std::isfinite(sum)) continue;
      // Around the field: where the level is passed upwards, and downwards.
      std::vector<Eigen::Vector2d> up, down;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        const double a = values[k], b = values[next];
        if ((a < level) == (b < level)) continue;
        const Eigen::Vector2d from(of.x[corners[k].first], of.y[corners[k].second]);
        const Eigen::Vector2d to(of.x[corners[next].first], of.y[corners[next].second]);
        (a < level ? up : down).emplace_back(from + (level - a) / (b - a) * (to - from));
      }
      if (up.size() == 1) lines.emplace_back(down[0], up[0]);
      if (up.size() < 2) continue;
      // Two ways: around the low corners where the middle is high, around the high ones else.
      const bool middle_high = 0.25 * sum >= level, first_low = values[0] < level;
      const bool crossed = middle_high == first_low;
      for (std::size_t k = 0; k < 2; ++k) lines.emplace_back(down[crossed ? 1 - k : k], up[k]);
    }
  }
  return lines;
}

}  // namespace boxbeam::plot
