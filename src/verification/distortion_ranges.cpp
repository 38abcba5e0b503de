#include "distortion_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "boxbeam/fatigue/joined_cycles.hpp"

namespace boxbeam {
namespace {

/// Cycles of a situation with those of distortion.
std::vector<Cycle> joined(const Situation& situation, std::vector<Cycle> cycles, double range,
                          double rise) {
  if (situation.is_change()) {
    // One cycle, and shares of it.
    if (cycles.empty()) cycles = change_cycles(situation, {}, {});
    for (std::size_t k = 0; k < cycles.size(); ++k)
      cycles[k].range +=
          si<Stress>((situation.spectrum.empty() ? 1.0 : situation.spectrum[k].share) * range);
    return cycles;
  }
  for (Cycle& cycle : cycles) cycle.count /= situation.cycles;
  cycles = joined_cycles(std::move(cycles), si<Stress>(range), si<Stress>(rise));
  for (Cycle& cycle : cycles) cycle.count *= situation.cycles;
  return cycles;
}

/// What of distortion joins a stress: its range and its rise [Pa].
struct Joining {
  double range = 0.0, rise = 0.0;
};

Joining joining(const DistortedPoint& of, StressKind kind, const DistortionTravel& travel) {
  Joining most;
  for (const DistortionInfluence& at : of.at) {
    const bool direct = kind == StressKind::direct;
    const double per = std::abs(direct ? at.along : at.shear);
    const double range = per * (direct ? travel.range.moment : travel.range.shear);
    if (range < most.range) continue;
    most = {range, per * (direct ? travel.rise.moment : travel.rise.shear)};
  }
  if (kind == StressKind::direct && of.point.detail != nullptr) {
    most.range *= of.point.detail->stress_factor;
    most.rise *= of.point.detail->stress_factor;
  }
  return most;
}

std::array<double, cut_force::count> factors_of(const DistortedPoint& of, StressKind kind) {
  std::array<double, cut_force::count> factors =
      kind == StressKind::direct ? of.point.influence.normal : of.point.influence.shear;
  if (kind == StressKind::direct && of.point.detail != nullptr)
    for (double& factor : factors) factor *= of.point.detail->stress_factor;
  return factors;
}

std::vector<StressKind> kinds_of(const DistortedPoint& of) {
  std::vector<StressKind> kinds;
  if (of.point.detail != nullptr) kinds.push_back(StressKind::direct);
  if (of.point.shear_detail != nullptr) kinds.push_back(StressKind::shear);
  return kinds;
}

SnCurve curve_for(const DistortedPoint& of, StressKind kind) {
  return curve_of(kind == StressKind::direct ? of.point.detail->detail : *of.point.shear_detail);
}

}  // namespace

DistortedStretch::Torque torque_at(const DistortedStretch& stretch, std::size_t place,
                                   const TorquesIn& torques) {
  double along = 0.0, across = 0.0;
  for (std::size_t plate = 0; plate < 4; ++plate) {
    const DistortionInfluence at =
        distortion_at(stretch.cell(place), stretch.stiffness(place), {plate, 0.0});
    along = std::max(along, std::abs(at.along));
    across = std::max(across, at.across);
  }
  return stretch.most_at(place, torques, along, across);
}

DistortionRanges::DistortionRanges(const Project& project, const std::deque<SituationRun>& runs,
                                   const DistortedStretch& stretch)
    : project_(&project), runs_(&runs), stretch_(&stretch) {
  if (!project.fatigue.asked) return;
  counted_ = whole_life_of(runs) == nullptr;
  const auto run_of_situation = [&](std::size_t situation) {
    std::size_t r = 0;
    while (index_of(project, *runs[r].situation) != situation) ++r;
    return r;
  };
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    const Situation& situation = project.situations[i];
    if (situation.cycles == 0.0) continue;
    Sequence& of = sequences_.emplace_back();
    of.situation = i;
    if (situation.runs()) of.runs = {run_of_situation(i)};
    for (const std::size_t part : situation.between) of.runs.push_back(run_of_situation(part));
    of.travels = stretch.travels(of.runs);
  }
}

std::vector<CheckResult> DistortionRanges::checks() const {
  std::vector<CheckResult> all;
  for (const Worst* of : {&along_, &across_})
    if (of->check) all.push_back(*of->check);
  return all;
}

const DistortionRanges::Sequence& DistortionRanges::sequence_of(std::size_t situation) const {
  return *std::find_if(sequences_.begin(), sequences_.end(),
                       [&](const Sequence& of) { return of.situation == situation; });
}

