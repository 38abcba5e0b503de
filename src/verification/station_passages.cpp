// When loads slide over a station, and what it feels on both sides of that.
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "boxbeam/verification/load_history.hpp"
#include "bracket_nodes.hpp"
#include "passed_borders.hpp"

namespace boxbeam {

const std::vector<StationHistory::Passage>& StationHistory::passages() const {
  if (!passages_) passages_ = find_passages();
  return *passages_;
}

std::vector<StationHistory::Passage> StationHistory::find_passages() const {
  std::vector<Passage> found;
  if (loads_->is_recorded()) return found;  // their places never change
  const std::size_t n = loads_->instants();
  const auto borders_at = [&](std::size_t instant) {
    return borders_before(loads_->kept_diagram(instant), station_);
  };
  std::size_t to = borders_at(closed() ? n - 1 : 0);
  for (std::size_t i = closed() ? 0 : 1; i < n; ++i) {
    const std::size_t previous = i > 0 ? i - 1 : n - 1, from = to;
    to = borders_at(i);
    if (from == to || loads_->begins_piece(i)) continue;
    const Time begin = loads_->time_of(previous) - (i > 0 ? Time{} : loads_->period());
    const std::size_t first = found.size();
    for (std::size_t border = std::min(from, to); border < std::max(from, to); ++border) {
      if (auto passage = passage_of(border, {begin, loads_->time_of(i)}, from > to)) {
        passage->instant = i;
        found.push_back(*passage);
      }
    }
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
              [](const Passage& a, const Passage& b) { return a.time < b.time; });
  }
  return found;
}

std::optional<StationHistory::Passage> StationHistory::passage_of(std::size_t border,
                                                                  const LoadHistory::Reach& within,
                                                                  bool forwards) const {
  // How far the border still has to go, below zero when it has passed. Which border it is is told
  // by their order, which changes where a load slides over one that stays: there this has a kink,
  // and where that one is the station itself, a level.
  constexpr double least = 1e-300;
  const auto left_in = [&](const CutForceDiagram& diagram) {
    const std::size_t count = borders_before(diagram, station_);
    const bool passed = forwards ? count <= border : count > border;
    const Length to_go = border_of(diagram, border) - station_.s;
    const double left = std::max(std::abs(to_go.value()), least);
    return passed ? -left : left;
  };
  const LoadHistory::Bracket& bracket = loads_->bracket(within);
  std::array<double, LoadHistory::nodes> left{};
  std::transform(bracket.begin(), bracket.end(), left.begin(), left_in);
  std::size_t k = 1;
  while (k < last_node && left[k] > 0.0) ++k;
  if (left[k - 1] < 0.0 || left[k] > 0.0) return std::nullopt;

  const double begin = within.from.value(), end = within.to.value();
  const auto time_at = [&](double u) {
    return si<Time>(0.5 * (begin + end) + 0.5 * (end - begin) * u);
  };
  // On either side of the passage, this near; nearer, what stands beside a border counts as on it.
  constexpr double near = 1e-5;
  CutForceDiagram before, behind;
  const auto look_at = [&](double u) {
    CutForceDiagram at = loads_->diagram_at(time_at(u));
    const double value = left_in(at);
    (value > 0.0 ? before : behind) = std::move(at);
    return value;
  };
  double low = BracketPoints::point(k - 1), high = BracketPoints::point(k);
  constexpr int bisections = 32;
  for (int i = 0; i < bisections; ++i) {
    const double half = 0.5 * (low + high);
    (interpolate(left, half) > 0.0 ? low : high) = half;
  }
  double passed_at = low;
  if (!(look_at(low - near) > 0.0 && look_at(low + near) < 0.0)) {
    std::uintmax_t most = 100;
    const auto [from, to] = boost::math::tools::toms748_solve(
        look_at, BracketPoints::point(k - 1), BracketPoints::point(k), left[k - 1], left[k],
        [](double a, double b) { return b - a <= near; }, most);
    passed_at = 0.5 * (from + to);
    if (!(look_at(from - near) > 0.0 && look_at(to + near) < 0.0)) return std::nullopt;
  }
  return Passage{0, time_at(passed_at), before.at(station_), behind.at(station_)};
}

}  // namespace boxbeam
