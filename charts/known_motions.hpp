#pragma once

#include <Eigen/Core>
#include <array>

#include "boxbeam/mechanism/planar/instant_solver.hpp"

/// Mechanisms moved by forces whose motion is known.
namespace boxbeam::charts {

/// A point of 1 kg at 1 m from a pin, let go at rest from (-1, 0) under g = 9.81 m/s^2.
/// Source: IFToMM library of computational benchmark problems, A01.
planar::Mechanism simple_pendulum();
/// Its place, in long double: sin(theta/2) = -sqrt(1/2) cd(sqrt(g) t), theta from below.
Eigen::Vector2d simple_pendulum_at(double time);
/// Of one swing there and back [s].
double simple_pendulum_period();

/// `loops` + 1 cranks of 1 m and 1 kg side by side, joined by as many couplers as loops of the
/// same; upright at the start, the tips at 1 m/s. It passes positions where all links lie flat,
/// with `loops` + 1 freedoms for an instant, twice per turn. Cranks first, couplers behind.
/// Source: the same library, A02.
planar::Mechanism n_four_bar(int loops);
/// The tip of the first crank, in long double: all cranks turn as one,
///
///     theta'' = k sin(theta),  k = g ((N + 1)/2 + N)/((N + 1)/3 + N)
///
/// theta from the vertical, by Jacobi's elliptic functions.
Eigen::Vector2d n_four_bar_tip_at(int loops, double time);
/// Of a turn [s].
double n_four_bar_period(int loops);

/// Andrews' squeezing mechanism: seven bodies, a spring, a torque. Its first three joints are the
/// pins at the knee F, whose multipliers are those of the three loops.
/// Source: Hairer, Wanner, Solving Ordinary Differential Equations II (1996), VII.7.
planar::Mechanism andrews();
/// What its problem in the IVP Test Set starts from: beta, Theta, gamma, Phi, delta, Omega,
/// epsilon.
std::array<double, 7> andrews_start();
/// The same angles, or their rates, from coordinates or velocities.
std::array<double, 7> andrews_angles_of(const Eigen::VectorXd& q);
/// After 0.03 s: these angles and the forces of the three loops [N], to about 1e-13 of each. By
/// extrapolation of order 16 with projection, long double, three step sizes.
std::array<double, 7> andrews_angles_at_end();
std::array<double, 6> andrews_forces_at_end();

/// Kinetic energy, that of gravity and of springs between points [J].
double energy_of(const planar::Mechanism& mechanism, const Eigen::VectorXd& q,
                 const Eigen::VectorXd& v);

}  // namespace boxbeam::charts
