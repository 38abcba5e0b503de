#pragma once

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "boxbeam/numerics/table_curve.hpp"

/// Functions of time that a coordinate, a force or a couple follows. Plain SI numbers, by what is
/// driven: metres or radians, newtons or newton metres.
namespace boxbeam {

/// One harmonic, amplitude sin(omega t + phase).
struct Harmonic {
  double amplitude = 0.0;
  double omega = 0.0;  ///< [rad/s]
  double phase = 0.0;  ///< [rad]
};

/// mean + amplitude sin(omega t + phase) + the same of `further` harmonics.
struct HarmonicDriver {
  double mean = 0.0;
  double amplitude = 0.0;
  double omega = 0.0;  ///< [rad/s]
  double phase = 0.0;  ///< [rad]
  std::vector<Harmonic> further = {};
};

/// start + rate t. On an angle the mechanism comes back after a turn.
struct RateDriver {
  double start = 0.0;
  double rate = 0.0;  ///< [1/s]
};

/// c[0] + c[1] t + c[2] t^2 + ...
struct PolynomialDriver {
  std::vector<double> c;
};

/// From one value to another between two times, rate and acceleration zero at both ends:
///
///     from + (to - from) (10 u^3 - 15 u^4 + 6 u^5),   u = (t - begin)/(end - begin)
///
/// and constant before and behind.
struct StepDriver {
  double from = 0.0;
  double to = 0.0;
  double begin = 0.0;  ///< [s]
  double end = 1.0;    ///< [s]
};

/// Through the points of a table: what moves a coordinate is twice continuously differentiable, the
/// size of a force need not be.
struct TableDriver {
  TableCurve curve;
};

using Driver = std::variant<HarmonicDriver, RateDriver, PolynomialDriver, StepDriver, TableDriver>;

/// Value and first two time derivatives of a driver.
struct DriverState {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

DriverState driver_at(const Driver& driver, double time);

/// What a driver says about how long to look at the motion.
struct DriverTiming {
  /// Angular frequencies after which it repeats: of each harmonic, of a periodic table, of a turn
  /// at constant rate where `turning`. Empty for a driver that does not repeat, and for a constant.
  std::vector<double> omegas;
  /// Whether it repeats (a constant does).
  bool repeats = true;
  /// Where it does not repeat: the end of a step or table [s], 0 where it has none.
  double end = 0.0;
  /// Of a table that says nothing beyond its points: the only times at which it may be asked [s].
  std::optional<std::pair<double, double>> known = {};
  /// Highest angular frequency that it holds [rad/s]: a bound for the sampling of what follows it.
  double highest_omega = 0.0;
  /// Of a table that is straight or level between its points: the same by the mean distance of
  /// these. What it does between them is known from its points alone.
  std::optional<double> mean_omega = {};
};

/// `turning`: the driver moves an angle, whose whole turns are no difference.
DriverTiming timing_of(const Driver& driver, bool turning);

/// The times from `from` to `until`, both included, at which a driver is not smooth: points of a
/// table, ends of a smooth step. Ascending. At a jump (order 0) the driver has the value behind it;
/// the one before it is found a little earlier (1e-9 of the time looked at is far more than
/// rounding can take back).
std::vector<Break> breaks_of(const Driver& driver, double from, double until);

/// The shortest time after which all of the angular frequencies have completed whole cycles, or
/// nothing where there is none with at most `most` cycles of the fastest [s].
std::optional<double> common_period_of(const std::vector<double>& omegas, int most = 1000);

}  // namespace boxbeam
