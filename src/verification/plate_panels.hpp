#pragma once

#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/plate_checks.hpp"

namespace boxbeam {

/// Makes panels of the plates at a station, where it lies between two diaphragms: as long as these
/// are apart and, where the beam tapers by no more than 10 degrees, as deep as here (EN 1993-1-5,
/// 2.3(1)). Webs whose beam has two diaphragms at each end that are rigid end posts have them, but
/// between these two themselves.
void divide_into_panels(const Project& project, const Station& station,
                        std::vector<ShearedPlate>& plates);

/// How far the supports across the plates at a station are apart: diaphragms, and the ends of the
/// beam.
Length supported_length_at(const Project& project, Station station);

}  // namespace boxbeam
