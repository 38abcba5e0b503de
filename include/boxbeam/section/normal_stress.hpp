#pragma once

#include <Eigen/Core>

#include "boxbeam/section/outline.hpp"
#include "boxbeam/section/point_stress.hpp"

namespace boxbeam {

/// Factors of the six cut forces, in the order of cut_force::Index, SI.
using CutFactors = Eigen::Matrix<double, 6, 1>;

/// The plane sigma(y, z) = a + b y + c z that balances N, M_y and M_z about the beam axis:
///
///     (a, b, c) = K (N, M_y, M_z),  int sigma dA = N, int sigma z dA = M_y, int sigma y dA = -M_z
///
/// which is unsymmetric bending with I_yz about the centroid, written without moving to it. In
/// principal axes through the centroid sigma = N/A + M_y z/I_y - M_z y/I_z. SI.
/// Source: Megson, Aircraft Structures for Engineering Students, 16.2 (Navier's hypothesis).
Eigen::Matrix3d normal_stress_plane(const AreaSums& sums);

/// The influence of the cut forces on the normal stress at a place.
StressInfluence normal_influence(const AreaSums& sums, double y, double z);

/// Shear flow out of a part of the section, per cut force:
///
///     dF/dx = V_z beta_y - V_y beta_z + N alpha' + M_y beta_y' + M_z beta_z'
///
/// where F = N alpha + M_y beta_y + M_z beta_z is the resultant of its normal stresses; `force` is
/// (alpha, beta_y, beta_z), `slope` their change along the beam. Source: equilibrium along x.
CutFactors flow_out_of(const Eigen::RowVector3d& force, const Eigen::RowVector3d& slope);

}  // namespace boxbeam
