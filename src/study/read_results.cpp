#include "read_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

#include "boxbeam/study/named_expression.hpp"

namespace boxbeam {
namespace {

std::string without_ends(std::string text) {
  const auto end = text.find_last_not_of(' ');
  text.resize(end == std::string::npos ? 0 : end + 1);
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// "f = a + 2*b" of variables, since there is no case that has results.
void read_formula(TableReader& table, const std::string& written, Study& study) {
  const std::size_t equals = written.find('=');
  const std::string name = without_ends(written.substr(0, equals));
  if (equals == std::string::npos || !is_identifier(name)) {
    table.problem(
        "columns",
        fmt::format("\"{}\" is no formula with a name, and the study has no case", written),
        "write \"f = a + 2*b\" of variables, or case = \"rig.toml\" in [study]");
    return;
  }
  const std::string formula = without_ends(written.substr(equals + 1));
  std::vector<std::string> names;
  try {
    names = names_in(formula);
    NamedExpression looked_at(formula, names);
  } catch (const std::invalid_argument& error) {
    table.problem("columns", fmt::format("\"{}\": {}", formula, error.what()),
                  "write a formula of variables: \"f = a + 2*b\"");
    return;
  }
  for (const std::string& one : names)
    if (std::none_of(study.variables.begin(), study.variables.end(),
                     [&](const Variable& of) { return of.name == one && of.words.empty(); }))
      table.problem("columns",
                    fmt::format("\"{}\" in \"{}\" is no number of a variable", one, formula),
                    "name it in [variables], or write case = \"rig.toml\" in [study]");
  study.columns.push_back(name);
  study.formulas.push_back(formula);
}

/// Names in it are variables and columns, whose numbers a row has.
void read_keep(TableReader& table, Study& study) {
  study.keep = without_ends(table.text(
      {"keep",
       "which designs have a row, all count: \"utilisation > 0.9\", of variables and columns"},
      ""));
  if (study.keep.empty()) return;
  std::vector<std::string> names;
  try {
    names = names_in(study.keep);
    NamedExpression looked_at(study.keep, names);
  } catch (const std::invalid_argument& error) {
    table.problem("keep", fmt::format("\"{}\": {}", study.keep, error.what()),
                  "write a condition: \"utilisation > 0.9\"");
    return;
  }
  for (const std::string& name : names) {
    const bool is_word = name == "verdict" || name == "governing";
    const bool is_column =
        std::find(study.columns.begin(), study.columns.end(), name) != study.columns.end();
    const bool is_variable =
        std::any_of(study.variables.begin(), study.variables.end(),
                    [&](const Variable& of) { return of.name == name && of.words.empty(); });
    if (is_variable || (is_column && !is_word)) continue;
    table.problem("keep", fmt::format("\"{}\" in \"{}\" is no number of a row", name, study.keep),
                  is_word ? "write \"utilisation > 1\""
                          : "name a variable, or a column that stands in \"columns\"");
  }
}

}  // namespace

bool is_identifier(const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(), plain);
}

void read_results(TableReader& root, Study& study) {
  TableReader results = root.table({"results", "what is kept of each design"}, false);
  const std::vector<std::string> written = results.texts(
      {"columns", "keys of results.json, \"verdict\", \"governing\"; without a case \"f = a + b\""},
      false);
  if (!study.case_file.empty())
    study.columns = written.empty() ? std::vector<std::string>{"verdict", "governing",
                                                               "utilisation", "beam.mass"}
                                    : written;
  else
    for (const std::string& column : written) read_formula(results, column, study);
  std::set<std::string> taken;
  for (const std::string& column : study.columns)
    if (!taken.insert(column).second)
      results.problem("columns", fmt::format("column \"{}\" stands twice", column),
                      "write each once");
  read_keep(results, study);
  for (const Variable& variable : study.variables)
    if (taken.count(variable.name) > 0)
      results.problem("columns", fmt::format("\"{}\" is a variable and a column", variable.name),
                      "give the variable another name");
  results.finish();
}

void read_indices(TableReader& root, Study& study) {
  if (!root.has({"indices", "which part of the scatter each variable makes (Sobol)"})) return;
  TableReader table = root.table("indices");
  IndexDemand demand;
  constexpr int fewest = 100, most = 100'000;
  const int written =
      table.whole_number({"resamples", "of the samples, from which the bounds of the indices come"},
                         static_cast<int>(demand.resamples));
  if (written < fewest || written > most)
    table.problem("resamples", fmt::format("\"resamples\" is {}", written),
                  fmt::format("write {} to {}", fewest, most));
  demand.resamples = static_cast<std::size_t>(std::max(fewest, written));
  bool scatters = false;
  for (const Variable& variable : study.variables) {
    scatters = scatters || variable.distribution.has_value();
    if (variable.values.size() + variable.words.size() > 1)
      root.problem(
          "variables",
          fmt::format("\"{}\" has several values, of which indices know no part", variable.name),
          "give it one value, or a distribution");
  }
  if (!scatters && !study.variables.empty())
    root.problem("variables", "no variable scatters, so that none has a part in the scatter",
                 "write distribution = \"uniform\" with min and max");
  if (study.correlation.size() > 0)
    root.problem(
        "correlation",
        "indices divide a variance among independent variables: of correlated ones no part "
        "is that of one alone",
        "leave [correlation] out, or tie variables by expression = \"...\" and let what "
        "they share scatter");
  if (!study.keep.empty())
    root.problem("results",
                 "indices rest on all designs, of which \"keep\" leaves some without a row",
                 "leave keep out");
  table.finish();
  study.indices = demand;
}

}  // namespace boxbeam
