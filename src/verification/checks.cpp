#include "boxbeam/verification/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/fatigue/rainflow.hpp"

namespace boxbeam {
namespace {

std::string yield_source(const Material& material) {
  return "EN 1993-1-1:2005, 6.2.1(5) (elastic, von Mises); yield strength by " + material.source;
}

const char* fatigue_source(const FatigueInput& fatigue) {
  if (fatigue.published_step) {
    return "sledge-rig thesis, 4.8.2: the category taken at 5e6 cycles (not EN 1993-1-9)";
  }
  return fatigue.demand.loading == Loading::spectrum
             ? "EN 1993-1-9:2005+AC:2009, 7.1(3), 8, annex A.5"
             : "EN 1993-1-9:2005+AC:2009, 7.1(2), 8";
}

/// A name without spaces: "hole hub edge +z" is "hole-hub-edge+z".
std::string one_word(const std::string& name) {
  std::string word;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool before_sign =
        name[i] == ' ' && i + 1 < name.size() && (name[i + 1] == '+' || name[i + 1] == '-');
    if (!before_sign) word += name[i] == ' ' ? '-' : name[i];
  }
  return word;
}

/// "yield/4.2-/hole-hub-edge+z": no spaces, so that an id is one word on a command line.
std::string id_of(Criterion criterion, const Station& station, const std::string& point) {
  return fmt::format("{}/{}/{}", one_word(to_text(criterion)), to_text(station), one_word(point));
}

CutForceFunction normal_stress(const StressPoint& point) {
  return [&point](const CutForces& cut) { return stress_at(point.level, cut).normal.value(); };
}

/// The check's frame, and the stress in the situation where it is worst.
CheckResult start(Criterion criterion, const Project& project, const StressPoint& point,
                  const SituationHistory& worst, const CutForceFunction& stress) {
  CheckResult result;
  result.check.criterion = criterion;
  result.check.station = point.station;
  result.check.point = point.name;
  result.check.id = id_of(criterion, point.station, point.name);
  result.check.situation = worst.situation->name;
  CheckBasis& basis = result.basis.emplace();
  basis.point = point;
  basis.running = index_of(project, *worst.situation);
  const StationHistory& history = worst.history;
  for (std::size_t i = 0; i < history.samples().size(); ++i) {
    basis.times.push_back(history.time_of(i).value());
    basis.history.push_back(stress(history.samples()[i]));
  }
  if (history.closed()) {
    basis.times.push_back(basis.times.front() + history.period().value());
    basis.history.push_back(basis.history.front());
  }
  return result;
}

/// The turning points of a stress in every situation that runs; by the situation's index.
using Turns = std::vector<std::vector<TurningPoint>>;

Turns turns_of(const Project& project, const std::vector<SituationHistory>& histories,
               const CutForceFunction& stress) {
  Turns turns(project.situations.size());
  for (const SituationHistory& at : histories) {
    turns[index_of(project, *at.situation)] = at.history.turning_points(stress);
  }
  return turns;
}

/// The highest and the lowest stress in a situation, or in those between which it changes.
std::pair<Extreme, Extreme> extremes_in(const Project& project, std::size_t situation,
                                        const Turns& turns) {
  std::vector<std::size_t> among = project.situations[situation].between;
  if (among.empty()) among = {situation};
  const TurningPoint& first = turns[among.front()].front();
  Extreme highest{first.time, first.value, among.front()};
  Extreme lowest = highest;
  for (const std::size_t i : among) {
    for (const TurningPoint& turn : turns[i]) {
      if (turn.value > highest.value) highest = {turn.time, turn.value, i};
      if (turn.value < lowest.value) lowest = {turn.time, turn.value, i};
    }
  }
  return {highest, lowest};
}

/// All cycles of the wanted life.
std::vector<SpectrumRow> spectrum_of(const Project& project, const Turns& turns) {
  std::vector<SpectrumRow> spectrum;
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    const Situation& situation = project.situations[i];
    if (situation.cycles == 0.0) continue;
    if (!situation.between.empty()) {
      const auto [highest, lowest] = extremes_in(project, i, turns);
      const double range = highest.value - lowest.value;
      const double mean = 0.5 * (highest.value + lowest.value);
      spectrum.push_back(
          {situation.name, {si<Stress>(range), si<Stress>(mean), situation.cycles}, 0.0});
      continue;
    }
    std::vector<Stress> stresses;
    stresses.reserve(turns[i].size());
    for (const TurningPoint& turn : turns[i]) stresses.push_back(si<Stress>(turn.value));
    for (Cycle& cycle : count_periodic_cycles(stresses)) {
      cycle.count *= situation.cycles;
      spectrum.push_back({situation.name, cycle, 0.0});
    }
  }
  return spectrum;
}

