#include "boxbeam/verification/life_cycles.hpp"

#include <cmath>

#include "boxbeam/fatigue/rainflow.hpp"

namespace boxbeam {
namespace {

std::vector<Cycle> periodic_cycles_of(const std::vector<Stress>& points) {
  // Between its highest and its lowest point a history of two has one cycle.
  if (points.size() != 2) return count_periodic_cycles(points);
  const Stress range = abs(points[0] - points[1]);
  if (range == Stress{}) return {};
  return {{range, 0.5 * (points[0] + points[1]), 1.0}};
}

}  // namespace

Turns turns_of(const Project& project, const std::vector<SituationHistory>& histories,
               const CutForceFunction& stress) {
  Turns turns(project.situations.size());
  for (const SituationHistory& at : histories) {
    const std::vector<CutForces>& samples = at.history.samples();
    turns[index_of(project, *at.situation)] = {
        at.history.turning_points(stress), stress(samples.front()),
        stress(at.history.closed() ? samples.front() : samples.back())};
  }
  return turns;
}

std::pair<Extreme, Extreme> extremes_in(const Project& project, std::size_t situation,
                                        const Turns& turns) {
  const std::vector<std::size_t>& between = project.situations[situation].between;
  const std::size_t first_of = between.empty() ? situation : between.front();
  const TurningPoint& first = turns[first_of].turns.front();
  Extreme highest{first.time, first.value, first_of};
  Extreme lowest = highest;
  const auto look_in = [&](std::size_t i) {
    for (const TurningPoint& turn : turns[i].turns) {
      if (turn.value > highest.value) highest = {turn.time, turn.value, i};
      if (turn.value < lowest.value) lowest = {turn.time, turn.value, i};
    }
  };
  if (between.empty()) look_in(situation);
  for (const std::size_t i : between) look_in(i);
  return {highest, lowest};
}

std::vector<Cycle> change_cycles(const Situation& change, const Cycle& whole, Stress first_middle) {
  if (change.spectrum.empty()) return {{whole.range, whole.mean, change.cycles}};
  std::vector<Cycle> cycles;
  for (const SpectrumLevel& level : change.spectrum) {
    cycles.push_back({level.share * whole.range,
                      si<Stress>(std::lerp(first_middle.value(), whole.mean.value(), level.share)),
                      level.cycles});
  }
  return cycles;
}

std::vector<SituationCycles> life_cycles_of(const Project& project, const Turns& turns,
                                            bool compression_reduced) {
  std::vector<SituationCycles> life;
  const auto add = [&](std::size_t index, std::vector<Cycle> cycles) {
    if (compression_reduced) cycles = boxbeam::compression_reduced(std::move(cycles));
    life.push_back({index, std::move(cycles)});
  };
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    const Situation& situation = project.situations[i];
    if (situation.cycles == 0.0) continue;
    if (situation.is_change()) {
      const auto [highest, lowest] = extremes_in(project, i, turns);
      const auto [high, low] = extremes_in(project, situation.between.front(), turns);
      add(i, change_cycles(situation,
                           {si<Stress>(highest.value - lowest.value),
                            si<Stress>(0.5 * (highest.value + lowest.value)), 1.0},
                           si<Stress>(0.5 * (high.value + low.value))));
      continue;
    }
    std::vector<Stress> stresses;
    const auto take = [&](double value) { stresses.push_back(si<Stress>(value)); };
    if (!situation.in_order) {
      for (const TurningPoint& turn : turns[i].turns) take(turn.value);
    }
    for (const std::size_t part : situation.between) {
      // Where one situation follows another, an end may be a turning point as well.
      take(turns[part].begin);
      for (const TurningPoint& turn : turns[part].turns) take(turn.value);
      take(turns[part].end);
    }
    std::vector<Cycle> cycles = periodic_cycles_of(stresses);
    for (Cycle& cycle : cycles) cycle.count *= situation.cycles;
    add(i, std::move(cycles));
  }
  return life;
}

}  // namespace boxbeam
