#include "boxbeam/report/verdict_sentence.hpp"

#include <fmt/format.h>

#include "boxbeam/report/format.hpp"
#include "boxbeam/verification/verdict_text.hpp"

namespace boxbeam {
namespace {

bool is_by_fatigue(Criterion criterion) {
  return criterion == Criterion::fatigue || criterion == Criterion::shear_fatigue ||
         criterion == Criterion::combined_fatigue || criterion == Criterion::distortion_fatigue ||
         criterion == Criterion::patch_fatigue || criterion == Criterion::lug_fatigue;
}

/// "at 4.2 m, fibre +z (transverse weld)", "of rod hanger".
std::string place_of(const CheckResult& result) {
  const Check& check = result.check;
  if (!check.on_beam) return "of " + check.point;
  std::string place = fmt::format("at {:.4g} m, {}", check.station.s.value(), check.point);
  const bool has_detail = is_by_fatigue(check.criterion) && result.basis &&
                          result.basis->point.detail != nullptr &&
                          check.criterion != Criterion::shear_fatigue;
  if (!has_detail) return place;
  const BeamDetail& detail = *result.basis->point.detail;
  const std::string& name = detail.detail.name;
  // One that is called after its category says nothing of the place.
  if (name.empty() || name.starts_with("category")) return place;
  return fmt::format("{} ({}{})", place, name, detail.assumed.empty() ? "" : ", assumed");
}

/// "fatigue at 4.2 m, fibre +z, 165 % used, under "running"".
std::string use_of(const CheckResult& result) {
  const Check& check = result.check;
  std::string use = fmt::format("{} {}, {} used", to_text(check.criterion), place_of(result),
                                text::percent(check.utilisation()));
  if (!check.situation.empty()) use += fmt::format(", under \"{}\"", check.situation);
  return use;
}

/// "; yield fails, too (120 %)": criteria of another kind than the worst.
std::string other_failures(const Verification& verification) {
  const Criterion worst = verification.checks.front().check.criterion;
  std::string others;
  for (const Criterion criterion : criteria) {
    const CheckResult* other = verification.governing(criterion);
    const bool same_kind = criterion == worst || (is_by_fatigue(criterion) && is_by_fatigue(worst));
    if (other == nullptr || same_kind || other->check.passes()) continue;
    others += fmt::format("; {} fails, too ({})", to_text(criterion),
                          text::percent(other->check.utilisation()));
  }
  return others;
}

/// The check that governs; of fatigue by direct stress and together with shear, where both say the
/// same, the former, whose place is a point and whose detail is known.
const CheckResult& governing_of(const Verification& verification) {
  const CheckResult& worst = verification.checks.front();
  const CheckResult* direct = verification.governing(Criterion::fatigue);
  const bool tied =
      direct != nullptr && worst.check.criterion == Criterion::combined_fatigue &&
      direct->check.station == worst.check.station &&
      text::percent(direct->check.utilisation()) == text::percent(worst.check.utilisation());
  return tied ? *direct : worst;
}

/// All reasons stand beside the sentence.
std::string in_short(const std::vector<std::string>& reasons) {
  constexpr std::size_t few = 2;
  if (reasons.size() <= few) return fmt::format("{}", fmt::join(reasons, "; "));
  return fmt::format("{}; and {} more reasons", reasons.front(), reasons.size() - 1);
}

std::string remedies_text(const Remedies& remedies) {
  std::string text;
  std::vector<std::string> names;
  for (const Remedy& remedy : remedies.found) names.push_back(remedy.name);
  if (!names.empty()) {
    text = fmt::format("; {} would pass", fmt::join(names, " or "));
  } else if (remedies.in_vain.size() == 1) {
    text = fmt::format("; {} would not make it pass", remedies.in_vain.front());
  } else if (!remedies.in_vain.empty()) {
    text = fmt::format("; neither {} would make it pass", fmt::join(remedies.in_vain, " nor "));
  }
  if (!remedies.not_searched.empty())
    text += fmt::format("; not searched: {}", fmt::join(remedies.not_searched, ", "));
  return text;
}

}  // namespace

std::string verdict_sentence_of(const Project& project, const Verification& verification) {
  const CheckResult& worst = governing_of(verification);
  const VerdictText verdict = verdict_text_of(project, verification);
  const std::string beam =
      project.beam_name.empty() ? "" : fmt::format("beam {} ", project.beam_name);
  switch (verification.verdict) {
    case Verdict::fail:
      return fmt::format("{}fails in {}{}{}", beam, use_of(worst), other_failures(verification),
                         remedies_text(verification.remedies));
    case Verdict::not_applicable:
      return fmt::format("{}not applicable: {}; of what is judged most used is {}", beam,
                         in_short(verdict.reasons), use_of(worst));
    case Verdict::pass: break;
  }
  // "PASS for strength; fatigue: no stress range"; what is long stands with the verdict, just
  // above.
  std::string rest = verdict.line.substr(verdict.word.size());
  constexpr std::size_t short_enough = 60;
  if (rest.size() > short_enough)
    rest = rest.substr(0, rest.find(';')) + "; what is not judged stands with the verdict";
  return fmt::format("{}passes{}; most used is {}", beam, rest, use_of(worst));
}

}  // namespace boxbeam
