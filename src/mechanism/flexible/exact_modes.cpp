#include "mode_searches.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "modal_problem.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A motion is without strain below this part of the lowest square that can strain.
constexpr double strainless = 1e-8;
/// Squares of one bracket over each other, within which frequencies are refined together.
constexpr double near = 1.05;
/// And within which they are refined as if they agreed: nearer to a frequency a count may be wrong.
constexpr double agreeing = 1e-5;
/// How far from the squares sought inverse iteration ends, relative: what is left of the third
/// order is round-off; nearer, a part that is in resonance by itself loses more digits.
constexpr double off = 2e-5;
/// How far squares may lie outside their bracket, relative: what a count may be wrong by.
constexpr double slack = 1e-6;

[[noreturn]] void fail_to_find(double frequency) {
  fail_modes(fmt::format(
      "stiffnesses and masses near {:.6g} Hz are too far apart; write element = \"corrected\"",
      frequency));
}

/// Numbers of frequencies below squares of omega, as they become known.
class Counts {
 public:
  explicit Counts(const Structure& structure) : structure_(&structure) {}

  std::size_t below(double square) {
    const auto known = known_.find(square);
    if (known != known_.end()) return known->second;
    return known_[square] = frequencies_below(*structure_, square);
  }

 private:
  const Structure* structure_;
  std::map<double, std::size_t> known_;
};

/// Squares of omega between which `count` frequencies lie.
struct Bracket {
  double low = 0.0, high = 0.0;
  std::size_t first = 0, count = 0;
};

/// The frequencies of a bracket, in equal or smaller ones, those that are among the `wanted` first.
void split(const Bracket& of, std::size_t wanted, Counts& counts, std::vector<Bracket>& parts) {
  if (of.count == 0 || of.first >= wanted) return;
  const double ratio = of.high / of.low;
  if ((of.count == 1 && ratio <= near) || ratio <= 1.0 + agreeing) {
    parts.push_back(of);
    return;
  }
  const double middle = std::sqrt(of.low) * std::sqrt(of.high);
  const std::size_t end = of.first + of.count;
  const std::size_t below = std::clamp(counts.below(middle), of.first, end);
  split({of.low, middle, of.first, below - of.first}, wanted, counts, parts);
  split({middle, of.high, below, end - below}, wanted, counts, parts);
}

double dot(const LinkColumns<double>& a, const LinkColumns<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k].cwiseProduct(b[k]).sum();
  return sum;
}

/// Motions that are refined together, with their mass.
struct Block {
  std::vector<Deformation<double>> motions;
  std::vector<LinkColumns<double>> inertia;

  std::size_t size() const { return motions.size(); }
};

template <class Columns>
MatrixXd products(const std::vector<Columns>& a, const std::vector<LinkColumns<double>>& b) {
  const auto size = static_cast<Index>(b.size());
  MatrixXd result(size, size);
  for (Index i = 0; i < size; ++i) {
    for (Index j = 0; j < size; ++j) {
      const auto& of = a[static_cast<std::size_t>(i)];
      if constexpr (std::is_same_v<Columns, LinkColumns<double>>) {
        result(i, j) = dot(of, b[static_cast<std::size_t>(j)]);
      } else {
        result(i, j) = dot(of.motion, b[static_cast<std::size_t>(j)]);
      }
    }
  }
  return 0.5 * (result + result.transpose());
}

Deformation<double> combined(const std::vector<Deformation<double>>& of, const VectorXd& factors) {
  Deformation<double> sum = of.front();
  for (auto& columns : sum.motion) columns *= factors[0];
  sum.joints *= factors[0];
  for (std::size_t i = 1; i < of.size(); ++i) {
    const double factor = factors[static_cast<Index>(i)];
    for (std::size_t k = 0; k < sum.motion.size(); ++k) sum.motion[k] += factor * of[i].motion[k];
    sum.joints += factor * of[i].joints;
  }
  return sum;
}

/// The modes of a bracket.
class Refinement {
 public:
  Refinement(const Structure& coarse, const Bracket& bracket)
      : bracket_(bracket), finer_(cut(coarse, pieces_at(coarse, 2.0 * bracket.high))) {
    begin();
  }

