#pragma once

#include <Eigen/Core>
#include <functional>

namespace boxbeam::frame {

/// The largest mu of M x = mu K x, which are those of the lowest frequencies, 1/mu = omega^2.
struct LowestModes {
  Eigen::VectorXd mu;     ///< descending; what has no mass has none
  Eigen::MatrixXd modes;  ///< columns, of elastic energy one half
};

/// What is iterated upon, column by column.
struct ModeOperators {
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> moved_by;    ///< K^-1 times forces
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> inertia_of;  ///< M times motions
};

/// So many, by Rayleigh and Ritz in the space of K^-1 M applied again and again to somewhat more
/// motions than modes are asked for, until it moves each of them out of that space by less than
/// 1e-11 of itself, by elastic energy. Of modes as frequent as each other it holds as many as are
/// asked for. Sources: Golub, Underwood, The block Lanczos method for computing eigenvalues, in:
/// Mathematical Software III (1977); Parlett, The Symmetric Eigenvalue Problem (1998), chapter 13.
///
/// `scale`: coordinates compare divided by it.
LowestModes lowest_modes_of(const ModeOperators& of, Eigen::Index count,
                            const Eigen::VectorXd& scale);

}  // namespace boxbeam::frame
