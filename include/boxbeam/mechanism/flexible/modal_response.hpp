#pragma once

#include <vector>

#include "boxbeam/mechanism/flexible/modes.hpp"

namespace boxbeam::flexible {

/// A structure reduced to its lowest modes, with what they leave of the static response added: mode
/// acceleration,
///
///     q = K^-1 (f - sum over modes of M phi_j eta_j'' + C phi_j eta_j')
///       = K^-1 f - sum of phi_j eta_j''/omega_j^2 + K^-1 C phi_j eta_j'
///
/// Joint forces are in balance with the loads and the inertia of the modes, however few. Damping of
/// links and joints is projected on the modes, couplings included. Where modes are without strain,
/// they enter as phi_j eta_j, and K^-1 is taken of what their inertia leaves of a load.
/// Source: Craig, Kurdila, Fundamentals of Structural Dynamics (2006), mode-acceleration method.
struct ModalModel {
  const Structure* structure = nullptr;
  std::vector<Mode> modes;
  Eigen::MatrixXd damping;  ///< phi^T C phi [1/s]
};

ModalModel modal_model_of(const Structure& structure, std::size_t count);

/// Response to the structure's harmonic loads. `static_correction` false: the modes alone.
/// Throws AnalysisError within a millionth of the frequency of a mode that the loads excite and
/// nothing damps, and with static correction where the model leaves out motions without strain.
Deformation<Complex> harmonic_response(const ModalModel& model, double frequency,
                                       bool static_correction = true);

/// Forces of a joint (x, y, couple on its a, world axes) over a range of frequencies [Hz].
struct Sweep {
  std::vector<double> frequencies;
  std::vector<std::vector<Eigen::Vector3cd>> joints;  ///< of each joint, by frequency
};
Sweep sweep_of(const ModalModel& model, const std::vector<double>& frequencies);

/// The harmonic loads switched on at t = 0 on the structure at rest under its static loads: joint
/// forces at equal steps. Free vibrations of the modes and the forced one, integrated exactly.
struct SuddenStart {
  std::vector<double> times;                         ///< [s]
  std::vector<std::vector<Eigen::Vector3d>> joints;  ///< of each joint, static part included
};
SuddenStart sudden_start_of(const ModalModel& model, double length, std::size_t steps);

}  // namespace boxbeam::flexible
