#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/strength/plastic_box.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/reduced_plates.hpp"
#include "boxbeam/verification/sheared_plates.hpp"

namespace boxbeam {

/// The plates of a thin-walled path at a station, as far as one of them may buckle before it
/// yields.
struct SlenderPath {
  EffectivePath section;
  std::vector<ShearedWall> sheared;    ///< plates held at both ends
  std::vector<ShearedWall> outstands;  ///< beyond class 3
  std::optional<PlasticBox> plastic;   ///< of those like an I
  std::vector<ReducedPlate> reduced;   ///< by reduced stresses, beside the verdict
};

/// Of a path, its plates held at both ends being panels of that length. `looked_at`: the plates, by
/// name, by which outstands are beyond class 3 and others may buckle in shear.
SlenderPath slender_path_of(const ThinWalled& profile, const PathSection& path, const Taper& taper,
                            std::optional<Length> panel_length, double gamma_M1,
                            const std::vector<PathPlate>& looked_at);

/// What of the force that makes an outstand yield in shear acts in it.
double sheared_share(const ShearedWall& outstand, const CutForces& cut);
/// The largest of it that needs no check of its own.
inline constexpr double hardly_sheared = 0.1;
/// What is said of one that bears more.
std::string sheared_outstand_text(double share);

/// Why a path has no effective section, "" where it has: a plate beyond class 3 has no effective
/// width (`width_obstacle`), a flange may buckle into its web (clause 8), or it does not settle.
std::string section_obstacle(const EffectivePath& of);

/// Why the plates of a path are not judged by effective widths, "" where they are: where the case
/// asks for reduced stresses, its walls are inclined by more than 10 degrees (2.3), or its section
/// has an obstacle.
std::string path_obstacle(const Project& project, const Station& station);

/// Which plates of a path are judged, each a number that changes where it is judged otherwise.
std::vector<int> path_choices_at(const Project& project, const Station& station);

/// Half of the way between the middles of what holds a plate, or from there to its free end: the
/// width over which shear lag works. Source: EN 1993-1-5:2006, 3.2.1, figure 3.1.
Length lagging_width_of(const PathSection& path, const PathPlate& plate);

/// The path of a station, with what supports it across and what shear lag leaves of it; nothing of
/// other profiles, and where a wall is thicker than its steel has a strength for.
std::optional<PathSection> judged_path_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station);

/// The plates of a station's path; nothing of other profiles, where none of its segment is beyond
/// class 3 in even compression, or where they are not judged.
std::shared_ptr<const SlenderPath> slender_path_at(const Project& project,
                                                   const std::vector<BendingZone>& zones,
                                                   const Station& station);

}  // namespace boxbeam
