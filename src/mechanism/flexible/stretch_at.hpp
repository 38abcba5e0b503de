#pragma once

#include <algorithm>
#include <vector>

#include "boxbeam/mechanism/flexible/mechanism.hpp"

namespace boxbeam::flexible {

/// The first stretch of a link that ends beyond a place of its axis, or the last.
inline std::vector<LinkStretch>::const_iterator stretch_at(const Link& link, double s) {
  return std::partition_point(link.stretches.begin(), link.stretches.end() - 1,
                              [&](const LinkStretch& of) { return of.start + of.length <= s; });
}

}  // namespace boxbeam::flexible
