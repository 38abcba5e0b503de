#pragma once

#include <optional>
#include <string>
#include <vector>

namespace boxbeam::report {

/// A part of a formula, see formula.hpp.
struct FormulaNode {
  enum class Kind {
    number,      ///< text "3.8657e9", index its unit "mm^4", or nothing
    name,        ///< text "sigma", index "v"; text "d_sigma" is a range
    product,     ///< parts side by side
    times,       ///< two parts with a sign between them
    fraction,    ///< numerator, denominator
    sum,         ///< parts; those behind a minus are negative
    negative,    ///< of its part
    power,       ///< base, exponent
    group,       ///< its part in parentheses
    call,        ///< text "sqrt", parts the arguments
    derivative,  ///< text "dx", part what is differentiated
    large,       ///< text "sum" or "int", part what it acts on
    relation,    ///< text "<=", left, right
  };
  Kind kind = Kind::number;
  std::string text;
  std::string index;
  std::vector<FormulaNode> parts;
};

/// Whether a part is taller than a line of text, so that brackets must grow with it.
bool is_tall(const FormulaNode& node);

/// The tree of a formula; nothing for words that are none.
std::optional<FormulaNode> parse_formula(const std::string& text);

}  // namespace boxbeam::report
