#include "boxbeam/mechanism/flexible/modes.hpp"

#include <fmt/format.h>

#include <Spectra/SymGEigsShiftSolver.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "element_mass.hpp"
#include "exact_modes.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// So many coordinates, or elasticities, or fewer: all modes, by dense matrices, where a few of
/// them are not found by themselves.
constexpr Index few = 150;
/// So many or fewer: by these from the first, for nothing is faster.
constexpr Index very_few = 24;
/// Few of the modes: one in so many elasticities, and coordinates.
constexpr Index one_in = 6;
/// theta = |shift|/(omega^2 + |shift|) of a mode, over the largest, below which it is round-off.
constexpr double no_mode = 1e-10;
/// The same where no elasticity is left, so that all of them are.
constexpr double least_mode = 1e-12;
/// omega^2 over |shift|, below which a motion is without strain.
constexpr double no_strain = 1e-8;
/// Largest residual |q - (omega^2 - shift) (K - shift M)^-1 M q| of a mode, by its mass.
constexpr double accepted = 1e-6;
/// Part of omega^2, and of the shift, by which the count of frequencies looks beyond the last mode:
/// far enough for a matrix that is clearly regular.
constexpr double beyond = 1e-5;
/// So many directions more than modes are begun with: theta falls with the fourth power of the
/// number of a beam's mode, so that a few steps find the first ones.
constexpr Index least_space = 8;
/// Runs that look for modes of a repeated frequency, each finds at least one.
constexpr int most_runs = 100;

[[noreturn]] void fail(const std::string& what) {
  throw AnalysisError({fmt::format("the natural frequencies were not found: {}", what), ""});
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

  Problem(const Structure& of, double shift)
      : structure(of), below(shift), coordinates(of), stiffness(of, -below, 0.0) {}

  VectorXd mass_times(const VectorXd& q) const {
    VectorXd product(q.size());
    mass_times(q.data(), product.data());
    return product;
  }

  void mass_times(const double* q, double* product) const {
    if (structure.mechanism->element == Element::exact) {
      coordinates.write(flexible::mass_times(structure, coordinates.columns(q)), product);
      return;
    }
    for (const DividedLink& link : structure.links) {
      for (const RigidElement& of : link.elements) {
        Eigen::Map<Eigen::Vector3d> result(product);
        result = flexible::mass_times(of, Eigen::Map<const Eigen::Vector3d>(q));
        q += 3;
        product += 3;
      }
    }
  }
};

/// A load without pattern, always the same for the same number.
VectorXd random_load(Index size, unsigned number) {
  const auto parts_of = [](Index count, unsigned seed) {
    std::mt19937 random(seed);
    VectorXd load(count);
    for (double& part : load) part = static_cast<double>(random()) / 4294967296.0 - 0.5;
    return load;
  };
  // Every posture of a motion asks for the first one.
  constexpr Index kept = 512;
  static const VectorXd first = parts_of(kept, 1U);
  return number == 1U && size <= kept ? VectorXd(first.head(size)) : parts_of(size, number);
}

/// The shift near the lowest frequency that strains. Masses that nothing moves (a flywheel on a
/// driven shaft) make the first guess too low, by however many powers of ten: one inverse iteration
/// tells how far, omega^2 + |shift| = q^T M q/(q^T M (K - shift M)^-1 M q).
Problem problem_of(const Structure& structure) {
  constexpr double near = 1e-3;
  constexpr int most_guesses = 8;
  double below = low_square_of(structure);
  for (int guess = 1;; ++guess) {
    Problem problem(structure, below);
    const Coordinates& coordinates = problem.coordinates;
    const auto moved_by = [&](const VectorXd& load) {
      return coordinates.vector(problem.stiffness.solve(coordinates.columns(load.data())).motion);
    };
    const VectorXd q = moved_by(random_load(coordinates.size(), 1U));
    const VectorXd M_q = problem.mass_times(q);
    const double theta = below * M_q.dot(moved_by(M_q)) / q.dot(M_q);
    if (!(theta > 0.0 && theta < near) || guess == most_guesses) return problem;
    below /= theta;
  }
}

