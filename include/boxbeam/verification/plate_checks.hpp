#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/plastic_box.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/station_samples.hpp"

namespace boxbeam {

/// The criteria by which plates that buckle are judged.
inline constexpr std::array plate_criteria{Criterion::effective_section, Criterion::shear_buckling,
                                           Criterion::interaction};

/// A plate of a station in shear.
struct ShearedPlate {
  BoxPlate plate = BoxPlate::left_web;
  std::string name;  ///< "web" where both are stressed alike
  ShearPanel panel;
  ShearResistance resists;
  bool may_buckle = false;  ///< in the segment it is so slender that shear buckling is judged
  /// A part of its clear width, between edges and feet of stiffeners, where the shear flow jumps.
  struct Piece {
    double width = 0.0;  ///< over the clear one
    /// Shear stress per cut force at both ends and in the middle, between which it is a parabola:
    /// of the gross section, taper and torsion included [1/m^2, 1/m^3].
    std::array<std::array<double, cut_force::count>, 3> per_cut_force{};
  };
  std::vector<Piece> pieces;

  /// The size of its force in its plane, over its clear width. Of a flange that of at least half of
  /// its largest stress, EN 1993-1-5, 7.1(5): under V_z both halves of it balance each other; of
  /// one with stiffeners that of the largest mean of its subpanels, as if all were stressed like
  /// it.
  Force force_of(const CutForces& cut) const;
};

/// The plates of a section in shear, in the order of its flow; of webs that are stressed alike the
/// left one, for both. `may_buckle` is left open.
std::vector<ShearedPlate> sheared_plates_of(const Section& section, const FourWalls& walls,
                                            const Taper& taper, bool in_plane, double gamma_M1);

/// The four plates of a section at a station, as far as one of them may buckle before it yields.
struct SlenderPlates {
  EffectiveBox box;
  PlasticBox plastic;
  LagShares lag;
  std::vector<ShearedPlate> sheared;
};

/// Their box under cut forces: below yield where the case asks for that, it settles and is used
/// less, which 4.4(4) leaves free.
std::shared_ptr<const EffectiveBox> box_under(const std::shared_ptr<const SlenderPlates>& plates,
                                              const CutForces& cut, WidthRule rule);

/// How far a plate is used by bending and shear together, and by which rule of 7.1.
WebInteraction interaction_of(const ShearedPlate& plate, const PlasticBox& plastic,
                              const CornerUse& corner, const CutForces& cut, double gamma_M0);

/// Why the plates of the section at a station are not judged by effective widths (EN 1993-1-5,
/// clauses 4 and 5), "" where they are: only boxes and rectangular tubes, by themselves, inclined
/// by at most 10 degrees (2.3), without openings above 0.05 of a plate's width, those of one
/// section together; stiffeners that do not twist (9.2.1(8)) and that are stiff enough to divide
/// their plate where it may buckle, all over the segment.
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

/// The checks of a station's plates, each at the instant that is worst for it: the effective
/// section under N, M_y and M_z together; shear buckling of each plate that may; both together in
/// the plate that is used most by them. Source: EN 1993-1-5:2006, 4.6, 5.5, 7.1.
std::vector<CheckResult> check_plates(const Project& project, const Station& station,
                                      const std::shared_ptr<const SlenderPlates>& plates,
                                      const std::vector<SituationHistory>& histories);

/// Takes out a criterion whose worst check of the beam says what another says as well, and is used
/// no more than that: the effective section where all of it works there, beside yielding; both
/// together where shear, or normal stress, has no part in it.
void leave_out_covered(const Project& project, std::vector<CheckResult>& checks);

}  // namespace boxbeam
