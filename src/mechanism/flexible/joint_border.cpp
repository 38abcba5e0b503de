// The border of a structure's dynamic stiffness: the elements that stay and the forces of joints.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam::flexible {
namespace {

/// Smallest pivot of the scaled border over the largest, below which it is singular.
constexpr double no_pivot = 1e-14;

/// Of a symmetric matrix that is nearly singular, where pivots lose a digit that turns do not:
/// those of a tridiagonal one, which are as many as its negative pivots. Source: Givens (1954);
/// Parlett, The Symmetric Eigenvalue Problem, 3.3 and 7.3.
std::size_t negative_eigenvalues_of(const Eigen::MatrixXd& matrix) {
  const Eigen::Tridiagonalization<Eigen::MatrixXd> tridiagonal(matrix);
  const Eigen::VectorXd diagonal = tridiagonal.diagonal(), beside = tridiagonal.subDiagonal();
  const double least = std::numeric_limits<double>::min();
  std::size_t negative = 0;
  double pivot = diagonal[0];
  for (Eigen::Index i = 0;;) {
    if (pivot < 0.0) ++negative;
    // Zero is taken for the least there is, as if the matrix were moved by that.
    if (std::abs(pivot) < least) pivot = least;
    if (++i == diagonal.size()) return negative;
    pivot = diagonal[i] - beside[i - 1] / pivot * beside[i - 1];
  }
}

}  // namespace

template <class Scalar>
void DynamicStiffness<Scalar>::factor_border() {
  const std::size_t links = structure_->links.size();
  const auto fixed = static_cast<Eigen::Index>(3 * links);
  const auto size = fixed + static_cast<Eigen::Index>(rows_.size());
  border_ = Matrix::Zero(size, size);
  for (std::size_t k = 0; k < links; ++k) {
    const auto at = static_cast<Eigen::Index>(3 * k);
    border_.template block<3, 3>(at, at) = stiffness_[k];
  }
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const Eigen::Index row = fixed + static_cast<Eigen::Index>(j);
    border_(row, row) -= rows_[j].flexibility;
  }
  Eigen::Matrix<Scalar, 3, Eigen::Dynamic> unit, motion;
  for (const Port& port : ports_) {
    const Eigen::Index row = fixed + static_cast<Eigen::Index>(port.row);
    const auto at = static_cast<Eigen::Index>(3 * port.link);
    Vector3 effect = port.h.template cast<Scalar>();
    if (port.element != retained_[port.link]) {
      const auto elements = static_cast<Eigen::Index>(structure_->links[port.link].elements.size());
      unit = Eigen::Matrix<Scalar, 3, Eigen::Dynamic>::Zero(3, elements);
      unit.col(static_cast<Eigen::Index>(port.element)) = port.h.template cast<Scalar>();
      const Gathered gathered = gather(port.link, unit);
      effect = gathered.at_retained;
      spread(port.link, gathered, Vector3::Zero(), motion);
      for (const Port& other : ports_) {
        if (other.link != port.link || other.element == retained_[port.link]) continue;
        const Eigen::Index to = fixed + static_cast<Eigen::Index>(other.row);
        const Vector3 there = motion.col(static_cast<Eigen::Index>(other.element));
        border_(to, row) -=
            other.sign * port.sign * (other.h.transpose().template cast<Scalar>() * there).value();
      }
    }
    border_.template block<3, 1>(at, row) -= port.sign * effect;
    border_.template block<1, 3>(row, at) -= port.sign * effect.transpose();
  }
  // Equilibrated: lengths, angles and forces become comparable, whatever the stiffnesses.
  // Begun at the joints' own stiffnesses, so that those of stiff joints side by side count.
  scale_ = Eigen::VectorXd::Ones(size);
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const double flexibility = std::abs(rows_[j].flexibility);
    if (flexibility > 0.0) {
      scale_[fixed + static_cast<Eigen::Index>(j)] = 1.0 / std::sqrt(flexibility);
    }
  }
  const Eigen::MatrixXd rows = border_.cwiseAbs().transpose();
  bool even = false;
  for (int pass = 0; pass < 8 && !even; ++pass) {
    even = true;
    for (Eigen::Index i = 0; i < size; ++i) {
      const double largest = scale_[i] * rows.col(i).cwiseProduct(scale_).maxCoeff();
      if (!(largest > 0.0)) continue;
      scale_[i] /= std::sqrt(largest);
      even = even && 0.25 < largest && largest < 4.0;
    }
  }
  border_ = scale_.asDiagonal() * border_ * scale_.asDiagonal();
  // Full pivoting costs ten times as much and decides only where pivots are small.
  constexpr double clearly_regular = 1e-12;
  factor_.compute(border_);
  fully_pivoted_ = size > 0 && !(factor_.condition() > clearly_regular);
  if (!fully_pivoted_) return;
  lu_.compute(border_);
  const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
  if (size > 0 && !(pivots.minCoeff() > no_pivot * pivots.maxCoeff())) fail_singular();
}

