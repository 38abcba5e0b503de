#pragma once

#include <array>
#include <optional>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/strength/lateral_buckling.hpp"

namespace boxbeam {

/// From its shear centre, along z and y [m].
struct SectionReach {
  std::array<double, 2> low{}, high{}, centroid{};
};

/// Lateral torsional buckling of the beam of a case by its cut forces: held sideways and against
/// turning at one or two places, bent about both axes. Of segments of open paths that do not taper
/// E I_w resists as well where the section goes on; nothing holds against warping. Forces count
/// with their height above the shear centre: all at the edge of the section at which they turn the
/// beam over, weight and inertia at the centroid; where lines of force press the beam weight counts
/// as one of them.
/// In open sections the longitudinal stresses turn with the section: G I_T + int sigma r^2 dA about
/// the shear centre resists (Wagner), less where the narrower flange is compressed.
/// Of polygons a lower bound of I_T counts.
/// EN 1993-1-1, 6.3.2.1(2): sections alike in both directions only turn over by such forces.
class LateralEstimate {
 public:
  explicit LateralEstimate(const Project& project);

  /// 1/alpha_cr under these cut forces; `known` where it is not above it.
  double part(const CutForceDiagram& diagram, const BeamLoads& loads, const std::vector<double>& at,
              double known);

  /// Of many instants of a beam that is held in one way, which can be the worst: all are taken into
  /// one envelope of what turns it over, place by place (`screen`, `widen`). None is above the part
  /// of the envelope, `bound`, nor above it times its own `share`, for 1/alpha_cr grows with each
  /// of these loads and is in proportion to them. Not to be mixed with calls of `part`.
  void screen(const std::vector<double>& at);
  void widen(const CutForceDiagram& diagram, const BeamLoads& loads);
  double bound();
  double share(const CutForceDiagram& diagram, const BeamLoads& loads);

 private:
  /// Per element what twists it, M^2 over the difference of the stiffnesses, and what the stresses
  /// that turn with the section add to G I_T; per node what tips it [N m].
  struct Turning {
    std::vector<std::array<double, 2>> twisting, turned;
    std::vector<double> tipping;
  };

  /// Stiffness in the nodes and elements for these places, a node wherever a force acts.
  void hold(const std::vector<double>& at, const BeamLoads& loads);
  void take(const CutForceDiagram& diagram, const BeamLoads& loads);
  void tip(const BeamLoads& loads);
  double part_of(const Turning& load, double known) const;

  const Project* project_;
  bool lines_are_cut_;
  std::vector<double> at_, places_;
  TurningBeam beam_;
  std::vector<std::array<double, 2>> by_M_y_, by_M_z_;  ///< 1/(E I) - 1/(E I_M) of the elements
  std::vector<std::array<SectionReach, 2>> reach_;
  std::vector<std::optional<SectionReach>> node_reach_;  ///< of the nodes at which forces act
  /// Of int sigma r^2 dA the parts per M_y and per M_z; empty where there is none.
  std::vector<std::array<std::array<double, 2>, 2>> turned_;
  Turning load_, envelope_;
  bool screening_ = false;  ///< no node wherever a force acts: it tips both beside it
};

}  // namespace boxbeam
