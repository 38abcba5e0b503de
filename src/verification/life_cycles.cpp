#include "boxbeam/verification/life_cycles.hpp"

#include <cmath>

#include "boxbeam/fatigue/rainflow.hpp"

namespace boxbeam {
namespace {

/// The cycles of a situation that has any, as often as the wanted life asks for.
void add_cycles_of(const Project& project, std::size_t index, const Turns& turns,
                   std::vector<Cycle>& all) {
  const Situation& situation = project.situations[index];
  if (situation.is_change()) {
    const auto [highest, lowest] = extremes_in(project, index, turns);
    const auto [high, low] = extremes_in(project, situation.between.front(), turns);
    const Cycle whole{si<Stress>(highest.value - lowest.value),
                      si<Stress>(0.5 * (highest.value + lowest.value)), 1.0};
    const std::vector<Cycle> cycles =
        change_cycles(situation, whole, si<Stress>(0.5 * (high.value + low.value)));
    all.insert(all.end(), cycles.begin(), cycles.end());
    return;
  }
  const std::vector<TurningPoint>& own = turns[index].turns;
  if (!situation.in_order && own.size() == 2) {
    // Between its highest and its lowest point a history of two has one cycle.
    const double range = std::abs(own[0].value - own[1].value);
    const double mean = 0.5 * (own[0].value + own[1].value);
    if (range != 0.0) all.push_back({si<Stress>(range), si<Stress>(mean), situation.cycles});
    return;
  }
  std::vector<Stress> stresses;
  const auto take = [&](double value) { stresses.push_back(si<Stress>(value)); };
  if (!situation.in_order) {
    for (const TurningPoint& turn : own) take(turn.value);
  }
  for (const std::size_t part : situation.between) {
    // Where one situation follows another, an end may be a turning point as well.
    take(turns[part].begin);
    for (const TurningPoint& turn : turns[part].turns) take(turn.value);
    take(turns[part].end);
  }
  for (Cycle& cycle : count_periodic_cycles(stresses)) {
    cycle.count *= situation.cycles;
    all.push_back(cycle);
  }
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
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    if (project.situations[i].cycles == 0.0) continue;
    std::vector<Cycle> cycles;
    add_cycles_of(project, i, turns, cycles);
    if (compression_reduced) cycles = boxbeam::compression_reduced(std::move(cycles));
    life.push_back({i, std::move(cycles)});
  }
  return life;
}

void count_life_cycles(const Project& project, const Turns& turns, bool compression_reduced,
                       std::vector<Cycle>& cycles) {
  cycles.clear();
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    if (project.situations[i].cycles != 0.0) add_cycles_of(project, i, turns, cycles);
  }
  if (compression_reduced) cycles = boxbeam::compression_reduced(std::move(cycles));
}

}  // namespace boxbeam
