#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "boxbeam/fatigue/range_limit.hpp"
#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/life_cycles.hpp"
#include "boxbeam/verification/peak_over_time.hpp"
#include "boxbeam/verification/turning_samples.hpp"
#include "channel_life.hpp"
#include "neighbour_parts.hpp"

namespace boxbeam {
namespace {

/// The force of a joint in one situation, as one of the frames of its pin sees it.
class TurningForce {
 public:
  TurningForce(NeighbourLoads& loads, int joint, std::size_t frame)
      : loads_(&loads), joint_(joint), frame_(frame) {
    for (const SampledInstant& instant : loads.span().instants)
      samples_.push_back(force_at(instant.at));
  }

  /// The turning points of its component along a direction, as stresses by a factor; where it is
  /// only looked for a direction, among the instants.
  SituationTurns turns_along(const Eigen::Vector3d& way, double factor, bool between_instants) {
    const SampledTime& span = loads_->span();
    std::vector<double> values;
    for (const Eigen::Vector3d& force : samples_) values.push_back(factor * way.dot(force));
    const TurningSamples found = turning_samples_of(values);
    const bool closed = loads_->run().loads.closed();
    SituationTurns turns{{}, values.front(), closed ? values.front() : values.back()};
    for (const auto& [sample, maximum] : found.turns) {
      const double sign = maximum ? 1.0 : -1.0;
      const SampledInstant& at = span.instants[sample];
      Extremum best{at.at, sign * values[sample]};
      if (between_instants && at.to > at.from) {
        const Extremum between =
            find_maximum([&](double time) { return sign * factor * way.dot(force_at(time)); },
                         at.from, at.to, 14);
        if (between.value > best.value) best = between;
      }
      turns.turns.push_back({si<Time>(within(best.at)), sign * best.value, maximum});
    }
    if (turns.turns.empty())
      turns.turns.push_back(
          {si<Time>(span.instants[found.highest].at), values[found.highest], true});
    std::sort(turns.turns.begin(), turns.turns.end(),
              [](const TurningPoint& a, const TurningPoint& b) { return a.time < b.time; });
    return turns;
  }

 private:
  double within(double time) const {
    const SampledTime& span = loads_->span();
    if (time < span.begin) return time + span.period;
    return time > span.begin + span.period ? time - span.period : time;
  }

  Eigen::Vector3d force_at(double time) { return loads_->force_seen(joint_, frame_, time); }

  NeighbourLoads* loads_;
  int joint_;
  std::size_t frame_;
  std::vector<Eigen::Vector3d> samples_;
};

/// What the components of a force along a direction do to a lug.
struct AlongDirection {
  Eigen::Vector3d way = Eigen::Vector3d::UnitX();
  LifeChannel channel;
  ChannelLife life;
  Turns turns;
  double largest = 0.0;                  ///< range of any situation with cycles [Pa]
  std::size_t of_largest = 0;            ///< that situation
  double by_life = 0.0, by_range = 0.0;  ///< uses

  double use() const { return std::max(by_life, by_range); }
};

/// A lug under the forces of its pin's joint.
class LugLife {
 public:
  LugLife(const Project& project, const NeighbourRuns& runs, const PinInput& pin,
          const LugInput& lug)
      : project_(&project), lug_(&lug), pin_(&pin) {
    stress_per_force_ = share_of(lug) * lug.detail.stress_factor / lug_net_area(lug.plate).value();
    for (const PinFrame& of : runs.front()->frames_of(pin.joint)) {
      const std::size_t index = frames_.size();
      Frame& frame = frames_.emplace_back();
      frame.of = of;
      for (const auto& run : runs)
        frame.runs.emplace_back(index_of(project, *run->run().situation),
                                TurningForce(*run, pin.joint, index));
    }
  }

