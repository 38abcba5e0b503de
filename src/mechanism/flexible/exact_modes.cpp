#include "mode_searches.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

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
    return known_[square] = count(square);
  }

 private:
  /// A little beyond where that is too near a resonance to tell.
  std::size_t count(double square) const {
    constexpr double farthest = 1e-9;
    for (double part = 0.0;; part = std::max(1e-14, 10.0 * part)) {
      try {
        return DynamicStiffness<double>(*structure_, square * (1.0 + part), 0.0)
            .frequencies_below();
      } catch (const AnalysisError&) {
        if (part >= farthest) throw;
      }
    }
  }

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
    bool was_near = false;
    for (int step = 0; step < most_steps; ++step) {
      const VectorXd theta = iterate(shift);
      if (theta.size() == 0) return {};
      const double mean = shift + theta.mean();
      if (!(mean >= bracket_.low - margin && mean <= bracket_.high + margin)) return {};
      // The last two steps begin so near the frequencies that nothing of a second order is left,
      // nor of other motions.
      const double spread = theta.maxCoeff() - theta.minCoeff();
      const bool is_near = theta.cwiseAbs().maxCoeff() <= 4.0 * off * mean + 2.0 * spread;
      if (is_near && was_near) return inside(shift, theta);
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
      const LinkColumns<double>& motion = block_.motions[static_cast<std::size_t>(i)].motion;
      const double mass = dot(motion, mass_times(finer_.structure, motion, shift + theta[i]));
      const double square = shift + 0.5 * (3.0 - mass) * theta[i];
      if (square < bracket_.low * (1.0 - slack) || square > bracket_.high * (1.0 + slack))
        return {};
      squares.push_back(square);
    }
    return squares;
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

void add_modes(const Structure& structure, const Bracket& of, Counts& counts,
               std::vector<Mode>& modes) {
  Refinement refinement(structure, of);
  const std::vector<double> squares = refinement.run();
  for (std::size_t i = 0; i < squares.size(); ++i) {
    Mode& mode = modes.emplace_back();
    mode.frequency = std::sqrt(squares[i]) / full_turn;
    mode.shape = at_coarse_nodes(refinement.finer(), refinement.motions()[i]);
    turn(mode.shape);
  }
  if (!squares.empty() || of.count == 0) return;
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
  for (const Bracket& bracket : brackets) add_modes(structure, bracket, counts, modes);
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  if (modes.size() > count) modes.resize(count);
  return modes;
}

}  // namespace boxbeam::flexible
