#include "boxbeam/verification/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/fatigue/range_limit.hpp"
#include "boxbeam/strength/yield.hpp"
#include "boxbeam/verification/station_memory.hpp"
#include "channel_life.hpp"
#include "check_sources.hpp"
#include "linear_stress.hpp"

namespace boxbeam {
namespace {

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

/// A stress of a point.
struct StressFunction {
  StressKind kind;
  LinearStress of;
};

StressFunction normal_stress(const StressPoint& point) {
  return {StressKind::direct, {&point.influence.normal}};
}

/// The normal stress of a point times a factor of its details.
StressFunction detail_stress(const StressPoint& point, double factor) {
  return {StressKind::direct, {&point.influence.normal, factor}};
}

StressFunction shear_stress(const StressPoint& point) {
  return {StressKind::shear, {&point.influence.shear}};
}

/// The check's frame, of a stress in the situation where it is worst.
CheckResult start(Criterion criterion, const Project& project, const StressPoint& point,
                  const SituationHistory& worst, const StressFunction& stress) {
  CheckResult result;
  result.check.criterion = criterion;
  result.check.station = point.station;
  result.check.point = point.name;
  result.check.id = id_of(criterion, point.station, point.name);
  result.check.situation = worst.situation->name;
  CheckBasis& basis = result.basis.emplace();
  basis.point = point;
  basis.kind = stress.kind;
  basis.stress_factor = stress.of.factor;
  basis.running = index_of(project, *worst.situation);
  return result;
}

/// All cycles of the wanted life of one stress.
std::vector<SpectrumRow> spectrum_of(const Project& project,
                                     const std::vector<SituationCycles>& life, StressKind kind) {
  std::vector<SpectrumRow> spectrum;
  for (const SituationCycles& of : life) {
    const std::vector<SpectrumRow> rows =
        rows_of(project.situations[of.situation].name, kind, of.cycles);
    spectrum.insert(spectrum.end(), rows.begin(), rows.end());
  }
  return spectrum;
}

double largest_range_of(const std::vector<SpectrumRow>& spectrum) {
  double largest = 0.0;
  for (const SpectrumRow& row : spectrum) largest = std::max(largest, row.cycle.range.value());
  return largest;
}

/// A stress of a point, its cycles and what resists them.
struct Channel {
  const Turns* turns;
  LifeChannel life;
};

WholePlace whole_place_of(const WholeLife& whole, const std::vector<SituationHistory>& histories,
                          const StressPoint& point, StressKind kind) {
  const bool direct = kind == StressKind::direct;
  return whole.place_of(
      unit_cuts_of(histories), direct ? point.influence.normal : point.influence.shear,
      direct ? point.detail->stress_factor : 1.0, direct && point.compression_reduced);
}

/// The channels that a criterion looks at; none of them where its stress does not change.
std::vector<Channel> channels_of(PointHistory& of, Criterion criterion) {
  const Project& project = *of.project;
  const StressPoint& point = *of.point;
  std::vector<Channel> channels;
  channels.reserve(2);
  const auto add = [&](StressKind kind, const Turns& turns, const Detail& detail,
                       bool compression_reduced) {
    Channel channel{&turns, {}};
    channel.life.curve = curve_of(detail);
    const WholeLife* const whole = whole_life_of(*of.histories);
    const std::vector<SituationCycles> life =
        whole == nullptr ? life_cycles_of(project, turns, compression_reduced)
                         : whole->cycles_of(whole_place_of(*whole, *of.histories, point, kind),
                                            channel.life.curve);
    channel.life.spectrum = spectrum_of(project, life, kind);
    if (largest_range_of(channel.life.spectrum) >= no_stress_at(point))
      channels.push_back(std::move(channel));
  };
  if (point.detail != nullptr && criterion != Criterion::shear_fatigue) {
    add(StressKind::direct, of.direct(point.detail->stress_factor), point.detail->detail,
        point.compression_reduced);
  }
  if (point.shear_detail != nullptr && criterion != Criterion::fatigue)
    add(StressKind::shear, of.shear(), *point.shear_detail, false);
  return channels;
}

const SituationHistory& history_of(const std::vector<SituationHistory>& histories,
                                   const Situation& situation) {
  return *std::find_if(histories.begin(), histories.end(),
                       [&](const SituationHistory& at) { return at.situation == &situation; });
}

}  // namespace

const Turns& PointHistory::direct(double factor) {
  const auto found = direct_.find(factor);
  if (found != direct_.end()) return found->second;
  return direct_
      .emplace(factor,
               extremes != nullptr
                   ? extremes->turns_of(*project, *histories, point->influence.normal, factor)
                   : turns_of(*project, *histories, detail_stress(*point, factor).of))
      .first->second;
}

const Turns& PointHistory::shear() {
  if (!shear_) {
    shear_ = extremes != nullptr
                 ? extremes->turns_of(*project, *histories, point->influence.shear, 1.0)
                 : turns_of(*project, *histories, shear_stress(*point).of);
  }
  return *shear_;
}

std::vector<TurningPoint> PointHistory::largest_von_mises() {
  if (extremes != nullptr) return extremes->largest_von_mises(*histories, point->influence);
  std::vector<TurningPoint> largest;
  for (const SituationHistory& at : *histories) {
    largest.push_back(at.history.largest([&](const CutForces& cut) {
      return stress_at(point->influence, cut).von_mises().value();
    }));
  }
  return largest;
}

const CheckResult* governing_of(const std::vector<CheckResult>& checks, Criterion criterion) {
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const CheckResult& result) {
    return result.check.criterion == criterion;
  });
  return found == checks.end() ? nullptr : &*found;
}

