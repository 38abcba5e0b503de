#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

/// What the report draws, computed from the situations of a verification that run.
namespace boxbeam {

/// The mechanism as it stands at a time, with the loads on the beam; the text says why it is shown.
using PostureAt = std::function<PostureFigure(Time, const std::string& why)>;

/// The postures of a situation. Elastic links are drawn with their displacements magnified, by the
/// same factor at all times.
PostureAt postures_of(const Project& project, const SituationRun& run);

/// 48 instants of a situation, evenly divided: of a motion that repeats without its end, of one
/// that stays open with it.
CycleFigure cycle_figure_of(const Project& project, const SituationRun& run);

/// What moves the mechanism in a situation. In the plane the drivers; where they leave a freedom to
/// forces, also the points and angles that forces and couples act on, or, where nothing of that
/// kind acts, the coordinates of the first body that is moved, without force. In space the joints
/// that move, elastic links the harmonic loads with the motion of their points.
/// Where the Newton chain loads the beam, the drivers' forces are not known: they are left out.
std::vector<DriverLine> driver_lines_of(const Project& project, const SituationRun& run);

/// The section where the worst check that rests on cut forces stands; nothing where none does.
std::optional<SectionFigure> section_figure_of(const Project& project,
                                               const std::deque<SituationRun>& runs,
                                               const std::vector<CheckResult>& checks);

/// Fills what a verification holds for pictures, from its checks and critical instants.
void add_pictures(const Project& project, const std::deque<SituationRun>& runs, Figures figures,
                  Verification& result);

}  // namespace boxbeam
