#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/comparison.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "json_number.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using report::Cell;
using report::Mark;

Mark mark_of(Agreement agreement) {
  switch (agreement) {
    case Agreement::agrees: return Mark::passes;
    case Agreement::explained: return Mark::not_applicable;
    case Agreement::differs: return Mark::fails;
  }
  return Mark::none;
}

std::string with_unit(std::string number, const std::string& unit) {
  if (!unit.empty()) number += " " + unit;
  return number;
}

/// The program's value as the published one is written: in its unit, with its digits.
std::string ours_text(const ComparedValue& row) {
  constexpr int fewest = 4, most = 8;
  const int digits = std::clamp(row.published.digits, fewest, most);
  return with_unit(text::significant(row.ours / row.published.scale, digits), row.published.unit);
}

/// In per cent where the tolerance is, else in the published value's unit.
std::string difference_text(const ComparedValue& row) {
  constexpr int digits = 2;
  const bool relative = row.published.tolerance.relative;
  const double difference = relative ? 100.0 * row.difference / std::abs(row.published.value.value)
                                     : row.difference / row.published.scale;
  std::string text = text::significant(difference, digits);
  if (difference > 0.0 && text != "0") text.insert(0, "+");
  return with_unit(std::move(text), relative ? "%" : row.published.unit);
}

/// The number of each reason in the list of reasons, which grows.
std::string note_of(const std::string& reason, std::vector<std::string>& reasons) {
  if (reason.empty()) return "";
  const auto found = std::find(reasons.begin(), reasons.end(), reason);
  const auto place = found - reasons.begin();
  if (found == reasons.end()) reasons.push_back(reason);
  return fmt::format("({})", place + 1);
}

/// The rows of one status, in the order of the file.
report::Table table_of(const Comparison& comparison, Agreement agreement,
                       std::vector<std::string>& reasons) {
  report::Table table;
  table.header = {"result", "published", "ours", "difference", "tolerance", "source", "reason"};
  for (const ComparedValue& row : comparison.rows) {
    if (row.agreement != agreement) continue;
    table.rows.push_back(
        {Cell{row.key, {}}, Cell{row.published.written, row.published.value.value},
         Cell{ours_text(row), row.ours}, Cell{difference_text(row), row.difference},
         Cell{row.published.tolerance.written, row.tolerance}, Cell{row.published.source, {}},
         Cell{note_of(row.published.reason, reasons), {}}});
    table.marks.push_back(mark_of(agreement));
  }
  return table;
}

std::string heading_of(Agreement agreement) {
  switch (agreement) {
    case Agreement::agrees: return "Within the tolerance";
    case Agreement::explained: return "Beyond the tolerance, with a reason";
    case Agreement::differs: return "Beyond the tolerance, without a reason";
  }
  return "";
}

std::string counts_text(const Comparison& comparison) {
  return fmt::format("{} values: {} agree, {} differ with a reason, {} differ without",
                     comparison.rows.size(), comparison.count(Agreement::agrees),
                     comparison.count(Agreement::explained), comparison.count(Agreement::differs));
}

}  // namespace

report::Chapter comparison_chapter(const Comparison& comparison) {
  report::Chapter chapter;
  chapter.title = "Published values";
  chapter.blocks.push_back(report::Paragraph{
      fmt::format("{} ({}). Ours stands in the unit of the published value; a difference is ours "
                  "less published.",
                  counts_text(comparison), comparison.path)});
  std::vector<std::string> reasons;
  for (const Agreement status : {Agreement::differs, Agreement::explained, Agreement::agrees}) {
    report::Table table = table_of(comparison, status, reasons);
    if (table.rows.empty()) continue;
    chapter.blocks.push_back(report::Subheading{heading_of(status)});
    chapter.blocks.push_back(std::move(table));
  }
  if (reasons.empty()) return chapter;
  chapter.blocks.push_back(report::Subheading{"Reasons"});
  report::Bullets list;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    list.items.push_back(fmt::format("({}) {}", i + 1, reasons[i]));
  }
  chapter.blocks.push_back(std::move(list));
  return chapter;
}

report::Document comparison_document(const Project& project, const Comparison& comparison) {
  report::Document document;
  document.title = project.name;
  document.subtitle = fmt::format("{}: published values beside the program's", project.title);
  document.date = report_date();
  document.program = fmt::format("boxbeam {}", version);
  document.input_sha256 = project.sha256;
  document.verdict = !comparison.passes()                          ? "DIFFERS"
                     : comparison.count(Agreement::explained) == 0 ? "AGREES"
                                                                   : "AGREES OR IS EXPLAINED";
  document.mark = comparison.passes() ? Mark::passes : Mark::fails;
  document.facts.entries = {{"case file", project.path},
                            {"published", comparison.path},
                            {"values", counts_text(comparison)}};
  if (!project.overrides.empty()) {
    document.facts.entries.emplace_back("overrides",
                                        fmt::format("{}", fmt::join(project.overrides, "; ")));
  }
  document.facts.entries.emplace_back("loads by", to_text(project.dynamics));
  document.chapters.push_back(comparison_chapter(comparison));
  return document;
}

std::string comparison_text(const Project& project, const Comparison& comparison) {
  return report::text_of(comparison_document(project, comparison));
}

std::string comparison_json(const Project& project, const Comparison& comparison) {
  Json rows = Json::array();
  for (const ComparedValue& row : comparison.rows) {
    rows.push_back({{"result", row.key},
                    {"published", finite(row.published.value.value)},
                    {"ours", finite(row.ours)},
                    {"difference", finite(row.difference)},
                    {"tolerance", finite(row.tolerance)},
                    {"unit", row.unit},
                    {"status", to_text(row.agreement)},
                    {"reason", row.published.reason},
                    {"source", row.published.source},
                    {"line", row.published.line}});
  }
  const Json document = {{"schema", "boxbeam.comparison/1"},
                         {"case", project.name},
                         {"version", version},
                         {"input_sha256", project.sha256},
                         {"table", comparison.path},
                         {"agree", comparison.count(Agreement::agrees)},
                         {"explained", comparison.count(Agreement::explained)},
                         {"differ", comparison.count(Agreement::differs)},
                         {"rows", std::move(rows)}};
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
