#pragma once

#include <array>
#include <span>
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
/// EN 1993-1-1, 6.3.2.1(2): sections alike in both directions only turn over by such forces.
class LateralEstimate {
 public:
  explicit LateralEstimate(const Project& project);

  /// Whether I_T is known of all sections (not of polygons).
  bool is_known() const;

  /// 1/alpha_cr under these cut forces; `known` where it is not above it.
  double part(const CutForceDiagram& diagram, const BeamLoads& loads, const std::vector<double>& at,
              double known);

 private:
  /// Stiffness in the nodes and elements for these places, a node wherever a force acts.
  void hold(const std::vector<double>& at, const BeamLoads& loads);
  void tip(const BeamLoads& loads);
  /// The part of a beam whose stiffness changes with its load.
  double part_with_turned(const CutForceDiagram& diagram, double known) const;

  const Project* project_;
  bool lines_are_cut_;
  std::vector<double> at_, places_;
  TurningBeam beam_;
  std::vector<std::array<double, 2>> by_M_y_, by_M_z_;  ///< 1/(E I) - 1/(E I_M) of the elements
  std::vector<std::array<SectionReach, 2>> reach_;
  /// Of int sigma r^2 dA the parts per M_y and per M_z; empty where there is none.
  std::vector<std::array<std::array<double, 2>, 2>> turned_;
  std::vector<std::array<double, 2>> twisting_;
  std::vector<double> tipping_;
};

}  // namespace boxbeam
