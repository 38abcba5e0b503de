#pragma once

#include <limits>
#include <vector>

#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/verification/distorted_stretch.hpp"
#include "boxbeam/verification/stress_points.hpp"

namespace boxbeam {

/// A point of a box and what distortion does there, in each plate that meets there; in the throat
/// of a seam in that.
struct DistortedPoint {
  StressPoint point;
  std::vector<DistortionInfluence> at;
  double resisting = 0.0;         ///< of the equivalent stress [Pa]; 0: strength is not looked at
  double resisting_across = 0.0;  ///< of a throat, of its sigma_perp alone [Pa]
  WeldStrength weld;
};

/// The named points of a section, of the walls between them ends and middles; no edges of holes,
/// nothing that lies inside the box.
std::vector<DistortedPoint> distorted_points_at(const Project& project,
                                                const std::vector<BendingZone>& zones,
                                                const DistortedStretch& stretch, std::size_t place);

/// The throat of its seams where these are fillets, else none.
Length fillet_of(const Profile& profile);

/// How far a point is used up, and by which plate.
struct PointUse {
  double acting = 0.0, resisting = std::numeric_limits<double>::infinity();  ///< [Pa]
  const DistortionInfluence* at = nullptr;

  double use() const { return acting / resisting; }
};

/// Of its stress by the cut forces alone and what distortion adds, the load factor on both.
PointUse use_of(const DistortedPoint& of, const PointStress& alone, const DistortionSize& size,
                double load_factor);

}  // namespace boxbeam
