#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "boxbeam/project/case_document.hpp"

/// Many verifications of one case: what changes from one to the next, and what comes of each.
namespace boxbeam {

/// A number in the unit in which a case has it: 8 mm; "" where it has none.
struct WrittenQuantity {
  double value = 0.0;
  std::string unit;
};

/// "8 mm" in its parts. Nothing where the text is no quantity.
std::optional<WrittenQuantity> quantity_written_in(std::string_view text);

/// Of a value of a case, a quantity or a bare number. Nothing where it is neither.
std::optional<WrittenQuantity> quantity_written_in(const Node& node);

/// A number so that it is read back as it was: "0.1", "8.5".
std::string number_text(double value);

/// "8 mm", as a case is given it.
std::string to_text(const WrittenQuantity& quantity);

/// How much one of the second unit is in the first: 0.001 of m for mm. Nothing where they are of
/// unlike dimensions.
std::optional<double> ratio_of_units(const std::string& unit, const std::string& other);

}  // namespace boxbeam
