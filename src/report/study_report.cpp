#include "boxbeam/report/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "document_fields.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

using Counted = std::pair<std::string, std::size_t>;

/// The most frequent first.
std::vector<Counted> by_number(const std::map<std::string, std::size_t>& counts) {
  std::vector<Counted> all(counts.begin(), counts.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const Counted& a, const Counted& b) { return a.second > b.second; });
  return all;
}

}  // namespace

report::MarkedText study_text(const StudySummary& summary) {
  std::string text = layout::heading(
      fmt::format("{}: {} designs of {}", summary.name, summary.designs, summary.case_file));
  const std::size_t verified = summary.designs - summary.failed;
  for (const auto& [verdict, count] : by_number(summary.verdicts))
    text += layout::entry(verdict, fmt::format("{} of {} ({:.4g} %)", count, summary.designs,
                                               100.0 * static_cast<double>(count) /
                                                   static_cast<double>(summary.designs)));
  if (summary.failed > 0)
    text += layout::entry(
        "not verified", fmt::format("{} of {}, status says why", summary.failed, summary.designs));
  if (summary.verdicts.empty() && summary.failed == 0)
    text += layout::entry("verified", fmt::format("{} of {}", verified, summary.designs));
  if (!summary.statistics.empty()) {
    text += "\n";
    layout::Table table(
        {"column", "unit", "designs", "mean", "sd", "least", "5 %", "half", "95 %", "largest"});
    const auto number = [](double value) { return fmt::format("{:.5g}", value); };
    for (const ColumnStatistics& of : summary.statistics) {
      std::vector<std::string> row{of.column.name, of.column.unit, std::to_string(of.count),
                                   number(of.mean), number(of.sd)};
      for (const double quantile : of.quantiles) row.push_back(number(quantile));
      table.row(row);
    }
    text += table.text();
  }
  const std::vector<Counted> reasons = by_number(summary.reasons);
  if (!reasons.empty()) text += "\nWhy designs were not verified:\n";
  constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < std::min(most, reasons.size()); ++i)
    text += layout::item(fmt::format("{} times: {}", reasons[i].second, reasons[i].first));
  if (reasons.size() > most)
    text += layout::item(fmt::format("{} more reasons", reasons.size() - most));
  return text;
}

void report::put_study(Fields& to, const StudySummary& summary) {
  to.constant("schema", "boxbeam.study/1");
  to.text("name", summary.name);
  to.text({"study", "its file"}, summary.study_file);
  to.text({"case", "its file"}, summary.case_file);
  to.text({"input_sha256", "of the study, the case and its tables"}, summary.sha256);
  to.whole({"seed", "of random numbers"}, summary.seed);
  to.whole("designs", summary.designs);
  to.whole({"failed", "of them could not be verified"}, summary.failed);
  const std::vector<Counted> verdicts = by_number(summary.verdicts);
  const auto put_count = [](Fields& of, const Counted& count) {
    of.text("words", count.first);
    of.whole("designs", count.second);
  };
  to.list({"verdicts", "of those verified, where the verdict is a column"}, "{words}", verdicts,
          put_count);
  to.list({"reasons", "why designs failed, the most frequent first"}, "",
          by_number(summary.reasons), put_count);
  to.list({"statistics", "of the columns of numbers"}, "{column}", summary.statistics,
          [](Fields& of, const ColumnStatistics& column) {
            of.text("column", column.column.name);
            of.text({"unit", "of a variable as in the study, of a result SI; empty without"},
                    column.column.unit);
            of.whole({"count", "designs that have a number"}, column.count);
            of.number_in("mean", "", "unit", column.mean);
            of.number_in("sd", "", "unit", column.sd);
            of.number_in("min", "", "unit", column.quantiles[0]);
            of.number_in({"p5", "5 % of the designs are not above it"}, "", "unit",
                         column.quantiles[1]);
            of.number_in("p50", "", "unit", column.quantiles[2]);
            of.number_in("p95", "", "unit", column.quantiles[3]);
            of.number_in("max", "", "unit", column.quantiles[4]);
          });
}

std::string study_json(const StudySummary& summary) {
  Json document = Json::object();
  report::Fields fields(document);
  report::put_study(fields, summary);
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
