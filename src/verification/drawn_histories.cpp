#include "boxbeam/verification/drawn_histories.hpp"

#include <algorithm>
#include <numeric>

namespace boxbeam {

std::vector<std::size_t> drawn_samples(
    std::size_t n, const std::vector<std::function<double(std::size_t)>>& values) {
  constexpr std::size_t most = 4000;
  std::vector<std::size_t> drawn;
  if (n <= most) {
    drawn.resize(n);
    std::iota(drawn.begin(), drawn.end(), std::size_t{0});
    return drawn;
  }
  const std::size_t stretches = most / (2 * std::max<std::size_t>(1, values.size()));
  drawn = {0, n - 1};
  for (std::size_t k = 0; k < stretches; ++k) {
    const std::size_t from = k * n / stretches, to = (k + 1) * n / stretches;
    for (const auto& value : values) {
      std::size_t low = from, high = from;
      for (std::size_t i = from; i < to; ++i) {
        if (value(i) < value(low)) low = i;
        if (value(i) > value(high)) high = i;
      }
      drawn.push_back(low);
      drawn.push_back(high);
    }
  }
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  return drawn;
}

std::vector<std::size_t> drawn_over_time(const std::vector<CheckResult>& checks) {
  constexpr std::size_t most = 3;
  const CheckResult* governing = governing_of(checks, Criterion::fatigue);
  if (governing == nullptr || !governing->basis) governing = governing_of(checks, Criterion::yield);
  if (governing == nullptr || !governing->basis) return {};
  std::vector<std::size_t> drawn{static_cast<std::size_t>(governing - checks.data())};
  for (std::size_t i = 0; i < checks.size() && drawn.size() < most; ++i) {
    const CheckResult& of = checks[i];
    if (of.check.criterion != governing->check.criterion || !of.basis ||
        of.basis->running != governing->basis->running)
      continue;
    const bool same_station = std::any_of(drawn.begin(), drawn.end(), [&](std::size_t other) {
      return checks[other].check.station == of.check.station;
    });
    if (!same_station) drawn.push_back(i);
  }
  return drawn;
}

void find_drawn_histories(const Project& project, const std::deque<SituationRun>& runs,
                          std::vector<CheckResult>& checks) {
  for (const std::size_t drawn : drawn_over_time(checks)) {
    const Check& check = checks[drawn].check;
    CheckBasis& basis = *checks[drawn].basis;
    const LoadHistory& loads = run_of(runs, project.situations[basis.running]).loads;
    const std::vector<CutForces> cuts = loads.cuts_at(check.station);
    const StressInfluence& influence = basis.point.influence;
    const auto stress_at = [&](std::size_t i) {
      return basis.stress_factor *
             stress_of(basis.kind == StressKind::direct ? influence.normal : influence.shear,
                       cuts[i]);
    };
    for (const std::size_t i : drawn_samples(cuts.size(), {stress_at})) {
      basis.times.push_back(loads.time_of(i).value());
      basis.history.push_back(stress_at(i));
    }
    if (!loads.closed()) continue;
    basis.times.push_back(basis.times.front() + loads.period().value());
    basis.history.push_back(basis.history.front());
  }
}

}  // namespace boxbeam
