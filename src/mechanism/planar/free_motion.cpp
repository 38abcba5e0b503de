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

constexpr double near_singular = 1e-3;        ///< a scaled pivot of the equations of motion
constexpr double error_near_singular = 1e-8;  ///< of a step there

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
  double pivot = 1.0;  // the smallest of a step's stages
  const auto rates = [&](const Vector& y, Vector& rate, double t) {
    unpack(y);
    solved = solved && equations_.solve_rates(t, q, v, a, lambda);
    if (!solved) {
      std::fill(rate.begin(), rate.end(), 0.0);
      return;
    }
    pivot = std::min(pivot, equations_.smallest_pivot());
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
  while (direction * (time - t) > smallest) {
    dt = direction * std::min(std::abs(dt), std::abs(time - t));
    solved = true;
    pivot = 1.0;
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
    const double bound =
        pivot < near_singular ? std::max(1.0, error_near_singular / tolerance_) : 1.0;
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
    std::swap(y, next);
    t += dt;
    dt *= std::min(5.0, 0.9 * std::pow(bound / std::max(size, 1e-9 * bound), 1.0 / 8.0));
  }
  unpack(y);
  return state_of(time, q, v);
}

}  // namespace boxbeam::planar
