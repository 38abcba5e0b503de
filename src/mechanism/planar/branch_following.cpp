// The solver of instants: from a known state to a near one on the same branch.

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"
#include "solver_limits.hpp"

namespace boxbeam::planar {

using namespace limits;

bool InstantSolver::smooth(const State& from, const State& to, double tolerance) const {
  // Source of the rule: Hermite's quadrature, exact for polynomials of the third degree.
  const double dt = to.time - from.time;
  double error = 0.0;
  double change = 1e-9;
  for (Eigen::Index i = 0; i < to.q.size(); ++i) {
    const double moved = to.q[i] - from.q[i];
    const double by_rates = dt * (0.5 * (from.v[i] + to.v[i]) + dt / 12.0 * (from.a[i] - to.a[i]));
    error = std::max(error, std::abs(moved - by_rates) * inverse_scale_[i]);
    const double largest =
        std::max(std::abs(moved), std::abs(dt) * std::max(std::abs(from.v[i]), std::abs(to.v[i])));
    change = std::max(change, largest * inverse_scale_[i]);
  }
  // Where few digits are left, positions differ by their round-off.
  return error <= tolerance * change + 10.0 * round_off / std::min(1.0, to.pivot);
}

InstantSolver::Outcome InstantSolver::step(double time, const State& known, State& result,
                                           double tolerance, bool crossing) {
  const double dt = time - known.time;
  equations_.set_time(time);
  result.time = time;
  result.q = known.q + dt * (known.v + 0.5 * dt * known.a);
  if (!correct(result.q)) return Outcome::no_convergence;
  if (!complete(result)) return Outcome::singular;
  if (!on_branch(*mechanism_, equations_)) return Outcome::off_branch;
  if (!crossing) {
    const bool comparable = known.assembly != 0 && result.assembly != 0;
    if (comparable && known.assembly != result.assembly) return Outcome::other_assembly;
    const bool comparable_minors = redundant_ && known.pivot > 0.0;
    if (comparable_minors && !on_same_side(known, result)) return Outcome::other_assembly;
  }
  return smooth(known, result, tolerance) ? Outcome::good : Outcome::not_smooth;
}

void InstantSolver::solve_near(double time, const State& known, State& result) {
  // At the known instant itself only the mechanism's masses can differ: the position holds.
  if (time == known.time) {
    result = solve_at(time, known.q);
    return;
  }
  const Outcome direct = step(time, known, result, smooth_enough, false);
  if (direct == Outcome::good) return;
  State reached = known;
  if (follow(time, known, result, reached, deepest_split) == Outcome::good) return;
  // A near miss of a dead point looks smooth from afar: a change point is singular where it is.
  const double condition = condition_of(*mechanism_, reached.q);
  const bool singular = condition == 0.0 || condition * near_change_point > 1.0;
  if (singular && pass_change_point(time, reached.time, known, result)) return;
  throw AnalysisError(failure_of_motion(*mechanism_, reached, time));
}

State InstantSolver::solve_near(double time, const State& known) {
  State result;
  solve_near(time, known, result);
  return result;
}

InstantSolver::Outcome InstantSolver::follow(double time, const State& known, State& result,
                                             State& reached, int splits) {
  split_work_ += static_cast<double>(known.q.size());
  if (split_work_ > most_split_work) {
    throw AnalysisError(
        {"the motion turns or swings too often between the instants looked at: following it takes "
         "too many steps; give a shorter [motion] duration",
         "mechanism", known.time});
  }
  const Outcome direct = step(time, known, result, smooth_enough, false);
  if (direct == Outcome::good) {
    reached = result;
    return direct;
  }
  if (splits == 0) return direct;
  State middle;
  const Outcome half =
      follow(known.time + 0.5 * (time - known.time), known, middle, reached, splits - 1);
  if (half != Outcome::good) return half;
  return follow(time, middle, result, reached, splits - 1);
}

}  // namespace boxbeam::planar
