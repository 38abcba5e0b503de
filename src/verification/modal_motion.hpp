#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/verification/transient_response.hpp"

namespace boxbeam {

/// Modes of a posture that is passed in motion, in the basis of the posture's own.
struct ModalPosture {
  Eigen::VectorXd squares;           ///< of the angular frequencies, ascending, or zero [1/s^2]
  Eigen::MatrixXd damping;           ///< phi^T C phi [1/s]
  Eigen::MatrixXd of_material;       ///< the part of it that is in the strained beams
  Eigen::MatrixXd of_rate, of_size;  ///< what turning adds [1/s, 1/s^2]
  Eigen::VectorXd force;             ///< generalised, under the loads of the rigid motion
  Eigen::MatrixXd turn;              ///< from the basis of the motion to this one (`turn_between`)
};

/// The lowest of modes that do not move without force [Hz].
double lowest_frequency_of(const Eigen::VectorXd& squares);

/// What a unit of force moves each mode by statically; one without stiffness not at all.
Eigen::VectorXd flexibilities_of(const Eigen::VectorXd& squares);

/// The equations of a posture in the basis of the motion.
ModalEquations aligned(const ModalPosture& posture);

/// The coordinates of modes over a periodic motion, a row for each of its instants [sqrt(kg) m].
struct ModalMotion {
  Eigen::MatrixXd eta, speed;
  /// eta + K^-1 C eta' - K^-1 p: with the viscous part of the material, less their static one.
  Eigen::MatrixXd dynamic;
};

/// The periodic solution of
///
///     eta'' + (C + F') eta' + (K + F) eta = p(t)
///
/// F', F what turning adds, by Fourier collocation at equal steps, an even number of postures, from
/// the begin of a period. Throws AnalysisError where a harmonic meets a natural frequency without
/// damping. Source: Trefethen, Spectral Methods in MATLAB (2000), chapter 3.
ModalMotion solve_modal_motion(const std::vector<ModalPosture>& postures, double period);

/// The turn that brings the modes of a posture nearest to others, which have as many: Q with Q^T Q
/// = 1 and least |shapes Q - reference|. Source: Schönemann, Psychometrika 31 (1966).
Eigen::MatrixXd nearest_turn(const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& reference);

/// The same. Throws AnalysisError where they are not recognised.
Eigen::MatrixXd turn_between(const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& reference,
                             double time);

/// The value at a time of the trigonometric polynomial through equally spaced values (an even
/// number). Source: Berrut, Trefethen, SIAM Review 46 (2004), barycentric form.
Eigen::VectorXd trigonometric_at(const Eigen::MatrixXd& values, double turns);

/// Throws AnalysisError where a period has more instants than are solved.
void require_few_instants(std::size_t instants);

/// The fewest instants, a power of two apart from all, that leave the linear system small.
Eigen::Index stride_of(std::size_t instants, std::size_t modes);

/// Throws the AnalysisError of a beam; without a time of all times.
[[noreturn]] void refuse_vibration(const std::string& what);
[[noreturn]] void refuse_vibration(const std::string& what, double time);

/// The same loads on the stretches of others, each of which lies inside one of theirs.
std::vector<LineLoad> on_stretches_of(const std::vector<LineLoad>& lines,
                                      const std::vector<LineLoad>& finer);

/// Adds what a mode does to a beam to its loads, so many times: at the same places, and on the
/// mode's stretches, which lie inside the beam's own.
void add_mode(BeamLoads& sum, double factor, const BeamLoads& mode);

}  // namespace boxbeam
