#pragma once

#include <Eigen/Core>
#include <optional>

#include "boxbeam/mechanism/planar/equations_of_motion.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"

namespace boxbeam::planar {

/// Integrates the freedoms that no driver moves, under the forces applied: the accelerations of the
/// equations of motion by a Runge-Kutta method of order 8 with a step chosen by its error (Fehlberg
/// 7(8), Boost.Odeint). After every step positions and velocities are projected back onto the
/// constraints, so that nothing drifts. No step ends close to a singular position, where
/// accelerations lose digits and another branch begins: it is passed over in one step, whose error
/// may be 1e-8, and states asked for within are interpolated.
/// Sources: Fehlberg, NASA TR R-287 (1968); Eich, SIAM J. Numer. Anal. 30 (1993).
class FreeSolver {
 public:
  /// `tolerance`: error of a step in scaled coordinates and their rates. `project` false leaves the
  /// drift in, to show it.
  explicit FreeSolver(const Mechanism& mechanism, double tolerance = 1e-11, bool project = true);

  /// The state at a time from rough positions and velocities: both are moved onto the constraints.
  /// Throws AnalysisError where the mechanism cannot be assembled or its mass is singular.
  State start(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  /// The state at a later (or earlier) time. Throws AnalysisError where the step falls below what
  /// arithmetic can tell apart.
  State advance(double time, const State& known);

  /// Steps taken and equations solved so far.
  int steps() const { return steps_; }
  int evaluations() const { return equations_.evaluations(); }

 private:
  struct Step;
  /// A step over a singular position, and the state given last between its ends.
  struct Passage {
    State before, behind, given;
  };

  State state_of(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v);
  Step step_from(const State& known, double dt);
  /// Whether a pivot is that of a position close to a singular one.
  bool is_near_singular(double pivot) const;
  /// Of the steps further than one that ends close to a singular position, over it, the most
  /// accurate; nothing where none is accurate enough.
  std::optional<Step> step_over(const State& known, double dt);
  State between(const Passage& passage, double time);

  const Mechanism* mechanism_;
  double tolerance_;
  bool project_;
  EquationsOfMotion equations_;
  double regular_ = 0.0;  ///< the largest of the smallest pivots so far
  double natural_ = 0.0;  ///< the longest step that an error allowed, whatever was looked at [s]
  std::optional<Passage> passage_;
  int steps_ = 0;
};

}  // namespace boxbeam::planar
