#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "boxbeam/mechanism/frame/statics.hpp"

/// How motions and forces are carried along rigid arms and turned into other axes, and which of
/// their components a frame has.
namespace boxbeam::frame {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

inline Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Shift and turn of a place that stands `arm` off one whose shift and turn are known; transposed,
/// what a force and a couple there are at that one.
inline Matrix6 carry(const Eigen::Vector3d& arm) {
  Matrix6 m = Matrix6::Identity();
  m.topRightCorner<3, 3>() = -skew(arm);
  return m;
}

inline Matrix6 rotation(const Eigen::Matrix3d& axes) {
  Matrix6 m = Matrix6::Zero();
  m.topLeftCorner<3, 3>() = m.bottomRightCorner<3, 3>() = axes;
  return m;
}

/// `carry` along the axis of a member by `distance`.
inline Vector6 carried_on(Vector6 motion, double distance) {
  motion[1] += distance * motion[5];
  motion[2] -= distance * motion[4];
  return motion;
}

/// What cut forces at a place behind it are at a place `distance` before.
inline Vector6 carried_back(Vector6 cut, double distance) {
  cut[4] -= distance * cut[2];
  cut[5] += distance * cut[1];
  return cut;
}

/// Of motions and forces in world axes, and in those of joints: in the plane x, y and the turn.
inline std::span<const Eigen::Index> world_components(const Structure& structure) {
  static constexpr std::array<Eigen::Index, 6> all{0, 1, 2, 3, 4, 5};
  static constexpr std::array<Eigen::Index, 3> in_plane{0, 1, 5};
  if (structure.plane) return in_plane;
  return all;
}

/// Of cut forces: in the plane N, V_z, M_y.
inline std::span<const Eigen::Index> cut_components(const Structure& structure) {
  static constexpr std::array<Eigen::Index, 6> all{0, 1, 2, 3, 4, 5};
  static constexpr std::array<Eigen::Index, 3> in_plane{0, 2, 4};
  if (structure.plane) return in_plane;
  return all;
}

}  // namespace boxbeam::frame
