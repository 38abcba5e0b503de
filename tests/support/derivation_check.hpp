#pragma once

#include <set>
#include <string>
#include <vector>

#include "boxbeam/report/formula_tree.hpp"
#include "catch.hpp"
#include "src/report/derivation_text.hpp"
#include "support/formula_value.hpp"

namespace test {

/// What a pocket calculator finds wrong in printed steps: formulas of one step whose values, each
/// within the rounding of its printed numbers, are not the same number; and texts that are no
/// formulas. `without`: symbols of steps without a value.
inline std::vector<std::string> wrong_in(const boxbeam::report::Steps& steps,
                                         const std::set<std::string>& without) {
  std::vector<std::string> wrong;
  FormulaValues known;
  for (const boxbeam::report::Step& step : steps) {
    std::optional<FormulaValue> before;
    for (const std::string& formula : step.formulas) {
      if (!boxbeam::report::parse_formula(formula))
        wrong.push_back(step.symbol + ": no formula: " + formula);
      const auto value = value_of(formula, known);
      if (!value) continue;
      if (before && !agree(*before, *value))
        wrong.push_back(step.symbol + " is not " + formula + ", " + step.formulas.front());
      before = value;
    }
    if (!before && without.count(step.symbol) == 0) wrong.push_back(step.symbol + " has no value");
    if (before) known[step.symbol] = *before;
  }
  return wrong;
}

/// Checks that every step's symbols, values and result are the same number.
inline void check_derivation(const boxbeam::Derivation& derivation,
                             const std::set<std::string>& without = {}) {
  CHECK(wrong_in(boxbeam::report::steps_of(derivation), without) == std::vector<std::string>{});
}

}  // namespace test
