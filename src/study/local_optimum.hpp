#pragma once

#include <Eigen/Core>
#include <optional>

#include "boxbeam/study/optimum.hpp"

namespace boxbeam {

/// Counts designs, and keeps what could not be judged.
struct Tally {
  std::size_t evaluations = 0, troubled = 0;
  std::string first_trouble;

  void add(const Tally& other);
};

/// A design with its worth counted; what is no number is trouble.
Worth worth_at(const OptimumQuestion::Function& function, const std::vector<double>& values,
               Tally& tally);

/// Whether it can be judged and keeps its limits.
bool keeps_limits(const Worth& worth);

/// How far beyond its limits it is; infinite where it cannot be judged.
double violation_of(const Worth& worth);

/// The best design of choices with bounds in the neighbourhood of a start; those of lists stay as
/// the start has them.
struct LocalOptimum {
  std::vector<double> values;
  Worth worth;
  std::vector<ActiveLimit> active;
  double imbalance = 0.0;  ///< of the slopes, part of the goal's
};

/// The neighbourhood, without derivatives and therefore past kinks: COBYLA.
LocalOptimum rough_optimum(const OptimumQuestion& question,
                           const OptimumQuestion::Function& function,
                           const std::vector<double>& start, Tally& tally);

/// Its last digits, by the method of moving asymptotes, and what holds it.
LocalOptimum exact_optimum(const OptimumQuestion& question,
                           const OptimumQuestion::Function& function, const LocalOptimum& near,
                           Tally& tally);

/// Multipliers, none below zero, with which columns come nearest to a vector. Source: Lawson,
/// Hanson, Solving Least Squares Problems (1974), chapter 23.
Eigen::VectorXd nearest_by_nonnegative(const Eigen::MatrixXd& columns, const Eigen::VectorXd& to);

}  // namespace boxbeam
