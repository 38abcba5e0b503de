#pragma once

#include <deque>
#include <functional>
#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "second_order_growth.hpp"
#include "tried_models.hpp"

/// The choice of a model: where modes do not count, and the climb to ever more of them.
namespace boxbeam {

/// Bodies that bend statically under their axial force, without vibration.
inline constexpr ElasticModel bent{ModelLevel::quasi_static, 0, 16, {}, false};

/// A choice before any model is weighed, of a beam of rigid bodies.
ModelChoice begun_choice(const Project& project, SecondOrderEstimate estimated);

/// Whether bodies in space are pressed so far that theory of the first order does not hold, and
/// how they bend is known. Source: EN 1993-1-1, 5.2.1(3).
bool is_pressed_in_space(const Project& project, const SecondOrderEstimate& pressed);

/// What the second order of beams in space has not, in words; "" where it has all.
std::string left_out_of_bending(const Project& project);

/// Where vibration is not estimated: rigid bodies, or bent ones where second order asks for them.
/// Throws AnalysisError where elastic ones were demanded. `known`: what is said before the
/// obstacle.
void choose_unvibrated(const Project& project, const std::string& obstacle, ModelChoice& choice,
                       const std::string& known = "what vibration adds is not estimated: ");

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

/// The model of a beam that a mechanism in the plane moves: climbs from rigid bodies to bent ones
/// and to ever more modes, and says where loads from a table may have been measured. `obstacle`: to
/// an estimate of vibration. Throws AnalysisError where no model is within the tolerance.
ModelChoice choose_in_plane(const Project& project, const std::deque<SituationRun>& rigid,
                            const std::string& obstacle, TriedModels& tried,
                            DesignedSecondOrder designed);

/// States what the chosen model's loads leave unbalanced when the beam bends as far as it does.
void weigh_balance(const Project& project, const std::deque<SituationRun>& rigid,
                   const std::deque<SituationRun>& by_model, ModelChoice& choice);

/// The model of a beam that a mechanism in space moves: climbs from rigid bodies to ever more
/// modes; where none are known to be within the tolerance, rigid bodies with what they are
/// estimated to miss. Throws AnalysisError where elastic ones were demanded. `obstacle`: to an
/// estimate of vibration.
ModelChoice choose_in_space(const Project& project, const std::deque<SituationRun>& rigid,
                            const std::string& obstacle, TriedModels& tried,
                            SecondOrderEstimate estimated);

}  // namespace boxbeam
