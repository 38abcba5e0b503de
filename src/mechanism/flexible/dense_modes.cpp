#include "dense_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace boxbeam::flexible {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// theta = |shift|/(omega^2 + |shift|) of a mode, over the largest, below which it is round-off.
constexpr double no_mode = 1e-10;
/// The same where no elasticity is left, so that all of them are.
constexpr double least_mode = 1e-12;

MatrixXd symmetric(const MatrixXd& of) { return 0.5 * (of + of.transpose()); }

MatrixXd mass_times(const ModalProblem& problem, const MatrixXd& q) {
  MatrixXd product(q.rows(), q.cols());
  for (Index i = 0; i < q.cols(); ++i) product.col(i) = problem.mass_times(q.col(i));
  return product;
}

/// What loads do, without dimension.
MatrixXd moved_by(const ModalProblem& problem, const MatrixXd& loads) {
  MatrixXd motions(loads.rows(), loads.cols());
  for (Index i = 0; i < loads.cols(); ++i) problem.move(loads.col(i).data(), motions.col(i).data());
  motions *= problem.below;
  if (!motions.allFinite()) fail_modes(too_far_apart);
  return motions;
}

}  // namespace

SmallProblem whole_problem(const ModalProblem& problem) {
  const Index size = problem.coordinates.size();
  const MatrixXd identity = MatrixXd::Identity(size, size);
  return {identity, symmetric(moved_by(problem, identity)),
          symmetric(mass_times(problem, identity))};
}

std::optional<SmallProblem> few_motions(const ModalProblem& problem, Index most) {
  constexpr double new_part = 1e-13;  // of a motion beyond those known
  constexpr int nothing_new = 3;      // loads in a row
  const Index size = problem.coordinates.size();
  MatrixXd basis(size, 0);
  unsigned number = 0;
  for (int idle = 0; idle < nothing_new;) {
    VectorXd motion = moved_by(problem, random_load(size, ++number)).col(0);
    const double before = motion.norm();
    for (int again = 0; again < 2; ++again) {
      motion -= basis * (basis.transpose() * motion).eval();
    }
    if (!(motion.norm() > new_part * before)) {
      ++idle;
      continue;
    }
    if (basis.cols() == most) return std::nullopt;
    idle = 0;
    basis.conservativeResize(size, basis.cols() + 1);
    basis.rightCols<1>() = motion.normalized();
  }
  return SmallProblem{basis, symmetric(basis.transpose() * moved_by(problem, basis)),
                      symmetric(basis.transpose() * mass_times(problem, basis))};
}

FoundModes all_modes(const SmallProblem& of) {
  const Index size = of.flexibility.rows();
  FoundModes none{MatrixXd(of.basis.rows(), 0), VectorXd(0)};
  if (size == 0) return none;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> root(of.flexibility);
  const MatrixXd R =
      root.eigenvectors() * root.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> first(symmetric(R.transpose() * of.mass * R));
  const VectorXd& theta = first.eigenvalues();
  if (root.info() != Eigen::Success || first.info() != Eigen::Success || !theta.allFinite())
    fail_modes(too_far_apart);
  const double floor = std::max(no_mode * theta[size - 1], least_mode);
  const Index modes = (theta.array() > floor).count();
  if (modes == 0) return none;
  const MatrixXd q = R * first.eigenvectors().rightCols(modes) *
                     theta.tail(modes).cwiseSqrt().cwiseInverse().asDiagonal();
  const MatrixXd M_q = of.mass * q;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> second(
      symmetric(M_q.transpose() * of.flexibility * M_q), symmetric(q.transpose() * M_q));
  if (second.info() != Eigen::Success) fail_modes(too_far_apart);
  return {of.basis * q * second.eigenvectors().rowwise().reverse(), second.eigenvalues().reverse()};
}

}  // namespace boxbeam::flexible
