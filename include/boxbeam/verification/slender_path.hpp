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
#include "boxbeam/verification/station_samples.hpp"

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

/// How far they are used in any situation, by the samples of their station, by reduced stresses
/// too.
Utilisations path_uses_of(const Project& project, const SlenderPath& path,
                          const StationSamples& samples);

/// The checks of a station's path, each at the instant that is worst for it: the effective section
/// under N, M_y and M_z together; shear buckling of each plate held at both ends that may; both
/// together in the plate that is used most by them, webs of sections like an I as those of boxes,
/// by 7.1(1), all others by 7.1(5), on the safe side. Source: EN 1993-1-5:2006, 4.6, 5.5, 7.1.
std::vector<CheckResult> check_path(const Project& project, const Station& station,
                                    const std::shared_ptr<const SlenderPath>& path,
                                    const std::vector<SituationHistory>& histories);

/// The same by reduced stresses, which do not judge it: each plate under all that acts on it, on
/// the whole section. Source: EN 1993-1-5:2006, clause 10.
std::vector<CheckResult> check_reduced_path(const Project& project, const Station& station,
                                            const std::shared_ptr<const SlenderPath>& path,
                                            const std::vector<SituationHistory>& histories);

/// Whether one of its plates does not work whole under these cut forces.
bool buckles_under(const EffectivePath& path, const CutForces& cut);

double shear_use_of(const ShearedWall& wall, const CutForces& cut);

/// How far a plate is used by bending and shear together, and by which rule of 7.1.
WebInteraction interaction_of(const SlenderPath& path, const ShearedWall& wall,
                              const PathUse& normal, const CutForces& cut, double gamma_M0);

}  // namespace boxbeam
