#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/study/sensitivities.hpp"
#include "boxbeam/verification/any_motion_result.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// results.json, "boxbeam.results/1": SI units, key order fixed, every number finite. What each key
/// is says its schema, schema_of("results").
std::string results_json(const Project& project, const Verification& verification);

/// The same of every beam of a case: that of the beam that decides, with the checks of all and
/// "beams", what was found of each. Of one beam as above. With sensitivities where they are given.
std::string results_json(const std::vector<VerifiedBeam>& beams,
                         const Sensitivities* sensitivities = nullptr);

/// The motion document, "boxbeam.motion/1", of its kind: planar; spatial with vectors of three in
/// the axes that "axes" names and hand formulas in world axes; flexible with "frequencies",
/// "static", "harmonic" (phasors as [re, im] of e^(i omega t), of which the imaginary part counts)
/// and "discretisation", the errors.
std::string motion_json(const AnyMotionResult& motion);

/// The assemblies at an instant, "boxbeam.assemblies/1".
std::string assemblies_json(const std::vector<AssemblyResult>& assemblies, double time);

}  // namespace boxbeam
