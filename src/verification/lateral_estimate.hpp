#pragma once

#include <array>
#include <span>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/strength/lateral_buckling.hpp"

namespace boxbeam {

/// Lateral torsional buckling of the beam of a case by its cut forces: held sideways and against
/// turning at one or two places, bent about both axes. Of segments of open paths that do not taper
/// E I_w resists as well where the section goes on; nothing holds against warping. Every force is
/// taken to act at the edge of the section at which it turns the beam over, line loads at the axis.
/// In open sections the longitudinal stresses turn with the section: G I_T + int sigma r^2 dA about
/// the shear centre resists (Wagner), less where the narrower flange is compressed.
/// EN 1993-1-1, 6.3.2.1(2): sections alike in both directions only turn over by such forces.
class LateralEstimate {
 public:
  explicit LateralEstimate(const Project& project) : project_(&project) {}

  /// Whether I_T is known of all sections (not of polygons).
  bool is_known() const;

  /// 1/alpha_cr under these cut forces; `known` where it is not above it.
  double part(const CutForceDiagram& diagram, const BeamLoads& loads, const std::vector<double>& at,
              double known);

 private:
  /// Stiffness in the nodes and elements for these places.
  void hold(const std::vector<double>& at);
  /// The part of a beam whose stiffness changes with its load.
  double part_with_turned(const CutForceDiagram& diagram, double known) const;

  const Project* project_;
  std::vector<double> at_;
  TurningBeam beam_;
  std::vector<std::array<double, 2>> by_M_y_, by_M_z_;  ///< 1/(E I) - 1/(E I_M) of the elements
  std::vector<std::array<double, 2>> edges_;            ///< of each node, off the axis: along z, y
  /// Of int sigma r^2 dA the parts per M_y and per M_z; empty where there is none.
  std::vector<std::array<std::array<double, 2>, 2>> turned_;
  std::vector<std::array<double, 2>> twisting_;
  std::vector<double> tipping_;
};

}  // namespace boxbeam
