#pragma once

#include <memory>
#include <string>
#include <vector>

#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/sheared_plates.hpp"
#include "boxbeam/verification/station_samples.hpp"

namespace boxbeam {

/// The plates of a thin-walled path at a station, as far as one of them may buckle before it
/// yields.
struct SlenderPath {
  EffectivePath section;
  std::vector<ShearedWall> sheared;    ///< plates held at both ends
  std::vector<ShearedWall> outstands;  ///< beyond class 3
};

/// Why the plates of a path are not judged by effective widths, "" where they are: where the case
/// asks for reduced stresses, its walls are inclined by more than 10 degrees (2.3), a plate beyond
/// class 3 has no effective width (`width_obstacle`), a flange may buckle into its web (clause 8),
/// or no effective section settles.
std::string path_obstacle(const Project& project, const Station& station);

/// The plates of a station's path; nothing of other profiles, where none of its segment is beyond
/// class 3 in even compression, or where they are not judged.
std::shared_ptr<const SlenderPath> slender_path_at(const Project& project, const Station& station);

/// How far they are used in any situation, by the samples of their station.
Utilisations path_uses_of(const Project& project, const SlenderPath& path,
                          const StationSamples& samples);

/// The checks of a station's path, each at the instant that is worst for it: the effective section
/// under N, M_y and M_z together; shear buckling of each plate held at both ends that may; both
/// together in the plate that is used most by them, by 7.1(5), on the safe side where 7.1(1) would
/// leave the moment to the flanges. Source: EN 1993-1-5:2006, 4.6, 5.5, 7.1.
std::vector<CheckResult> check_path(const Project& project, const Station& station,
                                    const std::shared_ptr<const SlenderPath>& path,
                                    const std::vector<SituationHistory>& histories);

/// Whether one of its plates does not work whole under these cut forces.
bool buckles_under(const EffectivePath& path, const CutForces& cut);

/// The uses of a plate: by shear alone, and with normal stress.
double shear_use_of(const ShearedWall& wall, const CutForces& cut);
double use_together(const Project& project, const ShearedWall& wall, const PathUse& normal,
                    const CutForces& cut);

}  // namespace boxbeam
