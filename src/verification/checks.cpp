#include "boxbeam/verification/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

constexpr const char* yield_source =
    "EN 1993-1-1:2005, 6.2.1(5) (elastic, von Mises); yield strength EN 10025-2";

const char* fatigue_source(const FatigueInput& fatigue) {
  if (fatigue.curve == CurveKind::published_step) {
    return "sledge-rig thesis, 4.8.2: the category taken at 5e6 cycles (not EN 1993-1-9)";
  }
  return fatigue.demand.loading == Loading::spectrum
             ? "EN 1993-1-9:2005+AC:2009, 7.1(3), 8, annex A.5"
             : "EN 1993-1-9:2005+AC:2009, 7.1(2), 8";
}

/// "yield/4.2-/hole-hub-edge+z": no spaces, so that an id is one word on a command line.
std::string id_of(Criterion criterion, const Station& station, const std::string& point) {
  std::string word;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const bool before_sign =
        point[i] == ' ' && i + 1 < point.size() && (point[i + 1] == '+' || point[i + 1] == '-');
    if (!before_sign) word += point[i] == ' ' ? '-' : point[i];
  }
  return fmt::format("{}/{}/{}", to_text(criterion), to_text(station), word);
}

SnCurve curve_of(const FatigueInput& fatigue, int category) {
  return {si<Stress>(category * 1e6), fatigue.curve};
}

/// The check's frame, and the normal stress over the period.
CheckResult start(Criterion criterion, const StressPoint& point, const StationHistory& history) {
  CheckResult result;
  result.check.criterion = criterion;
  result.check.station = point.station;
  result.check.point = point.name;
  result.check.id = id_of(criterion, point.station, point.name);
  CheckBasis& basis = result.basis.emplace();
  basis.point = point;
  basis.history.reserve(history.samples().size());
  for (const CutForces& cut : history.samples()) {
    basis.history.push_back(stress_at(point.influence, cut).normal.value());
  }
  return result;
}

CutForceFunction normal_stress(const StressPoint& point) {
  return [&point](const CutForces& cut) { return stress_at(point.influence, cut).normal.value(); };
}

void fill_instants(CheckResult& result, const StationHistory& history) {
  CheckBasis& basis = *result.basis;
  basis.cut_at_highest = history.at(basis.highest.time);
  basis.cut_at_lowest = history.at(basis.lowest.time);
  basis.cut_at_time = history.at(result.check.time);
  basis.stress_at_time = stress_at(basis.point.influence, basis.cut_at_time);
}

Stress rounded(Stress stress, Stress step) {
  return si<Stress>(std::round(stress.value() / step.value()) * step.value());
}

}  // namespace

std::optional<CheckResult> check_yield(const Project& project, const StationHistory& history,
                                       const StressPoint& point) {
  const TurningPoint worst = history.largest(
      [&](const CutForces& cut) { return stress_at(point.influence, cut).von_mises().value(); });
  if (worst.value < 1e-9 * point.yield_strength.value()) return std::nullopt;
  CheckResult result = start(Criterion::yield, point, history);
  Check& check = result.check;
  check.time = worst.time;
  check.acting = si<Stress>(worst.value);
  check.resisting = point.yield_strength / project.strength.gamma_M0;
  check.safety_factor = check.resisting / check.acting;
  check.required = project.strength.required;
  check.source = yield_source;
  const double normal = normal_stress(point)(history.at(worst.time));
  result.basis->highest = result.basis->lowest = {worst.time, normal, normal > 0.0};
  fill_instants(result, history);
  return result;
}

std::optional<CheckResult> check_fatigue(const Project& project, const StationHistory& history,
                                         const StressPoint& point) {
  const std::vector<TurningPoint> turns = history.turning_points(normal_stress(point));
  std::vector<Stress> stresses;
  stresses.reserve(turns.size());
  for (const TurningPoint& turn : turns) stresses.push_back(si<Stress>(turn.value));
  const std::vector<Cycle> cycles = count_periodic_cycles(stresses);
  if (cycles.empty()) return std::nullopt;

  const auto by_value = [](const TurningPoint& a, const TurningPoint& b) {
    return a.value < b.value;
  };
  const auto [lowest, highest] = std::minmax_element(turns.begin(), turns.end(), by_value);
  const Stress range = si<Stress>(highest->value - lowest->value);
  if (range.value() < 1e-9 * point.yield_strength.value()) return std::nullopt;

  const FatigueInput& fatigue = project.fatigue;
  const SnCurve curve = curve_of(fatigue, point.category);
  CheckResult result = start(Criterion::fatigue, point, history);
  Check& check = result.check;
  check.time = std::abs(highest->value) >= std::abs(lowest->value) ? highest->time : lowest->time;
  check.acting = range;
  check.safety_factor = largest_factor(cycles, curve, fatigue.demand);
  // The range that the life allows, partial factors applied; of a spectrum, its largest range.
  check.resisting = check.safety_factor * range;
  check.required = fatigue.required;
  check.source = fatigue_source(fatigue);
  CheckBasis& basis = *result.basis;
  basis.highest = *highest;
  basis.lowest = *lowest;
  basis.cycles = cycles;
  for (const Cycle& cycle : cycles) {
    basis.endured.push_back(
        cycles_to_failure_in(cycles, cycle, curve, fatigue.demand, check.safety_factor));
  }
  FatigueDemand constant = fatigue.demand;
  constant.loading = Loading::constant_amplitude;
  basis.constant_amplitude_factor = largest_factor(cycles, curve, constant);
  basis.knee = knee_of(curve);
  basis.cut_off = cut_off_of(curve);
  fill_instants(result, history);
  return result;
}

std::vector<CheckResult> check_beam(const Project& project, const LoadHistory& loads,
                                    const std::vector<Station>& stations) {
  std::vector<CheckResult> results;
  for (const Station& station : stations) {
    const StationHistory history(loads, station);
    for (const StressPoint& point : stress_points_at(project, station)) {
      const auto add = [&](std::optional<CheckResult> result) {
        if (result) results.push_back(std::move(*result));
      };
      add(check_yield(project, history, at_worst_edge(point, history, Criterion::yield)));
      if (!point.fatigue) continue;
      add(check_fatigue(project, history, at_worst_edge(point, history, Criterion::fatigue)));
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
                         const char* source) {
      CheckResult result;
      result.check = {id_of(criterion, station, given.name),
                      criterion,
                      station,
                      given.name,
                      given.time,
                      acting,
                      resisting,
                      resisting / acting,
                      required,
                      source};
      results.push_back(std::move(result));
    };
    const Stress yield = yield_strength_of(project.material, given.thickness).value();
    add(Criterion::yield, given.peak, yield / project.strength.gamma_M0, project.strength.required,
        yield_source);
    if (!given.opposite) continue;
    const FatigueInput& fatigue = project.fatigue;
    Stress strength = strength_at(curve_of(fatigue, fatigue.category), fatigue.demand.periods,
                                  fatigue.demand.loading);
    if (fatigue.round_strength_to) strength = rounded(strength, *fatigue.round_strength_to);
    add(Criterion::fatigue, given.peak + *given.opposite,
        strength / (fatigue.demand.gamma_Ff * fatigue.demand.gamma_Mf), fatigue.required,
        fatigue_source(fatigue));
  }
  return results;
}

}  // namespace boxbeam