  /// The direction in which it is used most; a largest range of zero where nothing changes.
  AlongDirection worst() {
    AlongDirection worst;
    for (Frame& frame : frames_) {
      const bool anywhere = frame.of.ways > 2;
      Eigen::Vector3d most = Eigen::Vector3d::UnitX();
      double use = -1.0;
      for (const Eigen::Vector3d& way : directions_of(frame.of.ways)) {
        AlongDirection at = along(frame, way, !anywhere);
        if (at.use() > use) {
          use = at.use();
          most = way;
        }
        if (anywhere || (in_ != nullptr && at.use() <= worst.use())) continue;
        worst = std::move(at);
        in_ = &frame;
      }
      if (!anywhere) continue;
      AlongDirection at = turned_to_worst(frame, along(frame, most, true));
      if (in_ != nullptr && at.use() <= worst.use()) continue;
      worst = std::move(at);
      in_ = &frame;
    }
    if (in_->of.ways == 2) worst = turned_to_worst(*in_, std::move(worst));
    return worst;
  }

  NeighbourResult result_of(const AlongDirection& of) const {
    const bool by_range = of.by_range > of.by_life;
    const std::size_t situation = by_range ? of.of_largest : of.life.governing;
    const auto [highest, lowest] = extremes_in(*project_, situation, of.turns);
    const Extreme& larger = std::abs(highest.value) >= std::abs(lowest.value) ? highest : lowest;
    TiredLug tired{lug_, share_of(*lug_), {}, angle_of(of.way), seen(of.way), {}, {}};
    tired.range = si<Force>((highest.value - lowest.value) / stress_per_force_);
    NeighbourResult result{
        check_begun(Criterion::lug_fatigue, name_of(*pin_, *lug_), *project_, larger), {}};
    Check& check = result.check;
    check.situation = project_->situations[situation].name;
    const Stress range = si<Stress>(highest.value - lowest.value);
    tired.life.point.detail = &lug_->detail;
    tired.life.stress_factor = lug_->detail.stress_factor;
    tired.life.highest = highest;
    tired.life.lowest = lowest;
    take_life(*project_, {of.channel}, of.life, check, tired.life);
    check.acting = range;
    check.resisting = Stress(check.safety_factor * range);
    if (by_range) {
      tired.limit = limit();
      check.required = 1.0;
      check.safety_factor = 1.0 / of.by_range;
      check.resisting = *tired.limit;
      check.source = "EN 1993-1-9:2005+AC:2009, 8(1), equation 8.1";
    }
    result.basis = std::move(tired);
    return result;
  }

 private:
  struct Frame {
    PinFrame of;
    std::vector<std::pair<std::size_t, TurningForce>> runs;
  };

  static constexpr double step = std::numbers::pi / 36;

  /// Of one half of all: along what is opposite ranges are the same.
  static std::vector<Eigen::Vector3d> directions_of(int ways) {
    if (ways == 1) return {Eigen::Vector3d::UnitX()};
    std::vector<Eigen::Vector3d> all;
    const auto add_ring = [&](double radius, double height, int count) {
      for (int i = 0; i < count; ++i) {
        const double angle = (ways == 2 ? 1.0 : 2.0) * std::numbers::pi * i / count;
        all.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
      }
    };
    if (ways == 2) {
      add_ring(1.0, 0.0, 36);
      return all;
    }
    // Rings twice as far apart as directions across an axis.
    for (int ring = 0; ring < 18; ring += 2) {
      const double up = ring * step;
      add_ring(std::cos(up), std::sin(up), static_cast<int>(std::ceil(36.0 * std::cos(up))));
    }
    all.emplace_back(Eigen::Vector3d::UnitZ());
    return all;
  }

  /// Turned to where it is used most near a direction: across the axis of the pin, or every way.
  AlongDirection turned_to_worst(Frame& frame, AlongDirection from) {
    const bool anywhere = frame.of.ways > 2;
    const double reach = anywhere ? 2.0 * step : step;
    for (int turn = 0; turn < (anywhere ? 4 : 1); ++turn) {
      const Eigen::Vector3d way = from.way;
      Eigen::Vector3d beside(-way.y(), way.x(), 0.0);
      if (anywhere) beside = way.unitOrthogonal();
      if (turn % 2 == 1) beside = way.cross(beside).eval();
      const auto at = [&](double angle) {
        return along(frame, std::cos(angle) * way + std::sin(angle) * beside, true);
      };
      const Extremum between =
          find_maximum([&](double angle) { return at(angle).use(); }, -reach, reach, 10);
      if (between.value > from.use()) from = at(between.at);
    }
    return from;
  }

