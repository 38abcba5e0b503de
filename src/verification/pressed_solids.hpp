#pragma once

#include <deque>

#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// How far a force uses the strip between the edge that it comes by and a hole, a beam clamped on
/// both sides of the hole under all of the force in its middle, with what uses it besides:
///
///     m = F d/8 / (e^2 t f_y/4),  v = F/2 / (e t f_y/sqrt(3)),  n = sigma/f_y
///     k m + k^2 (v^2 + n^2) = 1, used by 1/k
///
/// d  diameter; e, t  depth and thickness of the strip. SI. Source: plastic hinges of a clamped
/// beam; m + v^2 + n^2 = 1 lies inside what a rectangle bears.
struct PressedStrip {
  double diameter = 0.0, depth = 0.0, thickness = 0.0, yield_strength = 0.0;
};
double use_of(const PressedStrip& strip, double force, double n);

/// Forces across the beam that come into solid plates by an edge: all but those that stand in a
/// hole, as pins do, or that bosses lead in ([[beam.load_introductions]], into = "webs").
///
/// What presses the strip beside a hole stands with the verdict from a tenth of its strength on; in
/// fatigue, or where the strip is used up by it with the stress of the net section at its edge,
/// there is no verdict. By which edge a force on the axis comes nobody says: each in turn.
///
/// A force needs a bearing F/(t f_y) long; longer than a tenth of the plate's depth it stands with
/// the verdict where the case does not say how long it is, and stops it where it says less.
void check_pressed_solids(const Project& project, const std::deque<SituationRun>& runs,
                          PatchChecks& found);

}  // namespace boxbeam
