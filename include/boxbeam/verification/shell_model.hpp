#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/verification/plate_field.hpp"

namespace boxbeam {

/// A shell of eight nodes: corners around it, then the middles of its edges.
struct ShellElement {
  std::array<std::size_t, 8> nodes;
  std::size_t set = 0;
  Station centre;
  double y = 0.0, z = 0.0;  ///< of its centre [m]
  PointStress stress;       ///< ours there: along x, and the shear flow over the thickness
  /// Ours as it acts in the section, along y or z: in a taper the flow passes along the plate's own
  /// lines, inclined to x, on which the normal stress has a part: tau + sigma dz/dx.
  Stress shear_in_section;
  int part = 0;  ///< index in part_names
};

/// Elements of one thickness: a plate in a segment, or in one step of it where it varies.
struct ShellSet {
  std::string name;
  double thickness = 0.0;  ///< [m]
};

struct NodalForce {
  std::size_t node = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< [N]
};

/// A displacement that is held: 0, 1, 2 for x, y, z.
struct HeldFreedom {
  std::size_t node = 0;
  int direction = 0;
};

/// The plates of a beam as shells under its loads of one instant, which are in balance: held in six
/// freedoms whose reactions are zero.
///
/// Plates are joined at their mid-lines: the area of a box is exact, its second moments within
/// about (t/h)^2, and the cell encloses Bredt's area. Where profiles begin, end or jump, the
/// section is held rigid. Loads at a place are spread over its section: along x by a plane, V on
/// the plates along it, T as Bredt's flow; what acts per length goes in parts to the two sections
/// beside it. Holes, stiffeners and rounded corners are left out.
struct ShellModel {
  std::vector<Eigen::Vector3d> nodes;  ///< beam axes [m]
  std::vector<ShellElement> elements;
  std::vector<ShellSet> sets;
  std::vector<NodalForce> forces;
  std::vector<std::vector<std::size_t>> rigid;  ///< nodes that move as one body
  std::vector<HeldFreedom> held;
  std::vector<std::string> simplified;  ///< what is left out, a sentence each
};

/// Why a beam is not modelled as shells: "round tube (segment S1)"; "" where it is. Known are boxes
/// and rectangular tubes, one inside another, and upright plates in the plane.
std::string obstacle_to_shells(const Project& project);

/// Precondition: there is no obstacle.
ShellModel shell_model_of(const Project& project, const BeamLoads& loads,
                          const CutForceDiagram& diagram);

}  // namespace boxbeam
