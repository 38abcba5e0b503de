#pragma once

#include <vector>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// By how much normal stresses at a station exceed those of the whole section, where shear lag or
/// buckling leaves a part of the beam's plates idle: what is idle in a plate brings no force to the
/// weld at its end either.
struct WeldLoss {
  double N = 1.0, M_y = 1.0, M_z = 1.0;

  bool none() const { return N == 1.0 && M_y == 1.0 && M_z == 1.0; }
};

/// Of elastic shear lag, on both sides of a station the larger one: A, I_y and I_z of the beam's
/// whole section over those of the effective one. One for paths, whose lag stops the verdict in
/// fatigue and is counted in `buckling_loss_at` else. Source: EN 1993-1-5:2006, 3.1, 3.2.
WeldLoss lag_loss_at(const Project& project, const std::vector<BendingZone>& zones, Length s);

/// Of plates that buckle, on both sides of a station: the largest ratio of the stress of the
/// effective sections to that of the whole one, each in the corner (place) used most, of all
/// instants. For strength only; fatigue of such plates goes by the whole section (2.2(5)).
/// Source: EN 1993-1-5:2006, 4.4, 4.6, 3.3 (of paths); that welds follow, EN 1993-1-8:2005, 4.9(1)
/// by analogy.
double buckling_loss_at(const Project& project, const std::vector<BendingZone>& zones, Length s,
                        const std::vector<SituationHistory>& histories);

WeldLoss operator*(const WeldLoss& loss, double by);

/// A section less what is idle: normal stresses by it are larger by the loss.
SectionProperties less(SectionProperties of, const WeldLoss& loss);

}  // namespace boxbeam
