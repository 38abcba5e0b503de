#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/study/distribution.hpp"
#include "boxbeam/study/reliability.hpp"

namespace boxbeam {

/// How designs are drawn from distributions.
enum class Sampling {
  random,
  latin_hypercube,  ///< each of as many equal shares of a variable is hit once
  sobol,            ///< Sobol's sequence, its first point (all zero) included as the middle
};

/// What changes from design to design.
struct Variable {
  std::string name;
  std::vector<std::string> keys;             ///< of the case; none: it stands in expressions alone
  std::string unit;                          ///< of its numbers; "" where they have none
  std::vector<double> values;                ///< one after the other
  bool is_grid = false;                      ///< values in equal steps; an optimum may lie between
  bool is_of_table = false;                  ///< values and words go with those of the others
  std::vector<std::string> words;            ///< likewise, where they are no numbers: "S355"
  std::optional<Distribution> distribution;  ///< instead
  std::string expression;                    ///< instead: of the variables before it
};

/// What `boxbeam optimise` is to find.
struct OptimiseDemand {
  std::vector<std::string> minimise;    ///< one goal or two, expressions of variables and results
  bool checks = false;                  ///< every check of the case passes
  std::vector<std::string> subject_to;  ///< expressions that are not below zero
  std::size_t starts = 8;               ///< of searches
  std::size_t designs = 2000;           ///< at most, of all combinations of lists
  std::size_t points = 11;              ///< of the front of two goals
};

/// Which part of the scatter of results each variable makes.
struct IndexDemand {
  std::size_t resamples = 1000;  ///< of the samples, for the bounds of the indices
};

/// A study as its file has it.
struct Study {
  std::string path;
  std::string name;
  std::string text;          ///< of the file, and of its table of designs
  std::string case_file;     ///< from the working folder; "" without a case
  std::string case_written;  ///< as the study has it
  std::uint64_t seed = 1;
  std::size_t samples = 0;  ///< of variables that scatter
  Sampling sampling = Sampling::random;
  std::vector<Variable> variables;
  std::vector<std::string> columns;   ///< keys of results; without a case names of formulas
  std::vector<std::string> formulas;  ///< of variables, one for each column, without a case
  /// Of variables and columns of numbers: not zero of the designs that have a row; "": all have.
  std::string keep;
  /// Of the normal variables behind those that scatter, by the order of these; empty where all are
  /// independent.
  Eigen::MatrixXd correlation;
  std::optional<IndexDemand> indices;
  std::optional<OptimiseDemand> optimise;
  std::optional<ReliabilityDemand> reliability;  ///< where it has a limit state
};

/// Reads a study. Throws InputError with all problems.
Study read_study(const std::string& path);
Study parse_study(const std::string& path, const std::string& text);

}  // namespace boxbeam
