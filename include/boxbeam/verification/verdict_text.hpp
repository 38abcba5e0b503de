#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// What a gate says, plates of which the same is to be said together.
struct GateText {
  std::string text;  ///< "web of segment S1, S2: ..."
  bool blocks = false;
};

std::vector<GateText> gate_texts_of(const Verification& verification);

/// A verdict in words, which leave out nothing that was asked for.
struct VerdictText {
  std::string word;  ///< "PASS", "FAIL", "NOT APPLICABLE", with which the line begins
  /// "PASS", "PASS (strength only)" where the case asks for no fatigue, "PASS for strength;
  /// fatigue: no stress range", "FAIL; rod hanger: no force", "NOT APPLICABLE".
  std::string line;
  std::vector<std::string> reasons;  ///< why it is not applicable, then what was not judged

  /// "NOT APPLICABLE: reason; reason".
  std::string whole() const;
};

VerdictText verdict_text_of(const Project& project, const Verification& verification);

}  // namespace boxbeam
