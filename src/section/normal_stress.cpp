#include "boxbeam/section/normal_stress.hpp"

namespace boxbeam {

Eigen::Matrix3d normal_stress_plane(const AreaSums& sums) {
  // About the centroid, where N is apart from the moments, and back to the beam axis.
  const double y = sums.y / sums.area, z = sums.z / sums.area;
  const double I_y = sums.zz - sums.area * z * z;
  const double I_z = sums.yy - sums.area * y * y;
  const double I_yz = sums.yz - sums.area * y * z;
  const double determinant = I_y * I_z - I_yz * I_yz;
  Eigen::Matrix3d plane;
  // Slopes b (along y) and c (along z) for M_y and M_z about the centroid.
  plane.row(1) << 0.0, -I_yz / determinant, -I_y / determinant;
  plane.row(2) << 0.0, I_z / determinant, I_yz / determinant;
  // N at the beam axis is N at the centroid with M_y = -N z_c and M_z = N y_c.
  plane.col(0).tail<2>() = -z * plane.col(1).tail<2>() + y * plane.col(2).tail<2>();
  plane.row(0) = -y * plane.row(1) - z * plane.row(2);
  plane(0, 0) += 1.0 / sums.area;
  return plane;
}

StressInfluence normal_influence(const AreaSums& sums, double y, double z) {
  const Eigen::RowVector3d at = Eigen::RowVector3d(1.0, y, z) * normal_stress_plane(sums);
  StressInfluence influence;
  influence.normal[cut_force::N] = at[0];
  influence.normal[cut_force::M_y] = at[1];
  influence.normal[cut_force::M_z] = at[2];
  return influence;
}

CutFactors flow_out_of(const Eigen::RowVector3d& force, const Eigen::RowVector3d& slope) {
  CutFactors factors = CutFactors::Zero();
  factors[cut_force::V_z] = force[1];
  factors[cut_force::V_y] = -force[2];
  factors[cut_force::N] = slope[0];
  factors[cut_force::M_y] = slope[1];
  factors[cut_force::M_z] = slope[2];
  return factors;
}

}  // namespace boxbeam
