#include "boxbeam/report/result_book.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "boxbeam/project/quantity_text.hpp"
#include "document_fields.hpp"

namespace boxbeam {

void ResultBook::add(std::vector<ResultValue> values) {
  for (ResultValue& value : values) {
    if (!places_.emplace(value.key, values_.size()).second) continue;
    keys_.push_back(value.key);
    values_.push_back(std::move(value));
  }
}

namespace {

/// What may be left out before a key.
constexpr std::array befores{"", "beam.", "governing."};

/// "effective_section.utilisation": names of criteria as expressions can hold them.
std::string without_blanks(std::string key) {
  std::replace(key.begin(), key.end(), ' ', '_');
  return key;
}

/// "shear_fatigue" of "governing.shear fatigue.acting"; "" where it begins with no criterion.
std::string criterion_in(const std::string& key) {
  constexpr std::string_view before = "governing.";
  const std::string rest =
      without_blanks(key.starts_with(before) ? key.substr(before.size()) : key);
  const std::string name = rest.substr(0, rest.find('.'));
  const bool is_one = std::any_of(criteria.begin(), criteria.end(), [&](Criterion criterion) {
    return name == without_blanks(to_text(criterion));
  });
  return is_one ? name : "";
}

}  // namespace

const ResultValue* ResultBook::find(const std::string& key) const {
  for (const std::string& written : {key, without_blanks(key)})
    for (const char* before : befores) {
      const auto found = places_.find(before + written);
      if (found != places_.end()) return &values_[found->second];
    }
  return nullptr;
}

std::string ResultBook::hint_for(const std::string& key) const {
  if (const std::string criterion = criterion_in(key);
      !criterion.empty() && continuations_of("governing." + criterion).empty())
    return fmt::format("the case has no check of it; behind \"governing\" stands one of {}",
                       fmt::join(continuations_of("governing"), ", "));
  std::string near;
  for (const char* before : befores)
    if (near.empty()) near = nearest_word(before + key, keys_);
  std::string hint = near.empty() ? "" : fmt::format("did you mean {}?", near);
  const std::size_t last = key.find_last_of(".[");
  for (const std::size_t end : {key.size(), last}) {
    for (const char* before : befores) {
      const std::string begin = before + key.substr(0, end);
      const std::vector<std::string> next = continuations_of(begin);
      if (next.empty()) continue;
      if (!hint.empty()) hint += " ";
      return hint + fmt::format("Behind \"{}\" stands one of {}", begin, fmt::join(next, ", "));
    }
  }
  if (!hint.empty()) return hint;
  return "keys are paths into what boxbeam verify --json prints, for example beam.mass or "
         "fatigue.safety_factor; boxbeam compare takes those of boxbeam motion --json, too: "
         "motion[0].bodies.beam.x";
}

/// The first ways in which a key goes on to results: ".mass", "[3.2-]".
std::vector<std::string> ResultBook::continuations_of(const std::string& key) const {
  constexpr std::size_t most = 12;
  std::vector<std::string> next;
  for (const ResultValue& value : values_) {
    if (!value.key.starts_with(key) || value.key.size() == key.size()) continue;
    const std::string_view rest = std::string_view(value.key).substr(key.size());
    if (rest.front() != '.' && rest.front() != '[') continue;
    const std::size_t end = rest.front() == '['
                                ? rest.find(']') + 1
                                : std::min(rest.find_first_of(".[", 1), rest.size());
    const std::string step(rest.substr(0, end));
    if (std::find(next.begin(), next.end(), step) != next.end()) continue;
    next.push_back(step);
    if (next.size() == most) break;
  }
  return next;
}

namespace {

ResultBook book_of(const Project& project, const Verification& verification,
                   const std::vector<VerifiedBeam>* beams, const report::WantedKeys& wanted) {
  ResultBook book;
  book.add(report::values_of(
      "", [&](report::Fields& to) { report::put_results(to, project, verification, beams); },
      wanted));
  book.add(report::values_of(
      "", [&](report::Fields& to) { report::put_governing(to, verification); }, wanted));
  return book;
}

}  // namespace

ResultBook results_of(const Project& project, const Verification& verification) {
  return book_of(project, verification, nullptr, {});
}

ResultBook results_of(const std::vector<VerifiedBeam>& beams) { return results_of(beams, {}); }

ResultBook results_of(const std::vector<VerifiedBeam>& beams,
                      const std::vector<std::string>& keys) {
  std::vector<std::string> asked;
  for (const std::string& key : keys)
    for (const std::string& written : {key, without_blanks(key)})
      for (const char* before : befores) asked.push_back(before + written);
  const VerifiedBeam& worst = worst_of(beams);
  return book_of(
      worst.project, worst.verification, beams.size() > 1 ? &beams : nullptr,
      asked.empty() ? report::WantedKeys{} : report::WantedKeys({asked.begin(), asked.end()}));
}

}  // namespace boxbeam
