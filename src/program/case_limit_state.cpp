#include "program/case_limit_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/named_expression.hpp"
#include "program/design_numbers.hpp"
#include "program/design_trial.hpp"

namespace boxbeam::program {
namespace {

CaseOptions case_options_of(const Study& study) {
  CaseOptions options;
  options.file = study.case_file;
  return options;
}

std::vector<std::string> criterion_names() {
  std::vector<std::string> names;
  for (const Criterion criterion : criteria) names.emplace_back(to_text(criterion));
  return names;
}

/// Why a design cannot be judged by a check, "" where it can.
std::string not_judged_by(const std::string& check, const std::vector<VerifiedBeam>& beams) {
  bool is_there = false;
  for (const VerifiedBeam& beam : beams) {
    const Verification& of = beam.verification;
    for (const Gate& gate : of.gates)
      if (gate.blocks) return fmt::format("not applicable: {}", gate.finding);
    for (const NotJudged& missing : of.not_judged)
      if (check == "all" || check == to_text(missing.by))
        return fmt::format("{}: {}", missing.what, missing.reason);
    is_there =
        is_there || std::any_of(of.checks.begin(), of.checks.end(), [&](const CheckResult& result) {
          return check == "all" || check == to_text(result.check.criterion);
        });
  }
  return is_there ? "" : fmt::format("there is no check {}", check);
}

double largest_use(const std::string& check, const std::vector<VerifiedBeam>& beams) {
  double most = 0.0;
  for (const VerifiedBeam& beam : beams)
    for (const CheckResult& result : beam.verification.checks)
      if (check == "all" || check == to_text(result.check.criterion))
        most = std::max(most, result.check.utilisation());
  return most;
}

/// What one thread needs to judge designs.
class Judge {
 public:
  Judge(const Study& study, const StudyTransformation& transformation, const DesignTrials& trials)
      : study_(&study),
        transformation_(&transformation),
        trials_(&trials),
        numbers_(study, study.reliability->expressions) {
    for (const std::string& text : study.reliability->expressions)
      expressions_.emplace_back(text, numbers_.names());
  }

  /// Throws InputError and AnalysisError.
  std::vector<Setting> design_at(const Eigen::VectorXd& u) const {
    return design_of(*study_, transformation_->values_at(u));
  }
  VerifiedDesign verified(const std::vector<Setting>& design) const {
    return trials_->verify(overrides_of(*study_, design));
  }

  Response at(const Eigen::VectorXd& u) {
    Response response;
    const std::string trouble = trouble_of([&] {
      const std::vector<Setting> design = design_at(u);
      const VerifiedDesign found = verified(design);
      const std::vector<VerifiedBeam>& beams = found.beams;
      response.g = std::numeric_limits<double>::infinity();
      for (const std::string& check : study_->reliability->checks) {
        response.trouble = not_judged_by(check, beams);
        if (!response.trouble.empty()) return;
        response.g = std::min(response.g, -std::log(largest_use(check, beams)));
      }
      if (!expressions_.empty()) take_expressions(design, beams, response);
    });
    if (!trouble.empty()) response.trouble = trouble;
    return response;
  }

 private:
  void take_expressions(const std::vector<Setting>& design, const std::vector<VerifiedBeam>& beams,
                        Response& response) {
    const std::vector<double> numbers = numbers_.of(design, beams);
    for (NamedExpression& expression : expressions_) {
      const double g = expression.at(numbers);
      if (std::isnan(g)) response.trouble = "an expression is no number";
      response.g = std::min(response.g, g);
    }
    // A verdict that counts for nothing leaves no number that can be believed.
    const std::string stopped = not_judged_by("", beams);
    if (stopped.starts_with("not applicable")) response.trouble = stopped;
  }

  const Study* study_;
  const StudyTransformation* transformation_;
  const DesignTrials* trials_;
  DesignNumbers numbers_;  ///< in expressions
  std::vector<NamedExpression> expressions_;
};

/// Every criterion that is asked for must be one, and judge the design of all medians.
void require_checks(const Study& study, const std::vector<VerifiedBeam>& beams) {
  std::vector<std::string> there;
  for (const VerifiedBeam& beam : beams)
    for (const CheckResult& result : beam.verification.checks) {
      const std::string name = to_text(result.check.criterion);
      if (std::find(there.begin(), there.end(), name) == there.end()) there.push_back(name);
    }
  const std::vector<std::string> known = criterion_names();
  for (const std::string& check : study.reliability->checks) {
    if (check == "all" || std::find(there.begin(), there.end(), check) != there.end()) continue;
    const bool is_known = std::find(known.begin(), known.end(), check) != known.end();
    throw InputError(is_known ? fmt::format("{}: the case has no check \"{}\"", study.path, check)
                              : fmt::format("{}: \"{}\" is no check", study.path, check),
                     fmt::format("one of {}, all", fmt::join(there, ", ")));
  }
}

}  // namespace

CaseLimitState limit_state_of_case(const Study& study, std::size_t threads) {
  const auto transformation = std::make_shared<const StudyTransformation>(study);
  const auto trials = std::make_shared<const DesignTrials>(case_options_of(study));
  const std::vector<Project> beams = read_beams_of(case_options_of(study));
  const Judge first(study, *transformation, *trials);
  const VerifiedDesign medians =
      first.verified(first.design_at(Eigen::VectorXd::Zero(transformation->dimension())));
  require_checks(study, medians.beams);
  DesignNumbers(study, study.reliability->expressions).units_in(medians.beams);
  const auto make = [transformation, trials, &study]() -> LimitState::Function {
    const auto judge = std::make_shared<Judge>(study, *transformation, *trials);
    return [transformation, trials, judge](const Eigen::VectorXd& u) { return judge->at(u); };
  };
  return {sha256_of(study.text + "\n" + beams.front().sha256),
          LimitState(transformation->dimension(), make, threads)};
}

}  // namespace boxbeam::program
