#include "boxbeam/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "blocks.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/verdict_sentence.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "front_end_text.hpp"
#include "report_parts.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using namespace report;

report::Facts title_facts(const Project& project, const Verification& verification) {
  report::Facts facts;
  const CaseHeader& header = project.header;
  for (const auto& [name, text] : {std::pair{"project", header.project},
                                   {"client", header.client},
                                   {"revision", header.revision},
                                   {"standard", header.standard},
                                   {"prepared by", header.author},
                                   {"checked by", header.checker}}) {
    if (!text.empty()) facts.entries.emplace_back(name, text);
  }
  facts.entries.emplace_back("file", project.path);
  for (const std::string& set : project.overrides) facts.entries.emplace_back("--set", set);
  facts.entries.emplace_back("loads by", project.dynamics == Dynamics::rigorous
                                             ? report::front_end_text_of(project)->source_of_loads()
                                             : "the published Newton chain");
  facts.entries.emplace_back("model", to_text(verification.model.chosen.level));
  if (std::string plates = plate_routes_text(verification); !plates.empty())
    facts.entries.emplace_back("plates", std::move(plates));
  facts.entries.emplace_back(
      "checks", fmt::format("{}, the worst used {}", verification.checks.size(),
                            text::percent(verification.checks.front().check.utilisation())));
  return facts;
}

Chapter remarks_chapter(const Source& source) {
  Bullets blocks, assumptions, others;
  for (Remark& remark : remarks_of(source.project, source.verification)) {
    switch (remark.kind) {
      case Remark::Kind::assumed: assumptions.items.push_back(std::move(remark.text)); break;
      case Remark::Kind::not_applicable: blocks.items.push_back(std::move(remark.text)); break;
      case Remark::Kind::other: others.items.push_back(std::move(remark.text)); break;
    }
  }
  Chapter chapter{"Assumptions and remarks", {}};
  const auto add = [&](const char* title, Bullets& bullets) {
    if (bullets.items.empty()) return;
    chapter.blocks.emplace_back(Subheading{title});
    chapter.blocks.emplace_back(std::move(bullets));
  };
  add("Why the checks do not apply", blocks);
  add("Assumptions of the case", assumptions);
  add("Remarks", others);
  return chapter;
}

/// What decides at a glance; other levels have each figure where it belongs.
Chapter figures_chapter(const Source& source) {
  Chapter chapter{"Figures", {}};
  if (source.level != ReportLevel::summary) return chapter;
  add_deciding_pictures(source, chapter.blocks);
  return chapter;
}

Chapter input_chapter(const Source& source) {
  Chapter chapter{"Appendix: the input", {}};
  if (source.level != ReportLevel::full) return chapter;
  chapter.blocks.emplace_back(Listing{source.project.text});
  return chapter;
}

void finish_tables(const Project& project, std::vector<Block>& blocks) {
  for (Block& block : blocks) {
    auto* const table = std::get_if<Table>(&block);
    if (table == nullptr) continue;
    table->folded = is_long(*table);
    drop_instants_at_rest(project, *table);
  }
}

}  // namespace

Mark report::mark_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return Mark::passes;
    case Verdict::fail: return Mark::fails;
    case Verdict::not_applicable: return Mark::not_applicable;
  }
  return Mark::none;
}

void report::drop_instants_at_rest(const Project& project, Table& table) {
  const auto* frame = std::get_if<frame::Structure>(&project.mechanism);
  if (frame == nullptr || changes_over_time(*frame)) return;
  const auto found = std::find(table.header.begin(), table.header.end(), "t [s]");
  if (found == table.header.end()) return;
  const auto column = found - table.header.begin();
  table.header.erase(found);
  for (std::vector<Cell>& row : table.rows) row.erase(row.begin() + column);
}

report::Document report_of(const Project& project, const Verification& verification,
                           ReportLevel level) {
  const Source source{project, verification, level};
  Document document;
  document.title = project.name;
  document.subtitle = project.beam_name.empty()
                          ? project.title
                          : fmt::format("{}: beam {}", project.title, project.beam_name);
  document.prepared_by = project.header.author;
  document.checked_by = project.header.checker;
  document.date = report_date();
  document.program = fmt::format("boxbeam {}", version);
  document.input_sha256 = project.sha256;
  VerdictText verdict = verdict_text_of(project, verification);
  document.verdict = std::move(verdict.line);
  document.reasons = std::move(verdict.reasons);
  document.sentence = verdict_sentence_of(project, verification);
  document.mark = mark_of(verification.verdict);
  document.facts = title_facts(project, verification);
  document.governing = governing_table(source);
  document.opening = opening_blocks(source);
  finish_tables(project, document.opening);
  for (const auto chapter_of :
       {remarks_chapter, model_chapter, inputs_chapter, mechanism_chapter, motion_chapter,
        loads_chapter, cut_force_chapter, section_chapter, stress_chapter, sheets_chapter,
        fatigue_chapter, checks_chapter, comparison_chapter, figures_chapter, input_chapter}) {
    Chapter chapter = chapter_of(source);
    finish_tables(project, chapter.blocks);
    if (!chapter.blocks.empty()) document.chapters.push_back(std::move(chapter));
  }
  return document;
}

report::Document with_pictures(report::Document document,
                               const std::function<bool(const std::string& name)>& drawn) {
  const auto missing = [&](const Block& block) {
    const auto* picture = std::get_if<Picture>(&block);
    return picture != nullptr && !drawn(picture->name);
  };
  std::erase_if(document.opening, missing);
  for (Chapter& chapter : document.chapters) std::erase_if(chapter.blocks, missing);
  std::erase_if(document.chapters, [](const Chapter& chapter) { return chapter.blocks.empty(); });
  return document;
}

}  // namespace boxbeam
