#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The concentration that a hole edge's stress contains.
struct EdgeConcentration {
  std::string hole;
  HoleCase hole_case = HoleCase::in_plane_bending;
  double diameter_to_width = 0.0;
  double factor = 1.0;  ///< on the membrane part (gross), or the published factor
  double angle = 0.0;   ///< of the place on the edge, from +x towards +z [rad]
};

/// A point of the beam whose stress is verified: all that its stress takes beside the cut forces.
struct StressPoint {
  Station station;
  std::string name;  ///< "fibre +z"
  Length y, z;
  Section section;
  SectionProperties gross;
  SectionProperties net;      ///< holes, and what shear lag leaves idle of the flanges, taken out
  StressInfluence influence;  ///< shear by equilibrium in the taper
  StressInfluence prismatic;  ///< shear by V S/(I b), for comparison
  Length plate;               ///< thickness that decides the yield strength
  Stress yield_strength;
  std::optional<EdgeConcentration> concentration;
  std::vector<HoleEdge> edges;  ///< of a hole: the places among which the worst is to be found
  /// What resists ranges of direct and of shear stress; none where that is not looked at.
  const BeamDetail* detail = nullptr;
  bool compression_reduced = false;  ///< whether compression counts 60 % of direct stress, 7.2.1
  const Detail* shear_detail = nullptr;
  bool yield = true;       ///< whether the equivalent stress is looked at
  bool on_throat = false;  ///< the throat of a seam: only its shear stress has a meaning
  std::optional<ShearLag> lag;
};

/// Extreme fibres, ends of the webs, neutral axis, fibres of an inner profile, hole edges and the
/// web beside them, throats of seams, and the user's own points in the section at a station.
std::vector<StressPoint> stress_points_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station);

/// A point on a hole's edge moved to the place with the largest stress (yield), or where the cycles
/// of all situations and changes leave the smallest factor (fatigue), at the instants of all
/// motions; any other point as it is.
StressPoint at_worst_edge(const Project& project, const StressPoint& point,
                          const std::vector<SituationHistory>& histories, Criterion criterion);

/// The stations to verify: both sides of every jump of load or section, other places once, and the
/// ends of the details' stretches, and places inside segments where a stress, stress range or cut
/// force has a maximum along the beam.
std::vector<Station> stations_to_verify(const Project& project,
                                        const std::deque<SituationRun>& runs);

}  // namespace boxbeam
