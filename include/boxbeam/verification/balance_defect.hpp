#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/elastic_motion.hpp"

namespace boxbeam {

/// What a model's loads on the beam leave unbalanced when the mechanism moves as they bend it.
///
/// The cut forces of the model strain the beam, viscous as it is: N/EA, V/GA, M/EI over 1 + i omega
/// tau. To its bent axis, however far it bends, belong one position of the mechanism at every
/// instant (its drivers fix it), hence velocities and accelerations of all masses (by Fourier
/// series of what they deviate from the rigid motion), hence by d'Alembert's principle the forces
/// in the joints and cut forces on the bent axis. A model without error gives these back. Contained
/// is all that linear vibration about the rigid motion leaves out: that bending shortens the beam
/// and moves what hangs on it, that the axial force vibrates, that the posture changes with the
/// vibration and the modes with the posture.
/// Sources: Reissner, ZAMP 23 (1972), for the strains; Shabana, Dynamics of Multibody Systems
/// (2005), chapter 3, for the inverse dynamics.
struct BalanceDefect {
  /// At the instants of the motion, loads in balance whose cut forces are those of the bent
  /// mechanism less the model's.
  std::vector<BeamLoads> loads;
  double deflection = 0.0;  ///< largest, from the line through the beam's outermost joints [m]
  double turn = 0.0;        ///< largest, of a section against another [rad]
};

/// Why it is not known; "" where it is: friction, and guides, slots or racks on the bent beam.
std::string obstacle_to_balance(const planar::Mechanism& mechanism, int beam);

/// `model`: loads at the instants of the motion. None where the mechanism cannot be assembled with
/// its beam as far bent as it is. Preconditions: the motion repeats and drivers fix it; no
/// obstacle.
std::optional<BalanceDefect> balance_defect_of(const RigidMotion& rigid, const ElasticBody& elastic,
                                               const LoadHistory& model);

/// The error where nothing is known of it.
inline constexpr double unknown_balance = 10.0;

/// How far a model's stresses are from balance, as `difference_between`: what the defect changes in
/// them by vibration with these modes, or by static bending with none, under the model's axial
/// force. That, delta, is the first step of an iteration from the model to the mechanism that bends
/// as far as it does; each further one is smaller by about the part of stiffness and inertia that
/// the first found wrong, delta again, which makes delta/(1 - delta) of all. Where delta is no
/// number or above 0.9, and where there is no defect: `unknown_balance`.
/// Source: Stetter, Numerische Mathematik 29 (1978), the defect as an estimate of the error.
double error_by_balance(const RigidMotion& rigid, const ElasticBody& elastic, std::size_t modes,
                        const LoadHistory& model);

}  // namespace boxbeam
