#pragma once

#include "program/case_options.hpp"

namespace boxbeam::program {

/// `boxbeam validate`: reads a case, and says what it is or everything that is wrong with it.
/// Returns the exit code.
int run_validate(const CaseOptions& options);

}  // namespace boxbeam::program
