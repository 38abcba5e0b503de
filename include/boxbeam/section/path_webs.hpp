#pragma once

#include <cstddef>
#include <vector>

#include "boxbeam/section/section_points.hpp"

namespace boxbeam {

/// The walls of a path that are its webs: steeper than 45 degrees, on a way of such walls that
/// spans at least half of the path's height and meets other walls at both its ends. Stems and lips
/// with a free end, and walls of short troughs, are none.
std::vector<std::size_t> webs_of(const ThinWalled& path);

/// What a place of a path is beside a wall: on a web, or where a web meets another wall (no farther
/// from both mid-lines than half of both thicknesses together).
SectionPart part_in(const ThinWalled& path, const std::vector<std::size_t>& webs, Length y,
                    Length z);

/// Whether a section has webs: boxes and rectangular tubes have, of paths those that `webs_of`
/// finds, also within another profile.
bool has_webs(const Section& section);

}  // namespace boxbeam
