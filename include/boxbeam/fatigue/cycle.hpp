#pragma once

#include <vector>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// A stress cycle: range from trough to peak (never the amplitude), mean, and how often.
struct Cycle {
  Stress range;
  Stress mean;
  double count = 1.0;
};

/// The full cycles of one period of a periodic history, from its turning points in order of time.
///
/// Rotated to its highest point the history closes, so that every cycle is a full one and no
/// residue is left: rainflow by four points. The largest range counted is max - min.
/// Source: ASTM E1049-85, 5.4.5 (repeating histories); Amzallag et al. (1994), four-point method.
std::vector<Cycle> count_periodic_cycles(const std::vector<Stress>& turning_points);

}  // namespace boxbeam
