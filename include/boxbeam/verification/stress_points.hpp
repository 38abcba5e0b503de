#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/wall_stretches.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The concentration that a hole edge's stress contains.
struct EdgeConcentration {
  std::string hole;
  double diameter_to_width = 0.0;
  double factor = 1.0;  ///< on the membrane part (gross), or the published factor
  EdgeBasis edge;       ///< of the place whose stress the point has
};

/// A stretch of wall in its section.
struct StressStretch {
  std::shared_ptr<const StressField> field;
  WallStretch wall;
  /// Whether no place on it is worse than its end: the flange of a section that mirrors itself,
  /// in the plane, where its normal stress is even and its shear grows from the middle.
  bool only_end = false;
};

/// A point of the beam whose stress is verified: all that its stress takes beside the cut forces.
struct StressPoint {
  Station station;
  std::string name;  ///< "fibre +z"
  Length y, z;
  SectionPart part = SectionPart::fibre;
  Section section;
  SectionProperties gross;
  SectionProperties net;      ///< holes, and what shear lag leaves idle of the flanges, taken out
  StressInfluence influence;  ///< shear by equilibrium in the taper
  StressInfluence prismatic;  ///< shear by V S/(I b), for comparison
  std::optional<WallTorsion> torsion;  ///< of the wall that it lies in
  Length plate;                        ///< thickness that decides the detail's strength
  PlateOf first_to_yield;              ///< of the plates there
  Stress yield_strength;               ///< of it
  PlateOf joined;                      ///< of a weld: the weaker part joined
  std::optional<EdgeConcentration> concentration;
  std::vector<HoleEdge> edges;  ///< of a hole: the places among which the worst is to be found
  std::optional<StressStretch> stretch;  ///< of a wall: the places along it
  /// What resists ranges of direct and of shear stress; none where that is not looked at.
  const BeamDetail* detail = nullptr;
  std::shared_ptr<const BeamDetail> in_plate;  ///< keeps `detail` where it is that of one plate
  bool compression_reduced = false;  ///< whether compression counts 60 % of direct stress, 7.2.1
  double range_factor = 1.0;         ///< on the direct stress whose range is limited, 8(1)
  const Detail* shear_detail = nullptr;
  bool yield = true;                ///< whether the equivalent stress is looked at
  bool is_strip = false;            ///< beside a hole: bears the force of its whole plate in shear
  bool beside_idle = false;         ///< of a weld: `net` is less what the plates beside leave idle
  bool on_throat = false;           ///< the throat of a seam: only its shear stress has a meaning
  std::optional<ShearLag> lag;      ///< of the flanges
  std::optional<ShearLag> web_lag;  ///< of the webs as flanges of M_z, in space
};

/// A stress of a weld below this is none, and a range of any stress: it does no damage in any life
/// and has no say together with another [Pa]. A millionth of the yield strength, far below every
/// cut-off limit and above round-off.
inline double no_stress_at(const StressPoint& point) { return 1e-6 * point.yield_strength.value(); }

/// What resists ranges of direct stress at a place.
struct ResistingDetail {
  const BeamDetail* detail = nullptr;
  std::shared_ptr<const BeamDetail> in_plate;  ///< keeps it where it is that of one plate
  bool compression_reduced = false;
  double range_factor = 1.0;  ///< the largest stress factor of all details there
};

/// The throat of the seam that a point on it has: of a seam that penetrates fully the web's
/// thickness. Precondition: on_throat.
Length seam_throat_of(const StressPoint& point);

/// The stress of a place in a point's section, its normal stress with what shear lag leaves.
StressInfluence influence_in(const StressPoint& point, const SectionPoint& place);

/// The stress fields of sections, each found once however many stations or designs have it.
class StressFields {
 public:
  /// Of a beam those of sections without holes that do not change along it, for in a taper no two
  /// stations are alike; of one station all.
  enum class Keep { even, all };

  explicit StressFields(Keep keep = Keep::even, Prismatic prismatic = Prismatic::found)
      : keep_(keep), prismatic_(prismatic) {}

  std::shared_ptr<const StressField> of(const Section& section, const std::vector<Hole>& holes,
                                        const Taper& taper);

 private:
  struct Known {
    Section section;
    std::vector<Hole> holes;
    Taper taper;
    std::shared_ptr<const StressField> field;
  };

  Keep keep_;
  Prismatic prismatic_;
  std::deque<Known> known_;
};

/// Extreme fibres, ends of the webs, neutral axis, fibres of an inner profile, hole edges and the
/// web beside them, welds of flats on plates, throats of seams, and the user's own points in the
/// section at a station. In
/// space corners, faces, seams on both webs. The stretches of wall and of solids between them; in
/// the plane of a section that mirrors itself those of its left half.
/// Throws AnalysisError where in space the stress of a shape or of a hole is not known.
std::vector<StressPoint> stress_points_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station, StressFields& fields);
std::vector<StressPoint> stress_points_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station);

/// Of these the throats of the seams of its outer profile.
std::vector<StressPoint> seam_throats_at(const Project& project,
                                         const std::vector<BendingZone>& zones,
                                         const Station& station);

}  // namespace boxbeam
