#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// A plate of a box, tube or path that goes on behind a border as a thicker or a thinner one.
struct PlateStep {
  std::string name;                   ///< before the border
  bool web = false, in_path = false;  ///< web: it lies along z
  Length from, to;                    ///< thicknesses
};

/// Those at the end of a segment that is not the last, whatever kind of profile is on either side.
std::vector<PlateStep> plate_steps_at(const Project& project, std::size_t segment);

}  // namespace boxbeam
