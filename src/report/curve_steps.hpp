#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// A corner of an S-N curve, where a branch begins.
struct Corner {
  std::string symbol;  ///< "d_sigma_D"
  double cycles = 0.0;
  double strength = 0.0;  ///< [Pa]
  double slope = 0.0;     ///< of the branch behind it
  std::string what;
};

/// "d_sigma" or "d_tau".
std::string prefix_of(const SnCurve& curve);

/// The corners from the reference to the cut-off, in order.
std::vector<Corner> corners_of(const SnCurve& curve);

/// The corner from which the branch of some cycles comes.
Corner corner_before(const std::vector<Corner>& corners, double cycles);

/// The slope of the branch of some cycles.
double slope_at(const SnCurve& curve, double cycles);

/// The strength of a detail: category, size effect, and the corners of its S-N curve.
Steps curve_steps(const SnCurve& curve, const BeamDetail* detail);

/// The strength at a number of cycles, by the branch of the curve that it lies on.
Step strength_step(const SnCurve& curve, double cycles, Loading loading);

}  // namespace boxbeam::report
