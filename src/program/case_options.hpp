#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam::program {

/// A case with what the command line changes of it; `dynamics` is "" where it is as the case says.
/// Throws InputError with all problems.
Project read_case(const std::string& path, const std::vector<std::string>& set,
                  const std::string& dynamics = "");

}  // namespace boxbeam::program