/// The situation whose cycles take the largest part of the life, or have the largest range where
/// none does damage.
std::size_t governing_situation(const Project& project, const std::vector<SpectrumRow>& spectrum) {
  std::size_t worst = 0;
  std::pair<double, double> most{-1.0, -1.0};
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    std::pair<double, double> of{0.0, 0.0};
    for (const SpectrumRow& row : spectrum) {
      if (row.situation != project.situations[i].name) continue;
      of.first += row.cycle.count / row.endured;
      of.second = std::max(of.second, row.cycle.range.value());
    }
    if (of <= most) continue;
    most = of;
    worst = i;
  }
  return worst;
}

const SituationHistory& history_of(const std::vector<SituationHistory>& histories,
                                   const Situation& situation) {
  return *std::find_if(histories.begin(), histories.end(),
                       [&](const SituationHistory& at) { return at.situation == &situation; });
}

Stress rounded(Stress stress, Stress step) {
  return si<Stress>(std::round(stress.value() / step.value()) * step.value());
}

}  // namespace

std::optional<CheckResult> check_yield(const Project& project,
                                       const std::vector<SituationHistory>& histories,
                                       const StressPoint& point) {
  const SituationHistory* worst = nullptr;
  TurningPoint largest;
  for (const SituationHistory& at : histories) {
    TurningPoint in = at.history.largest(
        [&](const CutForces& cut) { return stress_at(point.level, cut).von_mises().value(); });
    in.value *= at.situation->load_factor;
    if (worst != nullptr && in.value <= largest.value) continue;
    worst = &at;
    largest = in;
  }
  if (largest.value < 1e-9 * point.yield_strength.value()) return std::nullopt;
  CheckResult result = start(Criterion::yield, project, point, *worst, normal_stress(point));
  Check& check = result.check;
  check.time = largest.time;
  check.acting = si<Stress>(largest.value);
  check.resisting = point.yield_strength / project.strength.gamma_M0;
  check.safety_factor = check.resisting / check.acting;
  check.required = project.strength.required;
  check.source = yield_source(project.material);
  CheckBasis& basis = *result.basis;
  basis.cut_at_time = basis.cut_at_highest = basis.cut_at_lowest = worst->history.at(largest.time);
  basis.stress_at_time = stress_at(point.level, basis.cut_at_time);
  const double normal = basis.stress_at_time.normal.value();
  basis.highest = basis.lowest = {largest.time, normal, basis.running};
  return result;
}