/// What Spectra asks of M.
class Mass {
 public:
  using Scalar = double;
  explicit Mass(const Problem& problem) : problem_(&problem) {}
  Index rows() const { return problem_->coordinates.size(); }
  Index cols() const { return rows(); }
  void perform_op(const double* q, double* product) const { problem_->mass_times(q, product); }

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

/// Flexibility and mass of all motions that loads can cause, in a basis of these.
struct SmallProblem {
  MatrixXd basis, flexibility, mass;
};

MatrixXd symmetric(const MatrixXd& of) { return 0.5 * (of + of.transpose()); }

MatrixXd mass_times(const Problem& problem, const MatrixXd& q) {
  MatrixXd product(q.rows(), q.cols());
  for (Index i = 0; i < q.cols(); ++i) product.col(i) = problem.mass_times(q.col(i));
  return product;
}

/// What loads do, without dimension.
MatrixXd moved_by(const Problem& problem, const MatrixXd& loads) {
  const MatrixXd none(loads.rows(), 0);
  const VectorXd nothing(0);
  const Inverse inverse(problem, none, nothing);
  MatrixXd motions(loads.rows(), loads.cols());
  for (Index i = 0; i < loads.cols(); ++i) {
    inverse.perform_op(loads.col(i).data(), motions.col(i).data());
  }
  if (!motions.allFinite()) fail("stiffnesses and masses are too far apart");
  return motions;
}

/// In the coordinates themselves.
SmallProblem whole_problem(const Problem& problem) {
  const Index size = problem.coordinates.size();
  const MatrixXd identity = MatrixXd::Identity(size, size);
  return {identity, symmetric(moved_by(problem, identity)),
          symmetric(mass_times(problem, identity))};
}

/// Of many rigid bodies on few springs the motions that loads can cause are few, however many
/// coordinates there are: one load after the other, without pattern, until they bring nothing new.
/// Nothing where more than `most` do.
std::optional<SmallProblem> few_motions(const Problem& problem, Index most) {
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
Found all_modes(const SmallProblem& of) {
  const Index size = of.flexibility.rows();
  Found none{MatrixXd(of.basis.rows(), 0), VectorXd(0)};
  if (size == 0) return none;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> root(of.flexibility);
  const MatrixXd R =
      root.eigenvectors() * root.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> first(symmetric(R.transpose() * of.mass * R));
  const VectorXd& theta = first.eigenvalues();
  if (root.info() != Eigen::Success || first.info() != Eigen::Success || !theta.allFinite())
    fail("stiffnesses and masses are too far apart");
  const double floor = std::max(no_mode * theta[size - 1], least_mode);
  const Index modes = (theta.array() > floor).count();
  if (modes == 0) return none;
  const MatrixXd q = R * first.eigenvectors().rightCols(modes) *
                     theta.tail(modes).cwiseSqrt().cwiseInverse().asDiagonal();
  const MatrixXd M_q = of.mass * q;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> second(
      symmetric(M_q.transpose() * of.flexibility * M_q), symmetric(q.transpose() * M_q));
  if (second.info() != Eigen::Success) fail("stiffnesses and masses are too far apart");
  return {of.basis * q * second.eigenvectors().rowwise().reverse(), second.eigenvalues().reverse()};
}

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

/// Adds the `more` lowest modes beyond those found, of a repeated frequency perhaps only one. False
/// where the search does not come to an end in so large a space.
bool add_lanczos_modes(const Problem& problem, Index more, Index space, double work, Found& found) {
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
  if (!std::isfinite(moved_mass)) fail("stiffnesses and masses are too far apart");
  if (!(moved_mass > 0.0)) fail("there are fewer than are asked for: no mass moves any more");
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
    fail("there are fewer than are asked for");  // and where nothing is left to begin with
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
/// `patient`: however long it takes; else it gives up where all modes by dense matrices are sooner.
Found lowest_modes(const Problem& problem, Index count, bool patient = true) {
  const double work = patient ? 2e9 : 2e5;
  const int runs = patient ? most_runs : 3;
  Found found{MatrixXd(problem.coordinates.size(), 0), VectorXd(0)};
  Index missing = count;
  const Index size = problem.coordinates.size();
  for (int run = 0; run < runs; ++run) {
    Index space = std::min(size, std::max(2 * missing, missing + least_space) + 1);
    while (!add_lanczos_modes(problem, missing, space, work, found)) {
      if (!patient) fail("they do not converge at once");
      if (space == size || space > 16 * (missing + 8)) fail("they do not converge; ask for fewer");
      space = std::min(size, 2 * space + 3);
    }
    if (!(found.theta[count - 1] > 0.0)) fail("there are fewer than are asked for");
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

Found found_modes(const Problem& problem, Index asked) {
  const Index size = problem.coordinates.size();
  if (size <= few || one_in * asked > size) return all_modes(whole_problem(problem));
  if (elasticities_of(problem.structure) <= few) {
    if (const auto small = few_motions(problem, 2 * few)) return all_modes(*small);
  }
  return lowest_modes(problem, asked);
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

std::vector<Mode> finished(const Problem& problem, const Found& found, Index asked) {
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

double low_square_of(const Structure& structure) {
  const Mechanism& mechanism = *structure.mechanism;
  double mass = 0.0;
  double inertia = 0.0;
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
    for (const RigidElement& element : structure.links[k].elements) {
      mass += element.mass;
      inertia += element.inertia;
    }
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
  // A flywheel turns on the springs more slowly than any mass moves.
  const double slowness = mass * flexibility + inertia * turning;
  if (!std::isfinite(slowness)) fail("masses or flexibilities are beyond all numbers");
  return slowness > 0.0 ? 1.0 / slowness : 1.0;
}

std::vector<Mode> modes_of(const Structure& structure, std::size_t count) {
  if (count == 0 || structure.elements() == 0) return {};
  if (is_continuous(structure)) return exact_modes_of(structure, count);
  const Problem problem = problem_of(structure);
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
