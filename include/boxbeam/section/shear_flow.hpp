#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/taper.hpp"
#include "boxbeam/section/wall_cells.hpp"

namespace boxbeam {

/// The walls of a section with the normal stress in them.
struct StressedWalls {
  WallGraph graph;
  WallCells cells;
  Eigen::Matrix3d plane;  ///< normal_stress_plane of the net section
};

/// Shear flow in the walls of a thin-walled section.
///
/// Let a part of the section hang on a wall at the fraction s of it. Its normal stresses have the
/// resultant F = N alpha + M_y beta_y + M_z beta_z, and along the same place of the wall, from one
/// section to the next, equilibrium of the part along x asks the shear flow
///
///     q = V_z beta_y - V_y beta_z + N alpha' + M_y beta_y' + M_z beta_z'
///
/// out of it: V S/I (with I_yz) and, in a taper, what the change of the section adds. alpha and
/// beta are of M about the straight beam axis, so that a moving centroid is in alpha'. M_y' = V_z,
/// M_z' = -V_y and N' = 0 here: distributed loads act on the part as on the whole, in proportion to
/// its material, and cancel. A closed cell is cut open for q; its constant flow restores zero
/// twist, int q ds/t = 0, taken for the section as if it were prismatic (in a taper a good
/// approximation, not an identity). The torque that these flows and the inclined normal stresses do
/// not balance twists the section: Bredt's flow in the cells, and t/I_T per torque on the faces of
/// every wall. Where an outer and an inner profile do not balance each for itself, what passes
/// between them is spread over their material.
///
/// The flows along the walls add up to V_y, V_z and T less what the inclined normal stresses carry
/// and less the part I_own/I that crosses the walls' thickness (a flange's own bending, of order
/// (t/h)^2), which is taken to pass where the rest does. Of V the walls of an outer and an inner
/// profile carry sum I_c/I, I_c of each about its own centroid; where the centroids differ, what
/// ties the profiles together carries the rest. A hole passes the flow on and takes material only.
/// In a taper q acts along the wall's own generator, not square to it. Valid for free warping, thin
/// walls, a shape kept by diaphragms, slopes below about 10 degrees. Source: equilibrium; Bredt
/// (1896); Megson, Aircraft Structures, chapters 17, 21 and 23.
struct ShearFlow {
  StressedWalls at;
  struct Nearby {
    StressedWalls walls;
    double weight;
  };
  std::vector<Nearby> taper;
  std::vector<CutFactors> out_of_component;             ///< dF/dx of all material of each component
  Eigen::Matrix<double, Eigen::Dynamic, 6> cell_flows;  ///< against twist by transverse forces
  Eigen::VectorXd cell_flows_per_torque;                ///< [1/m^2]
  CutFactors torque;              ///< left over for twist, per cut force; exactly 1 for T
  double twist_per_torque = 0.0;  ///< 1/I_T [1/m^4]
};

/// Shear flow of a thin-walled section, or nothing where a profile is solid.
std::optional<ShearFlow> shear_flow_of(const Section& section, const std::vector<Hole>& holes,
                                       const Taper& taper);

/// The same of a section as if it did not change.
ShearFlow prismatic_flow_of(const ShearFlow& tapered, const Section& section);

/// Shear flow at a fraction of a wall per cut force, positive from `start` to `end` [1/m for
/// forces, 1/m^2 for moments].
CutFactors flow_at(const ShearFlow& flow, std::size_t wall, double fraction);

/// What the shear stress on the right face of a wall, seen from start to end, exceeds that of the
/// mid-line: t/I_T per torque; the left face has as much less.
CutFactors face_shear_of(const ShearFlow& flow, std::size_t wall);

/// How the shear stress of a torque at a place of a wall comes about:
///
///     tau/T = q/t +- t/I_T,  q = (1 - I_w/I_T)/(2 A_m) in the walls of a single cell
///
/// The cells' flow (Bredt) carries what the walls do not carry themselves (Saint-Venant), I_w = sum
/// s t^3/3 of all walls of the section.
struct WallTorsion {
  double flow = 0.0;       ///< q per torque, positive along the wall; 0 in open walls [1/m^2]
  double face = 0.0;       ///< +-t/I_T on the face looked at [1/m^3]
  double thickness = 0.0;  ///< t [m]
  double I_T = 0.0;        ///< of the whole section [m^4]
  double I_w = 0.0;        ///< [m^4]
  double enclosed = 0.0;   ///< A_m [m^2]; 0 unless the section is one cell, with or without ribs
};

/// Of a wall; `face` is 1 for its right face, -1 for the left one, 0 for that on which both add up.
WallTorsion wall_torsion_of(const ShearFlow& flow, std::size_t wall, double face);

/// V_y, V_z and T that the flows and, in a taper, the inclined normal stresses of the mid-lines add
/// up to, per cut force: rows V_y, V_z, T.
Eigen::Matrix<double, 3, 6> resultants_of(const ShearFlow& flow);

/// The place through which transverse forces cause no twist: thin-walled sections from the flow of
/// V_y and V_z, plates their middle; nothing for polygons. Source: Megson, 17.2.
std::optional<SectionPlace> shear_centre_of(const Section& section);

}  // namespace boxbeam
