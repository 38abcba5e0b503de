#include "boxbeam/mechanism/planar/instant_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

constexpr double converged = 1e-12;   ///< residual [m, rad] below which an assembly is one
constexpr double no_further = 1e-14;  ///< step [m, rad] below which Newton stops
constexpr double singular_pivot =
    1e-13;  ///< smallest pivot [1 or m] of a Jacobian that is no more regular
constexpr int assembly_iterations = 60;
constexpr int halvings = 30;
constexpr int other_starts = 256;
constexpr int deepest_split = 20;  ///< halvings of a time step when a branch is followed

/// Angles are only defined up to a turn: brings every one to the turn of its sketch.
Eigen::VectorXd unwound(const Mechanism& mechanism, Eigen::VectorXd q) {
  constexpr double turn = 2.0 * std::numbers::pi;
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    double& angle = q[3 * static_cast<Eigen::Index>(body) + 2];
    angle -= turn * std::round((angle - mechanism.bodies[body].sketch.angle) / turn);
  }
  return q;
}

/// The distance over which the mechanism spreads, for starts elsewhere [m].
double reach_of(const Mechanism& mechanism) {
  double reach = 0.0;
  for (const Body& body : mechanism.bodies) {
    double longest = 0.0;
    for (const BodyPoint& point : body.points) longest = std::max(longest, point.p.norm());
    reach += longest;
  }
  return reach;
}

/// Term `index` of the van der Corput sequence in a base, in [0, 1): fills the interval evenly
/// without randomness. Source: Halton (1960).
double van_der_corput(int index, int base) {
  double value = 0.0;
  double digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) value += digit * (index % base);
  return value;
}

int nth_prime(std::size_t n) {
  int candidate = 2;
  for (std::size_t found = 0;; ++candidate) {
    bool prime = true;
    for (int d = 2; d * d <= candidate; ++d) prime = prime && candidate % d != 0;
    if (prime && found++ == n) return candidate;
  }
}

}  // namespace

InstantSolver::InstantSolver(const Mechanism& mechanism)
    : mechanism_(&mechanism),
      mass_(mechanism.coordinates()),
      load_(mechanism.coordinates()),
      jacobian_(mechanism.coordinates(), mechanism.coordinates()),
      lu_(mechanism.coordinates()),
      phi_(mechanism.coordinates()),
      step_(mechanism.coordinates()),
      trial_(mechanism.coordinates()) {
  if (mechanism.equations() != mechanism.coordinates()) {
    throw AnalysisError(
        {fmt::format("the motion is not determined: {} equations of joints and "
                     "drivers for {} coordinates of {} bodies",
                     mechanism.equations(), mechanism.coordinates(), mechanism.bodies.size()),
         "mechanism",
         {},
         {},
         {}});
  }
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    mass_.segment<3>(i) << body.mass, body.mass, body.inertia;
    load_.segment<3>(i) << body.mass * mechanism.gravity, 0.0;
    i += 3;
  }
}

double InstantSolver::residual_at(double time, const Eigen::VectorXd& q) {
  evaluate_constraints(*mechanism_, time, q, phi_);
  return phi_.lpNorm<Eigen::Infinity>();
}

Eigen::VectorXd InstantSolver::assemble(double time, const Eigen::VectorXd& start) {
  Eigen::VectorXd q = start;
  if (!try_assemble(time, q)) {
    throw AnalysisError(
        {"the mechanism cannot be assembled from the given sketch: the joints stay "
         "open by the residual; check lengths and driver, or draw the sketch nearer",
         "mechanism",
         time,
         residual_at(time, q),
         {}});
  }
  return q;
}

bool InstantSolver::try_assemble(double time, Eigen::VectorXd& q) {
  for (int iteration = 0; iteration < assembly_iterations; ++iteration) {
    evaluate_constraints(*mechanism_, time, q, phi_, jacobian_);
    const double residual = phi_.lpNorm<Eigen::Infinity>();
    const double norm = phi_.norm();
    lu_.compute(jacobian_);
    if (lu_.matrixLU().diagonal().cwiseAbs().minCoeff() < singular_pivot) {
      if (residual < converged) return true;
      // Exactly at a singular position: step aside by a fixed small amount and go on.
      for (Eigen::Index i = 0; i < q.size(); ++i) {
        q[i] += 1e-3 * (van_der_corput(static_cast<int>(i) + 1, 2) - 0.4);
      }
      continue;
    }
    step_ = lu_.solve(phi_);
    if (!step_.allFinite()) return false;
    if (residual < converged && step_.lpNorm<Eigen::Infinity>() < no_further) return true;
    // No angle turns by more than half a radian at a time: farther the linear step means nothing.
    double turn = 0.0;
    for (Eigen::Index i = 2; i < step_.size(); i += 3) turn = std::max(turn, std::abs(step_[i]));
    if (turn > 0.5) step_ *= 0.5 / turn;
    double factor = 1.0;
    bool better = false;
    for (int k = 0; k < halvings && !better; ++k, factor *= 0.5) {
      trial_ = q - factor * step_;
      evaluate_constraints(*mechanism_, time, trial_, phi_);
      better = phi_.norm() < (1.0 - 0.1 * factor) * norm;
    }
    if (!better) return residual < converged;  // at round-off, or where no step helps
    q = trial_;
  }
  return residual_at(time, q) < converged;
}

