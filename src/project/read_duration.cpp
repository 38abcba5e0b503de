#include <fmt/format.h>

#include <algorithm>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

constexpr const char* with_a_duration =
    "or say how long to look at the motion: [motion] with duration = \"10 s\"";

/// The table of a case in which a function of time is written.
const char* table_of(const DriverUse& function, const FunctionTables& tables) {
  return function.on == DriverUse::On::joint ? tables.joints : tables.forces;
}

/// Notes tables that say nothing of a time that is looked at, 0 s to the end of the motion.
void check_tables_cover(TableReader& root, const std::vector<DriverUse>& functions,
                        const Duration& duration, const FunctionTables& tables) {
  double until = duration.settle + duration.length;
  if (duration.length == 0.0) {
    // To the end of the last step or table; where all repeats, no table has an end.
    for (const DriverUse& function : functions) {
      until = std::max(until, timing_of(*function.driver, function.turning).end);
    }
  }
  for (const DriverUse& function : functions) {
    const DriverTiming timing = timing_of(*function.driver, function.turning);
    if (!timing.known) continue;
    const auto [first, last] = *timing.known;
    const double rounding = 1e-9 * (last - first);
    if (first <= rounding && last >= until - rounding) continue;
    TableReader table = root.table(table_of(function, tables));
    table.problem(
        function.name,
        fmt::format("the table of \"{}\" goes from {:.6g} s to {:.6g} s, and the motion is "
                    "looked at from 0 s to {:.6g} s",
                    function.name, first, last, until),
        "write beyond = \"hold\" (it keeps its end values) or beyond = \"periodic\", or "
        "give it more rows");
  }
}

/// Without a duration, the motion is looked at for a common period, or to the end of a step.
void check_repetition(TableReader& root, const std::vector<DriverUse>& functions,
                      const FunctionTables& tables) {
  std::vector<double> omegas;
  const DriverUse* endless = nullptr;  // neither repeats nor ends
  bool repeats = true;
  for (const DriverUse& function : functions) {
    const DriverTiming timing = timing_of(*function.driver, function.turning);
    omegas.insert(omegas.end(), timing.omegas.begin(), timing.omegas.end());
    repeats = repeats && timing.repeats;
    if (!timing.repeats && timing.end <= 0.0 && endless == nullptr) endless = &function;
  }
  if (repeats && omegas.empty()) {
    root.problem("drivers", "nothing drives the mechanism",
                 fmt::format("write at least one [drivers.<name>], {}", with_a_duration));
  } else if (repeats && !common_period_of(omegas)) {
    root.problem(
        "drivers", "the drivers and forces have no common period after which the motion repeats",
        fmt::format("write frequencies of which a whole number of cycles takes the same time (0.7 "
                    "Hz and 1.4 Hz), {}",
                    with_a_duration));
  } else if (!repeats && endless != nullptr) {
    TableReader table = root.table(table_of(*endless, tables));
    table.problem(
        endless->name, fmt::format("\"{}\" neither repeats nor ends", endless->name),
        fmt::format("write a kind that does (harmonic, smooth step, table), {}", with_a_duration));
  }
}

}  // namespace

Duration read_duration(TableReader& root) {
  Duration duration;
  if (!root.has("motion")) return duration;
  TableReader table = root.table(
      {"motion", "how long to look: where forces move the mechanism or its drivers do not repeat"});
  duration.length = table.positive({"duration", "to look at"}, wanted::time);
  duration.settle = table.not_negative({"settle", "before it, not looked at"}, wanted::time, 0.0);
  table.finish();
  return duration;
}

void check_functions(TableReader& root, const std::vector<DriverUse>& functions,
                     const Duration& duration, const FunctionTables& tables) {
  if (root.problems().empty() && duration.length == 0.0) check_repetition(root, functions, tables);
  if (root.problems().empty()) check_tables_cover(root, functions, duration, tables);
}

}  // namespace boxbeam::readers
