#pragma once

#include <string>
#include <vector>

namespace boxbeam::program {

struct ValidateOptions {
  std::string case_file;
  std::vector<std::string> set;
  std::string dynamics;  ///< "": as the case says
};

/// `boxbeam validate`: reads a case, and says what it is or everything that is wrong with it.
/// Returns the exit code.
int run_validate(const ValidateOptions& options);

}  // namespace boxbeam::program
