#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/design_space.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam::program {

/// The numbers that expressions of a study name: variables and results by their keys.
class DesignNumbers {
 public:
  /// Looks at the study, which stays. Throws InputError where an expression is none.
  DesignNumbers(const Study& study, const std::vector<std::string>& expressions);

  /// In the order of the numbers.
  const std::vector<std::string>& names() const { return names_; }
  /// Whether any is a result, for which a design must be verified.
  bool asks_results() const { return !results_.empty(); }

  /// Units of the results that are named, "1" without. Throws InputError where one is none of these
  /// beams', or where the study has no case.
  std::map<std::string, std::string> units_in(const std::vector<VerifiedBeam>& beams) const;
  void require_case() const;

  /// Of a design and, where results are asked, its beams. Throws AnalysisError where a result is
  /// missing or, where the verdict is not asked beside it, rests on stresses that cannot be
  /// believed.
  std::vector<double> of(const std::vector<Setting>& design, const std::vector<VerifiedBeam>& beams,
                         bool beside_verdict = false) const;

 private:
  const Study* study_;
  std::vector<std::string> names_;
  std::vector<std::string> results_;  ///< of the names those that are no variables
};

/// Why the stresses of a beam cannot be believed; nothing where they can.
std::optional<AnalysisError> not_judged(const Verification& of);

}  // namespace boxbeam::program
