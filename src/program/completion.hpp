#pragma once

#include <string>

#include "program/command_line.hpp"

namespace boxbeam::program {

/// The completion of the command line for a shell, "bash" or "zsh": commands, options, the values
/// that an option can have, and files of the kind that is wanted.
std::string completion_of(const CommandLine& line, const std::string& shell);

}  // namespace boxbeam::program
