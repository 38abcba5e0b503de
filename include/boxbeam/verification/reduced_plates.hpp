#pragma once

#include <optional>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/strength/reduced_stress.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/sheared_plates.hpp"

namespace boxbeam {

/// A plate of a station as reduced stresses judge it.
struct ReducedPlate {
  ShearedPlate sheared;
  PlateEnds ends;    ///< of the gross section, less what shear lag leaves idle
  ShearPanel panel;  ///< the rectangle that it is taken for
  /// Stress along the steepest edge over that across the section: 1 + tan^2 of its slopes; 1 where
  /// no edge is steep.
  double along_edge = 1.0;
  /// Of an outstand of a path: whether the end that holds it is the high one.
  std::optional<bool> held_at_high = {};

  PanelStress under(const CutForces& cut) const;
  /// Compression at the low and at the high edge.
  std::array<Stress, 2> edges_under(const CutForces& cut) const;
  double use(const CutForces& cut, double gamma_M1) const;
};

/// The plates of a station by reduced stresses, in the order of `sheared`, these as panels between
/// diaphragms; none where a plate has stiffeners (of `walls`, which has them only where they are
/// needed).
///
/// Where the edges of the segment are inclined by more than 10 degrees a plate is taken for a
/// rectangle as wide as it is anywhere between its diaphragms or, on a side without one, to the end
/// of its segment, as long as it is along its own slope, and the normal stress for that along the
/// edge, which is free of stress across it: sigma (1 + tan^2). Beside the wedge of elasticity
/// (Timoshenko and Goodier) that is on the safe side. Source: EN 1993-1-5:2006, 2.3(1), note;
/// equilibrium.
std::vector<ReducedPlate> reduced_plates_at(const Project& project,
                                            const std::vector<BendingZone>& zones,
                                            const Station& station, const Section& section,
                                            const FourWalls& walls,
                                            const std::vector<ShearedPlate>& sheared);

/// The plates of a path by reduced stresses, of its whole section: those that both ends hold and
/// its outstands; none where shear lag counts.
std::vector<ReducedPlate> reduced_plates_of(const PathSection& path,
                                            const std::vector<ShearedWall>& held,
                                            const std::vector<ShearedWall>& outstands);

}  // namespace boxbeam
