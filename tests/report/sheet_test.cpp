#include <algorithm>
#include <deque>
#include <filesystem>
#include <set>

#include "boxbeam/report/format.hpp"
#include "boxbeam/report/formula.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "catch.hpp"
#include "support/formula_value.hpp"
#include "support/program.hpp"

using namespace boxbeam;
using report::Sheet;
using report::Step;

namespace {

/// A shipped case with its result, which points into the case.
struct Verified {
  explicit Verified(const std::string& path)
      : name(path), project(read_project(path)), verification(verify(project)) {}
  std::string name;
  Project project;
  Verification verification;
};

const std::deque<Verified>& shipped_cases() {
  static const std::deque<Verified> cases = [] {
    std::vector<std::string> paths;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(test::project_file("sections"))) {
      const std::filesystem::path& path = entry.path();
      if (path.extension() != ".toml" || path.parent_path().filename() == "catalogue") continue;
      paths.push_back(path.string());
    }
    std::sort(paths.begin(), paths.end());
    return std::deque<Verified>(paths.begin(), paths.end());
  }();
  return cases;
}

/// Does something with the sheet of every check of every shipped case.
template <class Action>
void for_all_sheets(const Action& action) {
  REQUIRE(shipped_cases().size() >= 10);
  for (const Verified& of : shipped_cases()) {
    for (const CheckResult& result : of.verification.checks) {
      const Sheet sheet = sheet_of(of.project, of.verification, result);
      INFO(of.name << "\n" << report::text_of(sheet));
      action(sheet, result.check);
    }
  }
}

const Step* find(const Sheet& sheet, const std::string& symbol) {
  const auto found = std::find_if(sheet.steps.begin(), sheet.steps.end(),
                                  [&](const Step& step) { return step.symbol == symbol; });
  return found == sheet.steps.end() ? nullptr : &*found;
}

/// How the values of a sheet hang together.
struct Recalculation {
  int compared = 0;   ///< pairs of formulas of one chain that have values
  int by_symbol = 0;  ///< among them formulas of symbols that earlier steps gave
  std::vector<std::string> wrong;
};

Recalculation recalculated(const Sheet& sheet) {
  Recalculation result;
  test::FormulaValues known;
  for (const Step& step : sheet.steps) {
    std::optional<test::FormulaValue> before;
    std::string formula_before;
    for (const std::string& formula : step.formulas) {
      const auto value = test::value_of(formula, known);
      if (!value) continue;
      if (before) {
        ++result.compared;
        if (formula_before == step.formulas.front()) ++result.by_symbol;
        if (!test::agree(*before, *value))
          result.wrong.push_back(step.symbol + ": " + formula_before + " = " + formula);
      }
      before = value;
      formula_before = formula;
    }
    if (before) known[step.symbol] = *before;
  }
  return result;
}

}  // namespace

TEST_CASE("Every formula of every sheet is one, and so is every symbol", "[report][sheet]") {
  int formulas = 0;
  for_all_sheets([&](const Sheet& sheet, const Check&) {
    for (const Step& step : sheet.steps) {
      INFO(step.symbol);
      if (!report::is_formula(step.symbol)) FAIL("no symbol: " << step.symbol);
      for (const std::string& formula : step.formulas) {
        if (!report::is_formula(formula)) FAIL("no formula: " << formula);
        ++formulas;
      }
    }
  });
  CHECK(formulas > 10000);
}

TEST_CASE("A pocket calculator comes to what every step of every sheet says", "[report][sheet]") {
  // Interval arithmetic over what the rounding of the printed numbers leaves open, with units.
  int compared = 0;
  int by_symbol = 0;
  for_all_sheets([&](const Sheet& sheet, const Check&) {
    const Recalculation of = recalculated(sheet);
    for (const std::string& wrong : of.wrong) FAIL_CHECK(wrong);
    compared += of.compared;
    by_symbol += of.by_symbol;
  });
  CHECK(compared > 10000);
  CHECK(by_symbol > 1000);
}

TEST_CASE("The pocket calculator finds a number that is one percent off", "[report][sheet]") {
  int found = 0;
  int chains = 0;
  for_all_sheets([&](Sheet sheet, const Check& check) {
    if (check.criterion != Criterion::yield || chains > 200) return;
    Step& factor = sheet.steps.back();
    ++chains;
    factor.formulas.back() = text::significant(check.safety_factor * 1.01, 4);
    found += recalculated(sheet).wrong.empty() ? 0 : 1;
  });
  CHECK(chains > 100);
  CHECK(found == chains);
}

TEST_CASE("A sheet ends with the factor of its check", "[report][sheet]") {
  for_all_sheets([](const Sheet& sheet, const Check& check) {
    if (sheet.steps.empty()) FAIL("no steps");
    const Step& last = sheet.steps.back();
    if (last.symbol != "factor") FAIL("ends with " << last.symbol);
    if (last.formulas.back() != text::significant(check.safety_factor, 4)) {
      FAIL_CHECK(last.formulas.back() << " is not " << check.safety_factor);
    }
    if (sheet.id != check.id || sheet.source != check.source ||
        sheet.utilisation != check.utilisation()) {
      FAIL_CHECK("another check");
    }
    if (sheet.mark != (check.passes() ? report::Mark::passes : report::Mark::fails)) {
      FAIL_CHECK("marked otherwise");
    }
  });
}

TEST_CASE("What acts and what resists stands in the sheet as in the table of checks",
          "[report][sheet]") {
  std::set<Criterion> seen;
  for_all_sheets([&](const Sheet& sheet, const Check& check) {
    seen.insert(check.criterion);
    const auto ends_with = [&](const char* symbol, const Amount& amount) {
      const Step* step = find(sheet, symbol);
      if (step == nullptr) FAIL("no step " << symbol);
      const auto value = test::value_of(step->formulas.back());
      const auto wanted = test::value_of(text::amount(amount.value(), amount.unit()));
      if (!value || !wanted || !test::agree(*value, *wanted))
        FAIL_CHECK(symbol << " is not " << amount.value());
    };
    switch (check.criterion) {
      case Criterion::yield:
        if (find(sheet, "sigma_v") != nullptr) ends_with("sigma_v", check.acting);
        break;
      case Criterion::fatigue: ends_with("d_sigma", check.acting); break;
      case Criterion::shear_fatigue: ends_with("d_tau", check.acting); break;
      case Criterion::combined_fatigue: ends_with("D", check.acting); break;
      case Criterion::stress_range: ends_with("limit", check.resisting); break;
      case Criterion::weld: ends_with("limit", check.resisting); break;
      case Criterion::pin: ends_with("F", check.acting); break;
      case Criterion::buckling:
        ends_with("N", check.acting);
        ends_with("N_b,Rd", check.resisting);
        break;
      case Criterion::deflection:
        ends_with("w", check.acting);
        ends_with("w_lim", check.resisting);
        break;
    }
  });
  CHECK(seen.size() == criteria.size());
}
