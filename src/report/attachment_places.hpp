#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam::report {

/// Welds of attachments that are alike.
struct AlikeWelds {
  const BeamDetail* detail = nullptr;
  std::string where;  ///< "s = 2, 4, 6 m", "s = 0 to 8 m"
};

/// Those that may govern, or of which the case says what they are.
std::vector<AlikeWelds> alike_welds_of(const FatigueInput& fatigue);

}  // namespace boxbeam::report
