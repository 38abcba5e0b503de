#include "mode_searches.hpp"

#include <fmt/format.h>

#include <Spectra/SymGEigsShiftSolver.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "boxbeam/core/error.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Part of omega^2, and of the shift, by which the count of frequencies looks beyond the last mode:
/// far enough for a matrix that is clearly regular.
constexpr double beyond = 1e-5;
/// So many directions more than modes are begun with: theta falls with the fourth power of the
/// number of a beam's mode, so that a few steps find the first ones.
constexpr Index least_space = 8;
/// Runs that look for modes of a repeated frequency, each finds at least one.
constexpr int most_runs = 100;

/// What Spectra asks of M.
class Mass {
 public:
  using Scalar = double;
  explicit Mass(const ModalProblem& problem) : problem_(&problem) {}
  Index rows() const { return problem_->coordinates.size(); }
  Index cols() const { return rows(); }
  void perform_op(const double* q, double* product) const { problem_->mass_times(q, product); }

 private:
  const ModalProblem* problem_;
};

/// What Spectra asks of (K - shift M)^-1, made free of dimension, without the modes known.
class Inverse {
 public:
  using Scalar = double;
  Inverse(const ModalProblem& problem, const MatrixXd& known, const VectorXd& theta)
      : problem_(&problem), known_(&known), theta_(&theta) {}
  Index rows() const { return problem_->coordinates.size(); }
  Index cols() const { return rows(); }
  void set_shift(double) {}  // NOLINT(readability-convert-member-functions-to-static)
  void perform_op(const double* loads, double* motion) const {
    problem_->move(loads, motion);
    Eigen::Map<VectorXd> result(motion, rows());
    result *= problem_->below;
    if (known_->cols() == 0) return;
    const Eigen::Map<const VectorXd> f(loads, rows());
    result -= *known_ * theta_->cwiseProduct(known_->transpose() * f);
  }

 private:
  const ModalProblem* problem_;
  const MatrixXd* known_;  ///< with mass one
  const VectorXd* theta_;
};

/// Adds the `more` lowest modes beyond those found, of a repeated frequency perhaps only one. False
/// where the search does not come to an end in so large a space.
bool add_lanczos_modes(const ModalProblem& problem, Index more, Index space, double work,
                       FoundModes& found) {
  const Index size = problem.coordinates.size();
  Inverse inverse(problem, found.q, found.theta);
  Mass mass(problem);
  Spectra::SymGEigsShiftSolver<Inverse, Mass, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, mass, more, space, 0.0);
  // A start among the motions that loads can cause.
  const VectorXd loads = random_load(size, static_cast<unsigned>(found.q.cols()) + 1U);
  VectorXd start(size);
  inverse.perform_op(loads.data(), start.data());
  const double moved_mass = start.dot(problem.mass_times(start));
  if (!std::isfinite(moved_mass)) fail_modes(too_far_apart);
  if (!(moved_mass > 0.0)) fail_modes("there are fewer than are asked for: no mass moves any more");
  // A restart takes the eigenvectors of a matrix as large as the space.
  const double cube = std::pow(static_cast<double>(space), 3);
  const auto restarts = static_cast<Index>(std::clamp(work / cube, 10.0, 1000.0));
  try {
    solver.init(start.data());
    solver.compute(Spectra::SortRule::LargestAlge, restarts, 1e-12,
                   Spectra::SortRule::SmallestAlge);
  } catch (const std::runtime_error&) {
    return false;  // Spectra throws where the small eigenproblem of a space does not converge
  } catch (const std::invalid_argument&) {
    fail_modes("there are fewer than are asked for");  // and where nothing is left to begin with
  }
  if (solver.info() != Spectra::CompInfo::Successful) return false;
  FoundModes all{MatrixXd(size, found.q.cols() + more), VectorXd(found.q.cols() + more)};
  all.q << found.q, solver.eigenvectors();
  all.theta << found.theta, solver.eigenvalues().cwiseInverse();  // solver: 1/theta
  std::vector<Index> order(static_cast<std::size_t>(all.theta.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return all.theta[a] > all.theta[b]; });
  found = {all.q(Eigen::all, order), all.theta(order)};
  return true;
}

double square_of(const ModalProblem& problem, double theta) {
  return problem.below * (1.0 / theta - 1.0);
}

/// How many natural frequencies lie below a limit, as omega^2.
struct Count {
  double limit = 0.0;
  Index below = 0;
};

/// The count just beyond a mode; farther beyond where that is too near a resonance to tell.
Count count_beyond(const ModalProblem& problem, double square) {
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

}  // namespace

FoundModes lowest_modes(const ModalProblem& problem, Index count, bool patient) {
  const double work = patient ? 2e9 : 2e5;
  const int runs = patient ? most_runs : 3;
  FoundModes found{MatrixXd(problem.coordinates.size(), 0), VectorXd(0)};
  Index missing = count;
  const Index size = problem.coordinates.size();
  for (int run = 0; run < runs; ++run) {
    Index space = std::min(size, std::max(2 * missing, missing + least_space) + 1);
    while (!add_lanczos_modes(problem, missing, space, work, found)) {
      if (!patient) fail_modes("they do not converge at once");
      if (space == size || space > 16 * (missing + 8))
        fail_modes("they do not converge; ask for fewer");
      space = std::min(size, 2 * space + 3);
    }
    if (!(found.theta[count - 1] > 0.0)) fail_modes("there are fewer than are asked for");
    const double last = std::max(0.0, square_of(problem, found.theta[count - 1]));
    const auto [limit, there] = count_beyond(problem, last);
    Index here = 0;
    while (here < found.theta.size() && square_of(problem, found.theta[here]) < limit) ++here;
    if (here == there) return found;
    if (here > there) fail_modes(fmt::format("{} where there are {}", here, there));
    missing = there - here;
  }
  fail_modes("too many agree; ask for fewer");
}

}  // namespace boxbeam::flexible
