#include "boxbeam/mechanism/planar/free_motion.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"

namespace boxbeam::planar {
namespace {

constexpr std::uint32_t diagonal = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t regular = diagonal - 1;  ///< what keeps repeated constraints apart
constexpr double regularisation = 1e-10;
constexpr double near_singular = 1e-3;        ///< a scaled pivot of the equations of motion
constexpr double error_near_singular = 1e-8;  ///< of a step there

}  // namespace

FreeSolver::FreeSolver(const Mechanism& mechanism, double tolerance, bool project)
    : mechanism_(&mechanism),
      tolerance_(tolerance),
      project_(project),
      equations_(mechanism),
      contacts_(friction_contacts_of(mechanism)),
      mass_(mechanism.coordinates()),
      weight_(mechanism.coordinates()),
      phi_(mechanism.equations()),
      gamma_(mechanism.equations()) {
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    mass_.segment<3>(i) << body.mass, body.mass, body.inertia;
    weight_.segment<3>(i) << body.mass * mechanism.gravity, 0.0;
    i += 3;
  }
  const Eigen::Index n = mechanism.coordinates();
  const Eigen::Index m = mechanism.equations();
  metric_ = equations_.col_scale().cwiseAbs2().cwiseInverse();
  // Scaled so that masses and Jacobian are comparable, whatever the units.
  const double largest = mass_.cwiseProduct(equations_.col_scale().cwiseAbs2()).maxCoeff();
  const double root = largest > 0.0 ? std::sqrt(largest) : 1.0;
  scale_.resize(n + m);
  scale_ << equations_.col_scale() / root, equations_.row_scale() * root;

  const SparsePattern& own = equations_.pattern();
  std::vector<std::vector<std::pair<int, std::uint32_t>>> rows(static_cast<std::size_t>(n + m));
  for (Eigen::Index k = 0; k < n; ++k) {
    rows[static_cast<std::size_t>(k)].emplace_back(static_cast<int>(k), diagonal);
  }
  for (Eigen::Index r = 0; r < m; ++r) {
    for (int e = own.row_start[static_cast<std::size_t>(r)];
         e < own.row_start[static_cast<std::size_t>(r) + 1]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      const auto number = static_cast<std::uint32_t>(e);
      rows[static_cast<std::size_t>(own.col[entry])].emplace_back(static_cast<int>(n + r), number);
      rows[static_cast<std::size_t>(n + r)].emplace_back(own.col[entry], number);
    }
    rows[static_cast<std::size_t>(n + r)].emplace_back(static_cast<int>(n + r), regular);
  }
  pattern_.rows = pattern_.cols = n + m;
  for (const auto& row : rows) {
    pattern_.row_start.push_back(static_cast<int>(pattern_.col.size()));
    for (const auto& [col, source] : row) {
      pattern_.col.push_back(col);
      source_.push_back(source);
    }
  }
  pattern_.row_start.push_back(static_cast<int>(pattern_.col.size()));
  values_.resize(pattern_.col.size());
  right_.resize(n + m);
  solution_.resize(n + m);
  correction_.resize(n + m);
}

bool FreeSolver::factor(SparseElimination& elimination, const Eigen::VectorXd& weight) {
  equations_.evaluate(phi_, jacobian_);
  const Eigen::Index n = mechanism_->coordinates();
  const auto fill = [&] {
    Eigen::Index k = 0;
    Eigen::Index r = n;
    for (std::size_t e = 0; e < values_.size(); ++e) {
      if (source_[e] == diagonal) {
        values_[e] = weight[k++];
      } else if (source_[e] == regular) {
        values_[e] = regularised_ ? -regularisation / (scale_[r] * scale_[r]) : 0.0;
        ++r;
      } else {
        values_[e] = jacobian_[source_[e]];
      }
    }
  };
  fill();
  const bool ordered = elimination.pivots() == static_cast<std::size_t>(pattern_.cols);
  if (ordered && elimination.factor(values_)) return true;
  if (elimination.analyse(pattern_, values_, scale_, scale_) == pattern_.cols) {
    return elimination.factor(values_);
  }
  const auto& left = elimination.cols_left();
  const bool only_multipliers =
      std::all_of(left.begin(), left.end(), [&](int col) { return col >= n; });
  if (regularised_ || !only_multipliers) return false;
  regularised_ = true;
  fill();
  return elimination.analyse(pattern_, values_, scale_, scale_) == pattern_.cols &&
         elimination.factor(values_);
}

