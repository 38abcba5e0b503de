#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "boxbeam/study/named_expression.hpp"
#include "boxbeam/study/study.hpp"
#include "boxbeam/study/written_quantity.hpp"
#include "design_table.hpp"
#include "read_correlation.hpp"
#include "read_optimise.hpp"
#include "read_reliability.hpp"
#include "read_results.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t most_values = 1'000'000;

/// Numbers of one variable, which have one unit: that of the first of them.
class OneUnit {
 public:
  OneUnit(TableReader& table, Variable& variable) : table_(&table), variable_(&variable) {}

  bool is_whole() const { return whole_; }  ///< all that was asked for was there
  /// In the unit of the variable; 0 where it is none, which is said.
  double number(std::string_view key, const Node& node) {
    const std::optional<WrittenQuantity> written = quantity_written_in(node);
    if (!written) {
      table_->problem(key, fmt::format("\"{}\" is no number or quantity", key),
                      "write a number, or a text with its unit: \"8 mm\"");
      return none();
    }
    if (!known_) variable_->unit = written->unit;
    known_ = true;
    const std::optional<double> ratio = ratio_of_units(variable_->unit, written->unit);
    if (!ratio) {
      table_->problem(
          key,
          fmt::format("\"{}\" is not of the dimension of the values before it", to_text(*written)),
          "write all numbers of a variable in one unit");
      return none();
    }
    return written->value * *ratio;
  }
  /// Of a key that must be there.
  double at(TableReader& table, const Key& key) {
    if (!table.has(key)) {
      table.problem(key.name, fmt::format("\"{}\" is missing", key.name),
                    fmt::format("write {} = \"8 mm\"", key.name));
      return none();
    }
    return number(key.name, *table.peek(key.name));
  }

 private:
  double none() {
    whole_ = false;
    return 0.0;
  }

  TableReader* table_;
  Variable* variable_;
  bool known_ = false, whole_ = true;
};

void read_values(TableReader& table, Variable& variable) {
  const Node& node = *table.peek("values");
  if (node.kind != Node::Kind::array || node.items.empty()) {
    table.problem("values", "\"values\" is no list", "write values = [\"8 mm\", \"10 mm\"]");
    return;
  }
  if (node.items.size() > most_values) {
    table.problem("values", "\"values\" has more than a million entries", "take grid or samples");
    return;
  }
  const auto is_word = [](const Node& item) {
    return item.kind == Node::Kind::text && !quantity_written_in(item);
  };
  // Among words "6.10" is one of them.
  const auto may_be_word = [](const Node& item) {
    return item.kind == Node::Kind::text &&
           quantity_written_in(item).value_or(WrittenQuantity{}).unit.empty();
  };
  if (std::all_of(node.items.begin(), node.items.end(), may_be_word) &&
      std::any_of(node.items.begin(), node.items.end(), is_word)) {
    for (const Node& item : node.items) {
      variable.words.push_back(item.text);
      if (item.text.find('\n') != std::string::npos)
        table.problem("values", "a word of \"values\" has more than one line", "write it in one");
    }
    return;
  }
  OneUnit unit(table, variable);
  for (const Node& item : node.items) {
    if (is_word(item)) {
      table.problem(
          "values", fmt::format("\"{}\" in \"values\" is no number or quantity", item.text),
          "write a number, or a text with its unit, \"8 mm\"; words have a list of theirs");
      return;
    }
    variable.values.push_back(unit.number("values", item));
  }
}

