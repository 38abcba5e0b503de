#pragma once

#include <memory>
#include <vector>

#include "boxbeam/verification/slender_path.hpp"
#include "boxbeam/verification/station_samples.hpp"

namespace boxbeam {

double shear_use_of(const ShearedWall& wall, const CutForces& cut);

/// How far a plate is used by bending and shear together, and by which rule of 7.1.
WebInteraction interaction_of(const SlenderPath& path, const ShearedWall& wall,
                              const PathUse& normal, const CutForces& cut, double gamma_M0);

/// How far the plates of a path are used in any situation, by the samples of their station, by
/// reduced stresses too.
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

}  // namespace boxbeam
