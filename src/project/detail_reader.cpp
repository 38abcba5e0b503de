#include "boxbeam/project/detail_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/project/plate_detail.hpp"
#include "boxbeam/project/sn_catalogue.hpp"

namespace boxbeam {
namespace {

const char* word_of(StressKind kind) { return kind == StressKind::direct ? "direct" : "shear"; }

Facts read_facts(TableReader& table) {
  Facts facts;
  if (!table.has("facts")) return facts;
  TableReader given = table.table(
      {"facts",
       "what is known of the detail: the rows that it can be, of which the weakest counts"});
  for (const FactDefinition& fact : fact_definitions()) {
    const Key key{fact.name, fact.means};
    switch (fact.kind) {
      case FactDefinition::Kind::words:
        if (given.has_choice(key, fact.words))
          facts.emplace(fact.name, fact.words[given.choice(key, fact.words)]);
        break;
      case FactDefinition::Kind::length:
        if (given.has_quantity(key, wanted::length))
          facts.emplace(fact.name, given.positive(key, wanted::length));
        break;
      case FactDefinition::Kind::ratio:
        if (given.has_number(key)) facts.emplace(fact.name, given.number(key));
        break;
    }
  }
  given.finish();
  return facts;
}

/// The entries of one row.
std::vector<DetailRow> entries_of(const std::string& id) {
  std::vector<DetailRow> entries;
  std::copy_if(detail_rows().begin(), detail_rows().end(), std::back_inserter(entries),
               [&](const DetailRow& row) { return row.id == id; });
  return entries;
}

/// Who names a row says all that every entry of it asks for in one word.
void add_implied(Facts& facts, const std::vector<DetailRow>& entries, StressKind kind) {
  for (const FactDefinition& fact : fact_definitions()) {
    std::optional<std::vector<std::string>> common;
    const bool same = std::all_of(entries.begin(), entries.end(), [&](const DetailRow& row) {
      if (row.kind != kind) return true;
      const auto found = row.conditions.find(fact.name);
      if (found == row.conditions.end()) return false;
      const auto* words = std::get_if<std::vector<std::string>>(&found->second);
      if (words == nullptr || words->size() != 1 || (common && *common != *words)) return false;
      common = *words;
      return true;
    });
    if (same && common) facts.emplace(fact.name, common->front());
  }
}

/// Facts without any one of which some row fits.
std::vector<std::string> contradicting(const std::vector<DetailRow>& rows, StressKind kind,
                                       const Facts& facts) {
  std::vector<std::string> names;
  for (const auto& [name, value] : facts) {
    Facts fewer = facts;
    fewer.erase(name);
    if (!assess(rows, kind, fewer).candidates.empty()) names.push_back(name);
  }
  return names;
}

const char* sizes_wanted(SizeEffect effect) {
  switch (effect) {
    case SizeEffect::none: return "";
    case SizeEffect::butt: return "\"thickness\"";
    case SizeEffect::eccentric_butt:
      return "\"thickness\", \"thicker_thickness\", \"eccentricity\"";
    case SizeEffect::bolt: return "\"bolt_diameter\"";
  }
  return "";
}

void check_sizes(TableReader& table, std::string_view key, const DetailAssessment& assessment,
                 const Facts& facts) {
  for (const DetailRow& row : assessment.candidates) {
    if (size_factor_of(row, facts)) continue;
    table.problem(key,
                  fmt::format("the strength of row {}, which may apply, depends on {}", row.id,
                              sizes_wanted(row.size_effect)),
                  "write the lengths in facts, or a fact that excludes the row");
    return;
  }
}

/// By a row, by facts, or by both.
void read_from_tables(TableReader& table, StressKind kind, bool raise_asterisk,
                      const std::vector<Length>& plates, Detail& detail) {
  const bool by_row = table.has("row");
  const char* key = by_row ? "row" : "facts";
  const std::size_t before = table.problems().size();
  std::vector<DetailRow> rows = detail_rows();
  Facts facts = read_facts(table);
  if (by_row) {
    const std::string id = table.text({"row", "table and row of EN 1993-1-9, \"8.2/6\""});
    rows = entries_of(id);
    if (rows.empty() && !id.empty()) {
      std::vector<std::string> ids;
      for (const DetailRow& row : detail_rows()) ids.push_back(row.id);
      const std::string near = nearest_word(id, ids);
      table.problem("row", fmt::format("there is no row \"{}\" in the tables of details", id),
                    near.empty() ? "write table and row, \"8.2/6\""
                                 : fmt::format("did you mean \"{}\"?", near));
    }
    if (!rows.empty() && std::none_of(rows.begin(), rows.end(),
                                      [&](const DetailRow& row) { return row.kind == kind; })) {
      table.problem("row", fmt::format("row {} has no category for {} stress", id, word_of(kind)),
                    "write kind = \"direct\" or kind = \"shear\", as the row has it");
    }
    add_implied(facts, rows, kind);
  }
  facts.emplace("stress", "nominal");
  if (facts.at("stress") == FactValue(local_stress)) {
    const std::vector<DetailRow> local = assess(rows, kind, facts).candidates;
    const std::string id = local.empty() ? "8.10/2" : local.front().id;
    table.problem(
        key,
        "what wheels press into a web or a deck, what a stud shears and what there is "
        "beside a cut-out are no stresses of the beam's sections, which its details are for",
        fmt::format("judge its history by itself: boxbeam fatigue HISTORY.csv --{} {}",
                    kind == StressKind::shear ? "shear-detail" : "detail", id));
  }
  if (table.problems().size() != before) return;
  DetailInPlates known{facts, assess(rows, kind, facts).candidates, raise_asterisk,
                       detail.compression_reduced, !detail.name.empty()};
  const bool by_plate = !plates.empty() && !facts.contains("thickness");
  DetailAssessment assessment{known.rows, {}};
  // The thickest of the plates that a row is for: what stands for all where none is asked for.
  if (by_plate) {
    for (const Length& plate : plates) {
      facts.insert_or_assign("thickness", plate.value());
      assessment = assess(known.rows, kind, facts);
      if (!assessment.candidates.empty()) break;
    }
  } else if (!known.rows.empty()) {
    assessment = assess(known.rows, kind, facts);
  }
  if (assessment.candidates.empty()) {
    const std::vector<std::string> names = contradicting(rows, kind, facts);
    table.problem(
        key,
        fmt::format("{} for {} stress fits these facts",
                    by_row ? "no part of this row" : "no row of the tables", word_of(kind)),
        names.empty() ? "write fewer facts"
                      : fmt::format("look again at \"{}\"", fmt::join(names, "\", \"")));
    return;
  }
  check_sizes(table, key, assessment, facts);
  const DetailRow& row = assessment.candidates.front();
  if (raise_asterisk && !row.asterisk) {
    table.problem(
        "raise_asterisk",
        fmt::format("category {} of row {} has no asterisk", category_name_of(row), row.id),
        "take it away");
  }
  take_governing(detail, assessment, facts, known);
  if (by_plate) detail.in_plates = std::move(known);
  detail.raises = raises_of(detail_rows(), assessment.candidates, facts, fixed_facts());
}

/// Those without an asterisk, of direct stress, which has those of shear among them.
std::vector<std::string> categories() {
  std::vector<std::string> plain;
  for (const std::string& name : names_of("EN 1993-1-9", StressKind::direct)) {
    if (!name.ends_with('*')) plain.push_back(name);
  }
  return plain;
}

void read_category(TableReader& table, StressKind kind, bool raise_asterisk, Detail& detail) {
  const std::size_t before = table.problems().size();
  const int category = table.whole_number(
      {"category", "detail category of EN 1993-1-9, the strength at 2e6 cycles in MPa"}, {},
      categories());
  if (table.problems().size() != before) return;
  const std::string name = fmt::format("{}{}", category, raise_asterisk ? "*" : "");
  const auto curve = find_curve("EN 1993-1-9", name, kind);
  if (!curve) {
    table.problem("category",
                  fmt::format("{} is no detail category for {} stress", name, word_of(kind)),
                  fmt::format("one of {}", fmt::join(names_of("EN 1993-1-9", kind), ", ")));
    return;
  }
  if (detail.name.empty()) detail.name = fmt::format("category {}", name);
  detail.curve = *curve;
}

}  // namespace

Detail read_detail(TableReader& table, const std::vector<Length>& plates) {
  Detail detail;
  detail.name = table.text({"name", "of the detail, in reports"}, "");
  detail.compression_reduced = table.boolean(
      {"stress_relieved", "not welded, or stress relieved: compression counts 60 % (7.2.1)"},
      false);
  const auto kind = static_cast<StressKind>(
      table.choice({"kind", "which stress it resists"}, {"direct", "shear"}, 0));
  const bool raise_asterisk = table.boolean(
      {"raise_asterisk", "the category with an asterisk is raised by one (7.1, note 3)"}, false);
  const bool one = table.says_one_of({{{"category"}}, {{"row", "facts"}, false}});
  const bool as_such = table.has("category");
  if (!one) {
    table.problem(as_such ? "category" : "",
                  as_such ? "a detail has a category, or a row and facts, not both"
                          : "a detail wants a row, facts or a category",
                  "write row = \"8.2/6\", facts = { part = \"seam\" } or category = 100");
    table.accept_all();
    return detail;
  }
  if (as_such) {
    read_category(table, kind, raise_asterisk, detail);
  } else {
    read_from_tables(table, kind, raise_asterisk, plates, detail);
  }
  return detail;
}

}  // namespace boxbeam
