#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"
#include "boxbeam/verification/planar_links.hpp"

namespace boxbeam {

/// A mechanism with its elastic beams, stopped in a posture, its links bearing what they bear in
/// the rigid motion at that instant: theory of the second order about the rigid bodies.
///
/// Forces keep their direction while links turn. On a link that turns by phi the forces F at arms p
/// from its centre of mass do the work -phi^2/2 sum of F . p, which is stiffness, in the beam along
/// its axis integral of N w'^2. What pushes or pulls along a line without mass, a rod, an actuator
/// or a spring of length l under the tension F, adds F/l across it.
/// Left out: that the normal force of a guide turns with a guide that itself moves, that toothed
/// wheels roll, and forces that turn with the body on which they act.
/// Sources: Przemieniecki, Theory of Matrix Structural Analysis (1968), chapter 15; for the links
/// the second derivative of the constraints times their multipliers (García de Jalón, Bayo,
/// Kinematic and Dynamic Simulation of Multibody Systems, 1994).
struct LoadedPosture {
  std::unique_ptr<const flexible::Mechanism> links;
  flexible::Structure structure;  ///< of these
  int beam_link = 0;
  const TaperedBeam* beam = nullptr;
  CutForceDiagram rigid;  ///< of the beam as a rigid body
  /// Links of what is elastic beside the beam, bodies and then lines, and the same of them.
  std::vector<std::pair<int, CutForceDiagram>> beside = {};
  /// Joints of the links that give way, and what they do in the rigid motion (`force_in`).
  std::vector<std::pair<std::size_t, Eigen::Vector3d>> joints = {};
};

/// Loads on what is elastic beside the beam as on rigid bodies, in the order of
/// `LoadedPosture::beside`.
std::vector<BeamLoads> loads_beside(const planar::Mechanism& mechanism, const planar::State& state,
                                    const ElasticBody& elastic);

/// `rigid`: loads on the rigid beam in this state; all forces that are there count `factor` times
/// in the stiffness. `axial`: loads whose axial force the beam bears, where they are better known
/// than those of the rigid beam. Precondition: no obstacle to links.
LoadedPosture loaded_posture(const planar::Mechanism& mechanism, const planar::State& state,
                             const ElasticBody& elastic, const TaperedBeam& beam,
                             const BeamLoads& rigid, double factor = 1.0,
                             const BeamLoads* axial = nullptr);

/// The beam alone, as a link that joints hold and that bears this axial force.
LoadedPosture loaded_beam(flexible::Mechanism held, const TaperedBeam& beam, const BeamLoads& rigid,
                          double factor = 1.0);

/// Whether no part of an elastic link buckles by itself.
bool all_parts_stand(const LoadedPosture& posture);

/// Whether the posture stands: nothing buckles in the plane.
bool stands(const LoadedPosture& posture);

/// Throws AnalysisError where links are free to move.
void require_held(const LoadedPosture& posture);

/// What bending adds to the loads of the rigid beam when it bends statically under them.
struct SecondOrder {
  /// Changes of the joints' forces and what the axial force does to the bent axis: in balance.
  BeamLoads loads;
  double turn = 0.0;  ///< largest of a section against the rigid beam [rad]
};

/// Solves (K + K_g) q = f, f the loads whose first-order cut forces are those of the rigid beam.
/// Throws AnalysisError where links are free to move. Precondition: it stands.
SecondOrder second_order_of(const LoadedPosture& posture);

/// What springs and joints take over where the mechanism is free to move and bends statically, by
/// the first order: in balance. `modes`: of the posture, all of frequency zero among them.
BeamLoads taken_over_in(const LoadedPosture& posture, const std::vector<flexible::Mode>& modes);

/// The loads on the beam in a motion about the posture, joint forces, what the axial force does to
/// the bent axis, and the inertia of a vibration of this frequency [Hz].
BeamLoads loads_in_motion(const LoadedPosture& posture, const flexible::Deformation<double>& motion,
                          double frequency);

/// The mean of cut forces (N, V, couple in the link's axes at the part's spring) over a part, for
/// cut forces that are polynomials of third degree in it.
Eigen::Vector3d mean_over(const CutForceDiagram& diagram, const flexible::SpringElement& part);

}  // namespace boxbeam
