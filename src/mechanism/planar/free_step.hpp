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

/// What is on the way from a state to a time, which a step at a time is gone.
struct FreeSolver::Way {
  Way(const Mechanism& mechanism, const State& from, double time);

  State begin;
  double end, direction, smallest;
  std::vector<double> stops;
  std::size_t stop = 0;  ///< the next of them
  double dt;
  bool inside = false;  ///< close to a singular position already
  int attempt = 0;      ///< to go it in another way
};

}  // namespace boxbeam::planar
