#include "boxbeam/report/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "document_fields.hpp"
#include "study_tables.hpp"

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

std::string indices_text(const StudySummary& summary, const ColumnIndices& column) {
  const SobolIndices& indices = column.indices;
  std::string text = fmt::format(
      "\nSobol indices of {}, from {} samples{}:\n", column.column.name, indices.samples,
      indices.left_out == 0
          ? ""
          : fmt::format(" ({} left out: a design of them has no number)", indices.left_out));
  if (indices.of.empty())
    return text + layout::item("none: it does not vary, or the samples are too few");
  double sum = 0.0;
  for (const SobolIndex& of : indices.of) sum += of.first.value;
  return text + report::indices_table(summary, indices).text() +
         layout::paragraph(fmt::format("S1: part of the variance that a variable makes by itself, "
                                       "{:.3f} together; ST: with all that it does together with "
                                       "others. From and to: 95 % confidence.",
                                       sum));
}

void put_bounded(report::Fields& to, const std::string& name, const char* says,
                 const BoundedEstimate& of) {
  to.number({name, says}, "1", of.value);
  to.number({name + "_low", "of 95 % confidence"}, "1", of.low);
  to.number(name + "_high", "1", of.high);
}

void put_indices(report::Fields& to, const StudySummary& summary, const ColumnIndices& column) {
  to.text("column", column.column.name);
  to.whole({"samples", "pairs of designs that they rest on"}, column.indices.samples);
  to.whole({"left_out", "pairs of which a design has no number"}, column.indices.left_out);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < column.indices.of.size(); ++i) places.push_back(i);
  to.list({"variables", "none where the column does not vary"}, "{variable}", places,
          [&](report::Fields& fields, std::size_t i) {
            const bool none = fields.is_describing();
            fields.text("variable", none ? "" : summary.index_variables[i]);
            const SobolIndex of = none ? SobolIndex{} : column.indices.of[i];
            put_bounded(fields, "S1", "part of the variance that it makes by itself", of.first);
            put_bounded(fields, "ST", "with all that it does together with others", of.total);
          });
}

}  // namespace

std::string p_f_text(const BoundedEstimate& p_f) {
  return fmt::format("{:.3g}, from {:.3g} to {:.3g} with 95 % confidence", p_f.value, p_f.low,
                     p_f.high);
}

std::string report::kept_text(const StudySummary& summary) {
  return fmt::format("{} of {} designs: those with {}{}", summary.kept, summary.designs,
                     summary.keep,
                     summary.failed > 0 ? ", and those that could not be verified" : "");
}

layout::Table report::statistics_table(const StudySummary& summary) {
  layout::Table table(
      {"column", "unit", "designs", "mean", "sd", "least", "5 %", "half", "95 %", "largest"});
  const auto number = [](double value) { return fmt::format("{:.5g}", value); };
  for (const ColumnStatistics& of : summary.statistics) {
    std::vector<std::string> row{of.column.name, of.column.unit, std::to_string(of.count),
                                 number(of.mean), number(of.sd)};
    for (const double quantile : of.quantiles) row.push_back(number(quantile));
    table.row(row);
  }
  return table;
}

std::string report::quantiles_text(const StudySummary& summary) {
  double error = 0.0;
  for (const ColumnStatistics& of : summary.statistics) error = std::max(error, of.quantile_error);
  if (error == 0.0) return "";
  return fmt::format("5 %, half and 95 %: within {:.2g} % of themselves; all others are exact.",
                     100.0 * error);
}

layout::Table report::indices_table(const StudySummary& summary, const SobolIndices& indices) {
  layout::Table table({"variable", "S1", "from", "to", "ST", "from", "to"});
  const auto number = [](double value) { return fmt::format("{:.4f}", value); };
  for (std::size_t i = 0; i < indices.of.size(); ++i) {
    const auto& [first, total] = indices.of[i];
    table.row({summary.index_variables[i], number(first.value), number(first.low),
               number(first.high), number(total.value), number(total.low), number(total.high)});
  }
  return table;
}

