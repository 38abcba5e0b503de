#include "boxbeam/verification/station_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/range_limit.hpp"
#include "boxbeam/section/equivalent_stress.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/strength/yield.hpp"
#include "boxbeam/verification/life_cycles.hpp"
#include "boxbeam/verification/whole_life.hpp"
#include "sampled_peaks.hpp"

namespace boxbeam {
namespace {

double largest_range_of(const std::vector<Cycle>& cycles) {
  double largest = 0.0;
  for (const Cycle& cycle : cycles) largest = std::max(largest, cycle.range.value());
  return largest;
}

/// The largest range in any situation that is repeated.
double largest_range_of(const Project& project, const Turns& turns) {
  double largest = 0.0;
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    if (project.situations[i].cycles == 0.0) continue;
    const auto [highest, lowest] = extremes_in(project, i, turns);
    largest = std::max(largest, highest.value - lowest.value);
  }
  return largest;
}

}  // namespace

StationSamples::StationSamples(const Project& project,
                               const std::vector<SituationHistory>& histories, Keep keep)
    : project_(&project), whole_(whole_life_of(histories)), keep_(keep) {
  room_.effect.direct.resize(project.situations.size());
  room_.effect.shear.resize(project.situations.size());
  if (whole_ != nullptr) unit_cuts_ = unit_cuts_of(histories);
  constexpr std::array all{cut_force::N, cut_force::V_y, cut_force::V_z,
                           cut_force::T, cut_force::M_y, cut_force::M_z};
  for (const cut_force::Index which : all) {
    const bool acts =
        std::any_of(histories.begin(), histories.end(), [&](const SituationHistory& at) {
          const std::vector<CutForces>& samples = at.history.samples();
          return std::any_of(samples.begin(), samples.end(),
                             [&](const CutForces& cut) { return value_of(cut, which) != 0.0; });
        });
    if (acts) acting_.push_back(which);
  }
  for (const SituationHistory& at : histories) {
    Run& run = runs_.emplace_back(
        Run{index_of(project, *at.situation), at.situation->load_factor, {}, {}});
    take_samples(at.history, run);
    if (!run.instants.closed) run.instants.begins.front() = true;
  }
}

void StationSamples::take_samples(const StationHistory& history, Run& run) const {
  SampledInstants& instants = run.instants;
  instants.closed = history.closed();
  instants.period = history.period().value();
  const std::vector<StationHistory::Passage>& passages = history.passages();
  const std::vector<CutForces>& samples = history.samples();
  const std::size_t size = samples.size() + 2 * passages.size();
  run.cuts.resize(acting_.size());
  if (passages.empty()) {
    // One force after the other, each in a row.
    for (std::size_t j = 0; j < acting_.size(); ++j) {
      run.cuts[j].reserve(size);
      for (const CutForces& cut : samples)
        run.cuts[j].push_back(value_of(cut, static_cast<cut_force::Index>(acting_[j])));
    }
    instants.times.resize(size);
    instants.begins.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      instants.times[i] = history.time_of(i).value();
      if (history.begins_piece(i)) instants.begins[i] = true;
    }
    return;
  }
  for (std::vector<double>& cuts : run.cuts) cuts.reserve(size);
  instants.times.reserve(size);
  instants.begins.reserve(size);
  const auto add = [&](Time time, const CutForces& cut, bool begins) {
    for (std::size_t j = 0; j < acting_.size(); ++j)
      run.cuts[j].push_back(value_of(cut, static_cast<cut_force::Index>(acting_[j])));
    instants.times.push_back(time.value());
    instants.begins.push_back(begins);
  };
  auto passage = passages.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (; passage != passages.end() && passage->instant == i; ++passage) {
      add(passage->time, passage->before, false);
      add(passage->time, passage->behind, true);
    }
    add(history.time_of(i), samples[i], history.begins_piece(i));
  }
}

void StationSamples::turn_to(const Project& project) {
  project_ = &project;
  lines_.clear();
  for (Run& run : runs_) {
    const double load_factor = project.situations[run.situation].load_factor;
    if (load_factor != run.load_factor) effects_ = {};
    run.load_factor = load_factor;
  }
}

void StationSamples::find_stresses(const Run& run,
                                   const std::array<double, cut_force::count>& factors,
                                   std::vector<double>& stresses) const {
  std::array<const double*, cut_force::count> cuts{};
  std::array<double, cut_force::count> by{};
  std::size_t count = 0;
  for (std::size_t j = 0; j < acting_.size(); ++j) {
    const double factor = factors[acting_[j]];
    if (factor == 0.0) continue;
    cuts[count] = run.cuts[j].data();
    by[count++] = factor;
  }
  const std::size_t n = run.instants.times.size();
  stresses.resize(n);
  double* const sums = stresses.data();
  // Two at once, in the order in which they stand.
  if (count == 0) std::fill(stresses.begin(), stresses.end(), 0.0);
  if (count == 1)
    for (std::size_t i = 0; i < n; ++i) sums[i] = by[0] * cuts[0][i];
  if (count > 1)
    for (std::size_t i = 0; i < n; ++i) sums[i] = by[0] * cuts[0][i] + by[1] * cuts[1][i];
  for (std::size_t k = 2; k < count; ++k)
    for (std::size_t i = 0; i < n; ++i) sums[i] += by[k] * cuts[k][i];
}

