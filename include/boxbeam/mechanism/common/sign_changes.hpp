#pragma once

#include <functional>
#include <vector>

namespace boxbeam {

/// A quantity at a time, and its rate of change.
struct ValueAndRate {
  double value = 0.0, rate = 0.0;
};

/// Adds the times at which a quantity becomes positive or ceases to be, of a motion that drivers
/// decide: looked at at 3072 times, between two of which it is a cubic, so that one that comes and
/// goes between them is seen as well; each to some 1e-15 of the length.
void add_sign_changes(double begin, double length, const std::function<ValueAndRate(double)>& at,
                      std::vector<double>& changes);

}  // namespace boxbeam
