#include "boxbeam/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "document_fields.hpp"
#include "text_layout.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using report::Cell;
using report::Mark;

/// "18.1e3" of "18.1e3 mm^2".
std::string number_of(const std::string& written, const std::string& unit) {
  std::string number = written.substr(0, written.size() - unit.size());
  while (number.ends_with(' ')) number.pop_back();
  return number;
}

/// A number [SI] as the published one is written: in its unit, with its power of ten.
std::string written_like(const PublishedValue& published, double value, int digits) {
  const std::string number = number_of(published.written, published.unit);
  const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
  double one = published.scale;
  if (exponent < number.size()) one *= std::pow(10.0, std::stoi(number.substr(exponent + 1)));
  std::string text = text::significant(value / one, digits);
  if (text != "0") text += number.substr(exponent);
  return text;
}

bool is_round_off(const ComparedValue& row) {
  constexpr double round_off = 1e-9;
  return std::abs(row.difference) <= round_off * std::abs(row.published.value.value);
}

/// With the digits of the published value, at least four.
std::string ours_text(const ComparedValue& row) {
  constexpr int fewest = 4, most = 8;
  if (is_round_off(row)) return number_of(row.published.written, row.published.unit);
  return written_like(row.published, row.ours, std::clamp(row.published.digits, fewest, most));
}

/// In per cent where the tolerance is and that says something, up to twice the published value;
/// else in the published value's unit.
std::string difference_text(const ComparedValue& row) {
  constexpr int digits = 2;
  constexpr double most = 2.0;
  if (is_round_off(row)) return "0";
  const double size = std::abs(row.published.value.value);
  std::string text;
  if (!row.published.tolerance.relative) {
    text = written_like(row.published, row.difference, digits);
  } else if (std::abs(row.difference) <= most * size) {
    text = fmt::format("{} %", text::significant(100.0 * row.difference / size, digits));
  } else {
    text = written_like(row.published, row.difference, digits);
    if (!row.published.unit.empty()) text += " " + row.published.unit;
  }
  if (row.difference > 0.0 && text != "0") text.insert(0, "+");
  return text;
}

/// Absolute ones without their unit where that is the published value's, which stands beside.
std::string tolerance_text(const PublishedValue& published) {
  const std::string& written = published.tolerance.written;
  const bool same = !published.tolerance.relative && written.ends_with(published.unit);
  return same ? number_of(written, published.unit) : written;
}

/// The number of each reason in the list of reasons, which grows.
std::string note_of(const std::string& reason, std::vector<std::string>& reasons) {
  const auto found = std::find(reasons.begin(), reasons.end(), reason);
  const auto place = found - reasons.begin();
  if (found == reasons.end()) reasons.push_back(reason);
  return std::to_string(place + 1);
}

/// The table less the columns in which nothing stands.
report::Table without_empty_columns(report::Table table) {
  for (std::size_t c = table.header.size(); c-- > 0;) {
    const auto at = static_cast<std::ptrdiff_t>(c);
    const auto empty = [c](const std::vector<Cell>& row) { return row[c].text.empty(); };
    if (!std::all_of(table.rows.begin(), table.rows.end(), empty)) continue;
    table.header.erase(table.header.begin() + at);
    for (std::vector<Cell>& row : table.rows) row.erase(row.begin() + at);
  }
  return table;
}

/// The rows of one status, in the order of the file. Reasons are those of a difference: where the
/// values agree there is nothing to explain.
report::Table table_of(const Comparison& comparison, Agreement agreement,
                       std::vector<std::string>& reasons) {
  report::Table table;
  // Short, so that there is room for keys.
  table.header = {"result", "published", "ours", "difference", "within", "unit", "source", "why"};
  for (const ComparedValue& row : comparison.rows) {
    if (row.agreement != agreement) continue;
    const PublishedValue& published = row.published;
    table.rows.push_back(
        {Cell{row.key, {}},
         Cell{number_of(published.written, published.unit), published.value.value},
         Cell{ours_text(row), row.ours}, Cell{difference_text(row), row.difference},
         Cell{tolerance_text(published), row.tolerance}, Cell{published.unit, {}},
         Cell{published.source, {}},
         Cell{agreement == Agreement::explained ? note_of(published.reason, reasons) : "", {}}});
    if (agreement == Agreement::differs) table.marks.push_back(Mark::fails);
  }
  return without_empty_columns(std::move(table));
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
  return fmt::format("{} {}: {} within the tolerance, {} beyond it with a reason, {} without",
                     comparison.rows.size(), comparison.rows.size() == 1 ? "value" : "values",
                     comparison.count(Agreement::agrees), comparison.count(Agreement::explained),
                     comparison.count(Agreement::differs));
}

