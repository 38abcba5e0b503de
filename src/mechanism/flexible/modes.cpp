#include "boxbeam/mechanism/flexible/modes.hpp"

#include <fmt/format.h>

#include <Spectra/SymGEigsShiftSolver.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "boxbeam/core/error.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// So many coordinates or fewer: all modes, by dense matrices.
constexpr Index few = 150;
/// theta = |shift|/(omega^2 + |shift|) of a mode, over the largest, below which it is round-off.
constexpr double no_mode = 1e-10;
/// The same where no elasticity is left, so that all of them are.
constexpr double least_mode = 1e-12;
/// omega^2 over |shift|, below which a motion is without strain.
constexpr double no_strain = 1e-8;
/// Largest residual |q - (omega^2 - shift) (K - shift M)^-1 M q| of a mode, by its mass.
constexpr double accepted = 1e-6;
/// Part of omega^2, and of the shift, by which the count of frequencies looks beyond the last mode.
constexpr double beyond = 1e-6;
/// Runs that look for modes of a repeated frequency, each finds at least one.
constexpr int most_runs = 100;

/// A square of a circular frequency for the shift: with the sign turned it lies below all natural
/// frequencies, and near the lowest that strains: 1/(mass x flexibility), all springs in a row.
double shift_of(const Structure& structure) {
  const Mechanism& mechanism = *structure.mechanism;
  double mass = 0.0;
  double flexibility = 0.0;
  double turning = 0.0;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector2d high = -low;
  const auto reach = [&](const Eigen::Vector2d& place) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  };
  for (std::size_t k = 0; k < structure.links.size(); ++k) {
    const Link& link = mechanism.links[k];
    reach(link.origin);
    reach(link.origin + link.length * Eigen::Vector2d(std::cos(link.angle), std::sin(link.angle)));
    for (const RigidElement& element : structure.links[k].elements) mass += element.mass;
    for (const SpringElement& spring : structure.links[k].springs) {
      flexibility += spring.axial + spring.bending(0, 0);
      turning += spring.bending(1, 1);
    }
  }
  for (const Joint& joint : mechanism.joints) {
    reach(in_world(mechanism, joint.a));
    for (const std::size_t axis : {0U, 1U, 2U}) {
      if (joint.stiffness[axis] > 0.0) {
        (axis < 2 ? flexibility : turning) += 1.0 / joint.stiffness[axis];
      }
    }
  }
  flexibility += turning * (high - low).squaredNorm();
  return mass > 0.0 && flexibility > 0.0 ? 1.0 / (mass * flexibility) : 1.0;
}

/// Motions of all rigid elements as one vector.
class Coordinates {
 public:
  explicit Coordinates(const Structure& structure)
      : zero_(no_loads<double>(structure)), size_(3 * static_cast<Index>(structure.elements())) {}

  Index size() const { return size_; }

  LinkColumns<double> columns(const double* vector) const {
    LinkColumns<double> result = zero_;
    for (auto& link : result) {
      link = Eigen::Map<const Eigen::Matrix3Xd>(vector, 3, link.cols());
      vector += link.size();
    }
    return result;
  }

  void write(const LinkColumns<double>& columns, double* vector) const {
    for (const auto& link : columns) vector = std::copy_n(link.data(), link.size(), vector);
  }

  VectorXd vector(const LinkColumns<double>& columns) const {
    VectorXd result(size_);
    write(columns, result.data());
    return result;
  }

 private:
  LinkColumns<double> zero_;
  Index size_;
};

/// The problem (K - shift M)^-1 M q = q/(omega^2 - shift), shift = -`below`.
struct Problem {
  const Structure& structure;
  double below;
  Coordinates coordinates;
  DynamicStiffness<double> stiffness;

  explicit Problem(const Structure& of)
      : structure(of), below(shift_of(of)), coordinates(of), stiffness(of, -below, 0.0) {}

  VectorXd mass_times(const VectorXd& q) const {
    return coordinates.vector(flexible::mass_times(structure, coordinates.columns(q.data())));
  }
};

