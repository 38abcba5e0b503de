#include "charts/integrators.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "boxbeam/mechanism/planar/free_motion.hpp"

namespace boxbeam::charts {
namespace {

using planar::EquationsOfMotion;
using Vector = std::vector<double>;
using Rates = std::function<void(const Vector&, Vector&, double)>;

constexpr const char* singular = "singular";
constexpr const char* blown_up = "diverges";
constexpr const char* no_convergence = "Newton does not converge";

/// Positions and velocities in one vector, lengths by the size of the mechanism.
struct Packing {
  Eigen::VectorXd scale;

  Eigen::Index n() const { return scale.size(); }
  Vector pack(const Moving& moving) const {
    Vector y(static_cast<std::size_t>(2 * n()));
    Eigen::Map<Eigen::VectorXd>(y.data(), n()) = moving.q.cwiseQuotient(scale);
    Eigen::Map<Eigen::VectorXd>(y.data() + n(), n()) = moving.v.cwiseQuotient(scale);
    return y;
  }
  void unpack(const Vector& y, Moving& moving) const {
    moving.q = Eigen::Map<const Eigen::VectorXd>(y.data(), n()).cwiseProduct(scale);
    moving.v = Eigen::Map<const Eigen::VectorXd>(y.data() + n(), n()).cwiseProduct(scale);
  }
};

Packing packing_of(const EquationsOfMotion& equations) {
  return {equations.constraints().col_scale()};
}

/// Rates of the packed vector; a failure is noted.
Rates rates_by(EquationsOfMotion& equations, const Packing& packing, Moving& moving) {
  return [&](const Vector& y, Vector& rate, double t) {
    packing.unpack(y, moving);
    if (moving.failure.empty() &&
        !equations.solve_rates(t, moving.q, moving.v, moving.a, moving.lambda)) {
      moving.failure = singular;
    }
    const Eigen::Index n = packing.n();
    Eigen::Map<Eigen::VectorXd>(rate.data(), n) = moving.v.cwiseQuotient(packing.scale);
    Eigen::Map<Eigen::VectorXd>(rate.data() + n, n) = moving.a.cwiseQuotient(packing.scale);
  };
}

/// What the state at the end of a step still lacks; the accelerations at the end of all steps.
void settle(EquationsOfMotion& equations, Moving& moving, Constraints constraints) {
  if (!moving.failure.empty()) return;
  if (!(moving.q.allFinite() && moving.v.allFinite())) {
    moving.failure = blown_up;
  } else if (constraints == Constraints::projected &&
             !equations.project(moving.time, moving.q, moving.v)) {
    moving.failure = "not to be projected";
  }
}

void finish(EquationsOfMotion& equations, Moving& moving) {
  if (moving.failure.empty() &&
      !equations.solve_rates(moving.time, moving.q, moving.v, moving.a, moving.lambda)) {
    moving.failure = singular;
  }
}

}  // namespace

Moving moving_of(const planar::State& state) {
  return {state.time, state.q, state.v, state.a, state.lambda, {}, ""};
}

Moving start_of(const planar::Mechanism& mechanism) {
  return moving_of(planar::FreeSolver(mechanism).start(0.0, planar::sketch_of(mechanism),
                                                       planar::start_velocity_of(mechanism)));
}

void runge_kutta_4(EquationsOfMotion& equations, Moving& moving, double until, int steps,
                   Constraints constraints) {
  const Packing packing = packing_of(equations);
  const double begin = moving.time;
  const double h = (until - begin) / steps;
  boost::numeric::odeint::runge_kutta4<Vector> stepper;
  Vector y = packing.pack(moving);
  const Rates rates = rates_by(equations, packing, moving);
  for (int i = 0; i < steps && moving.failure.empty(); ++i) {
    stepper.do_step(rates, y, begin + i * h, h);
    packing.unpack(y, moving);
    moving.time = i + 1 < steps ? begin + (i + 1) * h : until;
    settle(equations, moving, constraints);
    y = packing.pack(moving);
  }
  finish(equations, moving);
}

void dormand_prince(EquationsOfMotion& equations, Moving& moving, double until, double tolerance,
                    Constraints constraints) {
  const Packing packing = packing_of(equations);
  const double smallest = 1e-13 * std::max(std::abs(until), std::abs(moving.time));
  boost::numeric::odeint::runge_kutta_dopri5<Vector> stepper;
  Vector y = packing.pack(moving);
  Vector next(y.size()), error(y.size());
  const Rates rates = rates_by(equations, packing, moving);
  double h = until - moving.time;
  while (until - moving.time > smallest) {
    h = std::min(h, until - moving.time);
    stepper.reset();
    stepper.do_step(rates, y, moving.time, next, h, error);
    double size = 0.0;  // of the error, in tolerances
    for (std::size_t i = 0; i < y.size(); ++i) {
      size = std::max(size, std::abs(error[i]) / (tolerance * (1.0 + std::abs(y[i]))));
    }
    const bool solved = moving.failure.empty() && std::isfinite(size);
    if (!solved || size > 1.0) {
      // Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I (1993), II.4.
      h *= solved ? std::max(0.2, 0.9 * std::pow(size, -0.2)) : 0.25;
      if (h <= smallest) {
        moving.failure = "the step vanishes";
        return;
      }
      moving.failure.clear();
      continue;
    }
    moving.time += h;
    packing.unpack(next, moving);
    settle(equations, moving, constraints);
    if (!moving.failure.empty()) return;
    y = packing.pack(moving);
    h *= std::min(5.0, 0.9 * std::pow(std::max(size, 1e-9), -0.2));
  }
  packing.unpack(y, moving);
  moving.time = until;
  finish(equations, moving);
}

GeneralisedAlpha damped_by(double spectral_radius) {
  GeneralisedAlpha of;
  of.alpha_m = (2.0 * spectral_radius - 1.0) / (spectral_radius + 1.0);
  of.alpha_f = spectral_radius / (spectral_radius + 1.0);
  of.gamma = 0.5 + of.alpha_f - of.alpha_m;
  of.beta = 0.25 * (of.gamma + 0.5) * (of.gamma + 0.5);
  return of;
}

void generalised_alpha(EquationsOfMotion& equations, const planar::Mechanism& mechanism,
                       Moving& moving, double until, int steps,
                       const GeneralisedAlpha& parameters) {
  constexpr int most = 30;
  const auto& [alpha_m, alpha_f, beta, gamma] = parameters;
  const double begin = moving.time;
  const double h = (until - begin) / steps;
  // Of the true acceleration per change of the position.
  const double stiff = (1.0 - alpha_m) / (h * h * beta * (1.0 - alpha_f));
  const Eigen::VectorXd& scale = equations.constraints().col_scale();
  if (moving.algorithmic.size() == 0) moving.algorithmic = moving.a;
  Eigen::VectorXd change(mechanism.coordinates()), push(mechanism.equations());
  for (int i = 0; i < steps; ++i) {
    const Eigen::VectorXd known = moving.algorithmic;
    Eigen::VectorXd& now = moving.algorithmic;
    const Eigen::VectorXd a_known = moving.a;
    now = (alpha_f * a_known - alpha_m * known) / (1.0 - alpha_m);
    moving.q += h * moving.v + h * h * ((0.5 - beta) * known + beta * now);
    moving.v += h * ((1.0 - gamma) * known + gamma * now);
    moving.a.setZero();
    moving.time = i + 1 < steps ? begin + (i + 1) * h : until;
    double before = 0.0;
    for (int k = 0;; ++k) {
      if (!equations.stand_at(moving.time, moving.q)) {
        moving.failure = singular;
        return;
      }
      const Eigen::VectorXd open =
          equations.imbalance(moving.q, moving.v, moving.a, moving.lambda) / stiff;
      equations.solve(-open, -equations.phi(), change, push);
      moving.q += change;
      moving.v += gamma / (h * beta) * change;
      moving.a += stiff * change;
      now += (1.0 - alpha_f) / (1.0 - alpha_m) * stiff * change;
      moving.lambda += stiff * push;
      const double size = change.cwiseQuotient(scale).lpNorm<Eigen::Infinity>();
      // At round-off it shrinks no more.
      if (size < 1e-15 || (k > 1 && size < 1e-12 && size > 0.3 * before)) break;
      before = size;
      if (!std::isfinite(size) || k == most) {
        moving.failure = std::isfinite(size) ? no_convergence : blown_up;
        return;
      }
    }
  }
}

void central_differences(EquationsOfMotion& equations, const planar::Mechanism& mechanism,
                         Moving& moving, double until, int steps) {
  constexpr int most = 30;
  const double begin = moving.time;
  const double h = (until - begin) / steps;
  planar::ConstraintEquations constraints(mechanism);
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(mechanism.coordinates());
  Eigen::VectorXd phi(mechanism.equations()), defect(phi), push(phi);
  Eigen::VectorXd change(mechanism.coordinates());
  if (!equations.stand_at(begin, moving.q)) {
    moving.failure = singular;
    return;
  }
  for (int i = 0; i < steps; ++i) {
    // The matrix stands at the beginning of the step: constraint forces act along their directions
    // there.
    const Eigen::VectorXd known = moving.q;
    moving.q += h * moving.v + 0.5 * h * h * moving.a;
    moving.time = i + 1 < steps ? begin + (i + 1) * h : until;
    constraints.set_time(moving.time);
    for (int k = 0;; ++k) {
      constraints.set_position(moving.q);
      constraints.evaluate(phi);
      const double open = phi.cwiseProduct(constraints.row_scale()).lpNorm<Eigen::Infinity>();
      if (open < 1e-15 || (k > 3 && open < 1e-14)) break;
      if (!std::isfinite(open) || k == most) {
        moving.failure = std::isfinite(open) ? no_convergence : blown_up;
        return;
      }
      equations.solve(nothing, -phi, change, push);
      moving.q += change;
    }
    const Eigen::VectorXd half = (moving.q - known) / h;
    const Eigen::VectorXd predicted = half + 0.5 * h * moving.a;
    if (!equations.solve_rates(moving.time, moving.q, predicted, moving.a, moving.lambda)) {
      moving.failure = singular;
      return;
    }
    moving.v = half + 0.5 * h * moving.a;
    equations.velocity_defect(moving.v, defect);
    equations.solve(nothing, defect, change, push);
    moving.v += change;
  }
  finish(equations, moving);
}

}  // namespace boxbeam::charts