/// The values that the designs of a table have, row by row.
void read_column(TableReader& table, const std::optional<TableOfDesigns>& designs,
                 Variable& variable) {
  const std::string name = table.text({"column", "of the study's table of designs"});
  variable.is_of_table = true;
  if (!designs) {
    table.problem("column", "the study has no table of designs",
                  "write table = \"designs.csv\" in [study]");
    return;
  }
  const TableOfDesigns::Cells* const column = designs->find(name);
  if (column == nullptr) {
    std::vector<std::string> names;
    for (const TableOfDesigns::Cells& of : designs->columns) names.push_back(of.name);
    table.problem("column", fmt::format("{} has no column \"{}\"", designs->path, name),
                  fmt::format("one of {}", fmt::join(names, ", ")));
    return;
  }
  variable.unit = column->unit;
  const auto is_word = [](const std::string& cell) { return !quantity_written_in(cell); };
  if (std::all_of(column->cells.begin(), column->cells.end(), is_word)) {
    variable.words = column->cells;
    return;
  }
  for (std::size_t row = 0; row < column->cells.size(); ++row) {
    const std::optional<WrittenQuantity> written = quantity_written_in(column->cells[row]);
    const std::optional<double> ratio = !written ? std::nullopt
                                        : written->unit.empty()
                                            ? std::optional(1.0)
                                            : ratio_of_units(variable.unit, written->unit);
    if (!ratio) {
      table.problem(
          "column",
          fmt::format("{}, line {}: \"{}\" is no number{}", designs->path, designs->lines[row],
                      column->cells[row], variable.unit.empty() ? "" : " in " + variable.unit),
          "write a number in the unit of the column, \"t [mm]\"");
      return;
    }
    variable.values.push_back(written->value * *ratio);
  }
}

void read_grid(TableReader& table, Variable& variable) {
  TableReader grid = table.table({"grid", "equal steps: from, to, count"});
  OneUnit unit(grid, variable);
  const double from = unit.at(grid, {"from", "the first value"});
  const double to = unit.at(grid, {"to", "the last one"});
  const int count = grid.whole_number({"count", "how many values"});
  if (count < 2 || static_cast<std::size_t>(count) > most_values) {
    grid.problem("count", fmt::format("a grid of {} values", count), "write two or more");
  } else {
    for (int k = 0; k < count; ++k)
      variable.values.push_back(k + 1 == count ? to : from + k * (to - from) / (count - 1));
    variable.is_grid = true;
  }
  grid.finish();
}

void read_distribution(TableReader& table, Variable& variable) {
  const std::vector<std::string> words{"normal",  "lognormal", "uniform",
                                       "weibull", "gumbel",    "exponential"};
  const auto kind = static_cast<DistributionKind>(
      table.choice({"distribution", "by which the value scatters"}, words));
  OneUnit unit(table, variable);
  const bool by_bounds = table.is_there("min") || table.is_there("max");
  if (by_bounds) {
    const double low = unit.at(table, {"min", "least value, of a uniform distribution"});
    const double high = unit.at(table, {"max", "largest value, of a uniform distribution"});
    if (kind != DistributionKind::uniform)
      table.problem("distribution", "\"min\" and \"max\" belong to a uniform distribution",
                    "write mean and sd");
    else if (unit.is_whole() && !(low < high))
      table.problem("min", "\"min\" is not below \"max\"", "write the smaller one as min");
    variable.distribution = Distribution{DistributionKind::uniform, low, high};
    return;
  }
  const double mean = unit.at(table, {"mean", "of all values"});
  const bool by_mean = kind == DistributionKind::exponential;
  const double sd = by_mean ? mean : unit.at(table, {"sd", "standard deviation"});
  if (!unit.is_whole()) return;
  const bool positive = kind == DistributionKind::lognormal || kind == DistributionKind::weibull ||
                        kind == DistributionKind::exponential;
  if (positive && !(mean > 0.0)) {
    table.problem("mean",
                  fmt::format("the mean of a {} distribution is above zero",
                              words[static_cast<std::size_t>(kind)]),
                  "write a mean above zero");
  } else if (!(sd > 0.0)) {
    table.problem("sd", "the standard deviation is not above zero",
                  "write sd = ... above zero; a value that does not scatter is none of a study");
  } else {
    variable.distribution = distribution_by_moments(kind, mean, sd);
  }
}

/// An expression names numbers of variables before it.
void require_known(TableReader& table, const std::string& expression,
                   const std::vector<Variable>& before) {
  try {
    for (const std::string& name : names_in(expression))
      if (std::none_of(before.begin(), before.end(),
                       [&](const Variable& of) { return of.name == name && of.words.empty(); }))
        table.problem(
            "expression",
            fmt::format("\"{}\" in \"{}\" is no number of a variable above it", name, expression),
            "name variables that stand before this one");
  } catch (const std::invalid_argument& error) {
    table.problem("expression", fmt::format("\"{}\": {}", expression, error.what()),
                  "write \"0.5*t + 2\"");
  }
}

