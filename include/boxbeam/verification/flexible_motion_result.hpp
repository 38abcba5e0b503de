#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "boxbeam/mechanism/flexible/structure.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// The vibration of elastic links: the mechanism as the model takes it, and its response.
struct FlexibleMotion {
  std::shared_ptr<const flexible::Mechanism> mechanism;
  std::shared_ptr<const flexible::Structure> structure;
  flexible::Response response;
  /// The motion whose inertia is in the response: its own, or as much as the model counts.
  flexible::LinkColumns<flexible::Complex> inertial;
};

/// Solves the model of a mechanism of elastic links. Quasi-static: without inertia. Modal: the
/// inertia of the modes' own motion, and the static response to it and to the loads (mode
/// acceleration, in balance to round-off). Throws AnalysisError where the structure is free to move
/// or, undamped, in resonance.
FlexibleMotion flexible_motion_of(const flexible::Mechanism& mechanism, const ElasticModel& model);

/// The vibration of a situation of elastic links.
const FlexibleMotion& flexible_motion_of(const SituationRun& run);

/// The mechanism of a structure with every part of its links cut into `factor` equal ones: all its
/// nodes stay nodes, so that what is computed converges without jumps.
flexible::Mechanism refined(const flexible::Structure& structure, int factor);

/// How far a value of the structure may be from that of links divided without end.
struct DiscretisationError {
  double error = 0.0;           ///< absolute, in the unit of the value
  std::optional<double> order;  ///< of convergence; nothing where it is not seen
};

/// From the values of the structure itself and of it refined by 2 and by 4; vectors by the length
/// of their difference. With d_1 = |f_n - f_2n|, d_2 = |f_2n - f_4n|:
///
///     p = log2(d_1/d_2),   error = 1.25 d_1 2^p/(2^p - 1)   where 1 <= p <= 5
///     error = 3 max(d_1, d_2, |f_n - f_4n|)                 where p is not such an order
///
/// An estimate with a margin, no bound. Source: Richardson (1911); Roache, Journal of Fluids
/// Engineering 116 (1994): grid convergence index, factors 1.25 and 3.
DiscretisationError discretisation_error(const Eigen::VectorXd& own, const Eigen::VectorXd& by_2,
                                         const Eigen::VectorXd& by_4);

/// A value that stands still and one that vibrates, world axes: constant + Im(amplitude e^(i omega
/// t)).
template <int Size>
struct Vibration {
  Eigen::Matrix<double, Size, 1> constant;
  Eigen::Matrix<std::complex<double>, Size, 1> amplitude;
  double magnitude = 0.0;  ///< of the constant (x, y)
  double largest = 0.0;    ///< length of the vibrating (x, y) over the period
  DiscretisationError constant_error, amplitude_error;  ///< of (x, y), all components together
};

/// What a joint does to a link [N, N, N m].
struct JointVibration {
  std::string name;
  std::string on;  ///< the beam where it is in the joint, else the first link that is named
  Vibration<3> force;
};

/// Motion of a named point from the unstressed posture [m].
struct PointVibration {
  std::string name;  ///< "boom.lift"
  Vibration<2> motion;
};

struct NaturalFrequency {
  double frequency = 0.0;  ///< [Hz]
  DiscretisationError error;
};

/// A mechanism of elastic links alone: natural frequencies, statics and response to its harmonic
/// loads.
struct FlexibleMotionResult {
  std::size_t degrees_of_freedom = 0;  ///< generalised coordinates of the links
  std::size_t elements = 0;            ///< rigid elements of all links
  std::vector<NaturalFrequency> frequencies;
  double frequency = 0.0;  ///< of the loads [Hz]; zero: none vibrate
  std::vector<JointVibration> joints;
  std::vector<PointVibration> points;
};

/// The mechanism of a case as it stands, with up to eight of its lowest frequencies. Every value is
/// computed for the links as they are divided and for parts cut into 2 and 4, which gives its
/// error. Throws AnalysisError.
FlexibleMotionResult flexible_motion_of(const Project& project);

}  // namespace boxbeam
