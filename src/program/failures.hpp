#pragma once

#include <functional>

namespace boxbeam::program {

/// Runs a command: its exit code, or that of what it throws, whose cause goes to standard error.
/// What no part of the program foresees ends as an analysis that cannot be done, never as an abort.
int exit_code_of(const std::function<int()>& command);

}  // namespace boxbeam::program
