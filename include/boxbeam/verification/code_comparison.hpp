#pragma once

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
  Length thickness;           ///< of the plate at the place
  double size_factor = 1.0;   ///< on the curve's strengths, by the code's own rule for that plate
  std::string size_rule;      ///< in words; "" of the case's own code, whose detail has its own
  double damage_limit = 1.0;  ///< of the damage sum; less than 1 where the code asks for it
  /// Why there is no result: a detail weaker than every curve of the code. The rest is then empty.
  std::string missing;
};

/// The governing direct-stress fatigue check under the case's own code and the others it names:
/// the same stress ranges, counts and partial factors on the code's curve whose strength at 2e6
/// cycles is nearest below that of the detail (without its size effect), with the code's own
/// correction for the thickness of the plate and its own limit of the damage sum. Empty where the
/// case names no other code.
std::vector<CodeResult> compare_codes(const Project& project,
                                      const std::vector<CheckResult>& checks);

}  // namespace boxbeam
