#include "read_reliability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "boxbeam/study/named_expression.hpp"
#include "boxbeam/study/written_quantity.hpp"

namespace boxbeam {
namespace {

/// A text or several: check = "fatigue", checks = ["fatigue", "yield"].
std::vector<std::string> one_or_several(TableReader& table, const Key& one, const Key& several) {
  std::vector<std::string> all;
  if (table.has(one)) all.push_back(table.text(one));
  if (table.has(several))
    for (const std::string& text : table.texts(several, true)) all.push_back(text);
  return all;
}

/// What an expression names must be there, and be a number.
void require_names(TableReader& table, const std::string& key, const std::string& expression,
                   const Study& study) {
  if (is_condition(expression))
    table.problem(key, fmt::format("\"{}\" is 1 or 0, which is never below zero", expression),
                  "write what is below zero where it fails: \"r - s\"");
  std::vector<std::string> names;
  try {
    names = names_in(expression);
  } catch (const std::invalid_argument& error) {
    table.problem(key, fmt::format("\"{}\": {}", expression, error.what()),
                  "write a formula of variables and columns: \"r - 2*s\"");
    return;
  }
  for (const std::string& name : names) {
    const auto variable =
        std::find_if(study.variables.begin(), study.variables.end(),
                     [&](const Variable& of) { return of.name == name && of.words.empty(); });
    const bool is_column =
        std::find(study.columns.begin(), study.columns.end(), name) != study.columns.end();
    if (variable != study.variables.end()) continue;
    if (study.case_file.empty())
      table.problem(key,
                    fmt::format("\"{}\" in \"{}\" is no number of the study, which has no case",
                                name, expression),
                    "name variables, or write case = \"rig.toml\" in [study]");
    else if (name == "verdict" || name == "governing" || !is_column)
      table.problem(key,
                    fmt::format("\"{}\" in \"{}\" is no number of the study", name, expression),
                    "name variables, and results that stand in [results] columns");
  }
}

void read_limit_state(TableReader& root, Study& study, ReliabilityDemand& demand) {
  TableReader table = root.table({"limit_state", "where a design fails: below zero"});
  demand.checks = one_or_several(
      table, {"check", "criterion whose use is above 1, \"fatigue\"; \"all\" for any"},
      {"checks", "several, of which any fails"});
  demand.expressions = one_or_several(
      table, {"expression", "of variables and columns, below zero where it fails: \"r - s\""},
      {"expressions", "several, of which any fails"});
  if (table.problems().empty() && demand.checks.empty() && demand.expressions.empty())
    table.problem("", "the limit state says not where a design fails",
                  "write check = \"fatigue\" or expression = \"r - s\"");
  const char* const key = table.is_there("check") ? "check" : "checks";
  if (!demand.checks.empty() && study.case_file.empty())
    table.problem(key, fmt::format("\"{}\" is one of a case, but the study has none", key),
                  "write case = \"rig.toml\" in [study], or expression = \"r - s\" here");
  for (const std::string& expression : demand.expressions)
    require_names(table, table.is_there("expression") ? "expression" : "expressions", expression,
                  study);
  table.finish();
}

void read_demand(TableReader& root, const Study& study, ReliabilityDemand& demand) {
  TableReader table = root.table({"reliability", "how its probability is found"}, false);
  std::vector<std::string> words;
  for (const ReliabilityMethod method : reliability_methods) words.emplace_back(to_text(method));
  for (const std::string& word :
       table.texts({"methods", "form, sorm, monte-carlo, importance, subset"}, false)) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end())
      table.problem("methods", fmt::format("\"{}\" is no method", word),
                    fmt::format("one of {}", fmt::join(words, ", ")));
    else
      demand.methods.push_back(
          reliability_methods[static_cast<std::size_t>(found - words.begin())]);
  }
  using enum ReliabilityMethod;
  if (demand.methods.empty()) demand.methods = {form, sorm, importance};
  const auto count = [&](const Key& key, std::size_t fallback, int fewest) {
    const int number = table.whole_number(key, static_cast<int>(fallback));
    if (number >= fewest) return static_cast<std::size_t>(number);
    table.problem(key.name, fmt::format("\"{}\" is below {}", key.name, fewest),
                  fmt::format("write {} = {}", key.name, std::max<std::size_t>(fallback, 100)));
    return fallback;
  };
  // Of a case each evaluation verifies it, and rounding and the search along the beam stand in its
  // results: fewer of them, and longer steps.
  if (!study.case_file.empty()) {
    demand.starts = 4;
    demand.probes = 100;
    demand.samples = 4000;
    demand.per_level = 500;
    demand.step = 0.01;
    demand.tolerance = 1e-3;
  }
  if (study.samples > 0) demand.samples = study.samples;
  demand.samples = count({"samples", "at most, of each simulation"}, demand.samples, 100);
  demand.per_level = count({"per_level", "of them in a level of subset simulation"},
                           std::min(demand.per_level, demand.samples), 20);
  demand.starts =
      count({"starts", "of searches for design points, beside the medians"}, demand.starts, 0);
  demand.variation =
      table.number({"variation", "coefficient of variation of p_f at which a simulation ends"},
                   demand.variation, "0.05");
  if (demand.variation >= 1.0)
    table.problem("variation", "a coefficient of variation of 1 or more says nothing of p_f",
                  "write variation = 0.05");
  if (table.has({"years", "of service, over which p_f counts"}))
    demand.years = table.number("years", {}, "30");
  table.finish();
}

/// Variables whose probability is asked for: that scatter, the others with one value.
void require_one_value_of_others(TableReader& root, const Study& study) {
  bool scatters = false;
  for (const Variable& variable : study.variables) {
    scatters = scatters || variable.distribution.has_value();
    if (variable.values.size() + variable.words.size() > 1)
      root.problem("variables",
                   fmt::format("\"{}\" has several values, of which the limit state would need one",
                               variable.name),
                   "give it one value, or a distribution");
    if (study.case_file.empty() && !variable.keys.empty())
      root.problem("variables",
                   fmt::format("\"{}\" is a key of a case, but the study has none", variable.name),
                   "write case = \"rig.toml\" in [study]");
  }
  if (!scatters && !study.variables.empty())
    root.problem("variables", "no variable scatters, so that nothing has a probability",
                 "write distribution = \"normal\" with mean and sd");
}

}  // namespace

void read_reliability(TableReader& root, Study& study) {
  if (!root.is_there("limit_state")) {
    if (root.is_there("reliability"))
      root.problem("reliability", "the study says not where a design fails",
                   "write [limit_state] with check = \"fatigue\" or expression = \"r - s\"");
    return;
  }
  ReliabilityDemand demand;
  read_limit_state(root, study, demand);
  read_demand(root, study, demand);
  require_one_value_of_others(root, study);
  study.reliability = std::move(demand);
}

}  // namespace boxbeam
