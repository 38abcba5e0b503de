#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/study/number_counts.hpp"
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
  double quantile_error = 0.0;  ///< relative, of the three between; 0 where they are exact
  /// How many lie in each of as many equal parts from the least to the largest.
  std::vector<std::uint64_t> histogram;
};

/// Which part of the variance of one column each variable makes.
struct ColumnIndices {
  Column column;
  SobolIndices indices;
};

/// A study that has run.
struct StudySummary {
  std::string name, study_file, case_file;
  std::string sha256;             ///< of the study, the case and its tables
  std::string rows_sha256;        ///< of the table as it is written
  std::string statistics_sha256;  ///< of the file of all designs, where not all have a row
  std::string version;            ///< of the program
  std::uint64_t seed = 0;
  std::size_t designs = 0;
  std::string keep;                             ///< which designs have a row; "": all
  std::size_t kept = 0;                         ///< of them have one
  std::size_t failed = 0;                       ///< of them could not be verified
  std::map<std::string, std::size_t> verdicts;  ///< of the others, where this is a column
  std::map<std::string, std::size_t> reasons;   ///< why designs failed, the first thousand
  std::vector<ColumnStatistics> statistics;     ///< of all columns of numbers
  /// Share of the designs that do not pass, where they are drawn as they scatter.
  std::optional<BoundedEstimate> p_f;
  std::vector<std::string> index_variables;  ///< whose indices were asked for
  std::vector<ColumnIndices> indices;        ///< of results that are numbers
};

/// The cells of a row of comma-separated values. Source: RFC 4180.
std::vector<std::string> cells_in(std::string_view row);

/// The number in a cell as it is written; nothing where there is none.
std::optional<double> number_of_cell(std::string_view cell);

/// Gathers rows of a study, in memory that does not grow with them (but for indices: 8 bytes of
/// each number). Parts are joined in the order of the designs; what comes of it hangs on these
/// parts alone.
class StudyStatistics {
 public:
  /// All columns of a row, the first so many of which are variables; `scatters`: designs are drawn
  /// as they scatter, independently of each other; with a plan where indices are asked for. `most`:
  /// unlike numbers of a column that are told apart.
  StudyStatistics(std::vector<Column> columns, std::size_t variables, bool scatters = false,
                  std::optional<IndexPlan> plan = {}, std::size_t most = 1U << 14U);

  /// The cells of a row as they are written, and its status, "ok" or why it failed.
  void take(const std::vector<std::string>& cells, const std::string& status);
  /// Designs behind these, of the same study.
  void take(const StudyStatistics& next);

  /// Into a summary of which the rest is known.
  void put_into(StudySummary& summary) const;

  /// One line that `take_text` reads; not with a plan.
  std::string text() const;
  /// As `take`, of that line. Throws std::invalid_argument where it is none of these columns.
  void take_text(const std::string& text);

 private:
  struct Numbers {
    double mean = 0.0, squares = 0.0;  ///< of distances from the mean
    NumberCounts counts;
  };
  static void join(Numbers& numbers, const Numbers& next);
  void count_reason(const std::string& reason, std::size_t count);
  ColumnStatistics statistics_of(std::size_t column) const;

  std::vector<Column> columns_;
  std::size_t variables_;
  bool scatters_;
  std::optional<IndexPlan> plan_;
  std::size_t most_;
  std::vector<Numbers> numbers_;
  std::vector<std::vector<double>> of_designs_;  ///< results by design, for indices
  std::size_t designs_ = 0, failed_ = 0;
  std::map<std::string, std::size_t> verdicts_, reasons_;
};

}  // namespace boxbeam