  /// Squares of omega, ascending, of modes with mass one; nothing where they leave the bracket.
  std::vector<double> run() {
    constexpr int most_steps = 30;
    const double margin = 0.5 * (bracket_.high - bracket_.low);
    double shift = 0.5 * (bracket_.low + bracket_.high);
    VectorXd squares_before;
    bool was_near = false;
    for (int step = 0; step < most_steps; ++step) {
      const VectorXd theta = iterate(shift);
      if (theta.size() == 0) return {};
      const double mean = shift + theta.mean();
      if (!(mean >= bracket_.low - margin && mean <= bracket_.high + margin)) return {};
      // The last two steps begin so near the frequencies that nothing of a second order is left,
      // nor of other motions.
      const double spread = theta.maxCoeff() - theta.minCoeff();
      const VectorXd squares_now = theta.array() + shift;
      const bool is_settled =
          theta.size() == 1 || (squares_before.size() == theta.size() &&
                                (squares_now - squares_before).cwiseAbs().maxCoeff() <= off * mean);
      squares_before = squares_now;
      const bool is_near =
          is_settled && theta.cwiseAbs().maxCoeff() <= 4.0 * off * mean + 2.0 * spread;
      if (is_near && was_near) {
        const std::vector<double> squares = inside(shift, theta);
        return spread > agreeing * mean ? each_by_itself(squares) : squares;
      }
      was_near = is_near;
      shift = mean * (1.0 - off);
    }
    return {};
  }

  /// Motions without strain: so near below zero that nothing else has a part in them.
  void run_free() {
    for (int step = 0; step < 3; ++step) {
      if (iterate(-bracket_.high).size() == 0) fail_to_find(0.0);
    }
  }

  const std::vector<Deformation<double>>& motions() const { return block_.motions; }
  const FinerStructure& finer() const { return finer_; }

 private:
  /// Loads without pattern, always the same.
  void begin() {
    std::mt19937 random(static_cast<unsigned>(bracket_.first) + 1U);
    block_.inertia.clear();
    for (std::size_t i = 0; i < bracket_.count; ++i) {
      LinkColumns<double> load = no_loads<double>(finer_.structure);
      for (auto& columns : load) {
        for (double& part : columns.reshaped()) {
          part = static_cast<double>(random()) / 4294967296.0 - 0.5;
        }
      }
      block_.inertia.push_back(std::move(load));
    }
  }

  /// The squares, with the second order: the mass of a mode changes by the way from the shift.
  std::vector<double> inside(double shift, const VectorXd& theta) const {
    std::vector<double> squares;
    for (Index i = 0; i < theta.size(); ++i) {
      squares.push_back(square_of(shift, theta[i], static_cast<std::size_t>(i)));
      if (!is_inside(squares.back())) return {};
    }
    return squares;
  }

  double square_of(double shift, double theta, std::size_t at) const {
    const LinkColumns<double>& motion = block_.motions[at].motion;
    const double mass = dot(motion, mass_times(finer_.structure, motion, shift + theta));
    return shift + 0.5 * (3.0 - mass) * theta;
  }

  bool is_inside(double square) const {
    return square >= bracket_.low * (1.0 - slack) && square <= bracket_.high * (1.0 + slack);
  }

  /// From one shift between them motions are known to their distance only: once more from near
  /// each.
  std::vector<double> each_by_itself(const std::vector<double>& squares) {
    std::vector<double> refined;
    std::vector<Deformation<double>> motions;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const double shift = squares[i] * (1.0 - off);
      const VectorXd theta = iterate(shift);
      if (theta.size() == 0) return {};
      refined.push_back(square_of(shift, theta[static_cast<Index>(i)], i));
      const bool is_it = std::abs(refined.back() - squares[i]) <=
                         slack * squares[i] + 0.1 * (squares.back() - squares.front());
      if (!is_it || !is_inside(refined.back())) return {};
      motions.push_back(block_.motions[i]);
    }
    block_.motions = std::move(motions);
    return refined;
  }

  /// One step of inverse iteration at a shift, whose motions then have mass one: how far the
  /// squares are from the shift, ascending. Nothing where motions have no mass.
  VectorXd iterate(double shift) {
    const DynamicStiffness<double> stiffness(finer_.structure, shift, 0.0);
    std::vector<Deformation<double>> moved;
    std::vector<LinkColumns<double>> inertia;
    for (const LinkColumns<double>& load : block_.inertia) {
      moved.push_back(stiffness.solve(load));
      inertia.push_back(mass_times(finer_.structure, moved.back().motion, shift));
    }
    const MatrixXd work = products(moved, block_.inertia);
    const MatrixXd mass = products(moved, inertia);
    const VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) return {};
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(
        scale.asDiagonal() * work * scale.asDiagonal(),
        scale.asDiagonal() * mass * scale.asDiagonal());
    if (ritz.info() != Eigen::Success || !ritz.eigenvalues().allFinite()) return {};
    const MatrixXd vectors = scale.asDiagonal() * ritz.eigenvectors();
    block_.motions.clear();
    block_.inertia.clear();
    for (Index i = 0; i < vectors.cols(); ++i) {
      block_.motions.push_back(combined(moved, vectors.col(i)));
      block_.inertia.push_back(mass_times(finer_.structure, block_.motions.back().motion, shift));
    }
    return ritz.eigenvalues();
  }

  Bracket bracket_;
  FinerStructure finer_;
  Block block_;
};

