#include <fmt/format.h>

#include <algorithm>

#include "blocks.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "function_text.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

std::string frequencies_text(const std::vector<double>& frequencies) {
  std::string list;
  for (const double frequency : frequencies) {
    list += list.empty() ? "" : ", ";
    list += text::rounded(text::Quantity::frequency, frequency);
  }
  return list;
}

std::string harmonics_text(const std::vector<LoadHarmonic>& harmonics) {
  std::string list;
  for (const LoadHarmonic& harmonic : harmonics) {
    list += list.empty() ? "" : ", ";
    list += fmt::format("{} ({:.0f} % of the bending moment)", plain(harmonic.frequency),
                        100.0 * harmonic.share);
  }
  return list;
}

/// The models that were weighed, with what is estimated and found of each.
void add_weighed(const ModelChoice& choice, ReportLevel level, std::vector<Block>& blocks) {
  if (choice.weighed.empty()) return;
  // Of a long ladder the top is what decides.
  const std::size_t most = level == ReportLevel::full ? choice.weighed.size() : 12;
  const std::size_t first = choice.weighed.size() - std::min(most, choice.weighed.size());
  Table table = table_of("Error of the governing stress, by every model that was weighed",
                         {"model weighed", "estimated", "found", "the estimate's parts"});
  for (std::size_t i = first; i < choice.weighed.size(); ++i) {
    const ModelEstimate& of = choice.weighed[i];
    add_row(table, row_of(describe(of.model), cell(percent_text(of.error)),
                          of.found ? percent_text(*of.found) : std::string("-"), of.basis));
  }
  blocks.emplace_back(std::move(table));
  if (first == 0) return;
  blocks.emplace_back(Paragraph{fmt::format(
      "{} cheaper models, all estimated to miss the tolerance, stand in results.json.", first)});
}

}  // namespace

Chapter model_chapter(const Source& source) {
  const ModelChoice& choice = source.verification.model;
  Chapter chapter{"Model", {Paragraph{choice.reason + "."}}};
  if (source.level == ReportLevel::summary) return chapter;
  Facts facts;
  if (!choice.frequencies.empty()) {
    facts.entries.emplace_back("natural frequencies [Hz]", frequencies_text(choice.frequencies));
  }
  if (!choice.harmonics.empty()) {
    facts.entries.emplace_back("loads vibrate with [Hz]", harmonics_text(choice.harmonics));
  }
  if (!facts.entries.empty()) chapter.blocks.emplace_back(std::move(facts));
  add_weighed(choice, source.level, chapter.blocks);
  return chapter;
}

}  // namespace boxbeam::report
