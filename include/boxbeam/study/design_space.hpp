#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/study/study.hpp"

namespace boxbeam {

/// A value of a variable in a design.
struct Setting {
  double number = 0.0;
  std::string word;  ///< instead, of a variable of words
};

/// The design in which the variables that scatter have these values, in their order; of others the
/// first value. Throws AnalysisError where an expression has none.
std::vector<Setting> design_of(const Study& study, const std::vector<double>& scattering);

/// A design as --set, one for every key.
std::vector<std::string> overrides_of(const Study& study, const std::vector<Setting>& design);

/// All designs of a study: every combination of the variables with values (those of its table take
/// one row together), for each of these every
/// sample of those that scatter; the last variable changes first. A design hangs on the study and
/// its index alone, whoever asks for it and in whatever order. Where indices are asked for each
/// sample is a block of designs, as `sobol_indices_of` has them.
///
/// Random numbers are those of Philox 4x32-10 with the seed as key and (sample, variable) as
/// counter. Source: Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as 1, 2, 3 (2011).
class DesignSpace {
 public:
  /// Looks at the study, which stays. Throws InputError where there are too many designs.
  explicit DesignSpace(const Study& study);

  std::size_t size() const { return size_; }
  /// Values of all variables, in their order. Throws AnalysisError where an expression has none.
  std::vector<Setting> at(std::size_t index) const;
  std::vector<std::string> overrides(const std::vector<Setting>& design) const {
    return overrides_of(*study_, design);
  }

 private:
  std::vector<double> shares_of(std::size_t sample) const;
  std::vector<double> independent_shares(std::size_t sample, std::size_t count) const;
  /// Whether a variable takes the row of the table that another one before it takes.
  bool follows(std::size_t variable) const;

  const Study* study_;
  std::size_t size_ = 1, samples_ = 1;
  std::size_t block_ = 1;                ///< designs of a sample
  std::vector<std::size_t> scattering_;  ///< variables that do, by index
  std::optional<std::size_t> of_table_;  ///< the first that takes rows of the study's table
  Eigen::MatrixXd factor_;               ///< of the correlation, lower triangular
  /// Of Latin hypercubes: the share that each sample of a variable lies in.
  std::vector<std::vector<std::uint32_t>> shares_;
};

/// Gives the variables of a design that are tied to others their numbers. Throws AnalysisError
/// where an expression has none.
void take_expressions(const Study& study, std::vector<Setting>& design);

/// A number between 0 and 1, both excluded, of a seed and two counters.
double uniform_number(std::uint64_t seed, std::uint64_t sample, std::uint32_t variable);

}  // namespace boxbeam
