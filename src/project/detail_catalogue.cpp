#include "boxbeam/project/detail_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/sn_catalogue.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "catalogue_data.hpp"

namespace boxbeam {
namespace {

/// What stands before the rows.
struct Head {
  std::vector<FactDefinition> facts;
  std::array<std::array<double, 2>, 2> gamma_Mf{};  ///< by method and consequence
};

constexpr const char* file_name = "details-en-1993-1-9.toml";
constexpr std::string_view file = catalogue_data::details;
/// Where a row begins.
constexpr std::string_view row_mark = "\n[[rows]]\n";

/// The fact that says which stress of a detail is judged; every row has it by its place.
constexpr const char* stress_fact = "stress";

const char* judged_stress(StressPlace where) {
  switch (where) {
    case StressPlace::gross:
    case StressPlace::net: return "nominal";
    case StressPlace::throat: return "weld";
    case StressPlace::hot_spot: return "hot spot";
  }
  return "";
}

/// No place of a section: such rows are told apart by their word for the stress alone.
constexpr std::size_t local_at = 4;

FactDefinition read_fact(const std::string& name, TableReader& table) {
  FactDefinition fact;
  fact.name = name;
  if (table.has("number")) {
    fact.kind = table.choice("number", {"length", "ratio"}) == 0 ? FactDefinition::Kind::length
                                                                 : FactDefinition::Kind::ratio;
  } else {
    fact.words = table.texts("words", true);
  }
  fact.fixed = table.boolean("fixed", false);
  fact.means = table.text("means", "");
  table.finish();
  return fact;
}

/// "butt | fillet", each one of the fact's words.
std::vector<std::string> read_words(TableReader& table, const FactDefinition& fact) {
  constexpr std::string_view bar = " | ";
  const std::string text = table.text(fact.name);
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(bar, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    if (std::find(fact.words.begin(), fact.words.end(), words.back()) == fact.words.end()) {
      table.problem(fact.name, fmt::format("\"{}\" is no word of this fact", words.back()));
    }
    begin = end + bar.size();
  }
  return words;
}

FactRange read_range(TableReader table, FactDefinition::Kind kind) {
  FactRange range;
  const auto end = [&](const char* key, double& limit, bool& belongs, bool with) {
    if (!table.has(key)) return;
    limit = kind == FactDefinition::Kind::length ? table.positive(key, wanted::length)
                                                 : table.number(key);
    belongs = with;
  };
  end("from", range.from, range.with_from, true);
  end("over", range.from, range.with_from, false);
  end("up_to", range.to, range.with_to, true);
  end("under", range.to, range.with_to, false);
  table.finish();
  return range;
}

CategoryInterpolation read_interpolation(TableReader table, double from) {
  CategoryInterpolation read{table.text("fact"), from, table.number("to")};
  table.finish();
  return read;
}

DetailRow read_row(TableReader& table, const std::vector<FactDefinition>& facts) {
  DetailRow row;
  row.id = table.text("id");
  row.category = table.number("category");
  row.asterisk = table.boolean("asterisk", false);
  row.kind = static_cast<StressKind>(table.choice("kind", {"direct", "shear"}, 0));
  row.slope = table.number("slope", 0.0);
  row.endless = table.boolean("endless", false);
  if (table.has("interpolate"))
    row.interpolation = read_interpolation(table.table("interpolate"), row.category);
  const std::size_t where =
      table.choice("where", {"gross", "net", "throat", "hot spot", local_stress}, 0);
  const bool local = where == local_at;
  if (!local) row.where = static_cast<StressPlace>(where);
  row.size_effect = static_cast<SizeEffect>(
      table.choice("size_effect", {"none", "butt", "eccentric butt", "bolt"}, 0));
  row.welded = table.boolean("welded", true);
  row.unconfirmed = table.boolean("unconfirmed", false);
  row.what = table.text("what");
  row.workmanship = table.text("workmanship", "");
  row.note = table.text("note", "");
  row.conditions.emplace(stress_fact,
                         std::vector<std::string>{local ? local_stress : judged_stress(row.where)});
  TableReader conditions = table.table("facts");
  for (const Node::Member& member : conditions.members()) {
    const auto fact = std::find_if(facts.begin(), facts.end(), [&](const FactDefinition& each) {
      return each.name == member.key;
    });
    if (fact == facts.end()) continue;
    if (fact->kind == FactDefinition::Kind::words) {
      row.conditions.emplace(fact->name, read_words(conditions, *fact));
    } else {
      row.conditions.emplace(fact->name, read_range(conditions.table(fact->name), fact->kind));
    }
  }
  conditions.finish();
  table.finish();
  return row;
}

Head read_head() {
  const CaseDocument document =
      parse_document(file_name, std::string(file.substr(0, file.find(row_mark))), {});
  ProblemList problems(document);
  TableReader root(problems, document.root, "");
  Head head;
  for (auto& [name, table] : root.table("facts").named_tables())
    head.facts.push_back(read_fact(name, table));
  TableReader factors = root.table("partial_factors");
  factors.text("source");
  constexpr std::array methods{"damage_tolerant", "safe_life"};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    TableReader method = factors.table(methods[i]);
    head.gamma_Mf[i] = {method.number("low"), method.number("high")};
    method.finish();
  }
  factors.finish();
  root.finish();
  problems.raise();
  return head;
}

const Head& head() {
  static const Head all = read_head();
  return all;
}

std::vector<DetailRow> read_rows(std::string_view text) {
  const CaseDocument document = parse_document(file_name, std::string(text), {});
  ProblemList problems(document);
  TableReader root(problems, document.root, "");
  std::vector<DetailRow> rows;
  for (TableReader& table : root.tables("rows", true))
    rows.push_back(read_row(table, head().facts));
  root.finish();
  problems.raise();
  return rows;
}

std::string number_text(const FactDefinition& fact, double number) {
  return fact.kind == FactDefinition::Kind::length ? fmt::format("{:.6g} mm", number * 1e3)
                                                   : fmt::format("{:.3g}", number);
}

}  // namespace

