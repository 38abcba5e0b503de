#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/study/sobol_indices.hpp"

namespace boxbeam {

/// A column of the table of a study.
struct Column {
  std::string name;
  std::string unit;  ///< "" where it has none
};

/// What the numbers of one column come to, over all designs that have one.
struct ColumnStatistics {
  Column column;
  std::size_t count = 0;
  double mean = 0.0, sd = 0.0;  ///< sd with count - 1
  /// Least, 5 %, half, 95 % and largest: the smallest number that such a share is not above.
  std::array<double, 5> quantiles{};
};

/// Which part of the variance of one column each variable makes.
struct ColumnIndices {
  Column column;
  SobolIndices indices;
};

/// A study that has run.
struct StudySummary {
  std::string name, study_file, case_file;
  std::string sha256;       ///< of the study, the case and its tables
  std::string rows_sha256;  ///< of the table as it is written
  std::string version;      ///< of the program
  std::uint64_t seed = 0;
  std::size_t designs = 0;
  std::size_t failed = 0;                       ///< of them could not be verified
  std::map<std::string, std::size_t> verdicts;  ///< of the others, where this is a column
  std::map<std::string, std::size_t> reasons;   ///< why designs failed, the first thousand
  std::vector<ColumnStatistics> statistics;     ///< of all columns of numbers
  /// Share of the designs that do not pass, where they are drawn as they scatter.
  std::optional<BoundedEstimate> p_f;
  std::vector<std::string> index_variables;  ///< whose indices were asked for
  std::vector<ColumnIndices> indices;        ///< of results that are numbers
};

/// Gathers the rows of a study one after the other. Keeps every number: 8 bytes each.
class StudyStatistics {
 public:
  /// All columns of a row, the first so many of which are variables; `scatters`: designs are drawn
  /// as they scatter, independently of each other; with a plan where indices are asked for.
  StudyStatistics(std::vector<Column> columns, std::size_t variables, bool scatters = false,
                  std::optional<IndexPlan> plan = {});

  /// The cells of a row as they are written, and its status, "ok" or why it failed.
  void take(const std::vector<std::string>& cells, const std::string& status);

  /// Into a summary of which the rest is known.
  void put_into(StudySummary& summary) const;

 private:
  std::vector<Column> columns_;
  std::size_t variables_;
  bool scatters_;
  std::optional<IndexPlan> plan_;
  std::vector<std::vector<double>> numbers_;
  std::vector<std::vector<double>> of_designs_;  ///< results by design, for indices
  std::size_t designs_ = 0, failed_ = 0;
  std::map<std::string, std::size_t> verdicts_, reasons_;
};

}  // namespace boxbeam
