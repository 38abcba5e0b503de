#pragma once

#include <optional>
#include <string>
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

/// How long the panel at a station is; nothing where it is not between two diaphragms.
std::optional<Length> panel_length_at(const TaperedBeam& beam, const Station& station);

/// The plates of a station with what supports them across. Stiffeners of a plate that would do
/// without them are left out, they count as area alone.
std::optional<FourWalls> judged_walls_at(const Project& project, const Station& station);

/// Whether the c/t of a plate without its stiffeners is above the limit of class 3 in even
/// compression.
bool may_buckle(const BoxWall& wall);

/// Why the stiffened plates of a section are not judged, "" where they are.
std::string stiffener_obstacle(const FourWalls& of);

/// Whether a plate without stiffeners is so slender that it may buckle in shear (5.1(2)).
bool may_buckle_in_shear(const BoxWall& wall);

/// What shear lag leaves of the plates of a section at a station.
LagShares lag_shares_at(const std::vector<BendingZone>& zones, const Section& section,
                        const Station& station);

/// How far the supports across the plates at a station are apart: diaphragms, and the ends of the
/// beam.
Length supported_length_at(const Project& project, Station station);

}  // namespace boxbeam