/// What Spectra asks of M.
class Mass {
 public:
  using Scalar = double;
  explicit Mass(const Problem& problem) : problem_(&problem) {}
  Index rows() const { return problem_->coordinates.size(); }
  Index cols() const { return rows(); }
  void perform_op(const double* q, double* product) const {
    problem_->coordinates.write(mass_times(problem_->structure, problem_->coordinates.columns(q)),
                                product);
  }

 private:
  const Problem* problem_;
};

/// What Spectra asks of (K - shift M)^-1, made free of dimension, without the modes known.
class Inverse {
 public:
  using Scalar = double;
  Inverse(const Problem& problem, const MatrixXd& known, const VectorXd& theta)
      : problem_(&problem), known_(&known), theta_(&theta) {}
  Index rows() const { return problem_->coordinates.size(); }
  Index cols() const { return rows(); }
  void set_shift(double) {}  // NOLINT(readability-convert-member-functions-to-static)
  void perform_op(const double* loads, double* motion) const {
    const Coordinates& coordinates = problem_->coordinates;
    coordinates.write(problem_->stiffness.solve(coordinates.columns(loads)).motion, motion);
    Eigen::Map<VectorXd> result(motion, rows());
    result *= problem_->below;
    if (known_->cols() == 0) return;
    const Eigen::Map<const VectorXd> f(loads, rows());
    result -= *known_ * theta_->cwiseProduct(known_->transpose() * f);
  }

 private:
  const Problem* problem_;
  const MatrixXd* known_;  ///< with mass one
  const VectorXd* theta_;
};

/// Modes with mass one and theta = |shift|/(omega^2 + |shift|), descending: frequencies ascend.
struct Found {
  MatrixXd q;
  VectorXd theta;
};

[[noreturn]] void fail(const std::string& what) {
  throw AnalysisError(
      {fmt::format("the natural frequencies were not found: {}", what), "", {}, {}, {}});
}

/// All modes, by the flexibility R R^T of the structure: R^T M R z = theta z, q = R z. R squares
/// the round-off of high modes, what it takes from low ones: made good by Rayleigh and Ritz.
Found dense_modes(const Problem& problem) {
  const Index size = problem.coordinates.size();
  const MatrixXd none(size, 0);
  const VectorXd nothing(0);
  const Inverse inverse(problem, none, nothing);
  MatrixXd flexibility(size, size);
  for (Index i = 0; i < size; ++i) {
    const VectorXd unit = VectorXd::Unit(size, i);
    inverse.perform_op(unit.data(), flexibility.col(i).data());
  }
  const Mass mass(problem);
  const auto mass_times = [&](const MatrixXd& q) {
    MatrixXd product(q.rows(), q.cols());
    for (Index i = 0; i < q.cols(); ++i) mass.perform_op(q.col(i).data(), product.col(i).data());
    return product;
  };
  const auto symmetric = [](const MatrixXd& of) -> MatrixXd { return 0.5 * (of + of.transpose()); };
  const Eigen::SelfAdjointEigenSolver<MatrixXd> root(symmetric(flexibility));
  const MatrixXd R =
      root.eigenvectors() * root.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> first(symmetric(R.transpose() * mass_times(R)));
  const VectorXd& theta = first.eigenvalues();
  const double floor = std::max(no_mode * theta[size - 1], least_mode);
  const Index modes = (theta.array() > floor).count();
  if (modes == 0) return {MatrixXd(size, 0), VectorXd(0)};
  const MatrixXd q = R * first.eigenvectors().rightCols(modes) *
                     theta.tail(modes).cwiseSqrt().cwiseInverse().asDiagonal();
  const MatrixXd M_q = mass_times(q);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> second(
      symmetric(M_q.transpose() * flexibility * M_q), symmetric(q.transpose() * M_q));
  return {q * second.eigenvectors().rowwise().reverse(), second.eigenvalues().reverse()};
}

