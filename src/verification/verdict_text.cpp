#include "boxbeam/verification/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/verification/unsaid.hpp"

namespace boxbeam {
namespace {

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "PASS";
    case Verdict::fail: return "FAIL";
    case Verdict::not_applicable: return "NOT APPLICABLE";
  }
  return "";
}

}  // namespace

std::vector<GateText> gate_texts_of(const Verification& verification) {
  std::vector<std::pair<const Gate*, std::string>> groups;
  for (const Gate& gate : verification.gates) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return group.first->finding == gate.finding && group.first->plate == gate.plate;
    });
    if (same == groups.end())
      groups.emplace_back(&gate, gate.segment);
    else
      same->second += ", " + gate.segment;
  }
  std::vector<GateText> texts;
  for (const auto& [gate, segments] : groups) {
    const std::string where =
        gate->plate.empty() ? "" : fmt::format("{} of segment {}: ", gate->plate, segments);
    texts.push_back({where + gate->finding, gate->blocks});
  }
  return texts;
}

std::string VerdictText::whole() const {
  return reasons.empty() ? line : fmt::format("{}: {}", line, fmt::join(reasons, "; "));
}

VerdictText verdict_text_of(const Project& project, const Verification& verification) {
  const char* const word = word_of(verification.verdict);
  VerdictText text{word, word, {}};
  const std::vector<NotJudged>& missing = verification.not_judged;
  if (!project.fatigue.asked) {
    text.line += " (strength only)";
  } else if (!judged_in_fatigue(verification.checks) && verification.verdict == Verdict::pass) {
    text.line += " for strength";
  }
  const bool applicable = verification.verdict != Verdict::not_applicable;
  if (!applicable) {
    for (GateText& gate : gate_texts_of(verification)) {
      if (gate.blocks) text.reasons.push_back(std::move(gate.text));
    }
  }
  for (const NotJudged& of : missing) {
    const std::string said = fmt::format("{}: {}", of.what, of.reason);
    if (applicable)
      text.line += "; " + said;
    else
      text.reasons.push_back(said);
  }
  return text;
}

}  // namespace boxbeam
