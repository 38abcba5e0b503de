#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "boxbeam/project/quantity_text.hpp"

namespace boxbeam {

/// The unit that a program wrote, as a quantity of one of it; what is wrong as text where it is not
/// known here. Besides those of `parse_quantity`: "kN-m", "kNm", "sec", "mm/s**2", "Newton-meter",
/// "-" for a number without unit.
std::variant<ParsedQuantity, std::string> parse_file_unit(std::string_view unit);

/// A name and the unit in brackets or parentheses at its end, "force [kN]", "force (kN)"; without
/// them all is name.
struct NameWithUnit {
  std::string name;
  std::string unit;
};
NameWithUnit split_unit(std::string_view text);

/// Without the brackets or parentheses around all of it.
std::string_view without_unit_brackets(std::string_view unit);

}  // namespace boxbeam
