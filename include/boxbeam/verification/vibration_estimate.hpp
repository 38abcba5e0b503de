#pragma once

#include <vector>

#include "boxbeam/verification/elastic_motion.hpp"

namespace boxbeam {

/// What rigid bodies are estimated to miss in the stresses of a moving beam, by the modes of a few
/// postures, each taken for the whole motion: in mode j of a motion that repeats
///
///     sum over harmonics h of p_jh/omega_j^2 r^2/(1 - r^2 + 2 i zeta r),  r = h Omega/omega_j
///
/// and of one that does not the response from its beginning, at rest or under way as
/// `ElasticMotion` says (`TransientResponse`), eta + (C eta' - p)/omega_j^2, with a free vibration
/// of a period and a half behind an end at rest. Either is times the stresses of the mode: what
/// elasticity and viscosity bear together beyond the static 1 of the beam that bends statically.
/// Added is the order of what the rotation of the beam couples, (omega_rotation/omega_1)^2; where
/// modes are counted, of it the part of the first mode's mass that is neither the beam's nor of
/// bodies that turn as it does (where forces move the mechanism, that is not the beam's). Where a
/// motion that does not repeat holds more than 200 periods of a mode, phases of its free vibration
/// are not right, their sizes are.
struct VibrationEstimate {
  /// As `difference_between`, of the worst posture, with none, one, ... of the modes counted; of
  /// the last, all that are looked at, what their number leaves out is not known.
  std::vector<double> without_modes;
  /// What rotation couples in spite of modes, and the coefficient of dry friction times what no
  /// mode counted misses; contained in these.
  double left_out = 0.0;
  /// Of the posture whose first frequency is lowest [Hz].
  std::vector<double> frequencies;
  /// Harmonics of the bending moment where the stress range is largest, above a hundredth of it;
  /// none of a motion that does not repeat.
  std::vector<LoadHarmonic> harmonics;
};

/// `history`: of the rigid beam's loads. `slower`: frequencies count so many times, the stresses
/// under static loads staying as they are. Throws AnalysisError where the mechanism is free to move
/// though its drivers are held.
VibrationEstimate estimate_vibration(const RigidMotion& rigid, const ElasticBody& elastic,
                                     const LoadHistory& history, double slower = 1.0);

/// The part of a mode beyond its static one, elastic and viscous together, under generalised forces
/// p at equal steps of a period: its inertia over the square of its frequency. `base`: one over the
/// period [Hz]; `damping`: phi^T C phi [1/s].
Eigen::VectorXd dynamic_part(const Eigen::VectorXd& p, double frequency, double damping,
                             double base);

/// The harmonics of a moment at equal steps of a period that are above a hundredth of its largest.
std::vector<LoadHarmonic> harmonics_of(const Eigen::VectorXd& moment, double base);

}  // namespace boxbeam
