#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/elastic_model.hpp"
#include "boxbeam/verification/model_response.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"

namespace boxbeam {

/// A vibrating mechanism of elastic links whose stresses in one of them count.
struct LadderCase {
  const flexible::Mechanism* mechanism = nullptr;
  int link = 0;
  const TaperedBeam* beam = nullptr;  ///< that the link is
};

/// "0.59 %", "130 %".
std::string percent_text(double fraction);

/// "modal, 2 modes, 4 parts per link".
std::string describe(const ElasticModel& model);

/// Stresses of the link by a model. Throws AnalysisError at a resonance without damping.
VibratingStress stresses_by(const LadderCase& of, const ElasticModel& model,
                            const std::vector<ComparedPlace>& places);

/// Places of the link at which models are compared: ends and borders of segments, joints and loads,
/// and between.
std::vector<ComparedPlace> places_of(const LadderCase& of);

/// `difference_between` a model and all elements of a finer division with all deformations.
double error_of(const LadderCase& of, const ElasticModel& model);

/// Climbs from the cheapest model to the first that is estimated to be within the tolerance, solves
/// it, and goes on where a better model finds it wrong:
///
///     rigid             rigid links on joints as they are
///     flexible          all rigid elements
///
/// with n = 2, 3, 4, 6, 8, 12, ... parts per elastic link, bending links as they are or with their
/// elasticity along the axis. Under a harmonic load all elements are eliminated once, at a cost in
/// proportion to their number; its modes, however few, cost more than that (chart `model-cost`),
/// and are no rung. Estimated error of the stresses (`difference_between`): of the division, C n^-p
/// from 4, 8 and 16 parts, and of axial rigidity of bending links. These may cancel, so that a
/// model is tried where their sum is below twice the tolerance. Verified against all elements of
/// twice as many parts (at least 32) with all deformations; twice what that itself is estimated to
/// err is added. Throws AnalysisError at a resonance without damping, and where no division up to
/// 256 parts is good enough.
ModelChoice climb_ladder(const LadderCase& of, double tolerance);

}  // namespace boxbeam
