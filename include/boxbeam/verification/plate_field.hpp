#pragma once

#include <Eigen/Core>
#include <array>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/section/section_points.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// The instant at which a beam is shown: that of the check that is used most and rests on cut
/// forces. Nothing where none does.
struct ShownLoads {
  const CheckResult* check;
  const SituationRun* run;
  Time time;
};

std::optional<ShownLoads> governing_loads(const Project& project,
                                          const std::deque<SituationRun>& runs,
                                          const Verification& verification);

/// The nominal stress on the mid-line of a section's walls, without holes and shear lag: normal
/// stress by unsymmetric bending, shear by equilibrium in the taper, q/t.
class MidlineStress {
 public:
  MidlineStress(const Project& project, const Station& station);

  const StressField& field() const { return field_; }
  PointStress on_wall(std::size_t wall, double fraction, const CutForces& cut) const;
  /// At the place of a part of the outer or the inner profile that is nearest; in solids there.
  PointStress near(WallPart part, bool inner, double y, double z, const CutForces& cut) const;

 private:
  StressField field_;
};

/// A place on the mid-surface of a plate.
struct PlateNode {
  Eigen::Vector3d place;  ///< beam axes [m]
  PointStress stress;
};

/// A piece of a plate between two sections.
struct PlateQuad {
  std::array<std::size_t, 4> nodes;  ///< around it
  double thickness = 0.0;            ///< in its middle [m]
  int part = 0;                      ///< index in part_names, from 1
  std::size_t segment = 0;           ///< of the beam, from 1
  bool inner = false;                ///< of the section's inner profile
};

/// A place on the axis, and what is cut there.
struct AxisNode {
  Station station;
  CutForces cut;
};

/// The words for parts of a section in the order of WallPart; solids, the axis.
inline constexpr std::array part_names{"axis",     "top flange", "bottom flange",
                                       "left web", "right web",  "stiffener",
                                       "corner",   "wall",       "solid plate"};

/// The plates of a beam with the stress in them at one instant, along all its stretches between
/// jumps, and its axis with the cut forces.
struct PlateField {
  std::vector<PlateNode> nodes;
  std::vector<PlateQuad> quads;
  std::vector<AxisNode> axis;
  std::vector<std::string> left_out;  ///< segments whose profile is no plates, with their profile
};

/// Divided along the beam into pieces about a quarter of its height long, walls across into eight.
/// Solid rectangles are shown by their middle plane; polygons are left out.
PlateField plate_field_of(const Project& project, const CutForceDiagram& diagram);

/// Stations along the beam, both sides of every border of a diagram's pieces and of segments, and
/// between them steps not longer than a part of the section's height there.
struct BeamSteps {
  std::size_t segment = 0;
  std::vector<Station> stations;  ///< the first behind a border, the last before the next
};
std::vector<BeamSteps> steps_along(const TaperedBeam& beam, const CutForceDiagram& diagram,
                                   double part_of_height);

}  // namespace boxbeam
