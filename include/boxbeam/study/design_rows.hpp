#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxbeam/study/study_summary.hpp"

namespace boxbeam {

/// A column of a table of designs: numbers, "not a number" where a design has none, or words.
struct DesignColumn {
  Column column;
  bool is_variable = false;
  std::vector<double> numbers;
  std::vector<std::string> words;  ///< instead
};

/// Designs that are looked at one by one.
struct DesignRows {
  std::size_t designs = 0;           ///< that have a row, of which these are all or some
  std::vector<std::size_t> numbers;  ///< of these, from 1
  std::vector<DesignColumn> columns;
  bool scatters = false;  ///< variables do, so that shares of designs are probabilities

  std::size_t size() const { return numbers.size(); }
  /// Nullptr where there is none.
  const DesignColumn* find(const std::string& name) const;
};

/// Keeps so many designs at most of all that it is shown: one of each of as many equal parts, by
/// the seed, so that no pattern of the study is hit again and again.
class DesignSample {
 public:
  /// All columns of a row; the first so many are variables. `designs`: that have a row.
  DesignSample(std::vector<Column> columns, std::size_t variables, std::size_t designs,
               std::uint64_t seed);

  /// Whether the design of this row, from 0, is one that is shown.
  bool wants(std::size_t place) const;
  /// One that is, by its number: its cells as they are written, and its status.
  void take(std::size_t number, const std::vector<std::string>& cells, const std::string& status);
  /// Columns that say something: those of variables, of results that any design has, and "status"
  /// where a design failed.
  DesignRows rows() const;

  static constexpr std::size_t most = 10'000;

 private:
  std::vector<Column> columns_;
  std::size_t variables_, designs_, part_;
  std::uint64_t seed_;
  std::vector<std::size_t> numbers_;
  std::vector<std::vector<std::string>> cells_;  ///< with the status last
};

}  // namespace boxbeam
