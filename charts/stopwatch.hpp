#pragma once

#include <functional>
#include <vector>

#include "charts/chart.hpp"

namespace boxbeam::charts {

/// How much time experiments may take. Errors of the settings that both have are the same.
struct Effort {
  bool quick = false;  ///< fewer settings, shorter measurements
  bool once = false;   ///< each is done but once: errors and operations are known, times hardly

  int repetitions() const { return once ? 1 : quick ? 5 : 9; }
  double batch() const { return quick ? 5e-4 : 1e-2; }  ///< least time of one measurement [s]
};

/// Times of several alternatives, measured by turns so that whatever else the machine does falls on
/// all of them alike. Each is repeated within a measurement until it takes `Effort::batch`.
std::vector<Timing> times_of(const std::vector<std::function<void()>>& alternatives,
                             const Effort& effort);

/// Keeps a result from being optimised away.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace boxbeam::charts
