#include "boxbeam/strength/twisting_buckling.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace boxbeam {

double twisting_per_force(double GI_T, double EI_w, double L_T, double radius_squared) {
  return radius_squared / (GI_T + std::pow(std::numbers::pi / L_T, 2) * EI_w);
}

double twisting_part(const TwistingLoad& load) {
  Eigen::Matrix3d acting = Eigen::Matrix3d::Zero();
  acting.diagonal() << load.about_z, load.about_y, load.twisting;
  acting(0, 2) = acting(2, 0) = load.z_0 * std::sqrt(load.about_z * load.twisting);
  acting(1, 2) = acting(2, 1) = -load.y_0 * std::sqrt(load.about_y * load.twisting);
  double most = 0.0;
  for (const double sign : {1.0, -1.0}) {
    Eigen::Matrix3d resisting = Eigen::Matrix3d::Identity();
    resisting(0, 1) = resisting(1, 0) = sign * load.coupling;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver(acting, resisting,
                                                                           Eigen::EigenvaluesOnly);
    most = std::max(most, solver.eigenvalues().maxCoeff());
  }
  return most;
}

}  // namespace boxbeam
