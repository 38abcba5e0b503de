#pragma once

#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// The verdict in one sentence that can stand alone, in a mail: what is used most, where and in
/// which situation, and where the case fails what would make it pass, as far as that was sought.
///
///     fails in fatigue at 2.5 m, fibre +z (saddle plate), 119 % used, under "running"; category 63
///     or 34 mm flanges would pass
std::string verdict_sentence_of(const Project& project, const Verification& verification);

}  // namespace boxbeam
