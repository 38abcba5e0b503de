#pragma once

#include <array>
#include <string>

namespace boxbeam {

/// The least and the largest that a support does to what it holds, over the time that is looked at:
/// force and couple, world axes [N, N m].
struct SupportReaction {
  std::string name;
  std::array<double, 6> low{}, high{};
};

}  // namespace boxbeam
