#include "boxbeam/report/solution_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document_fields.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

std::string result_text(double result, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.6g}", result) : fmt::format("{:.6g} {}", result, unit);
}

std::string amount_text(const WrittenQuantity& amount) {
  const std::string number = fmt::format("{:.6g}", amount.value);
  return amount.unit.empty() ? number : number + " " + amount.unit;
}

/// With digits enough that it gives what is wanted when it is put into the case.
std::string value_text(const WrittenQuantity& quantity) {
  const std::string number = fmt::format("{:.12g}", quantity.value);
  return quantity.unit.empty() ? number : number + " " + quantity.unit;
}

}  // namespace

report::MarkedText solution_text(const Solution& solution) {
  const std::string wanted = result_text(solution.wanted, solution.result_unit);
  std::string text = layout::heading(fmt::format("{}: {} such that {} = {}", solution.case_file,
                                                 solution.key, solution.result, wanted));
  text += layout::entry("between",
                        fmt::format("{} and {}, verified {} times", amount_text(solution.from),
                                    amount_text(solution.to), solution.search.trials));
  if (solution.own && solution.own_result)
    text += layout::entry("as it is",
                          fmt::format("{}: {} is {}", amount_text(*solution.own), solution.result,
                                      result_text(*solution.own_result, solution.result_unit)));
  text += "\n";
  if (solution.values.empty()) {
    text += layout::paragraph(fmt::format("no value: {}", solution.reason));
    return text;
  }
  layout::Table table({solution.key, solution.result, "verdict", "most used check", "use [%]"});
  for (const SolvedValue& of : solution.values) {
    table.row({value_text(of.value), result_text(of.result, solution.result_unit), of.verdict,
               of.governing, fmt::format("{:.1f}", 100.0 * of.utilisation)});
  }
  text += table.text();
  constexpr double at_limit = 1e-9;
  if (std::any_of(solution.values.begin(), solution.values.end(),
                  [](const SolvedValue& of) { return std::abs(of.utilisation - 1.0) < at_limit; }))
    text += layout::paragraph(
        "Used 100 %: what is wanted is the limit itself, where the last digit decides between pass "
        "and fail.");
  for (const SolvedValue& of : solution.values)
    if (!of.gate.empty())
      text += layout::paragraph(
          fmt::format("At {} a gate stands against the stresses, which count for nothing: {}",
                      amount_text(of.value), of.gate));
  const Roots& search = solution.search;
  for (const JumpOver& jump : search.jumps) {
    text += layout::paragraph(
        fmt::format("At {} the result jumps from {:.6g} to {:.6g}, past the wanted one.",
                    amount_text({jump.value, solution.from.unit}), jump.before, jump.behind));
  }
  if (search.failed > 0)
    text += layout::paragraph(fmt::format(
        "{} of {} values cannot be verified, the first at {}: {}", search.failed, search.trials,
        amount_text({search.failed_at, solution.from.unit}), search.first_trouble));
  return text;
}

void report::put_solution(Fields& to, const Solution& solution) {
  const std::string& unit = solution.from.unit;
  to.constant("schema", "boxbeam.solution/1");
  to.text({"key", "of the case"}, solution.key);
  to.text({"result", "that is asked for"}, solution.result);
  to.text({"result_unit", "SI; 1 without"}, solution.result_unit);
  to.number_in({"wanted", "value of the result"}, "", "result_unit", solution.wanted);
  to.text({"unit", "of the key, as in the case; empty without"}, unit);
  to.number_in({"from", "where it was looked for"}, "", "unit", solution.from.value);
  to.number_in("to", "", "unit", solution.to.value);
  to.list(
      {"roots", "all values found, ascending"}, "", solution.values,
      [&](Fields& of, const SolvedValue& at) {
        of.number_in("value", "", "unit", at.value.value);
        of.text("unit", at.value.unit);
        of.number_in({"result", "there"}, "", "result_unit", at.result);
        of.word({"verdict", "of the whole case there"}, at.verdict,
                {"pass", "fail", "not applicable"});
        of.text({"governing", "id of the check that is used most"}, at.governing);
        of.number({"utilisation", "of it"}, "1", at.utilisation);
        of.text({"gate", "why stresses there count for nothing; empty where they count"}, at.gate);
      });
  to.text({"reason", "why there is none; empty where there is one"}, solution.reason);
  to.list({"jumps", "where the result passes the wanted one by a jump"}, "", solution.search.jumps,
          [](Fields& of, const JumpOver& jump) {
            of.number_in("value", "", "unit", jump.value);
            of.number_in({"before", "result"}, "", "result_unit", jump.before);
            of.number_in({"behind", "result"}, "", "result_unit", jump.behind);
            of.number_in({"apart", "of the two values, where these are whole numbers; else 0"}, "",
                         "unit", jump.apart);
          });
  to.whole({"verifications", "that it took"}, solution.search.trials);
  to.whole({"failed", "of them"}, solution.search.failed);
}

std::string solution_json(const Solution& solution) {
  return report::document_text(
      [&](report::Fields fields) { report::put_solution(fields, solution); });
}

}  // namespace boxbeam
