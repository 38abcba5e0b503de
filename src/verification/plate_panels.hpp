#pragma once

#include <array>
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

/// How far the diaphragms around a station are apart; nothing where it is not between two.
std::optional<Length> panel_length_at(const TaperedBeam& beam, const Station& station);

/// The diaphragm at a station as what bounds panels of a box's plate, with what of it works beside
/// the plate; nothing where nothing of it stands there. The station is on the panel's side of it.
std::optional<BearingStiffener> bounding_stiffener_at(const Project& project,
                                                      const Station& station,
                                                      const FourWalls& walls, BoxPlate plate);

/// Why what reaches from a plate to another one does not bound panels so long, "" where it does.
std::string across_obstacle(const BearingStiffener& of, const Diaphragm& diaphragm, Length length);

/// How long the panel of a box's plate at a station is, no shorter than those for which both
/// diaphragms are rigid (9.3.3(3)); nothing where it is not between two that bound it.
std::optional<Length> panel_length_at(const Project& project, const Station& station,
                                      BoxPlate plate);

/// The plates that decide what of a station is judged, so that it is no matter of the segments into
/// which a beam is cut: those of the station, of a steep segment as wide as they become in their
/// panel. On both sides of where they cross a limit the beam is cut (`plate_choices_at`).
std::optional<FourWalls> deciding_walls_at(const Project& project, const Station& station);

/// Which plates of a station are judged, each a number that changes where it is judged otherwise.
std::vector<int> plate_choices_at(const Project& project, const Station& station);

/// The plates of both ends of the segment of a station.
std::vector<FourWalls> walls_of_segment(const Project& project, const Station& station);

/// The clear widths of the plates where they are widest, by BoxPlate, in the panel of a station:
/// between diaphragms, or on a side without one to where the beam is steep no more.
std::array<Length, 4> widest_in_panel(const Project& project, const Station& station);

/// The plates of a station with what supports them across. Stiffeners of a plate that would do
/// without them are left out, they count as area alone. Of nested profiles those of the outer one.
std::optional<FourWalls> judged_walls_at(const Project& project, const Station& station);

/// c/t above the limit of class 3 in even compression.
bool may_buckle(const BoxWall& wall);

/// Whether a plate has stiffeners and may buckle without them.
bool may_buckle_with_stiffeners(const FourWalls& walls, BoxPlate plate);

/// Why the stiffened plates of a section are not judged, "" where they are.
std::string stiffener_obstacle(const FourWalls& of);

/// Why a flange of a box may buckle into one of its slender webs, "" where none may; in space a web
/// into a slender flange, too, for under M_z each is the other. Source: EN 1993-1-5:2006, 8(1).
std::string induced_obstacle(const FourWalls& of, bool in_space);

/// Whether a plate without stiffeners is so slender that it may buckle in shear (5.1(2)).
bool may_buckle_in_shear(const BoxWall& wall);

/// What shear lag leaves of the plates of a section at a station.
LagShares lag_shares_at(const std::vector<BendingZone>& zones, const Section& section,
                        const Station& station);

/// How steep the edges of a segment are: those that move along y, and along z.
struct EdgeSlopes {
  double along_y = 0.0, along_z = 0.0;
};
EdgeSlopes edge_slopes_of(const Segment& segment);

/// The diaphragms before and behind a station.
struct Supports {
  std::optional<Length> before, behind;
};
Supports supports_around(const TaperedBeam& beam, Station station);

/// How far the supports across the plates at a station are apart: diaphragms, of boxes those that
/// bound the panels of all their stiffened plates, and the ends of the beam.
Length supported_length_at(const Project& project, const Station& station);

}  // namespace boxbeam