void DistortionRanges::look_at(std::size_t place, const std::vector<DistortedPoint>& points,
                               const std::vector<std::vector<CutForces>>& cuts,
                               const DistortionStresses& of_unit, double least) {
  double most = 0.0;
  for (const Sequence& of : sequences_) {
    const DistortionSize& range = of.travels[place].range;
    const double along = of_unit[0] * range.moment, across = of_unit[1] * range.angle;
    largest_[0] = std::max(largest_[0], along);
    largest_[1] = std::max(largest_[1], across);
    most = std::max(most, along + across);
  }
  if (most < least || !counted_) return;
  std::optional<std::vector<SituationHistory>> histories;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const DistortedPoint& of = points[p];
    look_across(place, p, of);
    const bool resists = of.point.detail != nullptr || of.point.shear_detail != nullptr;
    if (!resists || !may_be_worse(place, of, cuts)) continue;
    if (!histories) histories = histories_at(*runs_, stretch_->places()[place].station);
    look_along(place, p, of, *histories);
  }
}

bool DistortionRanges::Worst::is_worse(double factor, std::size_t at_place,
                                       std::size_t at_point) const {
  if (!check) return true;
  const double known = check->check.safety_factor;
  return factor < known ||
         (factor == known && std::pair(at_place, at_point) < std::pair(place, point));
}

/// Whether a point may be used more than the worst one so far: every cycle that the instants show
/// as large as the largest.
bool DistortionRanges::may_be_worse(std::size_t place, const DistortedPoint& of,
                                    const std::vector<std::vector<CutForces>>& cuts) const {
  if (!along_.check) return true;
  constexpr double between_instants = 1.02;
  double damage = 0.0;
  for (const StressKind kind : kinds_of(of)) {
    const std::array<double, cut_force::count> factors = factors_of(of, kind);
    std::vector<Cycle> cycles;
    for (const Sequence& sequence : sequences_) {
      const Joining by = joining(of, kind, sequence.travels[place]);
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, last = 0.0;
      std::size_t turns = 2;
      bool up = true;
      for (const std::size_t r : sequence.runs) {
        for (const CutForces& cut : cuts[r]) {
          double stress = 0.0;
          for (std::size_t k = 0; k < cut_force::count; ++k)
            stress += factors[k] * value_of(cut, static_cast<cut_force::Index>(k));
          if (highest >= lowest && (stress > last) != up) {
            up = !up;
            ++turns;
          }
          lowest = std::min(lowest, stress);
          highest = std::max(highest, stress);
          last = stress;
        }
      }
      const Situation& situation = project_->situations[sequence.situation];
      double count = situation.cycles;
      if (!situation.is_change())
        count *=
            std::max(0.5 * static_cast<double>(turns), by.range > 0.0 ? by.rise / by.range : 0.0);
      cycles.push_back(
          {si<Stress>(between_instants * (highest - lowest + by.range)), Stress{}, count});
    }
    damage += damage_of(cycles, curve_for(of, kind), project_->fatigue.demand,
                        along_.check->check.safety_factor);
  }
  return damage > 1.0;
}

/// Rows of the cycles that `cycles_of` gives for each sequence.
std::vector<SpectrumRow> DistortionRanges::spectrum_of(
    StressKind kind,
    const std::function<std::vector<Cycle>(const Sequence&, const Situation&)>& cycles_of) const {
  std::vector<SpectrumRow> spectrum;
  for (const Sequence& sequence : sequences_) {
    const Situation& situation = project_->situations[sequence.situation];
    for (SpectrumRow& row : rows_of(situation.name, kind, cycles_of(sequence, situation)))
      if (row.cycle.range.value() > 0.0) spectrum.push_back(std::move(row));
  }
  return spectrum;
}

double DistortionRanges::use_of(std::size_t place, double of_unit, const Detail& detail,
                                StressKind kind) const {
  const LifeChannel channel{spectrum_of(kind,
                                        [&](const Sequence& sequence, const Situation& situation) {
                                          const DistortionTravel& travel = sequence.travels[place];
                                          return joined(situation, {}, of_unit * travel.range.angle,
                                                        of_unit * travel.rise.angle);
                                        }),
                            curve_of(detail)};
  if (channel.spectrum.empty()) return 0.0;
  return project_->fatigue.required / life_of(*project_, {channel}).factor;
}

Stress DistortionRanges::range_of(std::size_t place, double of_unit) const {
  double most = 0.0;
  for (const Sequence& of : sequences_)
    most = std::max(most, of_unit * of.travels[place].range.angle);
  return si<Stress>(most);
}

CheckResult DistortionRanges::fatigue_check(std::size_t place, const DistortedPoint& of,
                                            const std::string& name,
                                            const std::vector<LifeChannel>& channels,
                                            const ChannelLife& life,
                                            double DistortionSize::*by) const {
  CheckResult result;
  Check& check = result.check;
  check.criterion = Criterion::distortion_fatigue;
  check.station = stretch_->places()[place].station;
  check.point = name;
  check.id = id_of(check.criterion, check.station, name);
  check.situation = project_->situations[life.governing].name;
  DistortionBasis& basis = result.distortion.emplace();
  basis.stress.point = of.point;
  take_life(*project_, channels, life, check, basis.stress);
  check.acting = basis.stress.damage;
  check.resisting = 1.0;
  const Sequence& governing = sequence_of(life.governing);
  basis.size = governing.travels[place].range;
  basis.at = *std::max_element(of.at.begin(), of.at.end(),
                               [](const DistortionInfluence& a, const DistortionInfluence& b) {
                                 return std::abs(a.along) < std::abs(b.along);
                               });
  double most = -1.0;
  std::pair<std::size_t, std::size_t> when;
  for (const std::size_t r : governing.runs) {
    for (std::size_t i = 0; i < (*runs_)[r].loads.instants(); ++i) {
      const double size = stretch_->size_at(place, r, i).*by;
      if (size <= most) continue;
      most = size;
      when = {r, i};
    }
  }
  const LoadHistory& history = (*runs_)[when.first].loads;
  check.time = history.time_of(when.second);
  const DistortedStretch::Torque torque =
      torque_at(*stretch_, place, stretch_->torques_at(when.first, when.second));
  basis.introduced = torque.s;
  basis.torque = torque.torque;
  return result;
}

