#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// What is known of the loads and motions of a run and lies outside the time that is looked at:
/// - functions of time that repeat after more than the duration, one by itself or all together;
/// - steps and tables that end behind it;
/// - the time before `settle`, of a motion that does not only repeat.
/// Nothing of a run that is closed and of recorded loads, and of parts of a turn at a constant rate
/// where fatigue is asked only.
std::vector<NotJudged> unseen_time_of(const Project& project, const std::deque<SituationRun>& runs);

/// How long a motion is looked at [s]; its loads may go on with the vibration behind it.
double length_of_motion(const Project& project, const SituationRun& run);

/// Whether a function of time that has no end and does not repeat within the time of a run changes
/// where that ends: a constant rate, a polynomial.
bool changes_at_end(const Project& project, const SituationRun& run);

}  // namespace boxbeam
