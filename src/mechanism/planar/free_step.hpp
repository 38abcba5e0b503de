#pragma once

#include "boxbeam/mechanism/planar/free_motion.hpp"

namespace boxbeam::planar {

/// Error of a step close to a singular position, in scaled coordinates.
inline constexpr double error_near_singular = 1e-8;

/// One step of the method, its end on the constraints.

struct FreeSolver::Step {
  State end;
  double length = 0.0;  ///< [s]
  bool solved = true;
  double error = 0.0;      ///< in tolerances
  double change = 1.0;     ///< of it, where a stage first has a contact that does not go on
  double pivot = 1.0;      ///< the smallest of its stages and its end
  double end_pivot = 1.0;  ///< of its end
};

}  // namespace boxbeam::planar
