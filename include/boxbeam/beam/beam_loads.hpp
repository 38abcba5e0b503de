#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/core/units.hpp"
#include "boxbeam/numerics/polynomial.hpp"

namespace boxbeam {

/// A concentrated load on the beam, in beam axes.
struct PointLoad {
  Length s;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the axis point at s [N m]
};

/// Load per length on one segment, in beam axes, as polynomials of the distance from the segment's
/// start. With mass quadratic and acceleration linear along the axis these degrees are exact.
struct LineLoad {
  std::array<Polynomial<3>, 3> force;   ///< x, y, z [N/m]
  std::array<Polynomial<4>, 3> couple;  ///< about x, y, z [N m/m]
};

/// All that acts on the beam at one instant, inertia forces included, so that it is in balance:
/// the seam between the mechanisms and the verification.
struct BeamLoads {
  std::vector<PointLoad> points;
  std::vector<LineLoad> segments;  ///< one per segment of the beam
};

/// Acceleration along the axis of a rigid beam, in beam axes: a(s) = at_start + gradient * s.
struct AxisAcceleration {
  Eigen::Vector3d at_start = Eigen::Vector3d::Zero();  ///< [m/s^2]
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< [1/s^2]
  double alpha_y = 0.0;  ///< angular acceleration about y, for the rotary inertia [rad/s^2]
};

/// Weight and inertia of the beam itself per length,
///
///     q(s) = rho A(s) (g - a(s)),   m_y(s) = -rho I_y(s) alpha_y
///
/// gravity in beam axes [m/s^2]. Source: d'Alembert's principle for a rigid body.
std::vector<LineLoad> weight_and_inertia(const TaperedBeam& beam,
                                         const std::vector<SegmentMass>& distribution,
                                         const Eigen::Vector3d& gravity,
                                         const AxisAcceleration& acceleration);

/// What is left over when all loads are summed: force [N] and moment about s = 0 [N m].
struct Imbalance {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

Imbalance imbalance_of(const TaperedBeam& beam, const BeamLoads& loads);

}  // namespace boxbeam
