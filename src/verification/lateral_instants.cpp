#include "lateral_instants.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

void LateralInstants::look_at(const SituationRun& run, Time time, const CutForceDiagram& diagram,
                              const BeamLoads& loads, const HeldAt<std::vector<double>>& turning,
                              double factor) {
  const double part = factor * estimate_.part(diagram, loads, turning.at, most_.part / factor);
  if (part <= most_.part) return;
  most_ = {part, time, index_of(*project_, *run.situation), turning.words, !turning.said};
}

void LateralInstants::look_at_all(const SituationRun& run, double factor) {
  const LoadHistory& history = run.loads;
  const auto loads_of = [&](std::size_t i) { return history.loads_at(history.time_of(i)); };
  const auto turning_of = [&](const std::vector<double>& supports) {
    return holds_of(*project_, supports).turning;
  };
  constexpr double nodes_apart = 1.05;  // the envelope has no node where forces act
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const std::vector<double> supports = run.motion->supports(loads_of(0));
  const std::vector<double> at = turning_of(supports).at;
  estimate_.screen(at);
  std::vector<bool> alike(history.instants(), true);
  for (std::size_t i = 0; i < history.instants(); ++i) {
    const BeamLoads loads = loads_of(i);
    const std::vector<double> now = run.motion->supports(loads);
    alike[i] = now == supports || turning_of(now).at == at;
    if (alike[i]) estimate_.widen(history.diagram(i), loads);
  }
  const double bound = nodes_apart * factor * estimate_.bound();
  const bool all_alike = std::all_of(alike.begin(), alike.end(), [](bool of) { return of; });
  if (all_alike && bound <= std::max(most_.part, no_turning_over_below)) return;
  std::vector<std::pair<double, std::size_t>> at_most;
  for (std::size_t i = 0; i < history.instants(); ++i) {
    const double share = alike[i] ? estimate_.share(history.diagram(i), loads_of(i)) : unbounded;
    at_most.emplace_back(alike[i] ? bound * share : unbounded, i);
  }
  std::sort(at_most.begin(), at_most.end(), std::greater<>());
  for (const auto& [most, i] : at_most) {
    if (most <= most_.part) break;
    const BeamLoads loads = loads_of(i);
    look_at(run, history.time_of(i), history.diagram(i), loads,
            turning_of(run.motion->supports(loads)), factor);
  }
}

}  // namespace boxbeam
