#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
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
  Eigen::Vector2d at = Eigen::Vector2d::Zero();      ///< (y, z) of where the force stands [m]
  /// Of the joint or force that it comes from, which owns the text; "" of what bending adds.
  std::string_view name = {};
  std::size_t part = 0;  ///< of that force, where it has many that come and go: from 1 on
};

/// What of a load's moment about the beam's axis is no lever of its force [N m].
double torque_of(const PointLoad& load);

/// Load per length on a stretch of one segment, in beam axes, as polynomials of the distance from
/// the stretch's start. With mass quadratic and acceleration linear along the axis these degrees
/// are exact.
struct LineLoad {
  Length start, length;
  std::array<Polynomial<3>, 3> force;   ///< x, y, z [N/m]
  std::array<Polynomial<4>, 3> couple;  ///< about x, y, z [N m/m]
  /// What of the force stands on the beam from outside, beside weight and inertia: the sizes of all
  /// that pushes along an axis and of all that pushes against it, no less, along y and z [N/m].
  std::array<std::array<Polynomial<1>, 2>, 2> outside = {};
};

/// All that acts on the beam at one instant, inertia forces included, so that it is in balance:
/// the seam between the mechanisms and the verification.
struct BeamLoads {
  std::vector<PointLoad> points;
  std::vector<LineLoad> lines;  ///< in order, without gaps, over the whole beam
};

/// Adds loads on the same stretches and of the same places, in the same order, so many times.
void add(std::vector<LineLoad>& sum, double factor, const std::vector<LineLoad>& lines);
void add(BeamLoads& sum, double factor, const BeamLoads& loads);

/// Leaves stretches and places without force and couple.
void unload(std::vector<LineLoad>& lines);
void unload(BeamLoads& loads);

/// One stretch per segment, without load.
std::vector<LineLoad> unloaded_lines(const TaperedBeam& beam);

/// Adds a load from outside to a stretch, linear from its start to its end [N/m].
void add_from_outside(const Eigen::Vector3d& at_start, const Eigen::Vector3d& at_end,
                      LineLoad& stretch);

/// Motion of a rigid beam at an instant, in beam axes.
struct BeamMotion {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< of the axis point at s = 0 [m/s^2]
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();         ///< [rad/s]
  Eigen::Vector3d alpha = Eigen::Vector3d::Zero();         ///< [rad/s^2]
};

/// Weight and inertia of the beam itself per length,
///
///     q(s) = rho A(s) (g - a(s)),   a(s) = a_0 + s (alpha x e_x + omega x (omega x e_x))
///     m(s) = -(J alpha + omega x J omega),   J = rho [I_y + I_z, I_y, I_z; yz: -I_yz]
///
/// gravity in beam axes [m/s^2]. Source: d'Alembert's principle for a rigid body.
std::vector<LineLoad> weight_and_inertia(const TaperedBeam& beam,
                                         const std::vector<SegmentMass>& distribution,
                                         const Eigen::Vector3d& gravity, const BeamMotion& motion);

/// What is left over when all loads are summed: force [N] and moment about s = 0 [N m].
struct Imbalance {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

Imbalance imbalance_of(const BeamLoads& loads);

}  // namespace boxbeam
