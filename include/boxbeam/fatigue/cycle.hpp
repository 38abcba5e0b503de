#pragma once

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// A stress cycle: range from trough to peak (never the amplitude), mean, and how often.
struct Cycle {
  Stress range;
  Stress mean;
  double count = 1.0;
};

}  // namespace boxbeam
