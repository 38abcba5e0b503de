#pragma once

#include <map>
#include <string>
#include <vector>

#include "boxbeam/study/named_expression.hpp"
#include "boxbeam/study/optimum.hpp"
#include "program/design_numbers.hpp"
#include "program/design_trial.hpp"

namespace boxbeam::program {

/// What a study is to be the best of, and the names that stand in its expressions.
class BestDesign {
 public:
  explicit BestDesign(const Study& study);

  const Study& study() const { return *study_; }
  const OptimiseDemand& demand() const { return *demand_; }
  const std::vector<Choice>& choices() const { return choices_; }
  const std::vector<std::string>& units() const { return units_; }
  const std::vector<std::string>& limits() const { return limits_; }
  const DesignNumbers& numbers() const { return numbers_; }
  bool has_case() const { return !study_->case_file.empty(); }

  std::string goal_unit(const std::string& goal) const;
  /// All variables of a design.
  std::vector<Setting> settings_of(const std::vector<double>& chosen) const;
  VerifiedDesign verified(const std::vector<Setting>& design) const;

 private:
  void add_choice(std::size_t i);
  void find_units();

  const Study* study_;
  const OptimiseDemand* demand_;
  DesignTrials trials_;
  std::vector<Choice> choices_;
  std::vector<std::string> units_;
  std::vector<std::size_t> places_;  ///< of the choices among the variables
  std::vector<std::string> limits_;
  DesignNumbers numbers_;  ///< in expressions
  std::map<std::string, std::string> result_units_;
};

/// Of a design all goals, and the margins of the limits.
struct Judged {
  std::vector<double> goals;
  std::vector<double> margins;
  std::string trouble;
};

/// Judges designs for one thread.
class DesignJudge {
 public:
  explicit DesignJudge(const BestDesign& problem);

  Judged at(const std::vector<double>& chosen);

 private:
  void judge(const std::vector<double>& chosen, Judged& judged);

  const BestDesign* problem_;
  std::vector<NamedExpression> goals_, limits_;
};

}  // namespace boxbeam::program