/// The largest motion is positive.
void turn(Deformation<double>& mode) {
  double largest = 0.0;
  for (const auto& columns : mode.motion) {
    for (const double part : columns.reshaped()) {
      if (std::abs(part) > std::abs(largest)) largest = part;
    }
  }
  if (largest >= 0.0) return;
  for (auto& columns : mode.motion) columns = -columns;
  mode.joints = -mode.joints;
}

/// A mode that strains, with the square of its omega.
struct Found {
  double square;
  Mode mode;
  std::size_t together;  ///< the first of those that were refined with it
};

/// Nothing where the refinement fails.
std::vector<Found> modes_in(const Structure& structure, const Bracket& bracket) {
  Refinement refinement(structure, bracket);
  const std::vector<double> squares = refinement.run();
  std::vector<Found> modes;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    Mode mode{std::sqrt(squares[i]) / full_turn,
              at_coarse_nodes(refinement.finer(), refinement.motions()[i])};
    turn(mode.shape);
    modes.push_back({squares[i], std::move(mode), bracket.first});
  }
  return modes;
}

void add_modes(const Structure& structure, const Bracket& of, Counts& counts,
               std::vector<Found>& modes) {
  std::vector<Found> found = modes_in(structure, of);
  const bool is_done = !found.empty() || of.count == 0;
  std::move(found.begin(), found.end(), std::back_inserter(modes));
  if (is_done) return;
  // Another frequency was nearer: brackets half as wide.
  if (of.high <= of.low * (1.0 + 0.01 * agreeing)) {
    fail_to_find(std::sqrt(of.high) / full_turn);
  }
  const double middle = std::sqrt(of.low) * std::sqrt(of.high);
  const std::size_t end = of.first + of.count;
  const std::size_t below = std::clamp(counts.below(middle), of.first, end);
  if (below > of.first)
    add_modes(structure, {of.low, middle, of.first, below - of.first}, counts, modes);
  if (end > below) add_modes(structure, {middle, of.high, below, end - below}, counts, modes);
}

/// What a step of inverse iteration leaves of a neighbour is the distance from the shift over that
/// from the neighbour: modes so near each other are refined once more, together.
void refine_neighbours(const Structure& structure, std::vector<Found>& modes) {
  constexpr double apart = 1.03;
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Found& a, const Found& b) { return a.square < b.square; });
  for (std::size_t i = 0, end = 0; i < modes.size(); i = end) {
    end = i + 1;
    while (end < modes.size() && modes[end].square < apart * modes[end - 1].square) ++end;
    if (modes[i].together == modes[end - 1].together) continue;
    const double low = modes[i].square, high = modes[end - 1].square;
    // On the way there they are known less well.
    const double wider = 0.1 * (high - low) + slack * high;
    std::vector<Found> anew =
        modes_in(structure, {low - wider, high + wider, modes[i].together, end - i});
    if (anew.size() == end - i)
      std::move(anew.begin(), anew.end(), modes.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// So many motions without strain, far below a square of omega.
void add_free_modes(const Structure& structure, std::size_t count, double square,
                    std::vector<Mode>& modes) {
  if (count == 0) return;
  Refinement refinement(structure, {0.0, square, 0, count});
  refinement.run_free();
  for (const Deformation<double>& shape : refinement.motions()) {
    Mode& mode = modes.emplace_back();
    mode.shape = at_coarse_nodes(refinement.finer(), shape);
    mode.shape.joints.setZero();
    turn(mode.shape);
  }
}

}  // namespace

std::size_t frequencies_below(const Structure& structure, double square) {
  constexpr double farthest = 1e-9;
  for (double part = 0.0;; part = std::max(1e-14, 10.0 * part)) {
    try {
      return DynamicStiffness<double>(structure, square * (1.0 + part), 0.0).frequencies_below();
    } catch (const AnalysisError&) {
      if (part >= farthest) throw;
    }
  }
}

std::vector<Mode> exact_modes_of(const Structure& structure, std::size_t count) {
  std::vector<Mode> modes;
  Counts counts(structure);
  const double lowest = strainless * low_square_of(structure);
  const std::size_t free = counts.below(lowest);
  add_free_modes(structure, free, lowest, modes);
  if (modes.size() > count) modes.resize(count);
  double low = lowest, high = 4.0 / strainless * lowest;
  std::vector<Bracket> brackets;
  for (std::size_t known = free; known < count;) {
    const std::size_t below = counts.below(high);
    split({low, high, known, std::max(known, below) - known}, count, counts, brackets);
    known = std::max(known, below);
    low = high;
    high *= 4.0;
    if (!std::isfinite(high)) fail_to_find(std::sqrt(low) / full_turn);
  }
  std::vector<Found> found;
  for (const Bracket& bracket : brackets) add_modes(structure, bracket, counts, found);
  refine_neighbours(structure, found);
  for (Found& of : found) modes.push_back(std::move(of.mode));
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  if (modes.size() > count) modes.resize(count);
  return modes;
}

}  // namespace boxbeam::flexible