/// Adds the `more` lowest modes beyond those found, of a repeated frequency perhaps only one. False
/// where the search does not come to an end in so large a space.
bool add_lanczos_modes(const Problem& problem, Index more, Index space, Found& found) {
  const Index size = problem.coordinates.size();
  Inverse inverse(problem, found.q, found.theta);
  Mass mass(problem);
  Spectra::SymGEigsShiftSolver<Inverse, Mass, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, mass, more, space, 0.0);
  // A start among the motions that loads can cause.
  std::mt19937 random(static_cast<unsigned>(found.q.cols()) + 1U);
  VectorXd loads(size);
  for (double& load : loads) load = static_cast<double>(random()) / 4294967296.0 - 0.5;
  VectorXd start(size);
  inverse.perform_op(loads.data(), start.data());
  try {
    solver.init(start.data());
    solver.compute(Spectra::SortRule::LargestAlge, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
  } catch (const std::runtime_error&) {
    return false;  // Spectra throws where the small eigenproblem of a space does not converge
  }
  if (solver.info() != Spectra::CompInfo::Successful) return false;
  Found all{MatrixXd(size, found.q.cols() + more), VectorXd(found.q.cols() + more)};
  all.q << found.q, solver.eigenvectors();
  all.theta << found.theta, solver.eigenvalues().cwiseInverse();  // solver: 1/theta
  std::vector<Index> order(static_cast<std::size_t>(all.theta.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return all.theta[a] > all.theta[b]; });
  found = {all.q(Eigen::all, order), all.theta(order)};
  return true;
}

double square_of(const Problem& problem, double theta) {
  return problem.below * (1.0 / theta - 1.0);
}

/// How many natural frequencies lie below a limit, as omega^2.
struct Count {
  double limit = 0.0;
  Index below = 0;
};

/// The count just beyond a mode; farther beyond where that is too near a resonance to tell.
Count count_beyond(const Problem& problem, double square) {
  constexpr double farthest = 1e-3;
  for (double part = beyond;; part *= 10.0) {
    const double limit = square + part * (square + problem.below);
    try {
      const DynamicStiffness<double> stiffness(problem.structure, limit, 0.0);
      return {limit, static_cast<Index>(stiffness.frequencies_below())};
    } catch (const AnalysisError&) {
      if (part >= farthest) throw;
    }
  }
}

/// The lowest modes; none is left out below the last: the frequencies below it are counted.
Found lowest_modes(const Problem& problem, Index count) {
  Found found{MatrixXd(problem.coordinates.size(), 0), VectorXd(0)};
  Index missing = count;
  const Index size = problem.coordinates.size();
  for (int run = 0; run < most_runs; ++run) {
    Index space = std::min(size, std::max<Index>(2 * missing + 1, 20));
    while (!add_lanczos_modes(problem, missing, space, found)) {
      if (space == size || space > 64 * (missing + 8)) fail("they do not converge; ask for fewer");
      space = std::min(size, 2 * space + 3);
    }
    const double last = std::max(0.0, square_of(problem, found.theta[count - 1]));
    const auto [limit, there] = count_beyond(problem, last);
    Index here = 0;
    while (here < found.theta.size() && square_of(problem, found.theta[here]) < limit) ++here;
    if (here == there) return found;
    if (here > there) fail(fmt::format("{} where there are {}", here, there));
    missing = there - here;
  }
  fail("too many agree; ask for fewer");
}

/// One more step of inverse iteration, that gives the joint forces and takes out motions without
/// mass; Rayleigh's quotient for the frequency.
Mode finished(const Problem& problem, const VectorXd& q) {
  const Coordinates& coordinates = problem.coordinates;
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
         residual,
         {}});
  }
  const double square = shifted - problem.below;
  if (square > no_strain * problem.below) {
    mode.frequency = std::sqrt(square) / (2.0 * std::numbers::pi);
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

}  // namespace

std::vector<Mode> modes_of(const Structure& structure, std::size_t count) {
  if (count == 0 || structure.elements() == 0) return {};
  const Problem problem(structure);
  const Index size = problem.coordinates.size();
  const bool dense = size <= few || static_cast<Index>(count) > size / 6;
  const Found found =
      dense ? dense_modes(problem) : lowest_modes(problem, static_cast<Index>(count));
  std::vector<Mode> modes;
  const Index wanted = std::min(static_cast<Index>(count), found.theta.size());
  for (Index i = 0; i < wanted; ++i) modes.push_back(finished(problem, found.q.col(i)));
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  return modes;
}

}  // namespace boxbeam::flexible