const std::vector<FactDefinition>& fact_definitions() { return head().facts; }

const std::vector<DetailRow>& detail_rows() {
  static const std::vector<DetailRow> all = read_rows(file.substr(file.find(row_mark)));
  return all;
}

std::vector<DetailRow> detail_rows_of(std::string_view id) {
  std::vector<DetailRow> rows;
  const std::string first = fmt::format("id = \"{}\"\n", id);
  for (std::size_t at = file.find(row_mark); at != std::string_view::npos;) {
    const std::size_t end = std::min(file.find(row_mark, at + 1), file.size());
    if (file.substr(at + row_mark.size()).starts_with(first)) {
      for (DetailRow& row : read_rows(file.substr(at, end - at))) rows.push_back(std::move(row));
    }
    at = end < file.size() ? end : std::string_view::npos;
  }
  return rows;
}

std::vector<std::string> fixed_facts() {
  std::vector<std::string> names;
  for (const FactDefinition& fact : fact_definitions()) {
    if (fact.fixed) names.push_back(fact.name);
  }
  return names;
}

SnCurve curve_of(const DetailRow& row, bool raise_asterisk) {
  if (row.slope > 0.0) {
    SnCurve curve = row.kind == StressKind::direct ? en_1993_1_9_direct(row.category)
                                                   : en_1993_1_9_shear(row.category);
    curve.name = fmt::format("{}, m = {:g}", category_name_of(row), row.slope);
    curve.constant_amplitude_limit.reset();
    if (row.endless) curve.cut_off.reset();
    curve.branches = {{row.slope, curve.cut_off.value_or(std::numeric_limits<double>::infinity())}};
    curve.source = "table " + row.id.substr(0, row.id.find('/'));
    return curve;
  }
  const char* family = row.where == StressPlace::hot_spot ? "EN 1993-1-9 hot spot" : "EN 1993-1-9";
  const std::string name =
      raise_asterisk && row.asterisk ? category_name_of(row) : fmt::format("{:g}", row.category);
  const auto curve = find_curve(family, name, row.kind);
  assert(curve);
  return *curve;
}

std::string to_text(const FactChange& change) {
  if (const auto* words = std::get_if<std::vector<std::string>>(&change.to)) {
    return fmt::format("{} = {}", change.fact, fmt::join(*words, " or "));
  }
  const auto found =
      std::find_if(fact_definitions().begin(), fact_definitions().end(),
                   [&](const FactDefinition& fact) { return fact.name == change.fact; });
  assert(found != fact_definitions().end());
  const auto& range = std::get<FactRange>(change.to);
  std::string text = change.fact;
  if (std::isfinite(range.from)) {
    text +=
        fmt::format(" {} {}", range.with_from ? "from" : "over", number_text(*found, range.from));
  }
  if (std::isfinite(range.to)) {
    text += fmt::format(" {} {}", range.with_to ? "up to" : "under", number_text(*found, range.to));
  }
  return text;
}

std::string to_text(const Raise& raise) {
  std::vector<std::string> changes;
  for (const FactChange& change : raise.changes) changes.push_back(to_text(change));
  return fmt::format("{}: {}, {}", fmt::join(changes, ", "), raise.row.id,
                     category_name_of(raise.row));
}

double recommended_gamma_Mf(AssessmentMethod method, Consequence consequence) {
  return head().gamma_Mf[static_cast<std::size_t>(method)][static_cast<std::size_t>(consequence)];
}

}  // namespace boxbeam
