#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/verify.hpp"

/// What the report draws, computed from the situations of a verification that run.
namespace boxbeam {

/// The postures of a situation, with its name and that of the loads' situation in them.
PostureAt postures_of(const Project& project, const SituationRun& run);

/// 48 instants of a situation, evenly divided: of a motion that repeats without its end, of one
/// that stays open with it.
CycleFigure cycle_figure_of(const Project& project, const SituationRun& run);

/// The section where the worst check that rests on cut forces stands; nothing where none does.
std::optional<SectionFigure> section_figure_of(const Project& project,
                                               const std::deque<SituationRun>& runs,
                                               const std::vector<CheckResult>& checks);

/// Fills what a verification holds for pictures, from its checks and critical instants.
void add_pictures(const Project& project, const std::deque<SituationRun>& runs, Figures figures,
                  Verification& result);

}  // namespace boxbeam
