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
/// - in space, that take a couple about their guide, or one that tilts them without a guide_length,
///   which presses nowhere, and would at least with 2 M over the mechanism's size;
/// - that do not stick, of which more may act standing than sliding (a static coefficient);
/// of those only that bear a hundredth of the largest force on the beam. Where forces decide the
/// motion contacts stick, which is all that Coulomb's law says; of those that a case gives a creep
/// velocity there, the first is said. In space nothing is said of joints that drives move, which
/// take their friction.
std::vector<NotJudged> slow_friction_of(const Project& project,
                                        const std::deque<SituationRun>& runs);

}  // namespace boxbeam
