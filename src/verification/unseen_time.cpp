#include "boxbeam/verification/unseen_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "frame_time.hpp"
#include "front_ends.hpp"

namespace boxbeam {
namespace {

constexpr double rounded = 1e-6;  // of the time looked at

struct FunctionsOf {
  std::vector<DriverUse> operator()(const planar::Mechanism& of) const {
    return planar::functions_of(of);
  }
  std::vector<DriverUse> operator()(const spatial::Mechanism& of) const {
    return spatial::functions_of(of);
  }
  std::vector<DriverUse> operator()(const frame::Structure& of) const {
    return frame::functions_of(of);
  }
  /// Elastic links are driven by harmonics and looked at over their whole period, or after a sudden
  /// start; files have all that is known.
  std::vector<DriverUse> operator()(const flexible::Mechanism&) const { return {}; }
  std::vector<DriverUse> operator()(const recorded::Loads&) const { return {}; }
};

std::vector<DriverUse> functions_in(const Project& project, const SituationRun& run) {
  return std::visit(FunctionsOf{}, mechanism_in(project, *run.situation));
}

bool is_turn(const DriverUse& of) {
  return of.turning && std::holds_alternative<RateDriver>(*of.driver);
}

/// A harmonic function of no amplitude, a table of one value.
bool never_changes(const Driver& driver, double from, double until) {
  constexpr int looks = 64;
  const double first = driver_at(driver, from).value;
  for (int i = 0; i <= looks; ++i) {
    if (driver_at(driver, from + (until - from) * i / looks).value != first) return false;
  }
  return true;
}

/// After what time functions with these frequencies repeat; of those without a common period the
/// slowest.
double period_of(const std::vector<double>& omegas) {
  const std::optional<double> common = common_period_of(omegas);
  return common ? *common : full_turn / *std::min_element(omegas.begin(), omegas.end());
}

/// What lies behind the time looked at, "" where nothing is known of it. `turns`: whether a whole
/// turn at a constant rate is meant to be looked at, as ranges of stress do.
std::string behind(const std::vector<DriverUse>& functions, double begin, double length,
                   bool turns) {
  const double end = begin + length;
  std::vector<double> all;
  bool repeats = true;
  for (const DriverUse& of : functions) {
    const DriverTiming timing = timing_of(*of.driver, of.turning);
    repeats = repeats && timing.repeats;
    if (is_turn(of) && !turns) continue;
    if (!timing.omegas.empty()) {
      const double period = period_of(timing.omegas);
      if (never_changes(*of.driver, begin, begin + period)) continue;
      if (period > length * (1.0 + rounded))
        return fmt::format("{:.4g} s of the period of {}, {:.4g} s, are looked at", length, of.name,
                           period);
      all.insert(all.end(), timing.omegas.begin(), timing.omegas.end());
    } else if (timing.end > end + rounded * length && !never_changes(*of.driver, end, timing.end)) {
      return fmt::format("{} goes on to {:.6g} s, and {:.6g} s are looked at", of.name, timing.end,
                         end);
    }
  }
  if (!repeats || all.empty()) return "";
  const std::optional<double> common = common_period_of(all);
  if (!common || *common <= length * (1.0 + rounded)) return "";
  return fmt::format(
      "{:.4g} s of the {:.4g} s after which its functions of time repeat together "
      "are looked at",
      length, *common);
}

/// Whether all that ever happens happens between `begin` and the end of a run.
bool only_repeats(const Project& project, const SituationRun& run,
                  const std::vector<DriverUse>& functions) {
  if (const auto* const space = std::get_if<spatial::Mechanism>(&project.mechanism)) {
    if (std::any_of(space->joints.begin(), space->joints.end(), spatial::is_forced)) return false;
  }
  if (std::holds_alternative<planar::Mechanism>(project.mechanism) &&
      planar_motion_of(run).freedom.undriven > 0)
    return false;
  return std::all_of(functions.begin(), functions.end(),
                     [](const DriverUse& of) { return timing_of(*of.driver, of.turning).repeats; });
}

}  // namespace

double length_of_motion(const Project& project, const SituationRun& run) {
  if (std::holds_alternative<planar::Mechanism>(project.mechanism))
    return planar_motion_of(run).period;
  if (std::holds_alternative<spatial::Mechanism>(project.mechanism))
    return span_of_motion_in_space(run).period.value();
  if (std::holds_alternative<frame::Structure>(project.mechanism)) {
    if (const auto time = time_of_loads(frame_in(project, *run.situation))) return time->length;
  }
  return run.loads.period().value();
}

bool changes_at_end(const Project& project, const SituationRun& run) {
  const double length = length_of_motion(project, run);
  const double end = run.loads.begin().value() + length;
  const std::vector<DriverUse> functions = functions_in(project, run);
  return std::any_of(functions.begin(), functions.end(), [&](const DriverUse& of) {
    const DriverTiming timing = timing_of(*of.driver, of.turning);
    if (timing.end > 0.0 || timing.known) return false;
    if (!timing.omegas.empty() && (!is_turn(of) || period_of(timing.omegas) <= length))
      return false;
    const DriverState last = driver_at(*of.driver, end);
    return std::abs(last.rate) * length > rounded * std::abs(last.value);
  });
}

std::vector<NotJudged> unseen_time_of(const Project& project,
                                      const std::deque<SituationRun>& runs) {
  for (const SituationRun& run : runs) {
    if (run.loads.closed() || run.loads.is_recorded() || run.motion->stands_still()) continue;
    const double begin = run.loads.begin().value(), length = length_of_motion(project, run);
    const std::vector<DriverUse> functions = functions_in(project, run);
    const std::string what = run.situation->name.empty()
                                 ? "the motion"
                                 : fmt::format("the motion of {}", run.situation->name);
    const std::string later = behind(functions, begin, length, project.fatigue.asked);
    if (!later.empty()) return {{Criterion::yield, what, later + " ([motion] duration)"}};
    if (begin > 0.0 && !only_repeats(project, run, functions))
      return {
          {Criterion::yield, what,
           fmt::format("what happens before {:.6g} s is not looked at ([motion] settle)", begin)}};
  }
  return {};
}

}  // namespace boxbeam
