#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Which of `n` samples a picture shows: all, or of many the extremes of every value within equal
/// stretches, which look the same. Ascending, the first and the last among them.
std::vector<std::size_t> drawn_samples(
    std::size_t n, const std::vector<std::function<double(std::size_t)>>& values);

/// The checks whose stress is drawn over time, by their numbers: the governing one of fatigue, or
/// of yield where that rests on no cut forces, and two more of its criterion at other stations with
/// stress of the same situation. None where no stress is computed. `checks`: worst first.
std::vector<std::size_t> drawn_over_time(const std::vector<CheckResult>& checks);

/// The stress of these over one period, or over all of a motion that does not repeat.
void find_drawn_histories(const Project& project, const std::deque<SituationRun>& runs,
                          std::vector<CheckResult>& checks);

}  // namespace boxbeam
