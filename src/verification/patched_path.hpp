#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/strength/patch_loading.hpp"
#include "patch_search.hpp"

namespace boxbeam {

/// A wall of a path into which a flange leads forces across the beam.
struct PathWeb {
  const PathPlate* plate = nullptr;
  /// Of its mid-line, across the force: at the flange that leads it in, and at the other one.
  Length place, far_place;
  double cosine = 1.0;   ///< of its angle to the force: the wall takes the force by this, along it
  PatchedWeb bears;      ///< far from an end, under no force yet
  bool slender = false;  ///< it may buckle in shear
  /// How far a plate across it reaches within the flanges at both its ends, on each of both sides
  /// or on the only one; 0 where the flanges reach to unlike sides.
  Length beside;
  bool both_sides = false;
};

/// The walls of a path that bear forces along z, or along y, between two flanges.
struct PathWebs {
  std::vector<PathWeb> webs;  ///< from the higher place on; none where no wall lies along the force
  std::string obstacle;       ///< why it is not judged what walls along it bear; "" where it is

  /// Of two: their mid-lines, and what is clear between them, where they are nearest.
  Length apart() const;
  Length inside() const;
};

/// Walls along the force between the same two levels, with flanges square to it at both their ends:
/// both lean by 10 degrees at most, a single wall, which nothing opposes, by one. A wall that leans
/// takes its share over the cosine, along itself; flanges and diaphragm take what is across.
/// `onto_high`: the forces push onto the flange at the higher end. The flange is as wide as the
/// plates that meet the wall there: outstands, and half of those that lead on to another one.
/// Source: EN 1993-1-5:2006, 6.1, 6.5.
PathWebs webs_of_path(const PathSection& path, bool along_z, bool onto_high);

/// What stands of a diaphragm beside a single web, within the flanges at both its ends. The opening
/// is in the middle of the whole plate: at the web itself, or halfway to the tips of flanges on one
/// side, where the nearer half stays.
BearingStiffener flats_beside(const Project& project, const PathWeb& web,
                              const Diaphragm& diaphragm, const Station& station);
/// Why flats do not stiffen their web, "" where they do.
std::string flats_obstacle(const BearingStiffener& flats);

/// How long the panel of a path at a station is; nothing where it is not between two diaphragms, or
/// where one of these is too weak to bound it (9.3.3), beside a single web twists (9.2.1(8)), or is
/// not known to.
std::optional<Length> path_panel_length_at(const Project& project, const Station& station);

/// Whether a plate of a station's path is beyond class 3 in even compression; not of other
/// profiles.
bool is_slender_path_at(const Project& project, const Station& station);

/// How far a diaphragm is used that leads a force into walls which are no webs, by an estimate, on
/// loads as they are: of what it puts into the walls, its plate in shear, and where no wall stands
/// under the force its fillets there; and of its edge there. 0: not at all.
struct LedUse {
  double across = 0.0;
  double edge = 0.0;
};
/// The force goes by its lever to the outer walls along it, into as much of them as reaches along
/// it; in the plane half to either side. Fillets on both faces, where the case says how thick they
/// are: tau = F/(2 a h), across the flange sqrt(2) F/(2 a (s_s + 2 t_f)), f_u/(beta_w gamma_M2)
/// over sqrt(3) and 1 (EN 1993-1-8:2005, 4.5.3.2(6)); the plate as one between flanges (EN
/// 1993-1-5:2006, 5.2), less its opening; the edge F/(t (s_s + 2 t_f)). A bound of our own: walls
/// between the outer ones are left out. led_into_walls.cpp
LedUse led_into_walls(const Project& project, const Patch& patch, const PathSection& path,
                      const Station& station);
/// A force over what the weakest plate of a path bears as a web under it (6.5), far from an end.
double pressed_by_weakest(const Project& project, const Patch& patch, const PathSection& path);

/// What is not checked of diaphragms beside slender plates: why they bound no panels, and of paths
/// why it is not known what they bear as stiffeners of these.
std::vector<NotJudged> not_judged_of_diaphragms(const Project& project);

}  // namespace boxbeam