Turns StationSamples::shear_turns_of(const StressInfluence& influence) const {
  Turns turns(project_->situations.size());
  for (const Run& run : runs_) {
    find_stresses(run, influence.shear, room_.shear);
    find_turns(room_.shear, run.instants, room_.turning, turns[run.situation]);
  }
  return turns;
}

double StationSamples::largest_cut_force(cut_force::Index which, double sign) const {
  if (std::find(acting_.begin(), acting_.end(), which) == acting_.end()) return 0.0;
  std::array<double, cut_force::count> factors{};
  factors[which] = sign;
  double largest = 0.0;
  for (const Run& run : runs_) {
    find_stresses(run, factors, room_.normal);
    largest = std::max(largest, largest_of(room_.normal, run.instants));
  }
  return largest;
}

double StationSamples::largest_use(const CutForceFunction& use) const {
  double largest = 0.0;
  std::vector<double> uses;
  for (const Run& run : runs_) {
    uses.clear();
    for (std::size_t i = 0; i < run.instants.times.size(); ++i) {
      std::array<double, cut_force::count> of{};
      for (std::size_t j = 0; j < acting_.size(); ++j) of[acting_[j]] = run.cuts[j][i];
      uses.push_back(use({si<Force>(of[cut_force::N]), si<Force>(of[cut_force::V_y]),
                          si<Force>(of[cut_force::V_z]), si<Moment>(of[cut_force::T]),
                          si<Moment>(of[cut_force::M_y]), si<Moment>(of[cut_force::M_z])}));
    }
    largest = std::max(largest, run.load_factor * largest_of(uses, run.instants));
  }
  return largest;
}

const SnLine& StationSamples::line_of(const Detail& detail,
                                      const std::shared_ptr<const BeamDetail>& kept) const {
  for (const Line& known : lines_)
    if (known.detail == &detail) return known.line;
  return lines_.emplace_back(Line{&detail, kept, SnLine(curve_of(detail))}).line;
}

void StationSamples::find_effect(const StressInfluence& influence, double factor, const Looked& at,
                                 Effect& effect) const {
  std::vector<double>& normal = room_.normal;
  std::vector<double>& shear = room_.shear;
  std::vector<double>& both = room_.together;
  effect.equivalent = effect.throat = 0.0;
  for (const Run& run : runs_) {
    if (at.direct || at.yield) find_stresses(run, influence.normal, normal);
    if (at.along || at.yield || at.weld) find_stresses(run, influence.shear, shear);
    if (at.yield) {
      // Roots are taken of the largest squares alone.
      both.resize(normal.size());
      for (std::size_t i = 0; i < both.size(); ++i)
        both[i] = normal[i] * normal[i] + 3.0 * shear[i] * shear[i];
      const auto value_at = [&](std::size_t i) { return equivalent_stress(normal[i], shear[i]); };
      effect.equivalent =
          std::max(effect.equivalent, run.load_factor * largest_of(both, value_at, run.instants));
    }
    if (at.weld) {
      both.resize(shear.size());
      for (std::size_t i = 0; i < both.size(); ++i) both[i] = std::abs(shear[i]);
      effect.throat = std::max(effect.throat, run.load_factor * largest_of(both, run.instants));
    }
    if (at.direct) {
      if (factor != 1.0)
        for (double& stress : normal) stress *= factor;
      find_turns(normal, run.instants, room_.turning, effect.direct[run.situation]);
    }
    if (at.along) find_turns(shear, run.instants, room_.turning, effect.shear[run.situation]);
  }
}

const StationSamples::Effect& StationSamples::effect_of(const StressInfluence& influence,
                                                        double factor, const Looked& at) const {
  if (keep_ == Keep::nothing) {
    find_effect(influence, factor, at, room_.effect);
    return room_.effect;
  }
  std::array<double, 2 * cut_force::count + 2> key{};
  auto next = std::copy(influence.normal.begin(), influence.normal.end(), key.begin());
  next = std::copy(influence.shear.begin(), influence.shear.end(), next);
  *next++ = factor;
  *next = (at.direct ? 1.0 : 0.0) + (at.along ? 2.0 : 0.0) + (at.yield ? 4.0 : 0.0) +
          (at.weld ? 8.0 : 0.0);
  return effects_.of(key, [&] {
    find_effect(influence, factor, at, room_.effect);
    return room_.effect;
  });
}

