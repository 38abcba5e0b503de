#pragma once

#include <deque>

#include "tried_models.hpp"

namespace boxbeam {

/// Whether a frame at rest vibrates under loads over time by more than is tolerated, and if so the
/// first modes that are known to hold what does; loads act slowly where none are.

void choose_for_frame(const Project& project, TriedModels& tried, ModelChoice& choice,
                      std::deque<SituationRun>& runs);

}  // namespace boxbeam
