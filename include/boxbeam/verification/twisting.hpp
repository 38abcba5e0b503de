#pragma once

#include <deque>
#include <optional>

#include "boxbeam/verification/second_order_estimate.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// N/N_cr of beams of open thin walls under compression, bending both ways and twisting at once,
/// where it is above `no_buckling_below` and above that of bending alone.
///
/// By the largest compression of each open segment at any instant, the length between places held
/// against turning that it reaches over (beyond the outermost, and where there is but one, warping
/// resists nothing), the weakest of its sections, and the largest N/N_cr of bending, each on the
/// safe side. Source: EN 1993-1-1:2005, 6.3.1.4; Timoshenko, Gere, Theory of Elastic Stability
/// (1961), section 5.4.
std::optional<BucklingLoad> twisting_load_of(const Project& project,
                                             const std::deque<SituationRun>& runs,
                                             const SecondOrderEstimate& estimate);

}  // namespace boxbeam
