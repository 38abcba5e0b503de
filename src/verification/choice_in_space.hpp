#pragma once

#include <deque>
#include <string>

#include "boxbeam/verification/situation_run.hpp"
#include "second_order_growth.hpp"
#include "tried_models.hpp"

namespace boxbeam {

/// The model of a beam that a mechanism in space moves: climbs from rigid bodies to ever more
/// modes; where none are known to be within the tolerance, rigid bodies with what they are
/// estimated to miss. Throws AnalysisError where elastic ones were demanded. `obstacle`: to an
/// estimate of vibration.
ModelChoice choose_in_space(const Project& project, const std::deque<SituationRun>& rigid,
                            const std::string& obstacle, TriedModels& tried,
                            SecondOrderEstimate estimated);

}  // namespace boxbeam
