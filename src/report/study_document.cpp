#include "boxbeam/report/study_document.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "boxbeam/report/report.hpp"
#include "boxbeam/report/study_report.hpp"
#include "study_tables.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using report::Bullets;
using report::Chapter;
using report::DesignTable;
using report::Document;
using report::Paragraph;
using report::Picture;
using report::Subheading;

Document page_of(const std::string& name, const std::string& subtitle, const std::string& sha256) {
  Document document;
  document.title = name;
  document.subtitle = subtitle;
  document.date = report_date();
  document.program = fmt::format("boxbeam {}", version);
  document.input_sha256 = sha256;
  return document;
}

report::Table captioned(const layout::Table& table, const std::string& caption) {
  report::Table block = table.as_block();
  block.caption = caption;
  return block;
}

std::string of_all(std::size_t count, std::size_t all) {
  return fmt::format("{} of {} ({:.4g} %)", count, all,
                     100.0 * static_cast<double>(count) / static_cast<double>(all));
}

DesignTable designs_of(const DesignRows& rows) {
  DesignTable table;
  table.rows = rows;
  table.caption =
      "Each line and each point is a design. Draw along an axis to keep the designs that it has "
      "there, click on it to have all of them again; the other diagrams and the table show those "
      "that are kept.";
  if (rows.size() < rows.designs)
    table.caption += fmt::format(" {} of {} designs are shown, one of each of as many equal parts.",
                                 rows.size(), rows.designs);
  return table;
}

}  // namespace

Document study_document(const StudySummary& summary, const DesignRows& rows) {
  Document document = page_of(
      summary.name,
      fmt::format("{} designs{}", summary.designs,
                  summary.case_file.empty() ? "" : fmt::format(" of {}", summary.case_file)),
      summary.sha256);
  auto& facts = document.facts.entries;
  facts.emplace_back("study file", summary.study_file);
  for (const auto& [verdict, count] : summary.verdicts)
    facts.emplace_back(verdict, of_all(count, summary.designs));
  if (summary.failed > 0)
    facts.emplace_back("not verified", of_all(summary.failed, summary.designs));
  if (!summary.keep.empty()) facts.emplace_back("rows", report::kept_text(summary));
  if (summary.p_f) facts.emplace_back("p_f", p_f_text(*summary.p_f));
  facts.emplace_back("seed", std::to_string(summary.seed));
  document.chapters.push_back({"Designs", {designs_of(rows)}});
  if (!summary.indices.empty()) {
    Chapter chapter{"What makes the scatter", {}};
    chapter.blocks.emplace_back(
        Paragraph{"S1: part of the variance of a result that a variable makes by itself; ST: with "
                  "all that it does together with others; from and to: 95 % confidence."});
    chapter.blocks.emplace_back(
        Picture{"indices", "Sobol indices: which part of the variance each variable makes."});
    for (const ColumnIndices& column : summary.indices)
      if (!column.indices.of.empty())
        chapter.blocks.emplace_back(
            captioned(report::indices_table(summary, column.indices), column.column.name));
    document.chapters.push_back(std::move(chapter));
  }
  Chapter statistics{summary.keep.empty() ? "Statistics" : "Statistics of all designs",
                     {captioned(report::statistics_table(summary), "")}};
  const std::string quantiles = report::quantiles_text(summary);
  if (!quantiles.empty()) statistics.blocks.emplace_back(Paragraph{quantiles});
  if (!summary.reasons.empty()) {
    statistics.blocks.emplace_back(Subheading{"Why designs were not verified"});
    statistics.blocks.emplace_back(Bullets{report::reasons_text(summary)});
  }
  document.chapters.push_back(std::move(statistics));
  return document;
}

Document reliability_document(const StudyReliability& of) {
  Document document = page_of(
      of.name, fmt::format("How probable is {}?", fmt::join(of.limit_state, " or ")), of.sha256);
  auto& facts = document.facts.entries;
  facts.emplace_back("study file", of.study_file);
  if (!of.case_file.empty()) facts.emplace_back("case file", of.case_file);
  if (of.years) facts.emplace_back("years of service", fmt::format("{:.4g}", *of.years));
  facts.emplace_back("seed", std::to_string(of.seed));
  facts.emplace_back("evaluations", std::to_string(of.result.calls));
  Chapter methods{"Probability of failure", {captioned(report::methods_table(of), "")}};
  const std::vector<std::string> remarks = report::methods_remarks(of);
  if (!remarks.empty()) methods.blocks.emplace_back(Bullets{remarks});
  methods.blocks.emplace_back(
      Picture{"convergence",
              "The probability of failure over the samples of the simulations, dashed its "
              "bounds of 95 % confidence."});
  document.chapters.push_back(std::move(methods));
  if (of.points.empty()) return document;
  Chapter points{"What decides", {}};
  points.blocks.emplace_back(Paragraph{
      "At a design point failure is most probable. alpha above zero: more of the variable "
      "leads to failure; alpha^2: its part in the scatter that decides."});
  points.blocks.emplace_back(
      Picture{"importance", "What decides at the nearest design point, with the values there."});
  constexpr std::size_t most = 4;
  for (std::size_t i = 0; i < std::min(most, of.points.size()); ++i)
    points.blocks.emplace_back(
        captioned(report::point_table(of.points[i]),
                  fmt::format("Design point {}, beta = {:.4f}", i + 1, of.result.points[i].beta)));
  document.chapters.push_back(std::move(points));
  return document;
}

Document optimum_document(const OptimumReport& of) {
  Document document = page_of(std::filesystem::path(of.study).stem().string(),
                              fmt::format("Least {}", of.goals.front().name), "");
  document.facts.entries = report::optimum_facts(of);
  document.facts.entries.emplace_back("study file",
                                      std::filesystem::path(of.study).filename().string());
  if (of.optimum.best) {
    Chapter best{"The best design", {captioned(report::chosen_table(of), "")}};
    if (!of.optimum.active.empty())
      best.blocks.emplace_back(captioned(report::active_table(of), ""));
    document.chapters.push_back(std::move(best));
  }
  if (!of.front.empty()) {
    document.chapters.push_back(
        {"Front of both goals",
         {Picture{"front", "Neither goal can be less but for more of the other."},
          captioned(report::front_table(of), "")}});
  }
  if (of.judged.size() > 0) {
    DesignTable designs = designs_of(of.judged);
    if (of.goals.size() == 2) {
      designs.x = of.goals[0].name;
      designs.y = of.goals[1].name;
    }
    document.chapters.push_back({"Designs looked at", {std::move(designs)}});
  }
  return document;
}

}  // namespace boxbeam
