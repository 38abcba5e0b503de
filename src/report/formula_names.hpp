#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the words of a formula mean, for both of its printers.
namespace boxbeam::report {

/// A Greek letter as LaTeX ("\\sigma") and as UTF-8; nothing for other words.
struct GreekLetter {
  std::string_view latex, utf8;
};

std::optional<GreekLetter> greek_letter_of(std::string_view name);

/// "3.8657e9" is 3.8657 and 9; without exponent it is all mantissa.
struct NumberParts {
  std::string mantissa, exponent;
};

NumberParts parts_of_number(const std::string& number);

/// "mm^-2" is "mm" and "-2".
struct UnitPart {
  std::string name, exponent;
};

std::vector<UnitPart> parts_of_unit(const std::string& unit);

/// "y,eff" is "y" and "eff".
std::vector<std::string> parts_of_index(const std::string& index);

/// The letter of a differential, "s" of "ds"; nothing for other names.
std::optional<char> differential_of(std::string_view name);

}  // namespace boxbeam::report