std::optional<CheckResult> check_fatigue(const Project& project,
                                         const std::vector<SituationHistory>& histories,
                                         const StressPoint& point) {
  const CutForceFunction stress = normal_stress(point);
  const Turns turns = turns_of(project, histories, stress);
  std::vector<SpectrumRow> spectrum = spectrum_of(project, turns);
  std::vector<Cycle> cycles;
  double largest = 0.0;
  for (const SpectrumRow& row : spectrum) {
    cycles.push_back(row.cycle);
    largest = std::max(largest, row.cycle.range.value());
  }
  if (largest < 1e-9 * point.yield_strength.value()) return std::nullopt;

  const FatigueInput& fatigue = project.fatigue;
  const SnCurve curve = curve_of(fatigue, point.category);
  const double factor = largest_factor(cycles, curve, fatigue.demand);
  const auto endure = [&](double k) {
    for (SpectrumRow& row : spectrum) {
      row.endured = cycles_to_failure_in(cycles, row.cycle, curve, fatigue.demand, k);
    }
  };
  // Just above the factor, where the life is used up: at it a range may stand below the cut-off.
  endure(factor * (1.0 + 1e-9));
  const std::size_t governing = governing_situation(project, spectrum);
  endure(factor);
  const auto [highest, lowest] = extremes_in(project, governing, turns);
  const bool upper = std::abs(highest.value) >= std::abs(lowest.value);
  const auto in = [&](const Extreme& extreme) -> const SituationHistory& {
    return history_of(histories, project.situations[extreme.situation]);
  };

  CheckResult result =
      start(Criterion::fatigue, project, point, in(upper ? highest : lowest), stress);
  Check& check = result.check;
  check.situation = project.situations[governing].name;
  check.time = (upper ? highest : lowest).time;
  const Stress range = si<Stress>(highest.value - lowest.value);
  check.acting = range;
  check.safety_factor = factor;
  // The range that the life allows, partial factors applied; of a spectrum, its largest range.
  check.resisting = factor * range;
  check.required = fatigue.required;
  check.source = fatigue_source(fatigue);
  CheckBasis& basis = *result.basis;
  basis.highest = highest;
  basis.lowest = lowest;
  basis.cut_at_highest = in(highest).history.at(highest.time);
  basis.cut_at_lowest = in(lowest).history.at(lowest.time);
  basis.cut_at_time = upper ? basis.cut_at_highest : basis.cut_at_lowest;
  basis.stress_at_time = stress_at(point.level, basis.cut_at_time);
  basis.spectrum = std::move(spectrum);
  FatigueDemand constant = fatigue.demand;
  constant.loading = Loading::constant_amplitude;
  basis.constant_amplitude_factor = largest_factor(cycles, curve, constant);
  basis.damage = damage_of(cycles, curve, fatigue.demand);
  basis.equivalent = equivalent_range(basis.damage, curve, fatigue.demand);
  basis.knee = knee_of(curve);
  basis.cut_off = cut_off_of(curve);
  return result;
}

std::vector<CheckResult> check_beam(const Project& project, const std::deque<SituationRun>& runs,
                                    const std::vector<Station>& stations) {
  std::vector<CheckResult> results;
  for (const Station& station : stations) {
    const std::vector<SituationHistory> histories = histories_at(runs, station);
    for (const StressPoint& point : stress_points_at(project, station)) {
      const auto add = [&](std::optional<CheckResult> result) {
        if (result) results.push_back(std::move(*result));
      };
      add(check_yield(project, histories, at_worst_edge(point, histories, Criterion::yield)));
      if (!point.fatigue) continue;
      add(check_fatigue(project, histories, at_worst_edge(point, histories, Criterion::fatigue)));
    }
  }
  if (results.empty()) {
    throw AnalysisError(
        {"nothing to verify: no point of the beam is ever stressed", "beam", {}, {}, {}});
  }
  return results;
}

std::vector<CheckResult> check_given_stresses(const Project& project) {
  std::vector<CheckResult> results;
  for (const GivenStress& given : project.given_stresses) {
    const Station station{given.s, Side::both};
    const auto add = [&](Criterion criterion, Stress acting, Stress resisting, double required,
                         const std::string& source) {
      CheckResult result;
      Check& check = result.check;
      check.id = id_of(criterion, station, given.name);
      check.criterion = criterion;
      check.station = station;
      check.point = given.name;
      check.time = given.time;
      check.acting = acting;
      check.resisting = resisting;
      check.safety_factor = resisting / acting;
      check.required = required;
      check.source = source;
      results.push_back(std::move(result));
    };
    const Stress yield = yield_strength_of(project.material, given.thickness).value();
    add(Criterion::yield, given.peak, yield / project.strength.gamma_M0, project.strength.required,
        yield_source(project.material));
    if (!given.opposite) continue;
    const FatigueInput& fatigue = project.fatigue;
    Stress strength = strength_at(curve_of(fatigue, fatigue.category), most_cycles_of(project),
                                  fatigue.demand.loading);
    if (fatigue.round_strength_to) strength = rounded(strength, *fatigue.round_strength_to);
    add(Criterion::fatigue, given.peak + *given.opposite,
        strength / (fatigue.demand.gamma_Ff * fatigue.demand.gamma_Mf), fatigue.required,
        fatigue_source(fatigue));
  }
  return results;
}

}  // namespace boxbeam
