#include "boxbeam/verification/recorded_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "boxbeam/mechanism/recorded/derivatives.hpp"
#include "boxbeam/mechanism/recorded/motion_columns.hpp"

namespace boxbeam {
namespace {

/// The columns that move the beam.
std::set<std::string> motion_of(const recorded::Loads& loads) {
  std::set<std::string> columns;
  for (const recorded::ChannelSource& of : loads.sources) {
    if (of.load == recorded::motion_of_beam) columns.insert(of.what);
  }
  return columns;
}

bool is_path(const std::set<std::string>& columns) { return columns.count("angle") > 0; }

void add_turning(const std::set<std::string>& columns, std::vector<NotJudged>& found) {
  if (columns.empty() || is_path(columns)) return;
  const auto has = [&](const char* of) { return columns.count(of) > 0; };
  const auto look = [&](bool accelerated, const char* omega) {
    if (!accelerated || has(omega)) return;
    found.push_back({Criterion::yield, "the beam's motion",
                     fmt::format("how it turns is not in it: give {0} (a column of zeros where it "
                                 "does not turn)",
                                 omega)});
  };
  look(has("a_x") || has("a_z") || has("alpha_y"), "omega_y");
  look(has("a_y") || has("alpha_z"), "omega_z");
}

/// The channels that are derivatives of columns, by their places behind those of the loads.
std::vector<std::size_t> derived_channels(const std::set<std::string>& columns, std::size_t count) {
  // Their order is that of `add_inertia`: acceleration and alpha of each axis, then products.
  std::vector<bool> behind;
  const auto has = [&](const char* what, std::size_t axis) {
    return columns.count(fmt::format("{}_{}", what, "xyz"[axis])) > 0;
  };
  std::size_t turning = 0;
  if (is_path(columns)) {
    behind = {true, true, true};  // a_x, a_z, alpha_y
    turning = 1;
  } else {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (has("a", axis)) behind.push_back(false);
      const bool rate = has("omega", axis), given = has("alpha", axis);
      if (rate || given) behind.push_back(!given);
      if (rate) ++turning;
    }
  }
  behind.resize(behind.size() + turning * (turning + 1) / 2, false);
  std::vector<std::size_t> derived;
  for (std::size_t k = 0; k < behind.size() && behind.size() <= count; ++k) {
    if (behind[k]) derived.push_back(count - behind.size() + k);
  }
  return derived;
}

void add_waves(const recorded::Channels& channels, const std::set<std::string>& columns,
               std::vector<NotJudged>& found) {
  constexpr std::size_t enough = 10;  // instants to a wave
  if (columns.empty()) return;
  recorded::ShortestWave shortest;
  for (const std::size_t k : derived_channels(columns, channels.values.size())) {
    const recorded::ShortestWave of =
        recorded::shortest_wave_of(channels.times, channels.values[k]);
    if (of.instants == 0 || (shortest.instants != 0 && of.instants >= shortest.instants)) continue;
    shortest = of;
  }
  if (shortest.instants == 0 || shortest.instants >= enough) return;
  found.push_back(
      {Criterion::yield, "the beam's motion",
       fmt::format(
           "its accelerations have {} instants to a wave at {:.6g} s: up to {:.2g} % of "
           "their peaks may be missing",
           shortest.instants, shortest.time,
           100.0 * (1.0 - std::cos(std::numbers::pi / static_cast<double>(shortest.instants))))});
}

/// A step between two instants.
struct Step {
  double from = 0.0, length = 0.0;
  std::size_t instant = 0;  ///< behind it
};

/// What steps a record has.
struct RecordSteps {
  Step longest;         ///< over which a value changes
  double median = 0.0;  ///< half of all are at most that
  bool even = false;    ///< nearly all are that
};

template <class TimeOf, class Changes>
RecordSteps record_steps_of(std::size_t instants, TimeOf time_of, Changes changes) {
  std::vector<double> steps;
  RecordSteps of;
  Step& longest = of.longest;
  for (std::size_t i = 1; i < instants; ++i) {
    const double length = time_of(i) - time_of(i - 1);
    steps.push_back(length);
    if (length > longest.length && changes(i)) longest = {time_of(i - 1), length, i};
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  of.median = *middle;
  constexpr double alike = 0.01, nearly_all = 0.95;
  const auto even = std::count_if(steps.begin(), steps.end(), [&](double step) {
    return std::abs(step - of.median) <= alike * of.median;
  });
  of.even = static_cast<double>(even) >= nearly_all * static_cast<double>(steps.size());
  return of;
}

void add_gaps(const recorded::Channels& channels, std::vector<NotJudged>& found) {
  // Median steps; where all others are as long, instants were lost.
  constexpr double far = 100.0, far_of_even = 10.0;
  constexpr double same = 1e-6;       // of what a value changes
  constexpr std::size_t fewest = 10;  // instants of which a median says something
  const recorded::Record* const record = channels.record.get();
  const std::size_t instants = record != nullptr ? record->instants() : channels.times.size();
  if (instants < fewest) return;
  const std::size_t count = record != nullptr ? record->channels() : channels.values.size();
  std::vector<double> slack;
  for (std::size_t k = 0; k < count && k < channels.values.size(); ++k) {
    const auto [low, high] =
        std::minmax_element(channels.values[k].begin(), channels.values[k].end());
    slack.push_back(same * (*high - *low));
  }
  const auto value = [&](std::size_t k, std::size_t i) {
    return record != nullptr ? record->value(k, i) : channels.values[k][i];
  };
  const auto changes = [&](std::size_t i) {
    for (std::size_t k = 0; k < slack.size(); ++k) {
      if (std::abs(value(k, i) - value(k, i - 1)) > slack[k]) return true;
    }
    return false;
  };
  const auto time_of = [&](std::size_t i) {
    return record != nullptr ? record->time_of(i) : channels.times[i];
  };
  const RecordSteps steps = record_steps_of(instants, time_of, changes);
  const Step& gap = steps.longest;
  const double median = steps.median;
  if (gap.length < (steps.even ? far_of_even : far) * median) return;
  found.push_back({Criterion::yield, "the record",
                   fmt::format("it has no instants between {:.6g} and {:.6g} s, {:.3g} of its "
                               "usual steps: a straight line is taken there",
                               gap.from, gap.from + gap.length, gap.length / median)});
}

}  // namespace

std::vector<NotJudged> not_judged_of_records(const Project& project) {
  std::vector<NotJudged> found;
  std::set<std::pair<const void*, bool>> seen;
  for (const Situation& situation : project.situations) {
    const AnyMechanism& mechanism = mechanism_in(project, situation);
    const auto* const loads = std::get_if<recorded::Loads>(&mechanism);
    if (loads == nullptr || !situation.runs() || loads->acting.units.empty()) continue;
    if (!seen.insert({loads->acting.channels.get(), loads->inertia}).second) continue;
    const std::size_t before = found.size();
    const std::set<std::string> columns = motion_of(*loads);
    add_turning(columns, found);
    add_waves(*loads->acting.channels, columns, found);
    add_gaps(*loads->acting.channels, found);
    if (found.size() > before) break;  // the same of other situations
  }
  return found;
}

}  // namespace boxbeam
