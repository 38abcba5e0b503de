#pragma once

#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// The thicknesses at which what a plate resists may jump or bend: where the strengths of the steel
/// fall, where a size effect begins, where the row of a detail ends. Ascending, each once.
std::vector<Length> thickness_limits_of(const Project& project);

/// The section a billionth of the segment inside a station's side; of a station without side, and
/// of a segment that does not change, the section there.
Section section_inside(const TaperedBeam& beam, const Station& station);

/// The section by which a station is judged. Where a plate of varying thickness has just reached a
/// limit, each side of the station has strengths of its own: there it is the section inside, so
/// that the thicker side counts as thicker.
Section judged_section_at(const Project& project, const Station& station);

}  // namespace boxbeam
