#pragma once

#include <vector>

#include "boxbeam/mechanism/common/time_span.hpp"

namespace boxbeam {

/// The times of a motion at which a load jumps or its slope does (orders 0 and 1): between samples
/// on both sides of one of them nothing smooth is to be expected, however close they are.
class RoughTimes {
 public:
  /// Over the time from `begin` to `begin + period`; a closed motion goes on with its beginning.
  /// `more`: further times at which loads jump or bend.
  RoughTimes(const std::vector<DriverUse>& uses, double begin, double period, bool closed,
             const std::vector<double>& more = {});

  /// Whether samples from one time to the other lie on both sides of such a time; at a jump a
  /// sample has the value behind it. Both within one period of the time looked at.
  bool between(double from, double until) const;

 private:
  std::vector<Break> times_;
  double rounding_;
};

}  // namespace boxbeam
