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
    places_.emplace(value.key, values_.size());
    keys_.push_back(value.key);
    values_.push_back(std::move(value));
  }
}

namespace {

/// What may be left out before a key.
constexpr std::array befores{"", "beam.", "governing."};

}  // namespace

const ResultValue* ResultBook::find(const std::string& key) const {
  for (const char* before : befores) {
    const auto found = places_.find(before + key);
    if (found != places_.end()) return &values_[found->second];
  }
  return nullptr;
}

std::string ResultBook::hint_for(const std::string& key) const {
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
  return "keys are paths into what boxbeam verify --json and boxbeam motion --json print, for "
         "example beam.mass or motion[0].bodies.beam.x";
}

/// The first ways in which a key goes on to results: ".mass", "[3.2-]".
std::vector<std::string> ResultBook::continuations_of(const std::string& key) const {
  constexpr std::size_t most = 8;
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

ResultBook results_of(const Project& project, const Verification& verification) {
  ResultBook book;
  book.add(report::values_of(
      "", [&](report::Fields& to) { report::put_results(to, project, verification); }));
  return book;
}

ResultBook results_of(const std::vector<VerifiedBeam>& beams) { return results_of(beams, {}); }

ResultBook results_of(const std::vector<VerifiedBeam>& beams,
                      const std::vector<std::string>& keys) {
  std::vector<std::string> asked;
  for (const std::string& key : keys)
    for (const char* before : befores) asked.push_back(before + key);
  const report::WantedKeys wanted =
      asked.empty() ? report::WantedKeys{} : report::WantedKeys({asked.begin(), asked.end()});
  const VerifiedBeam& worst = worst_of(beams);
  ResultBook book;
  book.add(report::values_of(
      "",
      [&](report::Fields& to) {
        report::put_results(to, worst.project, worst.verification,
                            beams.size() > 1 ? &beams : nullptr);
      },
      wanted));
  return book;
}

}  // namespace boxbeam
