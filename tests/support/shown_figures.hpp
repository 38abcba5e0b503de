#pragma once

#include <string>
#include <vector>

#include "src/report/figure_kinds.hpp"

namespace test {

/// Names of the figures that a report of a verification shows, in its order.
inline std::vector<std::string> shown_figures(const boxbeam::Project& project,
                                              const boxbeam::Verification& verification) {
  std::vector<std::string> names;
  for (const boxbeam::report::FigureKind& kind : boxbeam::report::figure_kinds()) {
    if (kind.shown(project, verification)) names.emplace_back(kind.name);
  }
  return names;
}

}  // namespace test
