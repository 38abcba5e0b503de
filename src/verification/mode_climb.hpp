#pragma once

#include <deque>
#include <functional>
#include <string>

#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"

/// The climb from rigid bodies to ever more modes, which mechanisms in the plane and in space
/// share.

namespace boxbeam {

/// Part of the tolerance from which on an estimate is looked at: far below, it is not worth the
/// modes of every posture.
constexpr double verified_above = 0.7;

/// What bodies without vibration miss: what was `found` against one mode in every posture, and what
/// is estimated to be missed with that mode.
double missed_beside_mode(double found, const VibrationEstimate& estimate);

/// What vibration is estimated to add to rigid bodies, in words with the tolerance.
std::string missed_text(const VibrationEstimate& estimate, const ModelChoice& choice);

/// The lowest natural frequency against the loads, in words. `beside`: of the frequency, behind its
/// number.
std::string against_frequencies(const VibrationEstimate& estimate, const std::string& beside = "");

/// Why so many modes of motions that do not repeat cannot be looked at; "" where they can.
/// `held_behind`: whether the mechanism vibrates on behind its motion.
std::string too_fast(const std::deque<SituationRun>& rigid, const std::vector<double>& frequencies,
                     std::size_t modes, bool held_behind = true);

/// What a climb to ever more modes asks and says.
struct Climb {
  std::string missed;   ///< by rigid bodies, in words
  std::string against;  ///< `against_frequencies`
  /// Error of a model against a better one.
  std::function<double(const ElasticModel&)> found_by;
  /// Says of so many modes why they cannot be looked at; of those that can it is false.
  std::function<bool(std::size_t)> unseen = {};
  /// Error of the model asked last against one of twice the parts; without it links keep theirs.
  std::function<double()> missed_by_parts = {};
  bool bends_twice = false;  ///< `ElasticModel`
};

/// Sets the first modes that are known to be within the tolerance; else why none are, "" where that
/// is said already.
std::string climb_modes(const VibrationEstimate& estimate, const Climb& climb, ModelChoice& choice);

}  // namespace boxbeam
