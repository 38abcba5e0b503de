#pragma once

#include <Eigen/Core>

namespace boxbeam::frame {

/// What an axial force, tension positive, adds to the stiffness of a piece of length h against the
/// shifts and turns of its two ends, axes of the member: z with -theta_y, y with theta_z. It bends
/// as a cubic. Source: Przemieniecki, Theory of Matrix Structural Analysis (1968), 15.2.
Eigen::Matrix<double, 12, 12> geometric_block(double force, double h);

}  // namespace boxbeam::frame
