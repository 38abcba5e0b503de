#include "boxbeam/mechanism/planar/free_motion.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"

namespace boxbeam::planar {
namespace {

constexpr double near_singular = 2e-2;  ///< a scaled pivot of the equations of motion
/// A pivot, and its part of the largest of a step, below which a stage stands on a singular
/// position rather than beside it.
constexpr double on_singular = 1e-4;
constexpr double part_on_singular = 1e-3;
constexpr int most_attempts = 6;            ///< to pass one between two stages
constexpr double largest_round_off = 1e-8;  ///< that a step is accepted with

/// The stage of a step that is nearest to a singular position.
struct NearestStage {
  double smallest = 1.0, largest = 0.0;  ///< pivots of all stages
  double time = 0.0;                     ///< of the smallest

  void see(double t, double pivot) {
    if (pivot < smallest) time = t;
    smallest = std::min(smallest, pivot);
    largest = std::max(largest, pivot);
  }
  bool on_a_singular_position() const {
    return smallest < on_singular && smallest < part_on_singular * largest;
  }
  /// Of the accelerations, which no shorter step makes smaller.
  double round_off() const {
    constexpr double with_regular_equations = 1e-14;
    return std::min(largest_round_off,
                    with_regular_equations / std::max(smallest, with_regular_equations));
  }
};

/// A step that has a singular position in the middle between two stages, where it does no harm, or
/// one that ends before. `there`: how far it is; `dt`: the step that had a stage on it.
double step_past(double there, double dt) {
  // The stages stand at 0, 2/27, 1/9, 1/6, 1/3, 5/12, 1/2, 2/3, 5/6 and 1 of the step.
  for (const double between : {1.0 / 4.0, 7.0 / 12.0, 3.0 / 4.0, 11.0 / 12.0}) {
    if (std::abs(there) < 0.99 * between * std::abs(dt)) return there / between;
  }
  // So that what is left after it has the position at 3/4.
  const double behind = std::max(std::abs(dt - there), 0.05 * std::abs(there));
  return there - std::copysign(3.0 * behind, there);
}

}  // namespace

FreeSolver::FreeSolver(const Mechanism& mechanism, double tolerance, bool project)
    : mechanism_(&mechanism), tolerance_(tolerance), project_(project), equations_(mechanism) {}

State FreeSolver::state_of(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  State state;
  state.time = time;
  state.q = q;
  state.v = v;
  if (!equations_.solve_rates(time, q, v, state.a, state.lambda)) {
    throw AnalysisError(
        {"accelerations are not determined: a freedom that no driver moves has no "
         "mass (give the body a mass and inertia, or drive it), or the mechanism "
         "stands exactly in a singular position",
         "mechanism",
         time,
         {},
         {}});
  }
  state.residual = equations_.residual();
  return state;
}

State FreeSolver::start(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  Assembler assembler(*mechanism_);
  Assembly assembly = assembler.assemble(time, q);
  if (!assembly.closed) throw AnalysisError(failure_of_assembly(*mechanism_, time, assembly));
  constexpr int other_starts = 256;
  const std::string off = loops_off_branch(*mechanism_, assembly.q);
  for (int attempt = 1; !(assembly.closed && on_branch(*mechanism_, assembly.q)); ++attempt) {
    if (attempt > other_starts) {
      throw AnalysisError(
          {"no assembly found on the wanted branch; change the sign asked for, or "
           "the sketch",
           off,
           time,
           {},
           {}});
    }
    assembly = assembler.assemble(time, other_start(*mechanism_, q, attempt));
  }
  Eigen::VectorXd position = assembly.q;
  Eigen::VectorXd velocity = v;
  if (!equations_.project(time, position, velocity)) {
    throw AnalysisError(
        {"the motion starts in a singular position, where velocities cannot be moved "
         "onto the constraints; start beside it",
         "mechanism",
         time,
         {},
         {}});
  }
  return state_of(time, position, velocity);
}

State FreeSolver::advance(double time, const State& known) {
  using Vector = std::vector<double>;
  const Eigen::Index n = mechanism_->coordinates();
  const Eigen::VectorXd& scale = equations_.constraints().col_scale();
  Eigen::VectorXd q = known.q;
  Eigen::VectorXd v = known.v;
  Eigen::VectorXd a, lambda;
  const auto pack = [&](Vector& y) {
    Eigen::Map<Eigen::VectorXd>(y.data(), n) = q.cwiseQuotient(scale);
    Eigen::Map<Eigen::VectorXd>(y.data() + n, n) = v.cwiseQuotient(scale);
  };
  const auto unpack = [&](const Vector& y) {
    q = Eigen::Map<const Eigen::VectorXd>(y.data(), n).cwiseProduct(scale);
    v = Eigen::Map<const Eigen::VectorXd>(y.data() + n, n).cwiseProduct(scale);
  };
  bool solved = true;
  NearestStage nearest;
  bool on_constraints = false;  // stages are moved onto them as well
  const auto rates = [&](const Vector& y, Vector& rate, double t) {
    unpack(y);
    if (solved) {
      solved = (!on_constraints || equations_.project(t, q, v)) &&
               equations_.solve_rates(t, q, v, a, lambda);
      nearest.see(t, solved ? equations_.smallest_pivot() : 0.0);
    }
    if (!solved) {
      std::fill(rate.begin(), rate.end(), 0.0);
      return;
    }
    Eigen::Map<Eigen::VectorXd>(rate.data(), n) = v.cwiseQuotient(scale);
    Eigen::Map<Eigen::VectorXd>(rate.data() + n, n) = a.cwiseQuotient(scale);
  };

  boost::numeric::odeint::runge_kutta_fehlberg78<Vector> stepper;
  Vector y(static_cast<std::size_t>(2 * n)), next(y.size()), error(y.size()), rate(y.size());
  pack(y);
  double t = known.time;
  const double direction = time < t ? -1.0 : 1.0;
  const double smallest = 1e-13 * std::max(std::abs(time), std::abs(known.time)) + 1e-300;
  double dt = time - t;
  int attempts = 0;
  while (direction * (time - t) > smallest) {
    dt = direction * std::min(std::abs(dt), std::abs(time - t));
    solved = true;
    nearest = {};
    stepper.do_step(rates, y, t, next, dt, error);
    double size = 0.0;  // of the error, in tolerances
    for (std::size_t i = 0; i < y.size(); ++i) {
      size = std::max(size, std::abs(error[i]) / (tolerance_ * (1.0 + std::abs(y[i]))));
    }
    if (solved && project_) {
      unpack(next);
      solved = equations_.project(t + dt, q, v);
      pack(next);
    }
    if (solved) rates(next, rate, t + dt);  // where it ends must be regular as well
    if (project_ && !on_constraints && nearest.smallest < near_singular) {
      // What its stages are off the constraints, the equations enlarge by the inverse of the pivot.
      on_constraints = true;
      continue;
    }
    if (nearest.on_a_singular_position() && nearest.time != t && attempts++ < most_attempts) {
      // Its accelerations have no digits there: whatever branch crosses could be taken.
      dt = step_past(nearest.time - t, dt);
      continue;
    }
    const double bound = std::max(1.0, nearest.round_off() / tolerance_);
    if (!solved || !(size <= bound)) {
      // The order of the error estimate is eight; Source: Hairer, Norsett, Wanner (1993), II.4.
      const double shrink =
          solved && std::isfinite(size) ? 0.9 * std::pow(bound / size, 1.0 / 8.0) : 0.25;
      dt *= std::max(0.2, shrink);
      if (std::abs(dt) > smallest) continue;
      throw AnalysisError(
          {"the motion under the applied forces cannot be integrated further: it "
           "changes faster than the arithmetic can follow (a singular position, or "
           "far too stiff a spring)",
           "mechanism",
           t,
           {},
           {}});
    }
    ++steps_;
    attempts = 0;
    on_constraints = on_constraints && nearest.smallest < near_singular;
    std::swap(y, next);
    t += dt;
    dt *= std::min(5.0, 0.9 * std::pow(bound / std::max(size, 1e-9 * bound), 1.0 / 8.0));
  }
  unpack(y);
  return state_of(time, q, v);
}

}  // namespace boxbeam::planar
