#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "boxbeam/project/quantity_text.hpp"

/// Lines of comma-separated values, and their parts.
namespace boxbeam {

/// Beyond this no number of a table is meant, as in the case file.
inline constexpr double largest_table_number = 1e20;

/// A part of a line, without the blanks around it, and where it begins (in characters, from 1).
struct Field {
  std::string_view text;
  int column = 1;
};

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

std::vector<Field> fields_of(std::string_view line, char separator);

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

/// A number without unit, finite and of a magnitude that can be meant.
std::variant<double, FieldTrouble> number_in_table(std::string_view text);

}  // namespace boxbeam