report::Chapter chapter_of(const Comparison& comparison) {
  report::Chapter chapter;
  chapter.title = "Published values";
  chapter.blocks.push_back(report::Paragraph{fmt::format(
      "{} ({}). A difference is ours less published.", counts_text(comparison), comparison.path)});
  if (!comparison.gate.empty())
    chapter.blocks.push_back(report::Paragraph{
        fmt::format("A gate stands against the stresses of the case, which count for nothing: {}",
                    comparison.gate)});
  std::vector<std::string> reasons;
  for (const Agreement status : {Agreement::differs, Agreement::explained, Agreement::agrees}) {
    report::Table table = table_of(comparison, status, reasons);
    if (table.rows.empty()) continue;
    table.caption = heading_of(status);
    table.folded = status == Agreement::agrees && report::is_long(table);
    chapter.blocks.push_back(std::move(table));
    if (status != Agreement::explained) continue;
    report::Bullets list;
    for (std::size_t i = 0; i < reasons.size(); ++i) {
      list.items.push_back(fmt::format("{}: {}", i + 1, reasons[i]));
    }
    chapter.blocks.push_back(std::move(list));
  }
  return chapter;
}

}  // namespace

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
  document.facts.entries = {{"case file", project.path}, {"published", comparison.path}};
  if (!project.overrides.empty()) {
    document.facts.entries.emplace_back("overrides",
                                        fmt::format("{}", fmt::join(project.overrides, "; ")));
  }
  document.facts.entries.emplace_back("loads by", to_text(project.dynamics));
  document.governing.header = {"published values", "number"};
  for (const Agreement status : {Agreement::agrees, Agreement::explained, Agreement::differs}) {
    const std::size_t count = comparison.count(status);
    document.governing.rows.push_back(
        {report::Cell{heading_of(status), {}},
         report::Cell{std::to_string(count), static_cast<double>(count)}});
  }
  document.chapters.push_back(chapter_of(comparison));
  return document;
}

std::string comparison_text(const Project& project, const Comparison& comparison) {
  return report::text_of(comparison_document(project, comparison), layout::width());
}

void report::put_comparison(Fields& to, const Project& project, const Comparison& comparison) {
  to.constant("schema", "boxbeam.comparison/1");
  to.text("case", project.name);
  to.text({"version", "of the program"}, version);
  to.text("input_sha256", project.sha256);
  to.text({"table", "file of the published values"}, comparison.path);
  if (to.is_describing() || !comparison.gate.empty())
    to.optional().text({"gate", "where one stands against the stresses, which count for nothing"},
                       comparison.gate);
  to.whole("agree", comparison.count(Agreement::agrees), "1");
  to.whole({"explained", "beyond the tolerance, with a reason"},
           comparison.count(Agreement::explained), "1");
  to.whole({"differ", "beyond the tolerance, without"}, comparison.count(Agreement::differs), "1");
  to.list("rows", "", comparison.rows, [](Fields& of, const ComparedValue& row) {
    const auto number = [&](const Field& field, double value) {
      of.number_in(field, row.unit, "unit", value);
    };
    of.text({"result", "its key"}, row.key);
    number("published", row.published.value.value);
    number("ours", row.ours);
    number({"difference", "ours less published"}, row.difference);
    number({"tolerance", "on its size"}, row.tolerance);
    of.text("unit", row.unit);
    of.word("status", to_text(row.agreement), {"agrees", "differs, explained", "differs"});
    of.text("reason", row.published.reason);
    of.text("source", row.published.source);
    of.whole({"line", "of the table"}, row.published.line, "1");
  });
}

std::string comparison_json(const Project& project, const Comparison& comparison) {
  return report::document_text(
      [&](report::Fields fields) { report::put_comparison(fields, project, comparison); });
}

}  // namespace boxbeam