/// The parts of a key, items of arrays by their number however it is written.
std::vector<std::string> parts_of_key(const std::string& key) {
  std::vector<std::string> parts = key_parts(key);
  for (std::string& part : parts)
    if (!part.empty() && part.find_first_not_of("0123456789") == std::string::npos)
      part.erase(0, std::min(part.find_first_not_of('0'), part.size() - 1));
  return parts;
}

/// No key is set twice, nor with what stands below it.
void take_keys(TableReader& table, const Variable& variable,
               std::set<std::vector<std::string>>& taken) {
  for (const std::string& key : variable.keys) {
    const std::vector<std::string> parts = parts_of_key(key);
    const auto other = std::find_if(taken.begin(), taken.end(), [&](const auto& of) {
      return std::equal(of.begin(), of.begin() + std::min(of.size(), parts.size()), parts.begin());
    });
    if (other == taken.end())
      taken.insert(parts);
    else if (*other == parts)
      table.problem("key", fmt::format("{} is set by two variables", key),
                    "tie one to the other: expression = \"...\"");
    else
      table.problem("key",
                    fmt::format("{} and {} are set, one of which is a part of the other", key,
                                fmt::join(*other, ".")),
                    "set what stands in it by itself");
  }
}

Variable read_variable(const std::string& name, TableReader& table,
                       const std::optional<TableOfDesigns>& designs,
                       const std::vector<Variable>& before,
                       std::set<std::vector<std::string>>& keys_taken) {
  Variable variable;
  variable.name = name;
  static const std::set<std::string> reserved{"design",      "status", "verdict", "governing",
                                              "utilisation", "_pi",    "_e"};
  constexpr std::array ways{"values", "grid", "column", "distribution", "expression"};
  if (!is_identifier(name) || reserved.count(name) > 0)
    table.problem("", fmt::format("\"{}\" cannot be the name of a variable", name),
                  "letters, digits and \"_\", a letter first; not that of a column");
  if (table.has({"key", "of the case, which takes the value"}))
    variable.keys.push_back(table.text("key"));
  if (table.has({"keys", "several that take it together"}))
    for (const std::string& key : table.texts("keys", true)) variable.keys.push_back(key);
  take_keys(table, variable, keys_taken);
  if (!table.says_one_of(
          {{{"values"}}, {{"grid"}}, {{"column"}}, {{"distribution"}}, {{"expression"}}})) {
    const bool says_any =
        std::any_of(ways.begin(), ways.end(), [&](const char* way) { return table.is_there(way); });
    table.problem("",
                  fmt::format("variable \"{}\" {} which values it takes", name,
                              says_any ? "says twice" : "does not say"),
                  "write one of values, grid, column, distribution, expression");
  }
  if (table.is_there("values")) {
    read_values(table, variable);
  } else if (table.is_there("grid")) {
    read_grid(table, variable);
  } else if (table.is_there("column")) {
    read_column(table, designs, variable);
  } else if (table.is_there("distribution")) {
    read_distribution(table, variable);
  } else if (table.is_there("expression")) {
    variable.expression =
        table.text({"expression", "of the numbers of variables above: \"0.5*t + 2\""});
    require_known(table, variable.expression, before);
    variable.unit = table.text({"unit", "of its number: \"mm\""}, "");
    if (!ratio_of_units(variable.unit, variable.unit))
      table.problem("unit", fmt::format("\"{}\" is no unit", variable.unit), "write \"mm\"");
  }
  table.finish();
  return variable;
}

std::string beside_study(const Study& study, const std::string& file) {
  return (std::filesystem::path(study.path).parent_path() / file).lexically_normal().string();
}

