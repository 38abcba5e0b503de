#include "boxbeam/mechanism/spatial/rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace boxbeam::spatial {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

}  // namespace

Eigen::Matrix3d rotation_about(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  // Below this angle the next term of the series is under the round-off of the first.
  constexpr double small = 1e-4;
  const double half_sine = std::sin(0.5 * angle);
  const double sine = angle < small ? 1.0 - angle * angle / 6.0 : std::sin(angle) / angle;
  const double versine =
      angle < small ? 0.5 - angle * angle / 24.0 : 2.0 * half_sine * half_sine / (angle * angle);
  const Eigen::Matrix3d K = cross_matrix(turn);
  return Eigen::Matrix3d::Identity() + sine * K + versine * K * K;
}

Eigen::Vector3d turn_of(const Eigen::Matrix3d& R) {
  // By the unit quaternion: its largest component is divided by, so that nothing cancels.
  Eigen::Quaterniond q(R);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double length = q.vec().norm();
  if (length == 0.0) return Eigen::Vector3d::Zero();
  return 2.0 * std::atan2(length, q.w()) / length * q.vec();
}

Eigen::Matrix3d orthonormalised(const Eigen::Matrix3d& R) {
  return 0.5 * R * (3.0 * Eigen::Matrix3d::Identity() - R.transpose() * R);
}

Eigen::Matrix3d composed(const Eigen::Matrix3d& R_AB, const Eigen::Matrix3d& R_BC) {
  return orthonormalised(R_AB * R_BC);
}

}  // namespace boxbeam::spatial
