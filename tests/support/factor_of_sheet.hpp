#pragma once

#include <string>

#include "boxbeam/report/report.hpp"
#include "catch.hpp"

namespace test {

/// The sheet of a check, whose last step comes to the check's factor.
inline boxbeam::report::Sheet sheet_to_factor(const boxbeam::Project& project,
                                              const boxbeam::Verification& of,
                                              const boxbeam::CheckResult& result,
                                              double within = 6e-4) {
  INFO(result.check.id);
  boxbeam::report::Sheet sheet = boxbeam::sheet_of(project, of, result);
  REQUIRE(!sheet.steps.empty());
  const boxbeam::report::Step& last = sheet.steps.back();
  CHECK(last.symbol == "factor");
  REQUIRE(!last.formulas.empty());
  CHECK(std::stod(last.formulas.back()) == Approx(result.check.safety_factor).epsilon(within));
  return sheet;
}

}  // namespace test
