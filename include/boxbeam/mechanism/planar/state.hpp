#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "boxbeam/mechanism/common/contact.hpp"
#include "boxbeam/mechanism/common/friction.hpp"

namespace boxbeam::planar {

/// The mechanism at one instant. Coordinates body after body: x, y of the centre of mass, angle.
struct State {
  double time = 0.0;       ///< [s]
  Eigen::VectorXd q;       ///< [m, rad]
  Eigen::VectorXd v;       ///< [m/s, rad/s]
  Eigen::VectorXd a;       ///< [m/s^2, rad/s^2]
  Eigen::VectorXd lambda;  ///< multipliers, one per constraint equation [N, N m]
  /// Largest error of the constraints, lengths by the size of the mechanism.
  double residual = 0.0;
  /// Smallest pivot of the scaled Jacobian: falls towards a dead point with the root of the
  /// distance to it. Zero where forces decide the motion.
  double pivot = 0.0;
  /// Tells assemblies apart: the signs of the determinants of the Jacobian's irreducible blocks (a
  /// block is a loop that closes by itself). Zero where it is not known.
  std::uint64_t assembly = 0;
  /// Of every force, whether it has got to the length from which it acts one way; empty where that
  /// is as the position says and nothing is lost.
  std::vector<Touch> touches = {};
  /// Of every contact (`friction_contacts_of`), on what slides, along its guide [N].
  Eigen::VectorXd friction = {};
  /// The same, of those that can stick; empty where drivers decide the motion.
  std::vector<Slip> slips = {};
};

/// Between two states of a smooth motion: the polynomial of fifth degree that has the positions,
/// velocities and accelerations of both. Without multipliers.
State interpolate(double time, const State& before, const State& behind);

}  // namespace boxbeam::planar