const CheckResult* first_by_cut_forces(const std::vector<CheckResult>& checks) {
  const auto found = std::find_if(checks.begin(), checks.end(), [](const CheckResult& result) {
    return result.basis.has_value();
  });
  return found == checks.end() ? nullptr : &*found;
}

std::string id_of(Criterion criterion, const Station& station, const std::string& point) {
  return fmt::format("{}/{}/{}", one_word(to_text(criterion)), to_text(station), one_word(point));
}

std::optional<CheckResult> check_yield(const Project& project,
                                       const std::vector<SituationHistory>& histories,
                                       const StressPoint& point) {
  PointHistory of(project, histories, point);
  return check_yield(of);
}

std::optional<CheckResult> check_yield(PointHistory& of) {
  const Project& project = *of.project;
  const std::vector<SituationHistory>& histories = *of.histories;
  const StressPoint& point = *of.point;
  const SituationHistory* worst = &histories.front();
  TurningPoint largest;
  const std::vector<TurningPoint> in_each = of.largest_von_mises();
  for (std::size_t i = 0; i < histories.size(); ++i) {
    TurningPoint in = in_each[i];
    in.value *= histories[i].situation->load_factor;
    if (in.value <= largest.value) continue;
    worst = &histories[i];
    largest = in;
  }
  if (largest.value < 1e-9 * point.yield_strength.value()) return std::nullopt;
  CheckResult result = start(Criterion::yield, project, point, *worst, normal_stress(point));
  Check& check = result.check;
  check.time = largest.time;
  check.acting = si<Stress>(largest.value);
  check.resisting = yield_resistance(plainly, point.yield_strength, project.strength.gamma_M0);
  check.safety_factor = check.resisting / check.acting;
  check.required = project.strength.required;
  check.source = yield_source(*point.first_to_yield.material);
  CheckBasis& basis = *result.basis;
  basis.cut_at_time = basis.cut_at_highest = basis.cut_at_lowest = worst->history.at(largest.time);
  basis.stress_at_time = stress_at(point.influence, basis.cut_at_time);
  const double normal = basis.stress_at_time.normal.value();
  basis.highest = basis.lowest = {largest.time, normal, basis.running};
  return result;
}

std::optional<CheckResult> check_fatigue(const Project& project,
                                         const std::vector<SituationHistory>& histories,
                                         const StressPoint& point, Criterion criterion) {
  PointHistory of(project, histories, point);
  return check_fatigue(of, criterion);
}

std::optional<CheckResult> check_fatigue(PointHistory& of, Criterion criterion) {
  const Project& project = *of.project;
  const std::vector<SituationHistory>& histories = *of.histories;
  const StressPoint& point = *of.point;
  std::vector<Channel> channels = channels_of(of, criterion);
  const bool together = criterion == Criterion::combined_fatigue;
  if (channels.size() < (together ? 2 : 1)) return std::nullopt;

  std::vector<LifeChannel> lives;
  lives.reserve(channels.size());
  for (Channel& channel : channels) lives.push_back(std::move(channel.life));
  const ChannelLife life = life_of(project, lives);
  const std::size_t governing = life.governing;
  const auto [highest, lowest] = extremes_in(project, governing, *channels.front().turns);
  const bool upper = std::abs(highest.value) >= std::abs(lowest.value);
  const auto in = [&](const Extreme& extreme) -> const SituationHistory& {
    return history_of(histories, project.situations[extreme.situation]);
  };

  const bool shear = criterion == Criterion::shear_fatigue;
  CheckResult result =
      start(criterion, project, point, in(upper ? highest : lowest),
            shear ? shear_stress(point) : detail_stress(point, point.detail->stress_factor));
  Check& check = result.check;
  CheckBasis& basis = *result.basis;
  check.situation = project.situations[governing].name;
  check.time = (upper ? highest : lowest).time;
  take_life(project, lives, life, check, basis);
  if (together) {
    check.acting = basis.damage;
    check.resisting = 1.0;
  } else {
    // The range that the life allows, partial factors applied; of a spectrum, its largest range.
    const Stress range = si<Stress>(highest.value - lowest.value);
    check.acting = range;
    check.resisting = life.factor * range;
  }
  basis.highest = highest;
  basis.lowest = lowest;
  basis.cut_at_highest = in(highest).history.at(highest.time);
  basis.cut_at_lowest = in(lowest).history.at(lowest.time);
  basis.cut_at_time = upper ? basis.cut_at_highest : basis.cut_at_lowest;
  basis.stress_at_time = stress_at(point.influence, basis.cut_at_time);
  return result;
}

