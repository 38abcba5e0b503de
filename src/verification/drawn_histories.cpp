#include "boxbeam/verification/drawn_histories.hpp"

#include <algorithm>

#include "boxbeam/verification/drawn_samples.hpp"

namespace boxbeam {

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
