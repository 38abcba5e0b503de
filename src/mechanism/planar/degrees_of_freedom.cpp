#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

/// The Jacobian with lengths scaled.
Eigen::MatrixXd scaled_jacobian(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  ConstraintEquations equations(mechanism);
  Eigen::VectorXd phi(equations.rows());
  std::vector<double> values;
  equations.set_time(0.0);  // drivers move the right side only
  equations.set_position(q);
  equations.evaluate(phi, values);
  return equations.row_scale().asDiagonal() * equations.pattern().dense(values) *
         equations.col_scale().asDiagonal();
}

struct Rank {
  Eigen::Index rank = 0;
  double gap = std::numeric_limits<double>::infinity();
};

Rank rank_of(const Eigen::VectorXd& values) {
  constexpr double widest_needed = 1e6;
  constexpr double bound = 1e-10;
  Rank result;
  if (values.size() == 0 || values[0] == 0.0) return result;
  // A gap inside what is surely regular is none; what is surely round-off needs no gap.
  constexpr double surely = 1e-5;
  constexpr double never = 1e-13;
  double widest = 0.0;
  Eigen::Index at = values.size();
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double relative = values[i] / values[0];
    if (relative > surely) continue;
    const double before = i > 0 ? values[i - 1] / values[0] : 1.0;
    const double ratio = before / std::max(relative, 1e-18);
    if (ratio > widest) {
      widest = ratio;
      at = i;
    }
    if (relative < never) break;
  }
  if (widest < widest_needed) {
    at = 0;
    while (at < values.size() && values[at] > bound * values[0]) ++at;
  }
  result.rank = at;
  if (at > 0 && at < values.size()) {
    result.gap = values[at - 1] / std::max(values[at], 1e-18 * values[0]);
  }
  return result;
}

}  // namespace

double DegreesOfFreedom::digits_left() const { return digits_left_at(condition); }

double digits_left_at(double condition) {
  if (!(condition > 0.0)) return 0.0;
  const double lost = std::numeric_limits<double>::epsilon() * condition * condition;
  return std::max(0.0, -std::log10(lost));
}

DegreesOfFreedom degrees_of_freedom_of(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  constexpr double none = 1e-7;  // a part of a unit vector that is round-off
  const Eigen::MatrixXd jacobian = scaled_jacobian(mechanism, q);
  std::vector<Eigen::Index> of_joints;
  std::vector<int> owner;
  DegreesOfFreedom result;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const bool driver = is_driver(mechanism.joints[i]);
    result.drivers += driver ? 1 : 0;
    for (int k = 0; k < equations_of(mechanism.joints[i]); ++k) {
      if (!driver) of_joints.push_back(static_cast<Eigen::Index>(owner.size()));
      owner.push_back(static_cast<int>(i));
    }
  }
  const auto coordinates = static_cast<int>(mechanism.coordinates());
  result.gruebler = coordinates - static_cast<int>(of_joints.size());
  const Eigen::MatrixXd joints_only = jacobian(of_joints, Eigen::all);
  result.by_rank = coordinates;
  if (!of_joints.empty())
    result.by_rank -= static_cast<int>(
        rank_of(Eigen::JacobiSVD<Eigen::MatrixXd>(joints_only).singularValues()).rank);

  if (owner.empty()) {  // bodies that nothing holds
    result.undriven = coordinates;
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      result.moving.push_back(static_cast<int>(i));
    }
    return result;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  const Rank rank = rank_of(values);
  result.gap = rank.gap;
  result.redundant = static_cast<int>(jacobian.rows() - rank.rank);
  result.undriven = static_cast<int>(jacobian.cols() - rank.rank);
  if (result.undriven == 0) result.condition = values[0] / values[rank.rank - 1];

  // Redundancies: rows whose combination gives nothing.
  const auto combinations = svd.matrixU().rightCols(jacobian.rows() - rank.rank);
  result.unique.assign(owner.size(), 1);
  for (std::size_t row = 0; row < owner.size(); ++row) {
    if (combinations.row(static_cast<Eigen::Index>(row)).norm() < none) continue;
    result.unique[row] = 0;
    if (result.repeating.empty() || result.repeating.back() != owner[row]) {
      result.repeating.push_back(owner[row]);
    }
  }
  const auto motions = svd.matrixV().rightCols(jacobian.cols() - rank.rank);
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    const auto rows = motions.middleRows(3 * static_cast<Eigen::Index>(body), 3);
    if (rows.norm() > none) result.moving.push_back(static_cast<int>(body));
  }
  return result;
}

bool is_unique(const Mechanism& mechanism, const DegreesOfFreedom& freedom, int joint) {
  std::size_t row = 0;
  for (int i = 0; i < joint; ++i) {
    row += static_cast<std::size_t>(equations_of(mechanism.joints[static_cast<std::size_t>(i)]));
  }
  const auto count =
      static_cast<std::size_t>(equations_of(mechanism.joints[static_cast<std::size_t>(joint)]));
  return std::all_of(freedom.unique.begin() + static_cast<std::ptrdiff_t>(row),
                     freedom.unique.begin() + static_cast<std::ptrdiff_t>(row + count),
                     [](char unique) { return unique != 0; });
}

double condition_of(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  if (mechanism.equations() == 0) return 0.0;
  const Eigen::VectorXd values =
      Eigen::JacobiSVD<Eigen::MatrixXd>(scaled_jacobian(mechanism, q)).singularValues();
  const Eigen::Index rank = rank_of(values).rank;
  return rank == mechanism.coordinates() ? values[0] / values[rank - 1] : 0.0;
}

}  // namespace boxbeam::planar
