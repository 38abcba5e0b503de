#include "lowest_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Motions of no order, the same on every computer.
MatrixXd motions_of_no_order(Index count, const VectorXd& scale) {
  std::minstd_rand numbers;
  MatrixXd motions(scale.size(), count);
  for (double& size : motions.reshaped())
    size = 2.0 * static_cast<double>(numbers()) / std::minstd_rand::max() - 1.0;
  return scale.asDiagonal() * motions;
}

/// Motions of elastic energy one half that work none on each other's, with the forces that move
/// them and those of their inertia.
class IndependentMotions {
 public:
  explicit IndependentMotions(Index size)
      : motions_(size, 0), forces_(size, 0), inertia_(size, 0) {}

  Index count() const { return motions_.cols(); }
  const MatrixXd& motions() const { return motions_; }
  auto inertia_from(Index first) const { return inertia_.rightCols(count() - first); }

  /// What is new in these motions; of each of them the parts that the new ones are, a column each.
  /// What is left of one after Gram and Schmidt, twice, is little: its motion is solved for anew.
  MatrixXd add(const MatrixXd& motions, const MatrixXd& forces, const ModeOperators& of) {
    constexpr double little = 1e-3;
    constexpr int attempts = 4;
    const Index before = count();
    for (MatrixXd* const all : {&motions_, &forces_})
      all->conservativeResize(Eigen::NoChange, before + motions.cols());
    MatrixXd parts = MatrixXd::Zero(motions.cols(), motions.cols());
    Index now = before;
    for (Index j = 0; j < motions.cols() && now < motions_.rows(); ++j) {
      VectorXd motion = motions.col(j), force = forces.col(j);
      double share = 1.0;
      for (int attempt = 0; attempt < attempts; ++attempt) {
        const double whole = std::sqrt(std::max(0.0, motion.dot(force)));
        for (int twice = 0; twice < 2; ++twice) {
          const VectorXd same = forces_.leftCols(now).transpose() * motion;
          motion -= motions_.leftCols(now) * same;
          force -= forces_.leftCols(now) * same;
          parts.col(j).head(now - before) += share * same.tail(now - before);
        }
        const double size = std::sqrt(std::max(0.0, motion.dot(force)));
        if (size > little * whole) {
          parts(now - before, j) = share * size;
          motions_.col(now) = motion / size;
          forces_.col(now) = force / size;
          ++now;
          break;
        }
        const double left = force.norm();
        if (!(left > 0.0)) break;
        share *= left;
        force /= left;
        motion = of.moved_by(force);
      }
    }
    for (MatrixXd* const all : {&motions_, &forces_}) all->conservativeResize(Eigen::NoChange, now);
    return parts.topRows(now - before);
  }

  void add_inertia(const MatrixXd& inertia) {
    inertia_.conservativeResize(Eigen::NoChange, count());
    inertia_.rightCols(inertia.cols()) = inertia;
  }

 private:
  MatrixXd motions_, forces_, inertia_;
};

}  // namespace

LowestModes lowest_modes_of(const ModeOperators& of, Index count, const VectorXd& scale) {
  constexpr Index more = 2;
  constexpr double close = 1e-11, no_mass = 1e-12;
  IndependentMotions basis(scale.size());
  MatrixXd forces = of.inertia_of(motions_of_no_order(count + more, scale)),
           motions = of.moved_by(forces);
  MatrixXd parts = basis.add(motions, forces, of), by_ritz(0, 0);
  Eigen::SelfAdjointEigenSolver<MatrixXd> solver;
  while (true) {
    const Index before = by_ritz.cols(), now = basis.count();
    if (now == before) break;
    basis.add_inertia(of.inertia_of(basis.motions().rightCols(now - before)));
    forces = basis.inertia_from(before);
    motions = of.moved_by(forces);
    by_ritz.conservativeResize(now, now);
    const MatrixXd beside = basis.motions().transpose() * forces;
    by_ritz.rightCols(now - before) = beside;
    by_ritz.bottomRows(now - before) = beside.transpose();
    solver.compute(by_ritz);
    parts = basis.add(motions, forces, of);
    bool found = now >= count;
    for (Index k = now; found && k-- > std::max<Index>(0, now - count);) {
      const double mu = solver.eigenvalues()[k];
      const VectorXd last = solver.eigenvectors().col(k).tail(now - before);
      found = (parts * last).norm() <= close * mu || mu <= no_mass * solver.eigenvalues()[now - 1];
    }
    if (found) break;
  }
  LowestModes modes;
  if (by_ritz.cols() == 0) return modes;
  const Index all = by_ritz.cols();
  Index massive = 0;
  while (massive < std::min(count, all) &&
         solver.eigenvalues()[all - 1 - massive] > no_mass * solver.eigenvalues()[all - 1])
    ++massive;
  modes.mu = solver.eigenvalues().tail(massive).reverse();
  modes.modes =
      basis.motions().leftCols(all) * solver.eigenvectors().rightCols(massive).rowwise().reverse();
  return modes;
}

}  // namespace boxbeam::frame