void DistortionRanges::look_along(std::size_t place, std::size_t point, const DistortedPoint& of,
                                  const std::vector<SituationHistory>& histories) {
  std::vector<LifeChannel> channels;
  std::vector<Turns> turns;
  for (const StressKind kind : kinds_of(of)) {
    const std::array<double, cut_force::count> factors = factors_of(of, kind);
    Turns turned = turns_of(*project_, histories, [&](const CutForces& cut) {
      double stress = 0.0;
      for (std::size_t k = 0; k < cut_force::count; ++k)
        stress += factors[k] * value_of(cut, static_cast<cut_force::Index>(k));
      return stress;
    });
    const std::vector<SituationCycles> own = life_cycles_of(*project_, turned, false);
    const auto own_of = [&](std::size_t situation) {
      const auto found = std::find_if(own.begin(), own.end(), [&](const SituationCycles& at) {
        return at.situation == situation;
      });
      return found == own.end() ? std::vector<Cycle>{} : found->cycles;
    };
    LifeChannel channel{spectrum_of(kind,
                                    [&](const Sequence& sequence, const Situation& situation) {
                                      const Joining by = joining(of, kind, sequence.travels[place]);
                                      return joined(situation, own_of(sequence.situation), by.range,
                                                    by.rise);
                                    }),
                        curve_for(of, kind)};
    if (channel.spectrum.empty()) continue;
    channels.push_back(std::move(channel));
    turns.push_back(std::move(turned));
  }
  if (channels.empty()) return;
  const ChannelLife life = life_of(*project_, channels);
  if (!along_.is_worse(life.factor, place, point)) return;
  along_.place = place;
  along_.point = point;
  along_.check =
      fatigue_check(place, of, of.point.name, channels, life,
                    channels.front().curve.kind == StressKind::direct ? &DistortionSize::moment
                                                                      : &DistortionSize::shear);
  CheckBasis& basis = along_.check->distortion->stress;
  basis.kind = channels.front().curve.kind;
  const auto [highest, lowest] = extremes_in(*project_, life.governing, turns.front());
  basis.highest = highest;
  basis.lowest = lowest;
  // With what joins it the largest of its ranges.
  basis.highest.value += joining(of, basis.kind, sequence_of(life.governing).travels[place]).range;
  if (basis.kind == StressKind::direct) basis.stress_factor = of.point.detail->stress_factor;
}

void DistortionRanges::look_across(std::size_t place, std::size_t point, const DistortedPoint& of) {
  // The corner, of its plates and its seam by the thinnest.
  if (of.at.size() < 2 || of.point.on_throat) return;
  const Length fillet =
      fillet_of(section_at(project_->beam, stretch_->places()[place].station).outer);
  DistortionInfluence at = of.at[0].thickness < of.at[1].thickness ? of.at[0] : of.at[1];
  if (fillet.value() > 0.0 && fillet < at.thickness) {
    const DistortionInfluence in_seam = at.in_throat(fillet);
    at.across = in_seam.across;
    at.thickness = fillet;
  }
  LifeChannel channel{spectrum_of(StressKind::direct,
                                  [&](const Sequence& sequence, const Situation& situation) {
                                    const DistortionTravel& travel = sequence.travels[place];
                                    return joined(situation, {}, at.across * travel.range.angle,
                                                  at.across * travel.rise.angle);
                                  }),
                      curve_of(project_->fatigue.corner)};
  if (channel.spectrum.empty()) return;
  constexpr double round_off = 1e-9;
  if (across_.check &&
      damage_of(channel.for_damage().cycles, channel.curve, project_->fatigue.demand,
                across_.check->check.safety_factor) <= 1.0 - round_off)
    return;
  const ChannelLife life = life_of(*project_, {channel});
  if (!across_.is_worse(life.factor, place, point)) return;
  across_.place = place;
  across_.point = point;
  DistortionBasis& basis = *across_.check
                                .emplace(fatigue_check(place, of, of.point.name + " across",
                                                       {channel}, life, &DistortionSize::angle))
                                .distortion;
  basis.across = true;
  basis.at = at;
  basis.stress.highest.value = at.across * basis.size.angle;
}

}  // namespace boxbeam
