#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "../csv_text.hpp"
#include "row_block.hpp"
#include "text_lines.hpp"

namespace boxbeam {

/// The parts of a line between separators; between blanks, any number of them and of tabs is one.
std::vector<Field> signal_fields(std::string_view line, char separator);

/// Whether a line begins with a number, so that it can be a row.
bool begins_with_number(std::string_view line);

/// Reads so many numbers between blanks, and nothing else, from a part of the current line; fails
/// where it holds something else.
void read_numbers(const TextLines& lines, std::string_view part, std::size_t count, double* to,
                  const char* hint);

/// The rows of a table of text: reads the numbers of the wanted columns, and hands them to a block.
class NumberRows {
 public:
  /// Where the time stands, if it does, and what one of it is in seconds.
  struct Time {
    std::optional<std::size_t> column;
    double factor = 1.0;  ///< to s, of a column
    double step = 0.0;    ///< [s], where there is no column; the first row is at 0
  };

  /// `width`: columns of the table; `wanted`: which of them go to the block, in its order.
  NumberRows(const TextLines& lines, const TableForm& form, std::size_t width,
             const std::vector<std::size_t>& wanted, const Time& time, RowBlock& block);

  /// Takes a line, which is the current one of the lines or its part without a comment.
  void take(std::string_view line);

  std::uint64_t rows() const { return rows_; }

 private:
  bool read_quickly(std::string_view line);
  void read_unusual(std::string_view line);
  [[noreturn]] void fail(std::string_view line, const RowTrouble& trouble) const;

  const TextLines* lines_;
  TableForm form_;
  std::size_t width_;
  Time time_;
  RowBlock* block_;
  /// For each column the index of its value, or `none`; a value may be wanted twice.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> slot_of_column_;
  std::vector<std::size_t> slot_of_wanted_;
  std::vector<std::size_t> column_of_wanted_;
  std::vector<double> slots_;
  std::vector<double> values_;
  std::uint64_t rows_ = 0;
};

}  // namespace boxbeam
