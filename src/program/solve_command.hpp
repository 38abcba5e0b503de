#pragma once

#include <string>
#include <vector>

#include "program/case_options.hpp"

namespace boxbeam::program {

struct SolveOptions {
  CaseOptions of_case;
  std::string key;                   ///< of the case, that is looked for
  std::string such_that;             ///< "RESULT = VALUE"
  std::vector<std::string> between;  ///< two values; none: a quarter to four times that of the case
  std::string json;
};

/// `boxbeam solve`: the values of a key at which a result is the wanted one. Returns the exit code.
int run_solve(const SolveOptions& options);

}  // namespace boxbeam::program