template <class Scalar>
void DynamicStiffness<Scalar>::fail_singular() const {
  const std::vector<Link>& links = structure_->mechanism->links;
  const auto fixed = static_cast<Eigen::Index>(3 * links.size());
  Eigen::FullPivLU<Matrix> lu = lu_;
  lu.setThreshold(no_pivot);
  const Matrix kernel = lu.kernel();
  // Forces in balance among themselves, without any motion: rigid joints that hold the same twice.
  const auto part = [&](Eigen::Index from, Eigen::Index count) {
    return count > 0 ? kernel.middleRows(from, count).cwiseAbs().maxCoeff() : 0.0;
  };
  if (part(0, fixed) < 1e-8 * part(fixed, kernel.rows() - fixed)) {
    std::vector<std::string> joints;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      const std::string& name = structure_->mechanism->joints[rows_[j].joint].name;
      if (part(fixed + static_cast<Eigen::Index>(j), 1) < 1e-6) continue;
      if (joints.empty() || joints.back() != name) joints.push_back(name);
    }
    throw AnalysisError(
        {fmt::format("rigid joints hold the same motion more than once, so that their forces are "
                     "not determined: {}; give one of them a stiffness there",
                     fmt::join(joints, ", ")),
         joints.empty() ? "" : joints.front()});
  }
  if (square_ != 0.0) {
    const double frequency = std::sqrt(std::abs(square_)) / full_turn;
    throw AnalysisError(
        {fmt::format("the structure is in resonance at {:.6g} Hz and has no damping: its amplitude "
                     "grows without limit; take another frequency or give damping to links or "
                     "joints",
                     frequency),
         ""});
  }
  // The motion that nothing resists.
  std::vector<std::string> names;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(3 * k);
    const double largest = (scale_.asDiagonal() * kernel)
                               .topRows(static_cast<Eigen::Index>(3 * links.size()))
                               .cwiseAbs()
                               .maxCoeff();
    const double own =
        (scale_.segment<3>(at).asDiagonal() * kernel.middleRows(at, 3)).cwiseAbs().maxCoeff();
    if (own > 1e-6 * largest) names.push_back(links[k].name);
  }
  throw AnalysisError(
      {fmt::format(
           "the links can move without strain ({} free): {}; hold them by a joint, a spring "
           "or a drive",
           kernel.cols() == 1 ? "one motion is" : fmt::format("{} motions are", kernel.cols()),
           fmt::join(names, ", ")),
       names.empty() ? "" : names.front()});
}

template <class Scalar>
std::size_t DynamicStiffness<Scalar>::frequencies_below() const {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (border_.rows() == 0) return 0;
    // Every force of a joint brings a negative one of its own, but one that pushes its ends apart
    // across its line.
    const auto holding = std::count_if(rows_.begin(), rows_.end(),
                                       [](const Row& row) { return row.flexibility >= 0.0; });
    constexpr double clear = 1e-8;
    const std::size_t negative =
        factor_.condition() > clear ? factor_.negative() : negative_eigenvalues_of(border_);
    return gathered_below_ + negative - static_cast<std::size_t>(holding);
  } else {
    assert(false);
    return 0;
  }
}

template void DynamicStiffness<double>::factor_border();
template void DynamicStiffness<Complex>::factor_border();
template void DynamicStiffness<double>::fail_singular() const;
template void DynamicStiffness<Complex>::fail_singular() const;
template std::size_t DynamicStiffness<double>::frequencies_below() const;
template std::size_t DynamicStiffness<Complex>::frequencies_below() const;

}  // namespace boxbeam::flexible
