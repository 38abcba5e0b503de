#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/checks.hpp"

namespace boxbeam {

/// The direct-stress fatigue of the beam under one code.
struct CodeResult {
  std::string code;   ///< with its edition
  std::string curve;  ///< at the place that governs
  bool unconfirmed = false;
  Station station;
  std::string point;
  double safety_factor = 0.0;
  double required = 1.0;
  /// Why there is no result: a detail weaker than every curve of the code. The rest is then empty.
  std::string missing;
};

/// The governing direct-stress fatigue check under the case's own code and the others it names:
/// the same stress ranges, counts and partial factors on the code's curve whose strength at 2e6
/// cycles is nearest below that of the detail. Empty where the case names no other code.
std::vector<CodeResult> compare_codes(const Project& project,
                                      const std::vector<CheckResult>& checks);

}  // namespace boxbeam
