#pragma once

#include <vector>

#include "boxbeam/core/units.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"

namespace boxbeam {

/// What is left of the arithmetic at the instant nearest to a dead point.
struct DigitsLeft {
  double left = 0.0;  ///< decimal digits of velocities
  Time time;
};

/// What there is to know of a mechanism whose joints are equations to be solved.
struct ClosureSummary {
  planar::DegreesOfFreedom freedom;
  std::vector<int> branch;            ///< sign per loop
  DigitsLeft digits;                  ///< meaningless where forces decide the motion
  std::vector<double> change_points;  ///< times at which two branches cross [s]
  double largest_residual = 0.0;      ///< of the constraints, over all instants [m, rad]
};

}  // namespace boxbeam
