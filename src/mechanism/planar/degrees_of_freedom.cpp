#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/numerics/singular_values.hpp"

namespace boxbeam::planar {
namespace {

/// Of the largest: above it a singular value surely counts, as no gap of `widest_needed` is below
/// it.
constexpr double surely = 1e-6;

/// The Jacobian with lengths scaled.
Eigen::SparseMatrix<double> scaled_jacobian(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  ConstraintEquations equations(mechanism);
  Eigen::VectorXd phi(equations.rows());
  std::vector<double> values;
  equations.set_time(0.0);  // drivers move the right side only
  equations.set_position(q);
  equations.evaluate(phi, values);
  return equations.pattern().scaled(values, equations.row_scale(), equations.col_scale());
}

/// How many of a matrix's columns depend on the others, told by its smallest singular values.
struct Dependent {
  Eigen::Index count = 0;
  double gap = std::numeric_limits<double>::infinity();
  double condition = 0.0;   ///< of what is left
  Eigen::MatrixXd vectors;  ///< combinations of columns that give nothing
};

Dependent dependent_columns(const Eigen::SparseMatrix<double>& matrix) {
  constexpr double widest_needed = 1e6;
  constexpr double bound = 1e-10;
  Dependent result;
  const SingularValues of = smallest_singular_values(matrix, surely);
  if (of.largest == 0.0) {
    result.count = matrix.cols();
    result.vectors.setIdentity(matrix.cols(), matrix.cols());
    return result;
  }
  // A gap inside what is surely regular is none; what is surely round-off needs no gap.
  constexpr double never = 1e-13;
  const Eigen::VectorXd values = of.smallest / of.largest;
  double widest = 0.0;
  Eigen::Index at = values.size();
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] > surely) continue;
    const double before = i > 0 ? values[i - 1] : 1.0;
    const double ratio = before / std::max(values[i], 1e-18);
    if (ratio > widest) {
      widest = ratio;
      at = i;
    }
    if (values[i] < never) break;
  }
  if (widest < widest_needed) {
    at = 0;
    while (at < values.size() && values[at] > bound) ++at;
  }
  result.count = values.size() - at;
  if (at > 0) {
    result.condition = 1.0 / values[at - 1];
    if (at < values.size()) result.gap = values[at - 1] / std::max(values[at], 1e-18);
  }
  result.vectors = of.vectors.rightCols(result.count);
  return result;
}

/// Rows of a matrix.
Eigen::SparseMatrix<double> rows_of(const Eigen::SparseMatrix<double>& matrix,
                                    const std::vector<char>& wanted) {
  std::vector<Eigen::Index> row(wanted.size());
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    row[i] = count;
    count += wanted[i] != 0 ? 1 : 0;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index c = 0; c < matrix.outerSize(); ++c) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, c); it; ++it) {
      const auto from = static_cast<std::size_t>(it.row());
      if (wanted[from] != 0) entries.emplace_back(row[from], c, it.value());
    }
  }
  Eigen::SparseMatrix<double> result(count, matrix.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

void judge_uniqueness(const Mechanism& mechanism, const Eigen::VectorXd& q,
                      DegreesOfFreedom& freedom) {
  if (freedom.redundant == 0) return;
  const DegreesOfFreedom here = degrees_of_freedom_of(mechanism, q);
  // A position that is singular itself says nothing of the others.
  if (here.redundant != freedom.redundant) return;
  for (std::size_t row = 0; row < here.unique.size(); ++row) {
    if (here.unique[row] == 0) freedom.unique[row] = 0;
  }
  std::vector<int> both;
  std::set_union(here.repeating.begin(), here.repeating.end(), freedom.repeating.begin(),
                 freedom.repeating.end(), std::back_inserter(both));
  freedom.repeating = both;
}

double digits_left_at(double condition) {
  if (!(condition > 0.0)) return 0.0;
  const double lost = std::numeric_limits<double>::epsilon() * condition * condition;
  return std::max(0.0, -std::log10(lost));
}

DegreesOfFreedom degrees_of_freedom_of(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  constexpr double none = 1e-7;  // a part of a unit vector that is round-off
  std::vector<char> of_joints;
  std::vector<int> owner;
  DegreesOfFreedom result;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const bool driver = is_driver(mechanism.joints[i]);
    result.drivers += driver ? 1 : 0;
    const auto count = static_cast<std::size_t>(equations_of(mechanism.joints[i]));
    of_joints.insert(of_joints.end(), count, driver ? 0 : 1);
    owner.insert(owner.end(), count, static_cast<int>(i));
  }
  const auto coordinates = static_cast<int>(mechanism.coordinates());
  const auto joint_equations = static_cast<int>(std::count(of_joints.begin(), of_joints.end(), 1));
  result.gruebler = coordinates - joint_equations;
  if (owner.empty()) {  // bodies that nothing holds
    result.by_rank = coordinates;
    result.undriven = coordinates;
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      result.moving.push_back(static_cast<int>(i));
    }
    return result;
  }
  const Eigen::SparseMatrix<double> jacobian = scaled_jacobian(mechanism, q);
  result.by_rank = joint_equations == 0
                       ? coordinates
                       : static_cast<int>(dependent_columns(rows_of(jacobian, of_joints)).count);
  const Dependent motions = dependent_columns(jacobian);
  const Eigen::Index rank = jacobian.cols() - motions.count;
  result.undriven = static_cast<int>(motions.count);
  result.redundant = static_cast<int>(jacobian.rows() - rank);
  if (result.undriven == 0) result.condition = motions.condition;

  // Redundancies: rows whose combination gives nothing.
  result.unique.assign(owner.size(), 1);
  if (result.redundant > 0) {
    const Dependent rows = dependent_columns(jacobian.transpose());
    for (std::size_t row = 0; row < owner.size(); ++row) {
      if (rows.vectors.row(static_cast<Eigen::Index>(row)).norm() < none) continue;
      result.unique[row] = 0;
      if (result.repeating.empty() || result.repeating.back() != owner[row]) {
        result.repeating.push_back(owner[row]);
      }
    }
  }
  // Of more rows than columns, or fewer, a part is zero by its number alone: no gap says so.
  result.gap =
      jacobian.rows() < jacobian.cols() ? dependent_columns(jacobian.transpose()).gap : motions.gap;
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    const auto rows = motions.vectors.middleRows(3 * static_cast<Eigen::Index>(body), 3);
    if (rows.norm() > none) result.moving.push_back(static_cast<int>(body));
  }
  return result;
}

bool is_unique(const DegreesOfFreedom& freedom, int joint) {
  return !std::binary_search(freedom.repeating.begin(), freedom.repeating.end(), joint);
}

double condition_of(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  if (mechanism.equations() == 0) return 0.0;
  const Dependent dependent = dependent_columns(scaled_jacobian(mechanism, q));
  return dependent.count == 0 ? dependent.condition : 0.0;
}

}  // namespace boxbeam::planar
