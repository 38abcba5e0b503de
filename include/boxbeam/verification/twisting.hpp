#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/second_order_estimate.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// What is said of open thin-walled beams that may buckle by twisting under compression.
struct Twisting {
  std::vector<Gate> gates;
  std::vector<NotJudged> not_judged;
};

/// Compares the compression of open thin-walled segments with G I_T/i_0^2, i_0 about the shear
/// centre: the load at which they buckle by twisting alone is above that by what warping resists.
/// Where N is more than 0.04 of it and more than bending sideways leaves of its own critical load,
/// the verdict says that this is not judged; where walls may buckle, too, it is kept back. Source:
/// EN 1993-1-1:2005, 6.3.1.4; Timoshenko, Gere, Theory of Elastic Stability (1961), section 5.4.
Twisting look_at_twisting(const Project& project, const std::deque<SituationRun>& runs,
                          const SecondOrderEstimate& estimate);

}  // namespace boxbeam
