#include "boxbeam/mechanism/flexible/modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "modal_problem.hpp"
#include "mode_searches.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Flexibility and mass of all motions that loads can cause, in a basis of these.
struct SmallProblem {
  Eigen::MatrixXd basis, flexibility, mass;
};

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

/// In the coordinates themselves.
SmallProblem whole_problem(const ModalProblem& problem) {
  const Index size = problem.coordinates.size();
  const MatrixXd identity = MatrixXd::Identity(size, size);
  return {identity, symmetric(moved_by(problem, identity)),
          symmetric(mass_times(problem, identity))};
}

/// Of many rigid bodies on few springs the motions that loads can cause are few, however many
/// coordinates there are: one load after the other, without pattern, until they bring nothing new.
/// Nothing where more than `most` do.
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

/// All modes, by the flexibility R R^T of the structure: R^T M R z = theta z, q = R z. R squares
/// the round-off of high modes, what it takes from low ones: made good by Rayleigh and Ritz.
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

/// So many coordinates, or elasticities, or fewer: all modes, by dense matrices, where a few of
/// them are not found by themselves.
constexpr Index few = 150;
/// So many or fewer: by these from the first, for nothing is faster.
constexpr Index very_few = 24;
/// Few of the modes: one in so many elasticities, and coordinates.
constexpr Index one_in = 6;
/// omega^2 over |shift|, below which a motion is without strain.
constexpr double no_strain = 1e-8;
/// Largest residual |q - (omega^2 - shift) (K - shift M)^-1 M q| of a mode, by its mass.
constexpr double accepted = 1e-6;

/// At most so many modes bend anything: one for each elasticity.
Index elasticities_of(const Structure& structure) {
  Index count = 0;
  for (const DividedLink& link : structure.links) {
    for (const SpringElement& spring : link.springs) {
      count += (spring.axial > 0.0 ? 1 : 0) + (spring.bending.isZero(0.0) ? 0 : 2);
    }
  }
  for (const Joint& joint : structure.mechanism->joints) {
    count += std::count_if(joint.stiffness.begin(), joint.stiffness.end(),
                           [](double k) { return k > 0.0 && std::isfinite(k); });
  }
  return count;
}

FoundModes found_modes(const ModalProblem& problem, Index asked) {
  const Index size = problem.coordinates.size();
  if (size <= few || one_in * asked > size) return all_modes(whole_problem(problem));
  if (elasticities_of(problem.structure) <= few) {
    if (const auto small = few_motions(problem, 2 * few)) return all_modes(*small);
  }
  return lowest_modes(problem, asked);
}

/// One more step of inverse iteration, that gives the joint forces and takes out motions without
/// mass; Rayleigh's quotient for the frequency.
Mode finished(const ModalProblem& problem, const VectorXd& q) {
  const MotionVector& coordinates = problem.coordinates;
  const VectorXd M_q = problem.mass_times(q);
  const double mass = q.dot(M_q);
  Mode mode;
  mode.shape = problem.stiffness.solve(coordinates.columns(M_q.data()));
  const VectorXd next = coordinates.vector(mode.shape.motion);
  const double shifted = mass / next.dot(M_q);  // omega^2 - shift
  const VectorXd error = shifted * next - q;
  const double residual = std::sqrt(std::abs(error.dot(problem.mass_times(error))) / mass);
  if (!(residual < accepted)) {
    throw AnalysisError(
        {"a natural frequency was not found as exactly as it must be; ask for fewer",
         "",
         {},
         residual});
  }
  const double square = shifted - problem.below;
  if (square > no_strain * problem.below) {
    mode.frequency = std::sqrt(square) / full_turn;
  } else {
    mode.shape.joints.setZero();
  }
  Index largest = 0;
  next.cwiseAbs().maxCoeff(&largest);
  const double factor =
      std::copysign(1.0 / std::sqrt(std::abs(next.dot(problem.mass_times(next)))), next[largest]);
  for (auto& link : mode.shape.motion) link *= factor;
  mode.shape.joints *= factor;
  return mode;
}

std::vector<Mode> finished(const ModalProblem& problem, const FoundModes& found, Index asked) {
  std::vector<Mode> modes;
  const Index wanted = std::min(asked, found.theta.size());
  for (Index i = 0; i < wanted; ++i) modes.push_back(finished(problem, found.q.col(i)));
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  return modes;
}

/// Whether links vibrate by themselves, in as many modes as one likes.
bool is_continuous(const Structure& structure) {
  const Mechanism& mechanism = *structure.mechanism;
  return mechanism.element == Element::exact &&
         std::any_of(mechanism.links.begin(), mechanism.links.end(), [](const Link& link) {
           return link.kind != LinkKind::rigid && rigid_mass_of(link).mass > 0.0;
         });
}

}  // namespace

std::vector<Mode> modes_of(const Structure& structure, std::size_t count) {
  if (count == 0 || structure.elements() == 0) return {};
  if (is_continuous(structure)) return exact_modes_of(structure, count);
  const ModalProblem problem = modal_problem_of(structure);
  const Index size = problem.coordinates.size();
  const auto asked = static_cast<Index>(count);
  const Index fewer = std::min(size, elasticities_of(structure));
  if (size > very_few && fewer <= few && one_in * asked <= fewer) {
    try {
      return finished(problem, lowest_modes(problem, asked, false), asked);
    } catch (const AnalysisError&) {
      // Stiffnesses or masses far apart, frequencies that repeat: all modes together tell.
    }
  }
  return finished(problem, found_modes(problem, asked), asked);
}

}  // namespace boxbeam::flexible
