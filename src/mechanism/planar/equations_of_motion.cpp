#include "boxbeam/mechanism/planar/equations_of_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxbeam::planar {
namespace {

constexpr std::uint32_t diagonal = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t regular = diagonal - 1;  ///< what keeps repeated constraints apart
constexpr double regularisation = 1e-10;

}  // namespace

EquationsOfMotion::EquationsOfMotion(const Mechanism& mechanism)
    : mechanism_(&mechanism),
      constraints_(mechanism),
      contacts_(friction_contacts_of(mechanism)),
      mass_(mechanism.coordinates()),
      weight_(mechanism.coordinates()),
      phi_(mechanism.equations()),
      gamma_(mechanism.equations()) {
  sticking_ = std::any_of(contacts_.begin(), contacts_.end(),
                          [](const FrictionContact& of) { return can_stick(of.law); });
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    mass_.segment<3>(i) << body.mass, body.mass, body.inertia;
    weight_.segment<3>(i) << body.mass * mechanism.gravity, 0.0;
    i += 3;
  }
  const Eigen::Index n = mechanism.coordinates();
  const Eigen::Index m = mechanism.equations();
  metric_ = constraints_.col_scale().cwiseAbs2().cwiseInverse();
  // Scaled so that masses and Jacobian are comparable, whatever the units.
  const double largest = mass_.cwiseProduct(constraints_.col_scale().cwiseAbs2()).maxCoeff();
  const double root = largest > 0.0 ? std::sqrt(largest) : 1.0;
  scale_.resize(n + m);
  scale_ << constraints_.col_scale() / root, constraints_.row_scale() * root;

  const SparsePattern& own = constraints_.pattern();
  std::vector<std::vector<std::pair<int, std::uint32_t>>> rows(static_cast<std::size_t>(n + m));
  for (Eigen::Index k = 0; k < n; ++k) {
    rows[static_cast<std::size_t>(k)].emplace_back(static_cast<int>(k), diagonal);
  }
  for (Eigen::Index r = 0; r < m; ++r) {
    own.in_row(r, [&](std::size_t entry, int column) {
      const auto number = static_cast<std::uint32_t>(entry);
      rows[static_cast<std::size_t>(column)].emplace_back(static_cast<int>(n + r), number);
      rows[static_cast<std::size_t>(n + r)].emplace_back(column, number);
    });
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

bool EquationsOfMotion::factor(SparseElimination& elimination, const Eigen::VectorXd& weight) {
  constraints_.evaluate(phi_, jacobian_);
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

void EquationsOfMotion::solve(const SparseElimination& elimination) {
  elimination.solve(right_, solution_);
  if (!regularised_) return;
  // Refinement against the system without what made it regular.
  constexpr int refinements = 2;
  for (int i = 0; i < refinements; ++i) {
    left_over_ = right_;
    for (Eigen::Index r = 0; r < pattern_.rows; ++r) {
      pattern_.in_row(r, [&](std::size_t entry, int column) {
        if (source_[entry] != regular) left_over_[r] -= values_[entry] * solution_[column];
      });
    }
    elimination.solve(left_over_, correction_);
    solution_ += correction_;
  }
}

void EquationsOfMotion::evaluate_at(double time, const Eigen::VectorXd& q) {
  constraints_.set_time(time);
  constraints_.set_position(q);
  constraints_.evaluate(phi_);
}

bool EquationsOfMotion::stand_at(double time, const Eigen::VectorXd& q) {
  ++evaluations_;
  time_ = time;
  constraints_.set_time(time);
  constraints_.set_position(q);
  return factor(dynamics_, mass_);
}

void EquationsOfMotion::solve(const Eigen::VectorXd& f, const Eigen::VectorXd& g,
                              Eigen::VectorXd& x, Eigen::VectorXd& y) {
  right_ << f, g;
  solve(dynamics_);
  x = solution_.head(f.size());
  y = solution_.tail(g.size());
}

Eigen::VectorXd EquationsOfMotion::imbalance(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                             const Eigen::VectorXd& a,
                                             const Eigen::VectorXd& lambda) const {
  Eigen::VectorXd Q = weight_;
  add_applied_forces(*mechanism_, time_, q, v, Q);
  Eigen::VectorXd open = mass_.cwiseProduct(a) - Q;
  const SparsePattern& own = constraints_.pattern();
  for (Eigen::Index r = 0; r < own.rows; ++r) {
    own.in_row(
        r, [&](std::size_t entry, int column) { open[column] += jacobian_[entry] * lambda[r]; });
  }
  return open;
}

void EquationsOfMotion::velocity_defect(const Eigen::VectorXd& v, Eigen::VectorXd& defect) const {
  constraints_.velocity_right_side(defect);
  const SparsePattern& own = constraints_.pattern();
  for (Eigen::Index r = 0; r < own.rows; ++r) {
    own.in_row(r,
               [&](std::size_t entry, int column) { defect[r] -= jacobian_[entry] * v[column]; });
  }
}

double EquationsOfMotion::residual() const {
  return phi_.size() > 0 ? phi_.cwiseProduct(constraints_.row_scale()).lpNorm<Eigen::Infinity>()
                         : 0.0;
}

bool EquationsOfMotion::solve_rates(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                    Eigen::VectorXd& a, Eigen::VectorXd& lambda) {
  State state;
  state.time = time;
  state.q = q;
  state.v = v;
  if (!solve_rates(state)) return false;
  a = std::move(state.a);
  lambda = std::move(state.lambda);
  return true;
}

bool EquationsOfMotion::solve_rates(State& state) {
  const Eigen::Index n = mechanism_->coordinates();
  FrictionResponse response;
  if (!friction_response(state, response)) return false;
  // What acts without friction.
  state.a = solution_.head(n);
  state.lambda = solution_.tail(solution_.size() - n);
  if (contacts_.empty()) return true;
  state.friction = solve_friction(*mechanism_, contacts_, state.time, state.slips, response);
  state.a += by_unit_.topRows(n) * state.friction;
  state.lambda += by_unit_.bottomRows(state.lambda.size()) * state.friction;
  return true;
}

bool EquationsOfMotion::friction_response(const State& state, FrictionResponse& response) {
  const Eigen::Index n = mechanism_->coordinates();
  if (!stand_at(state.time, state.q)) return false;
  const auto count = static_cast<Eigen::Index>(contacts_.size());
  const Eigen::Index m = solution_.size() - n;
  Eigen::VectorXd Q = weight_;
  by_unit_.resize(solution_.size(), count);
  for (Eigen::Index j = 0; j < count; ++j) {
    unit_friction(contacts_[static_cast<std::size_t>(j)], state.q, Q);
    right_ << Q, Eigen::VectorXd::Zero(m);
    solve(dynamics_);
    by_unit_.col(j) = solution_;
  }
  Q = weight_;
  add_applied_forces(*mechanism_, state.time, state.q, state.v, Q, state.touches);
  constraints_.acceleration_right_side(state.v, gamma_);
  right_ << Q, gamma_;
  solve(dynamics_);
  if (contacts_.empty()) return true;
  response =
      friction_response_of(contacts_, state.q, state.v, solution_.tail(m), by_unit_.bottomRows(m));
  if (!sticking_) return true;
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts_[static_cast<std::size_t>(j)];
    response.rate_0[j] = sliding_acceleration_of(contact, state.q, state.v, solution_.head(n));
    for (Eigen::Index k = 0; k < count; ++k)
      response.rate(j, k) = sliding_velocity_of(contact, state.q, by_unit_.col(k).head(n));
  }
  return true;
}

Eigen::VectorXd EquationsOfMotion::velocities_by(const Eigen::VectorXd& impulses) const {
  return by_unit_.topRows(mechanism_->coordinates()) * impulses;
}

bool EquationsOfMotion::project(double time, Eigen::VectorXd& q, Eigen::VectorXd& v) {
  constexpr int most = 8;
  const Eigen::Index n = mechanism_->coordinates();
  constraints_.set_time(time);
  for (int i = 0; i < most; ++i) {
    constraints_.set_position(q);
    if (!factor(projection_, metric_)) return false;
    const double open = residual();
    if (i > 0 && open < 1e-14) break;
    right_ << Eigen::VectorXd::Zero(n), -phi_;
    solve(projection_);
    q += solution_.head(n);
    if (open < 1e-15) break;
  }
  constraints_.set_position(q);
  if (!factor(projection_, metric_)) return false;
  // Joints that repeat each other at the start may contradict each other later.
  constexpr double still_closed = 1e-9;
  if (residual() > still_closed) {
    return false;
  }
  velocity_defect(v, gamma_);
  right_ << Eigen::VectorXd::Zero(n), gamma_;
  solve(projection_);
  v += solution_.head(n);
  return true;
}

}  // namespace boxbeam::planar
