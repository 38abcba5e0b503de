#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Dry friction that a contact's slowness takes away: sliding below three times its creep velocity
/// less than 95 % of mu P acts, standing nothing, where Coulomb's law has up to mu P in either
/// sense. Said of contacts
/// - of which less than nine tenths of the largest mu P ever act,
/// - that drivers make stand, or slide so slowly, for longer than a tenth of the time looked at,
///   where the beam is stressed more then than just before and behind (else sliding has shown what
///   the friction does), and by seven tenths of its largest stress;
/// of those only that bear a hundredth of the largest force on the beam. Where forces decide the
/// motion a contact may stick, which is right, and only the first is said.
std::vector<NotJudged> slow_friction_of(const Project& project,
                                        const std::deque<SituationRun>& runs);

}  // namespace boxbeam
