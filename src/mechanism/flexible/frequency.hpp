#pragma once

#include "boxbeam/core/angle.hpp"

namespace boxbeam::flexible {

/// Distance of the squares of the drive and a natural frequency, relative, within which an
/// amplitude that nothing damps is none; twice the damping ratio counts as distance.
inline constexpr double resonance = 2e-6;

/// The angular frequency [rad/s] of a frequency [Hz].
inline double omega_of(double frequency) { return full_turn * frequency; }

}  // namespace boxbeam::flexible
