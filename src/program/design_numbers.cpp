#include "program/design_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/result_book.hpp"
#include "boxbeam/study/named_expression.hpp"

namespace boxbeam::program {
namespace {

/// The variable of a name, by its place; nothing where there is none.
std::optional<std::size_t> variable_of(const Study& study, const std::string& name) {
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    if (study.variables[i].name == name) return i;
  return std::nullopt;
}

/// Whether a result would be another one under other stresses; masses and seams would not.
bool rests_on_stresses(const std::string& key) {
  return !key.starts_with("beam.") || key.starts_with("beam.stations");
}

void require_judged(const std::vector<VerifiedBeam>& beams) {
  for (const VerifiedBeam& beam : beams)
    if (const std::optional<AnalysisError> why = not_judged(beam.verification)) throw *why;
}

}  // namespace

std::optional<AnalysisError> not_judged(const Verification& of) {
  for (const Gate& gate : of.gates)
    if (gate.blocks) return AnalysisError({gate.finding, ""});
  return std::nullopt;
}

DesignNumbers::DesignNumbers(const Study& study, const std::vector<std::string>& expressions)
    : study_(&study) {
  std::set<std::string> names;
  for (const std::string& text : expressions) {
    try {
      const std::vector<std::string> named = names_in(text);
      names.insert(named.begin(), named.end());
      NamedExpression looked_at(text, named);
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}: \"{}\": {}", study.path, text, error.what()),
                       "write an expression of variables and of keys of results.json");
    }
  }
  names_.assign(names.begin(), names.end());
  for (const std::string& name : names_)
    if (!variable_of(study, name)) results_.push_back(name);
}

void DesignNumbers::require_case() const {
  if (results_.empty() || !study_->case_file.empty()) return;
  throw InputError(fmt::format("{}: there is no variable \"{}\"", study_->path, results_.front()),
                   "name it in [variables], or write case = \"...\" in [study]");
}

std::map<std::string, std::string> DesignNumbers::units_in(
    const std::vector<VerifiedBeam>& beams) const {
  std::map<std::string, std::string> units;
  if (results_.empty()) return units;
  require_case();
  const ResultBook book = results_of(beams);
  for (const std::string& name : results_) {
    const ResultValue* const value = book.find(name);
    if (value == nullptr)
      throw InputError(fmt::format("{}: there is no variable or result \"{}\"", study_->path, name),
                       book.hint_for(name));
    units[name] = value->unit;
  }
  return units;
}

std::vector<double> DesignNumbers::of(const std::vector<Setting>& design,
                                      const std::vector<VerifiedBeam>& beams,
                                      bool beside_verdict) const {
  std::optional<ResultBook> book;
  if (!results_.empty()) book = results_of(beams, results_);
  std::vector<double> numbers;
  for (const std::string& name : names_) {
    if (const auto place = variable_of(*study_, name)) {
      numbers.push_back(design[*place].number);
    } else {
      const ResultValue* const value = book->find(name);
      if (value == nullptr) throw AnalysisError({fmt::format("there is no {}", name), ""});
      if (!beside_verdict && rests_on_stresses(value->key)) require_judged(beams);
      numbers.push_back(value->value);
    }
  }
  return numbers;
}

}  // namespace boxbeam::program