/// What a study has changed with it: its hash is that of both.
std::optional<TableOfDesigns> read_table(TableReader& of, Study& study) {
  const std::string written =
      of.text({"table", "of designs, comma-separated, beside the study: \"designs.csv\""}, "");
  if (written.empty()) return std::nullopt;
  std::optional<TableOfDesigns> table = read_design_table(beside_study(study, written));
  if (table->lines.size() > most_values)
    of.problem("table", "the table has more than a million rows", "share it among several studies");
  study.text += table->text;
  return table;
}

/// A study of expressions alone needs no case.
void read_case(TableReader& of, bool may_be_missing, Study& study) {
  const Key key{"case", "file of the case, beside the study"};
  study.case_written = may_be_missing ? of.text(key, "") : of.text(key);
  if (study.case_written.empty()) return;
  study.case_file = beside_study(study, study.case_written);
}

/// Who gives a case for a study is not told all keys that a study has not.
void require_study(const CaseDocument& document) {
  const Node* const of_case = document.root.find("case");
  if (of_case != nullptr && document.root.find("variables") == nullptr)
    throw InputError({document.problem_at(
        of_case->place, "this is a case, not a study",
        "boxbeam verify takes it; a study has [study] with case = \"...\", and [variables]")});
}

Study read(const CaseDocument& document, std::string text) {
  require_study(document);
  ProblemList problems(document);
  TableReader root(problems, document.root, "");
  Study study;
  study.path = document.path;
  study.text = std::move(text);
  study.name = std::filesystem::path(document.path).stem().string();
  const bool asks_elsewhere = root.is_there("limit_state") || root.is_there("optimise");
  const bool of_expressions =
      asks_elsewhere || root.is_there("indices") || root.is_there("results");
  TableReader of = root.table({"study", "what is studied, and how"}, !of_expressions);
  read_case(of, of_expressions, study);
  study.seed = static_cast<std::uint64_t>(of.whole_number({"seed", "of random numbers"}, 1));
  if (of.has({"samples", "of variables that scatter"}))
    study.samples = static_cast<std::size_t>(std::max(0, of.whole_number("samples")));
  study.sampling = static_cast<Sampling>(
      of.choice({"sampling", "how they are drawn"}, {"random", "latin hypercube", "sobol"}, 0));
  const std::optional<TableOfDesigns> designs = read_table(of, study);
  of.finish();
  std::set<std::vector<std::string>> keys_taken;
  TableReader variables = root.table({"variables", "what changes from design to design"});
  for (auto& [name, table] : variables.named_tables("a variable"))
    study.variables.push_back(read_variable(name, table, designs, study.variables, keys_taken));
  if (problems.empty() && designs &&
      std::none_of(study.variables.begin(), study.variables.end(),
                   [](const Variable& one) { return one.is_of_table; }))
    of.problem(
        "table", "no variable takes a column of the table",
        fmt::format("write column = \"{}\" in [variables.NAME]", designs->columns.front().name));
  if (problems.empty() && study.variables.empty())
    variables.problem("", "the study has no variables",
                      "write [variables.t] with key = \"sections.A1.flange\" and values = [...]");
  const bool scatters =
      std::any_of(study.variables.begin(), study.variables.end(),
                  [](const Variable& one) { return one.distribution.has_value(); });
  if (problems.empty() && scatters && study.samples == 0 && !asks_elsewhere)
    of.problem("samples", "variables scatter, but \"samples\" says not how many designs are drawn",
               "write samples = 1000 in [study]; or what is asked of them, [limit_state] for "
               "boxbeam reliability, [optimise] for boxbeam optimise");
  if (problems.empty() && !scatters && study.samples > 0)
    of.problem("samples", "no variable scatters: nothing is drawn",
               "give one a distribution, or leave out samples");
  read_correlation(root, study);
  read_optimise(root, study);
  read_results(root, study);
  read_indices(root, study);
  read_reliability(root, study);
  root.finish();
  problems.raise();
  return study;
}

}  // namespace

Study parse_study(const std::string& path, const std::string& text) {
  return read(parse_document(path, text, {}), text);
}

Study read_study(const std::string& path) {
  const CaseDocument document = read_document(path, {});
  std::string text;
  for (const std::string& line : document.lines.at(path)) text += line + "\n";
  return read(document, std::move(text));
}

}  // namespace boxbeam
