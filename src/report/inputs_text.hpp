#pragma once

#include <string>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// The case's data that decide, in a page: beam, holes, driver, steel and demands.
std::string inputs_text(const Project& project);

/// A profile in one line, mm.
std::string profile_text(const Profile& profile);

}  // namespace boxbeam
