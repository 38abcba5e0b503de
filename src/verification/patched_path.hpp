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
  Length place;          ///< of its mid-line, across the force
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
};

/// Walls along the force between the same two levels, with flanges square to them (within 10
/// degrees) at both their ends.
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

/// What is not checked of diaphragms beside slender plates: why they bound no panels, and of paths
/// why it is not known what they bear as stiffeners of these.
std::vector<NotJudged> not_judged_of_diaphragms(const Project& project);

}  // namespace boxbeam
