#pragma once

#include <string>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// An input as the user wrote it: millimetres without trailing zeros.
std::string plain_mm(Length x);

/// A profile in one line, mm.
std::string profile_text(const Profile& profile);

}  // namespace boxbeam