void FreeSolver::solve(const SparseElimination& elimination) {
  elimination.solve(right_, solution_);
  if (!regularised_) return;
  // Refinement against the system without what made it regular.
  constexpr int refinements = 2;
  for (int i = 0; i < refinements; ++i) {
    left_over_ = right_;
    for (Eigen::Index r = 0; r < pattern_.rows; ++r) {
      for (int e = pattern_.row_start[static_cast<std::size_t>(r)];
           e < pattern_.row_start[static_cast<std::size_t>(r) + 1]; ++e) {
        const auto entry = static_cast<std::size_t>(e);
        if (source_[entry] == regular) continue;
        left_over_[r] -= values_[entry] * solution_[pattern_.col[entry]];
      }
    }
    elimination.solve(left_over_, correction_);
    solution_ += correction_;
  }
}

bool FreeSolver::solve_rates(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                             Eigen::VectorXd& a, Eigen::VectorXd& lambda) {
  const Eigen::Index n = mechanism_->coordinates();
  ++evaluations_;
  equations_.set_time(time);
  equations_.set_position(q);
  if (!factor(dynamics_, mass_)) return false;
  Eigen::VectorXd Q = weight_;
  add_applied_forces(*mechanism_, time, q, v, Q);
  equations_.acceleration_right_side(v, gamma_);
  right_ << Q, gamma_;
  solve(dynamics_);
  a = solution_.head(n);
  lambda = solution_.tail(solution_.size() - n);
  if (contacts_.empty()) return true;
  const auto count = static_cast<Eigen::Index>(contacts_.size());
  Eigen::MatrixXd response(solution_.size(), count);
  Eigen::VectorXd velocity(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts_[static_cast<std::size_t>(j)];
    unit_friction(contact, q, Q);
    right_ << Q, Eigen::VectorXd::Zero(gamma_.size());
    solve(dynamics_);
    response.col(j) = solution_;
    velocity[j] = sliding_velocity_of(contact, q, v);
  }
  const Eigen::VectorXd friction = solve_friction(*mechanism_, contacts_, time, lambda,
                                                  response.bottomRows(lambda.size()), velocity);
  a += response.topRows(n) * friction;
  lambda += response.bottomRows(lambda.size()) * friction;
  return true;
}

bool FreeSolver::project(double time, Eigen::VectorXd& q, Eigen::VectorXd& v) {
  constexpr int most = 8;
  const Eigen::Index n = mechanism_->coordinates();
  equations_.set_time(time);
  for (int i = 0; i < most; ++i) {
    equations_.set_position(q);
    if (!factor(projection_, metric_)) return false;
    const double open = phi_.cwiseProduct(equations_.row_scale()).lpNorm<Eigen::Infinity>();
    if (i > 0 && open < 1e-14) break;
    right_ << Eigen::VectorXd::Zero(n), -phi_;
    solve(projection_);
    q += solution_.head(n);
    if (open < 1e-15) break;
  }
  equations_.set_position(q);
  if (!factor(projection_, metric_)) return false;
  // Joints that repeat each other at the start may contradict each other later.
  constexpr double still_closed = 1e-9;
  if (phi_.size() > 0 &&
      phi_.cwiseProduct(equations_.row_scale()).lpNorm<Eigen::Infinity>() > still_closed) {
    return false;
  }
  equations_.velocity_right_side(gamma_);
  const SparsePattern& own = equations_.pattern();
  for (Eigen::Index r = 0; r < own.rows; ++r) {
    for (int e = own.row_start[static_cast<std::size_t>(r)];
         e < own.row_start[static_cast<std::size_t>(r) + 1]; ++e) {
      gamma_[r] -= jacobian_[static_cast<std::size_t>(e)] * v[own.col[static_cast<std::size_t>(e)]];
    }
  }
  right_ << Eigen::VectorXd::Zero(n), gamma_;
  solve(projection_);
  v += solution_.head(n);
  return true;
}

State FreeSolver::state_of(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  State state;
  state.time = time;
  state.q = q;
  state.v = v;
  if (!solve_rates(time, q, v, state.a, state.lambda)) {
    throw AnalysisError(
        {"accelerations are not determined: a freedom that no driver moves has no "
         "mass (give the body a mass and inertia, or drive it), or the mechanism "
         "stands exactly in a singular position",
         "mechanism",
         time,
         {},
         {}});
  }
  state.residual = phi_.cwiseProduct(equations_.row_scale()).lpNorm<Eigen::Infinity>();
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
  if (!project(time, position, velocity)) {
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
  const Eigen::VectorXd& scale = equations_.col_scale();
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
    solved = solved && solve_rates(t, q, v, a, lambda);
    if (!solved) {
      std::fill(rate.begin(), rate.end(), 0.0);
      return;
    }
    pivot = std::min(pivot, dynamics_.smallest_pivot());
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
      solved = project(t + dt, q, v);
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
