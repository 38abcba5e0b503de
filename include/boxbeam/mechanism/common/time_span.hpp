#pragma once

#include <string_view>
#include <vector>

#include "boxbeam/mechanism/common/driver.hpp"

namespace boxbeam {

/// The time that is looked at. All zero: one period of the drivers.
struct Duration {
  double settle = 0.0;  ///< time before, solved and left out [s]
  double length = 0.0;  ///< [s]
};

/// How long the motion is looked at.
struct TimeSpan {
  double begin = 0.0;          ///< [s]
  double length = 0.0;         ///< [s]
  bool closed = true;          ///< the drivers repeat after `length`
  double highest_omega = 0.0;  ///< of drivers and forces [rad/s]
  /// A force has edges of a table that are too steep for waves of this frequency: what it does
  /// there is looked at at the points of the table.
  bool steeper = false;
};

/// A function of time that a mechanism follows, and what follows it.
struct DriverUse {
  enum class On { joint, force, couple };

  const Driver* driver = nullptr;
  bool turning = false;  ///< it moves an angle, whose whole turns are no difference
  On on = On::joint;
  std::string_view name;  ///< of the joint or force, whose mechanism stays
};

/// From the duration, or one common period of all functions, or up to the end of the last step or
/// table. Throws AnalysisError where none of these is known.
TimeSpan time_span_of(const std::vector<DriverUse>& uses, const Duration& duration);

/// How many waves of the fastest function, but for steep edges of a force, the time holds. Throws
/// AnalysisError where they are more than `most` instants resolve, eight for each.
double waves_of(const TimeSpan& span, int most);

/// The times from `from` to `until` at which any of the functions is not smooth, ascending, each
/// once with the lowest order that jumps there: where a search over time is to be divided. A motion
/// driver that jumps in its third derivative gives loads whose slope jumps.
std::vector<Break> breaks_of(const std::vector<DriverUse>& uses, double from, double until);

}  // namespace boxbeam