std::vector<WholePlace> whole_places_of(const std::vector<SituationHistory>& histories,
                                        const StressPoint& point, Criterion criterion) {
  const WholeLife& whole = *whole_life_of(histories);
  std::vector<WholePlace> places;
  if (point.detail != nullptr && criterion != Criterion::shear_fatigue)
    places.push_back(whole_place_of(whole, histories, point, StressKind::direct));
  if (point.shear_detail != nullptr && criterion != Criterion::fatigue)
    places.push_back(whole_place_of(whole, histories, point, StressKind::shear));
  return places;
}

std::optional<CheckResult> check_range(const Project& project,
                                       const std::vector<SituationHistory>& histories,
                                       const StressPoint& point) {
  PointHistory of(project, histories, point);
  return check_range(of);
}

std::optional<CheckResult> check_range(PointHistory& of) {
  const Project& project = *of.project;
  const std::vector<SituationHistory>& histories = *of.histories;
  const StressPoint& point = *of.point;
  std::optional<CheckResult> worst;
  const auto look = [&](const StressFunction& stress, const Turns& turns) {
    const Stress limit = range_limit(plainly, point.yield_strength, stress.kind);
    for (std::size_t i = 0; i < project.situations.size(); ++i) {
      if (project.situations[i].cycles == 0.0) continue;
      const auto [highest, lowest] = extremes_in(project, i, turns);
      const double range = project.fatigue.demand.gamma_Ff * (highest.value - lowest.value);
      if (range < no_stress_at(point)) continue;
      const double factor = limit.value() / range;
      if (worst && factor >= worst->check.safety_factor) continue;
      const Situation& running = project.situations[highest.situation];
      const SituationHistory& history = history_of(histories, running);
      worst = start(Criterion::stress_range, project, point, history, stress);
      Check& check = worst->check;
      check.situation = project.situations[i].name;
      check.time = highest.time;
      check.acting = si<Stress>(range);
      check.resisting = limit;
      check.safety_factor = factor;
      check.source = "EN 1993-1-9:2005+AC:2009, 8(1), equation 8.1";
      CheckBasis& basis = *worst->basis;
      basis.highest = highest;
      basis.lowest = lowest;
      basis.cut_at_highest = basis.cut_at_time = history.history.at(highest.time);
      basis.cut_at_lowest =
          history_of(histories, project.situations[lowest.situation]).history.at(lowest.time);
      basis.stress_at_time = stress_at(point.influence, basis.cut_at_time);
    }
  };
  if (point.detail != nullptr)
    look(detail_stress(point, point.range_factor), of.direct(point.range_factor));
  if (point.shear_detail != nullptr) look(shear_stress(point), of.shear());
  return worst;
}

std::optional<CheckResult> check_throat(const Project& project,
                                        const std::vector<SituationHistory>& histories,
                                        const StressPoint& point) {
  const WorstInstant worst = worst_instant_of(histories, [&](const CutForces& cut) {
    return std::abs(stress_of(point.influence.shear, cut));
  });
  const Material& joined = *point.joined.material;
  const auto tensile = tensile_strength_of(joined, point.joined.thickness);
  if (!tensile || worst.use < no_stress_at(point)) return std::nullopt;
  CheckResult result = start(Criterion::weld, project, point, *worst.at, shear_stress(point));
  Check& check = result.check;
  check.time = worst.largest.time;
  check.acting = si<Stress>(worst.use);
  const WeldStrength strength{*tensile, joined.beta_w, project.strength.gamma_M2};
  check.resisting = weld_shear_strength(strength);
  check.safety_factor = check.resisting / check.acting;
  check.required = project.strength.required;
  check.source = "EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1";
  CheckBasis& basis = *result.basis;
  basis.weld = strength;
  basis.cut_at_time = basis.cut_at_highest = basis.cut_at_lowest = worst.at->history.at(check.time);
  basis.stress_at_time = stress_at(point.influence, basis.cut_at_time);
  basis.highest = basis.lowest = {check.time, basis.stress_at_time.shear.value(), basis.running};
  return result;
}

}  // namespace boxbeam
