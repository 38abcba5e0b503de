#pragma once

#include <Eigen/Core>

/// Rotations as matrices whose columns are the turned axes. None of these functions goes through
/// angles about three axes, so none has a singular position.
namespace boxbeam::spatial {

/// The rotation about a vector by its length [rad]. Source: Rodrigues (1840); for small angles the
/// series of sin(a)/a and (1 - cos(a))/a^2.
Eigen::Matrix3d rotation_about(const Eigen::Vector3d& turn);

/// The vector about which a rotation turns, with the angle in [0, pi] as its length [rad]: sound at
/// 0 and at pi, where the axis comes from the symmetric part and its sense does not matter.
/// Precondition: orthogonal but for round-off.
Eigen::Vector3d turn_of(const Eigen::Matrix3d& R);

/// The rotation nearest to a matrix that is one but for round-off: one step of Newton's iteration
/// for the polar decomposition, R (3 I - R^T R)/2, which squares the error. Source: Bjorck and
/// Bowie, SIAM J. Numer. Anal. 8 (1971).
Eigen::Matrix3d orthonormalised(const Eigen::Matrix3d& R);

/// First one rotation in the axes of the other: R_AB R_BC, orthogonal to round-off however often.
Eigen::Matrix3d composed(const Eigen::Matrix3d& R_AB, const Eigen::Matrix3d& R_BC);

}  // namespace boxbeam::spatial
