// The solver of instants where two branches cross: passing such a place on the smooth one.

#include <Eigen/LU>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "solver_limits.hpp"

namespace boxbeam::planar {

using namespace limits;

bool InstantSolver::pass_change_point(double time, double place, const State& known,
                                      State& result) {
  // A step over the place where the Jacobian is singular, from far enough before it to far enough
  // behind it: on the smooth branch the rule of Hermite holds to a high order, on the other one
  // velocities jump.
  constexpr double smooth_branch = 1e-4;
  const double dt = time - known.time;
  State beyond;
  for (const double share : {1.0, 1.5, 2.0, 3.0}) {
    const double target = known.time + share * dt;
    if (step(target, known, beyond, smooth_branch, true) != Outcome::good) continue;
    if (!assembles_around(place, known, beyond)) return false;
    change_points_.push_back(place);
    if (share == 1.0) {
      result = beyond;
    } else if (step(time, beyond, result, smooth_branch, true) != Outcome::good) {
      interpolate_singular(time, known, beyond, result);
    }
    return true;
  }
  return false;
}

bool InstantSolver::assembles_around(double place, const State& before, const State& behind) const {
  // Where a driver leads out of reach and back, there is nothing to pass over: then the mechanism
  // cannot be assembled somewhere in between.
  Assembler assembler(*mechanism_);
  const double width = behind.time - before.time;
  for (int k = 3; k <= 24; k += 3) {
    for (const double sign : {-1.0, 1.0}) {
      const double time = place + sign * width * std::ldexp(1.0, -k);
      const double inside = (time - before.time) / width;
      if (inside <= 0.0 || inside >= 1.0) continue;
      if (!assembler.assemble(time, interpolate(time, before, behind).q).closed) return false;
    }
  }
  return true;
}

void InstantSolver::interpolate_singular(double time, const State& before, const State& behind,
                                         State& result) {
  result = interpolate(time, before, behind);
  equations_.set_time(time);
  equations_.set_position(result.q);
  equations_.evaluate(phi_);
  result.residual = phi_.cwiseProduct(equations_.row_scale()).lpNorm<Eigen::Infinity>();
  result.assembly = 0;
  // At a change point nothing but inertia leads the mechanism across: unless it asks for no force,
  // reactions grow without bound towards it.
  State nearer;
  const double half_way = 0.5 * (time + before.time);
  const bool known = step(half_way, before, nearer, smooth_enough, true) == Outcome::good;
  const double far = before.lambda.lpNorm<Eigen::Infinity>();
  if (!known || nearer.lambda.lpNorm<Eigen::Infinity>() > 1.5 * far + 1e-12) {
    throw AnalysisError(
        {"reactions grow without bound: at a change point the mechanism can go over to another "
         "branch, and only inertia keeps it on this one; guide it (a second crank, a gear), or ask "
         "for an instant beside it",
         "mechanism", time});
  }
  const double share = (time - before.time) / (behind.time - before.time);
  result.lambda = (1.0 - share) * before.lambda + share * behind.lambda;
  result.friction = (1.0 - share) * before.friction + share * behind.friction;
}

bool InstantSolver::start_at_change_point(double time, const Eigen::VectorXd& sketch,
                                          State& state) {
  // The states a little later and a little earlier on a smooth motion through this position. Of two
  // that cross here, the sketch decides.
  const double h = 1e-3 * time_span_of(*mechanism_).length;
  State later, earlier;
  later.time = time + h;
  Assembly assembly = Assembler(*mechanism_).assemble(later.time, sketch);
  if (!assembly.closed) return false;
  equations_.set_time(later.time);
  if (!correct(assembly.q)) return false;
  later.q = unwound(assembly.q, sketch);
  equations_.set_position(later.q);
  if (!complete(later) || later.residual > still_closed) return false;
  if (!on_branch(*mechanism_, later.q)) return false;
  if (step(time - h, later, earlier, 1e-4, true) != Outcome::good) return false;
  if (!assembles_around(time, earlier, later)) return false;
  // A regular position near a dead point is a start like any other.
  if (step(time, later, state, smooth_enough, false) == Outcome::good) return true;
  interpolate_singular(time, earlier, later, state);
  change_points_.push_back(time);
  return true;
}

bool InstantSolver::on_same_side(const State& known, const State& result) {
  // All minors of the Jacobian change their sign together at a change point, and only there; by the
  // formula of Cauchy and Binet the sum of their products is this determinant.
  const auto scaled = [&](const State& at) -> Eigen::MatrixXd {
    equations_.set_time(at.time);
    equations_.set_position(at.q);
    equations_.evaluate(phi_, jacobian_);
    return equations_.row_scale().asDiagonal() * equations_.pattern().dense(jacobian_) *
           equations_.col_scale().asDiagonal();
  };
  const Eigen::MatrixXd before = scaled(known);
  const Eigen::MatrixXd product = before.transpose() * scaled(result);
  return Eigen::PartialPivLU<Eigen::MatrixXd>(product).determinant() > 0.0;
}

}  // namespace boxbeam::planar
