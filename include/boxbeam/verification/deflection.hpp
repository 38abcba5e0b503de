#pragma once

#include <deque>
#include <optional>
#include <string>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/deflected_line.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// "chord 0 to 4 m", "tangent at 0 m", "unloaded axis".
std::string to_text(const MeasuredFrom& against);

/// The largest deflection, in space of both directions together, anywhere along the beam, at any
/// time, in any situation, against its limit; the load factors of the situations count only where
/// the case asks for it. Small displacements, elastic, quasi-static under the loads of the chosen
/// model, and of second order: times 1/(1 - N/N_cr) by the compression of its situation in the
/// plane of motion, in space in the weaker plane, which `second_order_counted` says is in the cut
/// forces under the loads times one. Nothing for a beam that never bends, or without a limit.
std::optional<CheckResult> check_deflection(const Project& project,
                                            const std::deque<SituationRun>& runs,
                                            bool second_order_counted = false);

}  // namespace boxbeam
