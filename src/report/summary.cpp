#include "boxbeam/report/summary.hpp"

#include <fmt/format.h>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/verdict_sentence.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "report_parts.hpp"
#include "text_layout.hpp"
#include "text_table.hpp"

namespace boxbeam {
namespace {

/// A gate that blocks is always shown, here or beside the verdict, of the rest the first few.
std::string remarks_summary(const Project& project, const Verification& verification) {
  constexpr std::size_t most = 3;
  std::string out;
  std::size_t others = 0;
  std::size_t hidden = 0;
  for (const Remark& remark : remarks_of(project, verification)) {
    if (remark.kind == Remark::Kind::assumed) {
      ++hidden;
    } else if (remark.kind == Remark::Kind::not_applicable) {
      // Where nothing fails it stands above, with the verdict.
      if (verification.verdict == Verdict::fail) out += layout::item(remark.whole());
    } else if (others++ < most) {
      out += layout::item(remark.text);
    } else {
      ++hidden;
    }
  }
  if (hidden > 0) {
    out += layout::item(fmt::format("{} more remarks and assumptions stand in the report", hidden));
  }
  return out;
}

/// What a verdict says, its first word marked.
report::MarkedText marked(const Verification& verification, const VerdictText& verdict,
                          const std::string& text) {
  report::MarkedText out(verdict.word, report::mark_of(verification.verdict));
  out += text.substr(verdict.word.size());
  return out;
}

}  // namespace

report::MarkedText summary(const Project& project, const Verification& verification) {
  const report::Table governing =
      report::with_results(report::governing_table({project, verification, ReportLevel::summary}));
  const VerdictText verdict = verdict_text_of(project, verification);
  const std::string name = project.beam_name.empty() ? project.title : "beam " + project.beam_name;
  // With what it says beside its word it is longer than a line: the name stands below.
  const bool says_more = verdict.line.find("; ") != std::string::npos;
  report::MarkedText out =
      marked(verification, verdict,
             says_more ? layout::line(visible(verdict.line)) + layout::paragraph(visible(name))
                       : visible(verdict.line + "  " + name) + "\n");
  for (const std::string& reason : verdict.reasons) out += layout::item(reason);
  out += layout::entry("in short", verdict_sentence_of(project, verification)) + "\n";
  // How thick a plate is or how far diaphragms are apart is said in words; where flats stand is
  // not.
  for (const Remedy& remedy : verification.remedies.found) {
    if (remedy.what == Remedy::What::stiffeners)
      out += layout::entry("flats", fmt::format("--set '{}'", fmt::join(remedy.set, "' --set '"))) +
             "\n";
  }
  out += layout::entry("model", verification.model.reason) + "\n";
  if (const std::string plates = report::plate_routes_text(verification); !plates.empty())
    out += layout::entry("plates", plates) + "\n";
  out += report::table_text(governing, layout::width());
  out += "\nRemarks:\n" + remarks_summary(project, verification);
  return out;
}

report::MarkedText verdict_line(const Project& project, const Verification& verification) {
  const Check& worst = verification.checks.front().check;
  const VerdictText verdict = verdict_text_of(project, verification);
  report::MarkedText out = marked(verification, verdict, visible(verdict.whole()));
  out += fmt::format("  {}: {}, utilisation {}\n", project.name, worst.id,
                     text::percent(worst.utilisation()));
  return out;
}

report::MarkedText what_changed(const Verification& before, const Project& project,
                                const Verification& now) {
  const VerdictText verdict = verdict_text_of(project, now);
  report::MarkedText out = "\n";
  out += report::MarkedText(verdict.word, report::mark_of(now.verdict));
  if (now.verdict != before.verdict) out += fmt::format(" (was {})", to_text(before.verdict));
  out += visible(verdict.whole().substr(verdict.word.size()));
  out += "\n";
  bool any = false;
  for (const Criterion criterion : criteria) {
    const CheckResult* was = before.governing(criterion);
    const CheckResult* is = now.governing(criterion);
    const auto use = [](const CheckResult* of) {
      return of == nullptr ? "none" : text::percent(of->check.utilisation());
    };
    const auto id = [](const CheckResult* of) { return of == nullptr ? "" : of->check.id; };
    if (use(was) == use(is) && id(was) == id(is)) continue;
    any = true;
    out += fmt::format("  {:16}  {:>7} -> {:>7}  {}{}\n", to_text(criterion), use(was), use(is),
                       id(is), id(was) == id(is) || was == nullptr ? "" : ", was " + id(was));
  }
  if (!any) out += "  every criterion as before\n";
  return out;
}

}  // namespace boxbeam
