#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "boxbeam/project/quantity_text.hpp"

/// Tables of numbers as spreadsheets and measuring programs write them: columns between commas,
/// semicolons or tabs, decimals with a point or a comma, names with units or a row of units below
/// them, texts in quotation marks or not.
namespace boxbeam {

/// Beyond this no number of a table is meant, as in the case file.
inline constexpr double largest_table_number = 1e20;

/// A part of a line, without the blanks and the quotation marks around it, and where it begins (in
/// characters, from 1).
struct Field {
  std::string_view text;
  int column = 1;
};

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Up to the "#" of a comment, which stands outside quotation marks.
std::string_view without_comment(std::string_view line);

/// The parts of a line; a separator within quotation marks keeps nothing apart.
std::vector<Field> fields_of(std::string_view line, char separator);

/// How a table is written.
struct TableForm {
  /// As long as no number has shown it, where it may be either: no digit follows digits as a sign.
  static constexpr char not_shown = '0';

  char separator = ',';     ///< the first of ; tab , that its first line has outside quotes
  char decimal_sign = '.';  ///< between commas a point, else that of the first number with one

  /// "semicolons", "tabs", "commas", "blanks".
  std::string_view separators() const;
};

TableForm form_of(std::string_view first_line);

/// The columns that a table names: each with its unit in brackets, or names alone and their units
/// in the line below, in brackets or not.
///
///     time [s], force [kN]            "time";"force"
///                                     s;kN
class TableHead {
 public:
  struct Column {
    std::string name;  ///< with its unit, "force [kN]", as far as one is given
    int column = 1;    ///< in `line` below
  };

  /// Takes a line that is neither blank nor comment; whether more of the head is to come.
  bool wants_more_than(std::string_view line, int number);

  const std::vector<Column>& columns() const { return columns_; }
  const TableForm& form() const { return form_; }
  /// The line in which the units stand or should stand.
  const std::string& line() const { return line_; }
  int line_number() const { return line_number_; }

 private:
  void take_units(std::string_view line, int number);

  std::vector<Column> columns_;
  TableForm form_;
  std::string line_;
  int line_number_ = 0;
};

/// The unit in the brackets of a column's name, "stroke [mm]", as a quantity of one of it; what is
/// wrong as text where there is none.
std::variant<ParsedQuantity, std::string> unit_of_column(std::string_view name);

/// "this column is a time, but "[mm]" is a length".
std::string wrong_dimension(std::string_view column, const DimensionExponents& exponents,
                            const WantedDimension& wanted);

/// The unit in an example of a dimension: "mm" in "250 mm".
std::string_view example_unit_of(const WantedDimension& wanted);

/// What is wrong with a part of a line, and what to write.
struct FieldTrouble {
  std::string message;
  std::string hint;
};

/// A number without unit, finite and of a magnitude that can be meant. The first one with a decimal
/// sign settles it for the table: with both in one table, "1,234" could be 1234.
std::variant<double, FieldTrouble> number_in_table(std::string_view text, TableForm& form);

}  // namespace boxbeam
