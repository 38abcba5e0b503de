#pragma once

namespace boxbeam {

/// A prescribed coordinate as a function of time,
///
///     x(t) = mean + amplitude sin(omega t + phase)
///
/// Plain SI numbers: metres or radians, by the coordinate that is driven.
struct HarmonicDriver {
  double mean = 0.0;
  double amplitude = 0.0;
  double omega = 0.0;  ///< [rad/s]
  double phase = 0.0;  ///< [rad]
};

/// Value and first two time derivatives of a driver.
struct DriverState {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

DriverState driver_at(const HarmonicDriver& driver, double time);

}  // namespace boxbeam
