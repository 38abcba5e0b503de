#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// Freedom of the mechanism's joints, drivers left out, and what drivers and joints determine
/// together.
struct DegreesOfFreedom {
  int gruebler = 0;   ///< 3 bodies - equations of the joints
  int by_rank = 0;    ///< 3 bodies - rank of their Jacobian in a position
  int redundant = 0;  ///< equations that repeat others, drivers among them: equations - rank
  int drivers = 0;
  int undriven = 0;        ///< freedoms that no driver moves: forces move them
  double condition = 0.0;  ///< of the Jacobian with drivers, lengths scaled; 0 where undriven
  /// Smallest singular value that counts over the largest that does not: the gap by which the rank
  /// is known; infinite where none is left out.
  double gap = 0.0;
  std::vector<int> repeating;  ///< joints and drivers that take part in a redundancy, ascending
  std::vector<int> moving;     ///< bodies that the undriven freedoms move
  /// Per equation: whether its multiplier is determined. A multiplier is unique where no
  /// redundancy has a part in its equation. Source: Wojtyra, Multibody System Dynamics 13 (2005).
  std::vector<char> unique;
};

/// Decimal digits of velocities that are left of the sixteen of the arithmetic at a condition of
/// the scaled Jacobian: the error of positions grows with it, that of velocities with its square.
double digits_left_at(double condition);

/// Rank by singular values of the Jacobian with lengths divided by the mechanism's size, so that
/// it does not depend on the unit of length. Singular values that are round-off are told from the
/// others by the widest gap between neighbours (a factor of at least 1e6), not by a fixed bound;
/// where there is no such gap, by 1e-10 of the largest. Source: Grübler (1917); Haug (1989),
/// section 3.7; Golub and Van Loan, Matrix Computations (1996), section 5.5.8.
DegreesOfFreedom degrees_of_freedom_of(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// Whether all multipliers of a joint are unique.
bool is_unique(const DegreesOfFreedom& freedom, int joint);

/// Condition of the Jacobian with drivers in a position, for every instant: 0 where it is singular.
double condition_of(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// Multipliers that are unique in one position may be shared in another: unique is what is so in
/// this position as well, repeating what repeats in either. A position that is singular itself says
/// nothing.
void judge_uniqueness(const Mechanism& mechanism, const Eigen::VectorXd& q,
                      DegreesOfFreedom& freedom);

}  // namespace boxbeam::planar
