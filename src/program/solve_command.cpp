#include "program/solve_command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/report/result_book.hpp"
#include "boxbeam/report/solution_report.hpp"
#include "boxbeam/study/case_keys.hpp"
#include "boxbeam/study/solution.hpp"
#include "program/design_numbers.hpp"
#include "program/design_trial.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// "fatigue.safety_factor = 2", as it is written.
struct Wanted {
  std::string result, value;
};

Wanted wanted_in(const std::string& text) {
  const std::size_t equals = text.find('=');
  Wanted wanted;
  if (equals != std::string::npos)
    wanted = {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
  const bool compares = wanted.result.ends_with('<') || wanted.result.ends_with('>') ||
                        wanted.result.ends_with('!') || wanted.value.starts_with('=');
  if (compares)
    throw InputError(fmt::format("--such-that: \"{}\" is no single value", text),
                     "write for example --such-that \"fatigue.safety_factor = 2\": what is wanted "
                     "is the limit itself");
  if (wanted.result.empty() || wanted.value.empty())
    throw InputError(fmt::format("--such-that: \"{}\" is not a result, =, and a value", text),
                     "write for example --such-that \"fatigue.safety_factor = 2\"");
  return wanted;
}

/// "90 %" as a number; nothing where the text is none.
std::optional<double> percent_in(const std::string& text) {
  if (!text.ends_with('%')) return std::nullopt;
  const auto number = quantity_written_in(trimmed(text.substr(0, text.size() - 1)));
  if (!number || !number->unit.empty()) return std::nullopt;
  return 0.01 * number->value;
}

/// The wanted value in the SI unit of its result.
double value_of(const Wanted& wanted, const ResultValue& result) {
  if (const auto percent = percent_in(wanted.value); percent && result.unit == "1") return *percent;
  const auto parsed = parse_quantity(wanted.value);
  const auto unit = parse_quantity(result.unit == "1" ? "1" : "1 " + result.unit);
  const auto* const value = std::get_if<ParsedQuantity>(&parsed);
  const DimensionExponents& exponents = std::get<ParsedQuantity>(unit).exponents;
  if (value == nullptr || value->exponents != exponents)
    throw InputError(
        fmt::format("--such-that: {} is {}, not \"{}\"", result.key, name_of(exponents),
                    wanted.value),
        fmt::format("write for example \"{} = {}\"", wanted.result,
                    to_text(WrittenQuantity{2.0, result.unit == "1" ? "" : result.unit})));
  return value->value;
}

InputError unknown_key(const SolveOptions& options, const Node& root) {
  const std::string near = nearest_number_key(root, options.key);
  return InputError(fmt::format("the case says nothing of {}", options.key),
                    fmt::format("{}For a key that it leaves out give --between \"5 mm\" \"20 mm\"",
                                near.empty() ? "" : fmt::format("did you mean {}? ", near)));
}

/// What the case says of the key; nothing where it says nothing and need not.
std::optional<WrittenQuantity> own_amount(const SolveOptions& options) {
  const CaseDocument document = read_document(options.of_case.file, options.of_case.set);
  const Node* const node = value_at(document.root, options.key);
  if (node == nullptr && options.between.empty()) throw unknown_key(options, document.root);
  if (node == nullptr) return std::nullopt;
  std::optional<WrittenQuantity> own = quantity_written_in(*node);
  if (!own)
    throw InputError(
        {document.problem_at(node->place, fmt::format("{} is no number", options.key),
                             "--for takes a key whose value is a number or a quantity")});
  return own;
}

/// Where to look, in the unit of the case or, where it says nothing, of the first bound.
std::pair<WrittenQuantity, WrittenQuantity> interval_of(const SolveOptions& options,
                                                        const std::optional<WrittenQuantity>& own) {
  if (options.between.empty()) {
    if (own->value == 0.0)
      throw InputError(fmt::format("{} is 0 in the case", options.key),
                       "give --between with two values");
    const double low = 0.25 * own->value, high = 4.0 * own->value;
    return {{std::min(low, high), own->unit}, {std::max(low, high), own->unit}};
  }
  std::vector<WrittenQuantity> ends;
  for (const std::string& text : options.between) {
    const std::optional<WrittenQuantity> end = quantity_written_in(text);
    if (!end)
      throw InputError(fmt::format("--between: \"{}\" is no quantity", text),
                       "write a number with its unit, \"5 mm\"");
    const std::string unit = own ? own->unit : ends.empty() ? end->unit : ends.front().unit;
    const std::optional<double> ratio = ratio_of_units(unit, end->unit);
    if (!ratio)
      throw InputError(fmt::format("--between: \"{}\" is not of the dimension of {}", text,
                                   own ? to_text(*own) : options.between.front()),
                       "write both in the unit of the key");
    ends.push_back({end->value * *ratio, unit});
  }
  if (ends[0].value > ends[1].value) std::swap(ends[0], ends[1]);
  if (ends[0].value == ends[1].value)
    throw InputError("--between: both values are the same", "give two that are apart");
  return {ends[0], ends[1]};
}

/// A case of which one key is looked for.
class Search {
 public:
  explicit Search(const SolveOptions& options)
      : options_(&options), trials_(options.of_case), wanted_(wanted_in(options.such_that)) {
    const std::optional<WrittenQuantity> own = own_amount(options);
    std::tie(solution_.from, solution_.to) = interval_of(options, own);
    solution_.case_file = options.of_case.file;
    solution_.key = options.key;
    solution_.own = own;
    look_at_case();
  }

  Solution run(Progress& progress) {
    RootQuestion question;
    question.from = solution_.from.value;
    question.to = solution_.to.value;
    question.wanted = solution_.wanted;
    question.whole = takes_whole_numbers();
    std::size_t count = 0;
    question.at = [&](double value) {
      progress.now(fmt::format("verification {}, {}", ++count,
                               to_text(WrittenQuantity{value, solution_.from.unit})));
      return trial_at(value);
    };
    solution_.search = roots_of(question);
    for (const Root& root : solution_.search.roots) solution_.values.push_back(solved_at(root));
    if (solution_.values.empty()) solution_.reason = reason_of(solution_);
    return solution_;
  }

 private:
  std::vector<std::string> set_to(double value) const {
    return {
        fmt::format("{}={}", options_->key, to_text(WrittenQuantity{value, solution_.from.unit}))};
  }
  /// A case that can be read with its own number, but with no part more.
  bool takes_whole_numbers() const {
    if (!solution_.own || !solution_.own->unit.empty()) return false;
    const double own = solution_.own->value;
    if (own != std::round(own)) return false;
    const auto can_be = [&](double value) {
      CaseOptions with = options_->of_case;
      for (std::string& set : set_to(value)) with.set.push_back(std::move(set));
      return trouble_of([&] { read_beams_of(with); }).empty();
    };
    return can_be(own) && !can_be(own + 1e-6) && !can_be(own - 1e-6);
  }
  VerifiedDesign verified_at(double value) const { return trials_.verify(set_to(value)); }

  /// What is asked for must be there somewhere: in the case as it is, else in the middle or at a
  /// bound.
  void look_at_case() {
    std::optional<ResultBook> book;
    const auto look_at = [&](const std::vector<std::string>& set) {
      if (!book) trouble_of([&] { book = results_of(trials_.verify(set).beams); });
      return book.has_value();
    };
    const bool is_own = solution_.own && look_at({});
    const double from = solution_.from.value, to = solution_.to.value;
    for (const double value : {0.5 * (from + to), from, to}) look_at(set_to(value));
    if (!book)  // says why not
      book = results_of(
          trials_.verify(solution_.own ? std::vector<std::string>{} : set_to(0.5 * (from + to)))
              .beams);
    const ResultValue* const result = book->find(wanted_.result);
    if (result == nullptr)
      throw InputError(fmt::format("there is no result \"{}\"", wanted_.result),
                       book->hint_for(wanted_.result));
    solution_.result = result->key;
    solution_.result_unit = result->unit;
    solution_.wanted = value_of(wanted_, *result);
    if (is_own) solution_.own_result = result->value;
  }

  Trial trial_at(double value) const {
    Trial trial;
    trial.trouble = trouble_of([&] {
      const ResultBook book = results_of(verified_at(value).beams);
      const ResultValue* const result = book.find(solution_.result);
      if (result != nullptr) trial.result = result->value;
    });
    if (!trial.result && trial.trouble.empty())
      trial.trouble = fmt::format("there is no {}", solution_.result);
    return trial;
  }

  SolvedValue solved_at(const Root& root) const {
    const VerifiedDesign found = verified_at(root.value);
    const Verification& of = worst_of(found.beams).verification;
    SolvedValue solved{
        {root.value, solution_.from.unit}, root.result, to_text(of.verdict), "", 0.0, ""};
    if (const std::optional<AnalysisError> why = not_judged(of))
      solved.gate = in_one_line(why->failure().what);
    if (!of.checks.empty()) {
      solved.governing = of.checks.front().check.id;
      solved.utilisation = of.checks.front().check.utilisation();
    }
    return solved;
  }

  const SolveOptions* options_;
  DesignTrials trials_;
  Wanted wanted_;
  Solution solution_;
};

}  // namespace

int run_solve(const SolveOptions& options) {
  require_file(options.json);
  Solution solution;
  {
    Progress progress;
    progress.now("verifying the case as it is");
    solution = Search(options).run(progress);
  }
  put_result(options.json, solution_json(solution), solution_text(solution));
  return solution.values.empty() ? check_fails : all_pass;
}

}  // namespace boxbeam::program
