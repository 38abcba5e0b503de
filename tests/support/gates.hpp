#pragma once

#include <algorithm>
#include <string>

#include "boxbeam/verification/verify.hpp"

/// What stands against a verdict, or is said beside it.
namespace test {

inline bool has_gate(const boxbeam::Verification& of, const std::string& words) {
  return std::any_of(of.gates.begin(), of.gates.end(), [&](const boxbeam::Gate& gate) {
    return gate.finding.find(words) != std::string::npos;
  });
}

/// Whether one of those that stand against it says so.
inline bool blocks(const boxbeam::Verification& of, const std::string& words) {
  return std::any_of(of.gates.begin(), of.gates.end(), [&](const boxbeam::Gate& gate) {
    return gate.blocks && gate.finding.find(words) != std::string::npos;
  });
}

}  // namespace test
