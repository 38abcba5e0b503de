#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/discretisation.hpp"

namespace boxbeam {

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