  /// Between 0 and pi.
  static double angle_of(const Eigen::Vector3d& way) {
    const double angle = std::atan2(way.y(), way.x());
    return angle < 0.0 ? angle + std::numbers::pi : angle;
  }

  /// In words, where a direction lies.
  std::string seen(const Eigen::Vector3d& way) const {
    const std::string& name = in_->of.name;
    if (in_->of.ways == 1) return "along " + name;
    if (in_->of.ways == 2)
      return fmt::format("at {:.1f} deg in the axes of {}",
                         angle_of(way) * 180.0 / std::numbers::pi, name);
    return fmt::format("along ({:.2f}, {:.2f}, {:.2f}) in the axes of {}", way.x(), way.y(),
                       way.z(), name);
  }

  AlongDirection along(Frame& frame, const Eigen::Vector3d& way, bool between_instants) {
    AlongDirection of;
    of.way = way;
    of.turns.resize(project_->situations.size());
    for (auto& [situation, force] : frame.runs)
      of.turns[situation] = force.turns_along(way, stress_per_force_, between_instants);
    of.channel.curve = curve_of(lug_->detail.detail);
    for (const SituationCycles& cycles : life_cycles_of(*project_, of.turns, false)) {
      for (SpectrumRow& row :
           rows_of(project_->situations[cycles.situation].name, StressKind::direct, cycles.cycles))
        of.channel.spectrum.push_back(std::move(row));
      const auto [highest, lowest] = extremes_in(*project_, cycles.situation, of.turns);
      const double range = highest.value - lowest.value;
      if (range <= of.largest) continue;
      of.largest = range;
      of.of_largest = cycles.situation;
    }
    // As small as no stress is one (`no_stress_at`).
    if (of.largest < 1e-6 * lug_->yield_strength.value()) return of;
    of.life = life_of(*project_, {of.channel});
    of.by_life = project_->fatigue.required / of.life.factor;
    of.by_range = project_->fatigue.demand.gamma_Ff * of.largest / limit().value();
    return of;
  }

  Stress limit() const { return range_limit(plainly, lug_->yield_strength, StressKind::direct); }

  const Project* project_;
  const LugInput* lug_;
  const PinInput* pin_;
  double stress_per_force_ = 0.0;  ///< of the pin [1/m^2]
  std::vector<Frame> frames_;
  Frame* in_ = nullptr;  ///< in which it is used most
};

bool bears_force(const Project& project, const NeighbourRuns& runs, const PinInput& pin) {
  const double nothing = negligible_force(runs);
  return std::any_of(runs.begin(), runs.end(), [&](const auto& run) {
    const Extreme most =
        run->largest(project, [&](double time) { return run->force_in(pin.joint, time); });
    return most.value > nothing;
  });
}

}  // namespace

std::string name_of(const PinInput& pin, const LugInput& lug) {
  return pin.name + (lug.inner ? " inner plate" : " outer plates");
}

double share_of(const LugInput& lug) { return lug.inner ? 1.0 : 0.5; }

NeighbourChecks check_lugs(const Project& project, const std::deque<SituationRun>& solved) {
  NeighbourChecks checks;
  if (!project.fatigue.asked || project.pins.empty()) return checks;
  const NeighbourRuns runs = neighbour_loads_of(project, solved);
  for (const PinInput& pin : project.pins) {
    if (pin.lugs.empty()) {
      if (bears_force(project, runs, pin))
        checks.not_judged.push_back({Criterion::lug_fatigue, "fatigue of the plates of " + pin.name,
                                     "[[pins.lugs]] are not given"});
      continue;
    }
    check_unique(runs, pin.joint, "pin " + pin.name);
    for (const LugInput& lug : pin.lugs) {
      LugLife life(project, runs, pin, lug);
      const AlongDirection worst = life.worst();
      if (worst.use() > 0.0)
        checks.results.push_back(life.result_of(worst));
      else
        checks.not_judged.push_back(
            {Criterion::lug_fatigue, "fatigue of " + name_of(pin, lug), "no stress range"});
    }
  }
  return checks;
}

}  // namespace boxbeam
