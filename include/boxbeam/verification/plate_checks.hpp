#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/plastic_box.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/reduced_plates.hpp"
#include "boxbeam/verification/sheared_plates.hpp"
#include "boxbeam/verification/station_samples.hpp"

namespace boxbeam {

/// The criteria by which plates that buckle are judged.
inline constexpr std::array plate_criteria{Criterion::effective_section, Criterion::shear_buckling,
                                           Criterion::interaction, Criterion::reduced_stress};

const char* to_text(PlateRoute route);  ///< "effective widths", "reduced stresses"

/// Whether an edge of a segment is inclined by more than 10 degrees, so that its plates are no
/// rectangles. Source: EN 1993-1-5:2006, 2.3(1).
bool is_steep(const Segment& segment);
/// "its edges are inclined by 12.3 deg, above 10 deg (2.3)"
std::string steepness_text(const Segment& segment);

/// By which route the plates of a segment are judged: as the case asks, of a steep one by reduced
/// stresses.
PlateRoute plate_route_of(const Project& project, const Segment& segment);

/// The four plates of a section at a station, as far as one of them may buckle before it yields.
struct SlenderPlates {
  EffectiveBox box;
  PlasticBox plastic;
  LagShares lag;
  std::vector<ShearedPlate> sheared;
  std::vector<ReducedPlate> reduced = {};  ///< the same by reduced stresses; none with stiffeners
  PlateRoute route = PlateRoute::effective_widths;  ///< that judges
  bool steep = false;                               ///< no rectangles: effective widths say nothing
};

/// How far a plate is used by bending and shear together, and by which rule of 7.1.
WebInteraction interaction_of(const ShearedPlate& plate, const PlasticBox& plastic,
                              const CornerUse& corner, const CutForces& cut, double gamma_M0);

/// Why the plates of the section at a station are not judged by the route of their segment, ""
/// where they are: only boxes and rectangular tubes, by themselves, without openings above 0.05 of
/// a plate's width (2.3), those of one section together; stiffeners that do not twist (9.2.1(8))
/// and that are stiff enough to divide their plate where it may buckle, all over the segment, and
/// by reduced stresses none that a plate needs.
std::string plates_obstacle(const Project& project, const Station& station);

/// Whether a plate of a station's segment has stiffeners and may buckle without them (c/t above 42
/// eps): it is judged as a stiffened one, or not at all.
bool may_buckle_with_stiffeners(const Project& project, const Station& station, BoxPlate plate);

/// The plates of a station; nothing where none of its segment is so slender that it may buckle (c/t
/// above 42 eps), or where they are not judged.
std::shared_ptr<const SlenderPlates> slender_plates_at(const Project& project,
                                                       const std::vector<BendingZone>& zones,
                                                       const Station& station);

/// How far they are used in any situation, by the samples of their station.
Utilisations plate_uses_of(const Project& project, const SlenderPlates& plates,
                           const StationSamples& samples);

/// The checks of a station's plates.
struct PlateChecks {
  std::vector<CheckResult> checks;  ///< by the route that judges
  std::vector<CheckResult> beside;  ///< by the other one, as far as it can say something
};

/// Each at the instant that is worst for it. By effective widths: the effective section under N,
/// M_y and M_z together; shear buckling of each plate that may; both together in the plate that is
/// used most by them. By reduced stresses: each plate under all that acts on it. Source: EN
/// 1993-1-5:2006, 4.6, 5.5, 7.1, clause 10.
PlateChecks check_plates(const Project& project, const Station& station,
                         const std::shared_ptr<const SlenderPlates>& plates,
                         const std::vector<SituationHistory>& histories);

/// Takes out a criterion whose worst check of the beam says what another says as well, and is used
/// no more than that: the effective section where all of it works there, and reduced stresses where
/// none is reduced, beside yielding; both together where shear, or normal stress, has no part in
/// it.
void leave_out_covered(const Project& project, std::vector<CheckResult>& checks);

}  // namespace boxbeam