Utilisations StationSamples::judge(const StressPoint& point, CriterionSet by) const {
  return judge(point, point.influence, by);
}

Utilisations StationSamples::judge(const StressPoint& point, const StressInfluence& influence,
                                   CriterionSet by) const {
  const auto asked = [&](Criterion criterion) { return by.has(criterion); };
  const bool combined = asked(Criterion::combined_fatigue) && point.detail != nullptr &&
                        point.shear_detail != nullptr;
  const bool range = asked(Criterion::stress_range);
  const bool yield = asked(Criterion::yield) && point.yield && !point.on_throat;
  const bool weld = asked(Criterion::weld) && point.on_throat;
  const bool direct = point.detail != nullptr && (asked(Criterion::fatigue) || combined || range);
  const bool along =
      point.shear_detail != nullptr && (asked(Criterion::shear_fatigue) || combined || range);
  const double stress_factor = point.detail != nullptr ? point.detail->stress_factor : 1.0;

  const Effect& effect = effect_of(influence, stress_factor, {direct, along, yield, weld});
  const double equivalent = effect.equivalent, throat = effect.throat;
  const Turns &direct_turns = effect.direct, &shear_turns = effect.shear;

  Utilisations found;
  const StrengthDemand& strength = project_->strength;
  if (yield && equivalent >= 1e-9 * point.yield_strength.value()) {
    const Stress resistance = yield_resistance(plainly, point.yield_strength, strength.gamma_M0);
    found.of(Criterion::yield) = strength.required * equivalent / resistance.value();
  }
  const PlateOf& joined = point.joined;
  const auto tensile =
      weld ? tensile_strength_of(*joined.material, joined.thickness) : std::optional<Stress>{};
  if (tensile) {
    const WeldStrength of{*tensile, joined.material->beta_w, strength.gamma_M2};
    found.of(Criterion::weld) = strength.required * throat / weld_shear_strength(of).value();
  }
  const FatigueDemand& demand = project_->fatigue.demand;
  if (range) {
    // A range of shear stress counts sqrt(3) times, by which its limit is the lower.
    const Stress limit = range_limit(plainly, point.yield_strength, StressKind::direct);
    double largest = 0.0;
    if (direct)
      largest = point.range_factor / stress_factor * largest_range_of(*project_, direct_turns);
    if (along) {
      largest = std::max(largest, std::numbers::sqrt3 * largest_range_of(*project_, shear_turns));
    }
    found.of(Criterion::stress_range) = demand.gamma_Ff * largest / limit.value();
  }
  const double required = project_->fatigue.required;
  if (whole_ != nullptr) {
    std::vector<std::pair<WholePlace, SnCurve>> together;
    const auto look = [&](Criterion criterion, const Turns& turns, const Detail& detail,
                          const std::array<double, cut_force::count>& of, double factor,
                          bool reduced) {
      if (largest_range_of(*project_, turns) < no_stress_at(point)) return;
      together.emplace_back(whole_->place_of(unit_cuts_, of, factor, reduced), curve_of(detail));
      if (asked(criterion))
        found.of(criterion) = required / whole_->factor_of({&together.back(), 1});
    };
    if (direct && (asked(Criterion::fatigue) || combined)) {
      look(Criterion::fatigue, direct_turns, point.detail->detail, influence.normal, stress_factor,
           point.compression_reduced);
    }
    if (along && (asked(Criterion::shear_fatigue) || combined)) {
      look(Criterion::shear_fatigue, shear_turns, *point.shear_detail, influence.shear, 1.0, false);
    }
    if (combined && together.size() == 2)
      found.of(Criterion::combined_fatigue) = required / whole_->factor_of(together);
    return found;
  }
  std::array<FatigueLoad, 2> loads;
  std::size_t channels = 0;
  const auto look = [&](Criterion criterion, const Turns& turns, const Detail& detail,
                        bool reduced) {
    std::vector<Cycle>& counted = room_.cycles[channels];
    count_life_cycles(*project_, turns, reduced, counted);
    if (largest_range_of(counted) < no_stress_at(point)) return;
    loads[channels] = {counted, &line_of(detail, point.in_plate)};
    if (asked(criterion))
      found.of(criterion) = required / largest_factor({&loads[channels], 1}, demand);
    ++channels;
  };
  if (direct && (asked(Criterion::fatigue) || combined)) {
    look(Criterion::fatigue, direct_turns, point.detail->detail, point.compression_reduced);
  }
  if (along && (asked(Criterion::shear_fatigue) || combined))
    look(Criterion::shear_fatigue, shear_turns, *point.shear_detail, false);
  if (combined && channels == 2)
    found.of(Criterion::combined_fatigue) = required / largest_factor(loads, demand);
  return found;
}

}  // namespace boxbeam