State InstantSolver::complete(double time, Eigen::VectorXd q) {
  State state;
  state.time = time;
  evaluate_constraints(*mechanism_, time, q, phi_, jacobian_);
  state.residual = phi_.lpNorm<Eigen::Infinity>();
  lu_.compute(jacobian_);
  if (lu_.matrixLU().diagonal().cwiseAbs().minCoeff() < singular_pivot) {
    throw AnalysisError(
        {"velocities, accelerations and reactions are not determined: the Jacobian "
         "is singular (a dead point, or joints that constrain the same motion twice)",
         "mechanism",
         time,
         state.residual,
         {}});
  }
  velocity_right_side(*mechanism_, time, step_);
  state.v = lu_.solve(step_);
  acceleration_right_side(*mechanism_, time, q, state.v, step_);
  state.a = lu_.solve(step_);
  step_ = load_ - mass_.cwiseProduct(state.a);
  state.lambda = lu_.transpose().solve(step_);
  state.q = std::move(q);
  return state;
}

bool InstantSolver::correct(double time, Eigen::VectorXd& q) {
  constexpr int most = 12;
  double last = 0.0;
  for (int iteration = 0; iteration < most; ++iteration) {
    // The factors are kept while the steps shrink fast (a chord step); renewed when they do not.
    double step = 0.0;
    if (iteration == 0) {
      evaluate_constraints(*mechanism_, time, q, phi_, jacobian_);
      lu_.compute(jacobian_);
    } else {
      evaluate_constraints(*mechanism_, time, q, phi_);
    }
    step_ = lu_.solve(phi_);
    step = step_.lpNorm<Eigen::Infinity>();
    if (!(step < 0.3)) return false;
    q -= step_;
    if (step < no_further * 10.0) return true;
    if (iteration > 0) {
      if (step < 1e-11 && step > 0.1 * last) return true;  // round-off: it will not shrink further
      if (step > 0.1 * last) {
        evaluate_constraints(*mechanism_, time, q, phi_, jacobian_);
        lu_.compute(jacobian_);
      } else if (step * (step / last) < no_further * 10.0) {
        return true;  // linear convergence at the measured rate: the next step is round-off
      }
    }
    last = step;
  }
  return false;
}

State InstantSolver::solve_from_sketch(double time, const Eigen::VectorXd& sketch) {
  Eigen::VectorXd q = assemble(time, sketch);
  std::string off = loops_off_branch(*mechanism_, q);
  const double reach = reach_of(*mechanism_);
  for (int attempt = 1; !off.empty() && attempt <= other_starts; ++attempt) {
    Eigen::VectorXd start = sketch;
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      const double spread = van_der_corput(attempt, nth_prime(static_cast<std::size_t>(i))) - 0.5;
      start[i] += i % 3 == 2 ? 2.0 * std::numbers::pi * spread : reach * spread;
    }
    if (try_assemble(time, start) && loops_off_branch(*mechanism_, start).empty()) {
      q = std::move(start);
      off.clear();
    }
  }
  if (!off.empty()) {
    throw AnalysisError({fmt::format("no assembly found on the wanted branch, from the sketch and "
                                     "{} other starts; change the sign asked for, or the sketch",
                                     other_starts),
                         off,
                         time,
                         residual_at(time, q),
                         {}});
  }
  // Where a coupling or a driver counts turns, an angle must stay as it is.
  Eigen::VectorXd shown = unwound(*mechanism_, q);
  return complete(time, residual_at(time, shown) < converged ? std::move(shown) : std::move(q));
}

State InstantSolver::solve_near(double time, const State& known) {
  // At the known instant itself only the mechanism's masses can differ: the position holds.
  if (time == known.time) return complete(time, known.q);
  return follow(time, known, deepest_split);
}

State InstantSolver::follow(double time, const State& known, int splits) {
  const double dt = time - known.time;
  Eigen::VectorXd q = known.q + dt * (known.v + 0.5 * dt * known.a);
  const bool solved = correct(time, q);
  const std::string off = solved ? loops_off_branch(*mechanism_, q) : "mechanism";
  if (off.empty()) return complete(time, std::move(q));
  if (splits == 0) {
    throw AnalysisError(
        {"the motion cannot be followed on its branch: the mechanism reaches a "
         "dead point or the end of its reach",
         off,
         time,
         residual_at(time, q),
         {}});
  }
  return follow(time, follow(known.time + 0.5 * dt, known, splits - 1), splits - 1);
}

}  // namespace boxbeam::planar
