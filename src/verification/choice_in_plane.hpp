#pragma once

#include <deque>
#include <string>

#include "boxbeam/verification/situation_run.hpp"
#include "second_order_growth.hpp"
#include "tried_models.hpp"

namespace boxbeam {

/// The model of a beam that a mechanism in the plane moves: climbs from rigid bodies to bent ones
/// and to ever more modes, and says where loads from a table may have been measured. `obstacle`: to
/// an estimate of vibration. Throws AnalysisError where no model is within the tolerance.
ModelChoice choose_in_plane(const Project& project, const std::deque<SituationRun>& rigid,
                            const std::string& obstacle, TriedModels& tried,
                            DesignedSecondOrder designed);

/// States what the chosen model's loads leave unbalanced when the beam bends as far as it does.

void weigh_balance(const Project& project, const std::deque<SituationRun>& rigid,
                   const std::deque<SituationRun>& by_model, ModelChoice& choice);

}  // namespace boxbeam
