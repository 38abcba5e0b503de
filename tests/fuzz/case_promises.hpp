#pragma once

#include <string>

#include "fuzz/case_mutator.hpp"

namespace fuzz {

/// How a case ended.
enum class Ending { refused, impossible, pass, fail, not_applicable, broken };

struct Outcome {
  Ending ending = Ending::broken;
  std::string words;  ///< the message, or the promise that was broken
};

/// Reads and verifies a case in this process and looks whether every promise is kept: a case is
/// refused or impossible with words that say why, or its results are numbers, as its schema says,
/// with factors above zero. `with_report`: so is the report.
Outcome outcome_of(const Mutant& mutant, bool with_report);

}  // namespace fuzz
