#pragma once

#include <vector>

#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "second_order_growth.hpp"

namespace boxbeam {

/// Steady vibration of elastic links whose beam bears the axial force of its static loads, against
/// that of the same links without it, over a period: compression makes the beam softer and its
/// frequencies lower, omega^2 by 1 - N/N_cr, which near a resonance is far more than statics say.
///
/// `factor`: how many times the axial force counts. Axial forces of other links do not count.
/// Throws AnalysisError where it buckles or, undamped, meets a natural frequency.
/// Precondition: a case of elastic links.
/// Source: Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974), section 5.12.
BothCompared pressed_vibration_of(const Project& project, const SituationRun& run, double factor,
                                  const std::vector<ComparedPlace>& places);

}  // namespace boxbeam
