#pragma once

#include <string>

#include "program/command_line.hpp"

namespace boxbeam::program {

/// The manual page, for man(1): boxbeam manual | man -l -
std::string manual_of(const CommandLine& line);

}  // namespace boxbeam::program
