#pragma once

#include <variant>
#include <vector>

#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"

namespace boxbeam::planar {

/// Finds states of a mechanism: instant by instant where drivers fix the motion, else by
/// integration from the state before.
class StateSolver {
 public:
  /// Throws AnalysisError where a freedom is left that no driver moves and the mechanism has no
  /// duration over which forces should, and where impacts would move what drivers decide.
  explicit StateSolver(const Mechanism& mechanism);
  /// The same where the freedom is known.
  StateSolver(const Mechanism& mechanism, DegreesOfFreedom freedom);

  bool integrates() const { return std::holds_alternative<FreeSolver>(solver_); }
  const DegreesOfFreedom& freedom() const { return freedom_; }
  /// The first state, at t = 0, on the wanted branch; pins with clearance where they begin.
  State start();
  State near(double time, const State& known);
  std::vector<double> change_points() const;
  std::vector<double> changes() const;
  std::vector<SlipChange> slip_changes() const;

 private:
  const Mechanism* mechanism_;
  DegreesOfFreedom freedom_;
  std::variant<InstantSolver, FreeSolver> solver_;
};

}  // namespace boxbeam::planar