std::vector<std::string> report::reasons_text(const StudySummary& summary) {
  const std::vector<Counted> reasons = by_number(summary.reasons);
  constexpr std::size_t most = 5;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(most, reasons.size()); ++i)
    texts.push_back(fmt::format("{} times: {}", reasons[i].second, reasons[i].first));
  if (reasons.size() > most) texts.push_back(fmt::format("{} more reasons", reasons.size() - most));
  return texts;
}

report::MarkedText study_text(const StudySummary& summary) {
  std::string text =
      layout::heading(fmt::format("{}: {} designs{}", summary.name, summary.designs,
                                  summary.case_file.empty() ? "" : " of " + summary.case_file));
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
  if (!summary.keep.empty()) text += layout::entry("rows", report::kept_text(summary));
  if (summary.p_f) text += layout::entry("p_f", p_f_text(*summary.p_f));
  if (!summary.statistics.empty()) text += "\n" + report::statistics_table(summary).text();
  const std::string quantiles = report::quantiles_text(summary);
  if (!quantiles.empty()) text += layout::paragraph(quantiles);
  for (const ColumnIndices& column : summary.indices) text += indices_text(summary, column);
  const std::vector<std::string> reasons = report::reasons_text(summary);
  if (!reasons.empty()) text += "\nWhy designs were not verified:\n";
  for (const std::string& reason : reasons) text += layout::item(reason);
  return text;
}

void report::put_study(Fields& to, const StudySummary& summary) {
  to.constant("schema", "boxbeam.study/1");
  to.text("name", summary.name);
  to.text({"study", "its file"}, summary.study_file);
  to.text({"case", "its file; empty without"}, summary.case_file);
  to.text({"input_sha256", "of the study, the case and its tables"}, summary.sha256);
  to.text({"version", "of the program"}, summary.version);
  to.text({"rows_sha256", "of rows.csv"}, summary.rows_sha256);
  to.whole({"seed", "of random numbers"}, summary.seed);
  to.whole("designs", summary.designs);
  if (!summary.keep.empty() || to.is_describing()) {
    to.optional().text({"keep", "which designs have a row in rows.csv, and those that failed"},
                       summary.keep);
    to.optional().whole({"kept", "designs that have one; all others count, too"}, summary.kept);
    to.optional().text({"statistics_sha256", "of statistics.json, all designs as --resume needs"},
                       summary.statistics_sha256);
  }
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
  if (summary.p_f || to.is_describing()) {
    const BoundedEstimate p_f = summary.p_f.value_or(BoundedEstimate{});
    to.optional().number(
        {"p_f", "share of the designs that do not pass, where they are drawn as they scatter"}, "1",
        p_f.value);
    to.optional().number({"p_f_low", "of 95 % confidence"}, "1", p_f.low);
    to.optional().number("p_f_high", "1", p_f.high);
  }
  to.list(
      {"statistics", "of the columns of numbers"}, "{column}", summary.statistics,
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
        of.number({"quantile_error", "relative, of p5, p50 and p95; 0 where they are exact"}, "1",
                  column.quantile_error);
        const std::vector<double> parts(column.histogram.begin(), column.histogram.end());
        of.numbers({"histogram", "designs in each of 20 equal parts from min to max"}, "1", parts);
      });
  if (summary.index_variables.empty() && !to.is_describing()) return;
  to.optional().list({"indices", "where asked for: Sobol's, of results that are numbers"},
                     "{column}", summary.indices, [&](Fields& of, const ColumnIndices& column) {
                       put_indices(of, summary, column);
                     });
}

std::string study_json(const StudySummary& summary) {
  return report::document_text([&](report::Fields fields) { report::put_study(fields, summary); });
}

}  // namespace boxbeam
