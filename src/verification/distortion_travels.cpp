// How far distortion comes over situations that run one after the other.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "boxbeam/verification/distorted_stretch.hpp"

namespace boxbeam {
namespace {

/// The top of the parabola through three places, the middle one of which is not below the others,
/// above that one.
double top_above(const std::array<double, 3>& at, const std::array<double, 3>& values) {
  const double before = at[1] - at[0], behind = at[2] - at[1];
  const double fall_before = (values[1] - values[0]) / before;
  const double fall_behind = (values[1] - values[2]) / behind;
  const double bend = (fall_before + fall_behind) / (before + behind);
  if (bend <= 0.0) return 0.0;
  const double slope = (fall_before * behind - fall_behind * before) / (before + behind);
  return slope * slope / (4.0 * bend);
}

/// Values at the instants of a run, an extreme among its neighbours as the parabola through these
/// has it, where nothing jumps or bends between them.
std::vector<double> with_tops(const LoadHistory& loads, std::vector<double> values) {
  const std::vector<double> given = values;
  const std::size_t last = given.size() - 1;
  const double period = loads.period().value();
  for (std::size_t k = 0; k <= last; ++k) {
    const std::size_t next = k == last ? 0 : k + 1;
    if (loads.begins_piece(k) || loads.begins_piece(next)) continue;
    const std::size_t before = k == 0 ? last : k - 1;
    const double sign = given[k] >= given[next] ? 1.0 : -1.0;
    if (sign * (given[k] - given[next]) < 0.0 || sign * (given[k] - given[before]) < 0.0) continue;
    const double s = loads.time_of(k).value();
    values[k] += sign * top_above({loads.time_of(before).value() - (k == 0 ? period : 0.0), s,
                                   loads.time_of(next).value() + (k == last ? period : 0.0)},
                                  {sign * given[before], sign * given[k], sign * given[next]});
  }
  return values;
}

/// By how much a value goes up and down and rises, run after run, back to where it began.
struct Travel {
  double range = 0.0, rise = 0.0;
};

template <typename ValueAt>
Travel travel_of(const std::deque<SituationRun>& runs, const std::vector<std::size_t>& of,
                 const ValueAt& value_at) {
  std::vector<double> values;
  for (const std::size_t run : of) {
    const LoadHistory& loads = runs[run].loads;
    std::vector<double> more(loads.instants());
    for (std::size_t i = 0; i < more.size(); ++i) more[i] = value_at(run, i);
    more = with_tops(loads, std::move(more));
    values.insert(values.end(), more.begin(), more.end());
    // What repeats ends as it began, before the next one comes.
    if (loads.closed()) values.push_back(more.front());
  }
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  Travel travel{*highest - *lowest, std::max(0.0, values.front() - values.back())};
  for (std::size_t i = 1; i < values.size(); ++i)
    travel.rise += std::max(0.0, values[i] - values[i - 1]);
  return travel;
}

constexpr std::array<double DistortionSize::*, 3> sizes = {
    &DistortionSize::angle, &DistortionSize::moment, &DistortionSize::shear};

}  // namespace

std::vector<DistortionTravel> DistortedStretch::travels(
    const std::vector<std::size_t>& runs) const {
  std::map<std::pair<std::size_t, TorqueSource>, Travel> of_nodes;
  bool lines = false, tapers = false;
  for (const std::size_t run : runs) {
    for (const Loads& loads : loads_[run]) {
      for (const NodeLoad& at : loads.nodes) of_nodes[{at.node, at.from}];
      lines = lines || loads.lines;
      tapers = tapers || loads.tapers;
    }
  }
  for (auto& [of, travel] : of_nodes) {
    travel = travel_of(*runs_, runs, [&, of = of](std::size_t run, std::size_t i) {
      const std::vector<NodeLoad>& at = loads_[run][i].nodes;
      const auto found = std::find_if(at.begin(), at.end(), [&](const NodeLoad& load) {
        return load.node == of.first && load.from == of.second;
      });
      return found == at.end() ? 0.0 : found->d;
    });
  }
  std::vector<DistortionTravel> all(places_.size());
  for (std::size_t k = 0; k < places_.size(); ++k) {
    DistortionTravel& of = all[k];
    for (double DistortionSize::*const size : sizes) {
      for (const auto& [from, travel] : of_nodes) {
        const double effect = std::abs(of_node(from.first)[k].*size);
        of.range.*size += effect * travel.range;
        of.rise.*size += effect * travel.rise;
      }
      const auto add_effects = [&](std::optional<Effects> Loads::*effects) {
        const Travel travel = travel_of(*runs_, runs, [&](std::size_t run, std::size_t i) {
          const std::optional<Effects>& at = loads_[run][i].*effects;
          return at ? (*at)[k].*size : 0.0;
        });
        of.range.*size += travel.range;
        of.rise.*size += travel.rise;
      };
      if (lines) add_effects(&Loads::lines);
      if (tapers) add_effects(&Loads::tapers);
    }
  }
  // At every instant all are between minus and plus what they do together.
  for (std::size_t k = 0; k < places_.size(); ++k) {
    DistortionSize most;
    for (const std::size_t run : runs) {
      std::vector<DistortionSize> sums;
      for (const Loads& loads : loads_[run]) sums.push_back(size_at(k, loads));
      for (double DistortionSize::*const size : sizes) {
        std::vector<double> values;
        for (const DistortionSize& of : sums) values.push_back(of.*size);
        values = with_tops((*runs_)[run].loads, std::move(values));
        most.*size = std::max(most.*size, *std::max_element(values.begin(), values.end()));
      }
    }
    for (double DistortionSize::*const size : sizes)
      all[k].range.*size = std::min(all[k].range.*size, 2.0 * most.*size);
  }
  return all;
}

}  // namespace boxbeam
