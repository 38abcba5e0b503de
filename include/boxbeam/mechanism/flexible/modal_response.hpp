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

/// Precondition: a damped structure of the exact form is resolved at the last of its modes.
ModalModel modal_model_of(const Structure& structure, std::size_t count);

/// K q = f. Where motions are without strain: of what their inertia leaves of the loads, without
/// any part in them. Throws AnalysisError where the model leaves such motions out.
Deformation<double> static_response_of(const ModalModel& model, const LinkColumns<double>& loads);

/// A way along or about its axes in which a joint damps: it draws its ends together by `damping`
/// times the rate of its gap.
struct DampedWay {
  double damping = 0.0;  ///< [N s/m, N m s/rad]
  Eigen::VectorXd gaps;  ///< of the modes
  /// Under a unit of its force, which is in the joint's, by `static_response_of`.
  Deformation<double> pulled;
};
std::vector<DampedWay> damped_ways_of(const ModalModel& model);

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

/// What the modes bear after the loads are switched on, by their largest speeds eta_j' in the modal
/// coordinates of mass one: a bending beam's stress goes by the speed at which it vibrates.
///
///     free_j   ~ sqrt((r Re p_j)^2 + (Im p_j)^2)/(omega_j |D_j|)
///     driven_j ~ |p_j|/(omega_j |D_j|),  D_j = 1 - r^2 + i d_j r/omega_j,  r = omega/omega_j
///
/// p_j: modal load, of the time factor exp(i omega t); d_j: the mode's damping [1/s]. Each over the
/// largest of all; zero of a mode without strain.
/// Source: F. V. Hunt, J. Acoust. Soc. Am. 32 (1960), 1123.
struct StartShares {
  Eigen::VectorXd free, driven;
};
StartShares start_shares_of(const ModalModel& model);

/// The same at any time, by the parts that add up to it: loads and joint forces are
///
///     constant + Im(turn of_loads) + sum of x_j of_modes_j + speed_j of_speeds_j
///
struct StartNow {
  Complex turn;           ///< e^(i omega t) of the drive
  Eigen::VectorXd x;      ///< -eta''/omega_j^2: of a mode with the inertia of its vibration
  Eigen::VectorXd speed;  ///< eta'
};

class SuddenStartModes {
 public:
  /// Throws AnalysisError where the structure moves without strain in one of its modes.
  explicit SuddenStartModes(const ModalModel& model);

  StartNow at(double time) const;

  const Deformation<double>& constant() const { return constant_; }
  const Deformation<Complex>& of_loads() const { return of_loads_; }
  const std::vector<Mode>& modes() const { return modes_; }
  /// Of damping; empty where nothing damps.
  const std::vector<Deformation<double>>& of_speeds() const { return of_speeds_; }

 private:
  std::vector<Mode> modes_;
  Deformation<double> constant_;
  Deformation<Complex> of_loads_;
  std::vector<Deformation<double>> of_speeds_;
  double omega_ = 0.0;
  Eigen::VectorXcd exponents_;  ///< eigenvalues of the state's equations
  /// What makes x and the speeds of the real, then the imaginary parts of e^(exponents t).
  Eigen::MatrixXd of_waves_;
};

}  // namespace boxbeam::flexible
