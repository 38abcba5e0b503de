#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/flexible/structure.hpp"
#include "boxbeam/verification/planar_links.hpp"

namespace boxbeam {

/// Free vibrations of a planar mechanism with its elastic beam, stopped in a posture.
struct PostureModes {
  std::vector<double> frequencies;  ///< ascending [Hz]
  /// What acts on the beam in each, joints and inertia, per unit of the mode [per sqrt(kg) m].
  std::vector<BeamLoads> loads;
  std::vector<CutForceDiagram> diagrams;  ///< of these
  Eigen::MatrixXd damping;                ///< phi^T C phi [1/s]
  /// Motion of the bodies in their own axes, by roots of masses: a column per mode. Tells modes of
  /// different postures apart.
  Eigen::MatrixXd shapes;
  flexible::DividedLink beam;  ///< the springs of the beam
};

/// Throws AnalysisError where the stopped mechanism is free to move.
PostureModes modes_in_posture(const planar::Mechanism& mechanism, const planar::State& state,
                              const ElasticBody& elastic, const TaperedBeam& beam,
                              std::size_t count);

/// The generalised force of a mode under loads on the rigid beam that are in balance: the work of
/// their cut forces on its strains,
///
///     p_j = integral of N N_j/EA + V V_j/GA + M M_j/EI   over the beam
///
/// the same as phi_j^T of all forces and inertia of the rigid mechanism, for joints do no work and
/// rigid bodies are in balance. Per part by Simpson's rule. Source: principle of virtual work.
Eigen::VectorXd modal_loads(const PostureModes& modes, const CutForceDiagram& rigid);

}  // namespace boxbeam
