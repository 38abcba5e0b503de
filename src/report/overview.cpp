#include "boxbeam/report/overview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "blocks.hpp"
#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/summary.hpp"
#include "report_parts.hpp"
#include "text_layout.hpp"
#include "text_table.hpp"

namespace boxbeam {
namespace {

using namespace report;

Table beams_table(const std::vector<VerifiedBeam>& beams) {
  std::vector<const VerifiedBeam*> worst_first;
  for (const VerifiedBeam& beam : beams) worst_first.push_back(&beam);
  const auto use = [](const VerifiedBeam* beam) {
    return beam->verification.checks.front().check.utilisation();
  };
  std::stable_sort(worst_first.begin(), worst_first.end(),
                   [&](const VerifiedBeam* a, const VerifiedBeam* b) { return use(a) > use(b); });
  Table table = table_of("", {"beam", "verdict", "worst check", "use [%]", "factor", "place"});
  for (const VerifiedBeam* beam : worst_first) {
    const Check& check = beam->verification.checks.front().check;
    const VerdictText verdict = verdict_text_of(beam->project, beam->verification);
    add_row(table, row_of(beam->project.beam_name, verdict.word, to_text(check.criterion),
                          cell(text::Quantity::utilisation, check.utilisation()),
                          cell(text::Quantity::factor, check.safety_factor), place_of(check)));
    table.marks.push_back(mark_of(beam->verification.verdict));
  }
  return table;
}

/// Of one beam: its verdict and its worst checks; the rest is in its own report.
Chapter chapter_of(const VerifiedBeam& beam) {
  Chapter chapter{"Beam " + beam.project.beam_name, {}};
  const VerdictText verdict = verdict_text_of(beam.project, beam.verification);
  chapter.blocks.emplace_back(
      Paragraph{fmt::format("{}. {} checks; derived in {}/report.", verdict.whole(),
                            beam.verification.checks.size(), beam.project.beam_name)});
  chapter.blocks.emplace_back(
      governing_table({beam.project, beam.verification, ReportLevel::summary}));
  std::vector<Block> pictures;
  add_deciding_pictures({beam.project, beam.verification, ReportLevel::summary}, pictures);
  for (Block& block : pictures) {
    if (auto* picture = std::get_if<Picture>(&block))
      picture->name = fmt::format("{}/{}", beam.project.beam_name, picture->name);
    chapter.blocks.push_back(std::move(block));
  }
  Bullets remarks;
  for (const Remark& remark : remarks_of(beam.project, beam.verification)) {
    if (remark.kind != Remark::Kind::assumed) remarks.items.push_back(remark.text);
  }
  if (!remarks.items.empty()) chapter.blocks.emplace_back(std::move(remarks));
  return chapter;
}

MarkedText marked(const std::vector<VerifiedBeam>& beams, const VerdictText& verdict,
                  const std::string& text) {
  MarkedText out(verdict.word, mark_of(worst_of(beams).verification.verdict));
  out += visible(text.substr(verdict.word.size()));
  return out;
}

}  // namespace

VerdictText verdict_text_of(const std::vector<VerifiedBeam>& beams) {
  const VerifiedBeam& worst = worst_of(beams);
  VerdictText all = verdict_text_of(worst.project, worst.verification);
  all.line = all.word;
  all.reasons.clear();
  for (const VerifiedBeam& beam : beams) {
    const VerdictText of = verdict_text_of(beam.project, beam.verification);
    const std::string& name = beam.project.beam_name;
    if (of.line != of.word)
      all.line += fmt::format("; {}: {}", name, of.line);
    else if (of.word != all.word)
      all.line += fmt::format("; {} {}", name, of.word);
    for (const std::string& reason : of.reasons)
      all.reasons.push_back(fmt::format("{}: {}", name, reason));
  }
  return all;
}

Document overview_of(const std::vector<VerifiedBeam>& beams) {
  const VerifiedBeam& worst = worst_of(beams);
  // What stands on the first page of any report, of the beam that decides.
  Document document = report_of(worst.project, worst.verification, ReportLevel::summary);
  VerdictText verdict = verdict_text_of(beams);
  document.verdict = std::move(verdict.line);
  document.reasons = std::move(verdict.reasons);
  document.subtitle = worst.project.title;
  document.facts.entries.emplace_back(
      "beams", fmt::format("{}; {} decides", beams.size(), worst.project.beam_name));
  document.governing = beams_table(beams);
  document.chapters.clear();
  for (const VerifiedBeam& beam : beams) document.chapters.push_back(chapter_of(beam));
  return document;
}

MarkedText summary(const std::vector<VerifiedBeam>& beams) {
  const VerifiedBeam& worst = worst_of(beams);
  if (beams.size() == 1) return summary(worst.project, worst.verification);
  const VerdictText verdict = verdict_text_of(beams);
  MarkedText out = marked(beams, verdict, verdict.line);
  out += fmt::format("  {}\n", visible(worst.project.title));
  for (const std::string& reason : verdict.reasons) out += layout::item(reason);
  out += "\n";
  out += table_text(beams_table(beams), layout::width());
  out += "\n";
  out += summary(worst.project, worst.verification);
  return out;
}

MarkedText verdict_line(const std::vector<VerifiedBeam>& beams) {
  const VerifiedBeam& worst = worst_of(beams);
  if (beams.size() == 1) return verdict_line(worst.project, worst.verification);
  const VerdictText verdict = verdict_text_of(beams);
  const Check& check = worst.verification.checks.front().check;
  MarkedText out = marked(beams, verdict, verdict.whole());
  out += fmt::format("  {}: {} {}, utilisation {}\n", worst.project.name, worst.project.beam_name,
                     check.id, text::percent(check.utilisation()));
  return out;
}

}  // namespace boxbeam
