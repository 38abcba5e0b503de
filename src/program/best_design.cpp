#include "program/best_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "program/study_designs.hpp"

namespace boxbeam::program {
namespace {

std::vector<std::string> goals_and_limits_of(const OptimiseDemand& demand) {
  std::vector<std::string> all = demand.minimise;
  all.insert(all.end(), demand.subject_to.begin(), demand.subject_to.end());
  return all;
}

/// How far a check is from its limit: 1 - use, beyond it -ln(use), which has the same slope there
/// and does not run away.
double margin_of(double use) {
  constexpr double farthest = -50.0;
  if (use <= 1.0) return 1.0 - use;
  return std::isfinite(use) ? std::max(farthest, -std::log(use)) : farthest;
}

/// The worst use of each criterion; one that judges nothing keeps its limit.
void add_margins_of_checks(const std::vector<VerifiedBeam>& beams, Judged& judged) {
  std::array<double, criteria.size()> margins;
  margins.fill(1.0);
  for (const VerifiedBeam& beam : beams) {
    const Verification& of = beam.verification;
    if (of.verdict == Verdict::not_applicable) throw *not_judged(of);
    for (std::size_t i = 0; i < criteria.size(); ++i)
      if (const CheckResult* const worst = of.governing(criteria[i]))
        margins[i] = std::min(margins[i], margin_of(worst->check.utilisation()));
  }
  judged.margins.assign(margins.begin(), margins.end());
}

}  // namespace

BestDesign::BestDesign(const Study& study)
    : study_(&study),
      demand_(&*study.optimise),
      trials_(case_of(study)),
      numbers_(study, goals_and_limits_of(*demand_)) {
  for (std::size_t i = 0; i < study.variables.size(); ++i) add_choice(i);
  if (choices_.empty())
    throw InputError(fmt::format("{}: no variable may be chosen", study.path),
                     "write grid = { from = ..., to = ..., count = 2 } or values = [...]");
  if (demand_->checks)
    for (const Criterion criterion : criteria) limits_.emplace_back(to_text(criterion));
  for (const std::string& limit : demand_->subject_to) limits_.push_back(limit);
  if (!numbers_.asks_results()) return;
  numbers_.require_case();
  find_units();
}

/// Of the case as it is or, where it cannot be verified, of a design in the middle or at an end.
void BestDesign::find_units() {
  const auto known_by = [&](const std::vector<std::string>& set) {
    VerifiedDesign of;
    const std::string trouble = trouble_of([&] { of = trials_.verify(set); });
    if (trouble.empty()) result_units_ = numbers_.units_in(of.beams);
    return trouble.empty();
  };
  if (known_by({})) return;
  for (const double share : {0.5, 0.0, 1.0}) {
    std::vector<double> chosen;
    for (const Choice& of : choices_)
      chosen.push_back(of.values.empty() ? of.from + share * (of.to - of.from)
                                         : of.values[static_cast<std::size_t>(
                                               share * static_cast<double>(of.values.size() - 1))]);
    std::vector<std::string> set;
    if (trouble_of([&] { set = overrides_of(*study_, settings_of(chosen)); }).empty() &&
        known_by(set))
      return;
  }
  trials_.verify({});  // says why not
}

std::string BestDesign::goal_unit(const std::string& goal) const {
  const auto found = result_units_.find(goal);
  return found == result_units_.end() || found->second == "1" ? "" : found->second;
}

std::vector<Setting> BestDesign::settings_of(const std::vector<double>& chosen) const {
  std::vector<Setting> design(study_->variables.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) design[places_[i]].number = chosen[i];
  take_expressions(*study_, design);
  return design;
}

VerifiedDesign BestDesign::verified(const std::vector<Setting>& design) const {
  return trials_.verify(overrides_of(*study_, design));
}

void BestDesign::add_choice(std::size_t i) {
  const Variable& variable = study_->variables[i];
  if (!variable.expression.empty()) return;
  Choice choice{variable.name, 0.0, 0.0, {}};
  if (variable.distribution) {
    choice.from = variable.distribution->a;
    choice.to = variable.distribution->b;
  } else if (variable.is_grid) {
    choice.from = std::min(variable.values.front(), variable.values.back());
    choice.to = std::max(variable.values.front(), variable.values.back());
  } else {
    choice.values = variable.values;
    std::sort(choice.values.begin(), choice.values.end());
    choice.values.erase(std::unique(choice.values.begin(), choice.values.end()),
                        choice.values.end());
  }
  if (choice.values.empty() && !(choice.from < choice.to))
    throw InputError(
        fmt::format("{}: the ends of variable {} are the same", study_->path, variable.name),
        "write two that are apart");
  choices_.push_back(std::move(choice));
  units_.push_back(variable.unit);
  places_.push_back(i);
}

DesignJudge::DesignJudge(const BestDesign& problem) : problem_(&problem) {
  for (const std::string& goal : problem.demand().minimise)
    goals_.emplace_back(goal, problem.numbers().names());
  for (const std::string& limit : problem.demand().subject_to)
    limits_.emplace_back(limit, problem.numbers().names());
}

Judged DesignJudge::at(const std::vector<double>& chosen) {
  Judged judged;
  judged.trouble = trouble_of([&] { judge(chosen, judged); });
  return judged;
}

void DesignJudge::judge(const std::vector<double>& chosen, Judged& judged) {
  const std::vector<Setting> design = problem_->settings_of(chosen);
  VerifiedDesign found;
  if (problem_->demand().checks || problem_->numbers().asks_results())
    found = problem_->verified(design);
  const std::vector<VerifiedBeam>& beams = found.beams;
  if (problem_->demand().checks) add_margins_of_checks(beams, judged);
  const std::vector<double> numbers =
      problem_->numbers().of(design, beams, problem_->demand().checks);
  for (NamedExpression& goal : goals_) judged.goals.push_back(goal.at(numbers));
  for (NamedExpression& limit : limits_) judged.margins.push_back(limit.at(numbers));
}

}  // namespace boxbeam::program
