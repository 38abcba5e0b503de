#pragma once

#include <Eigen/SparseCore>

namespace boxbeam::charts {

/// The cantilever of `unit_cantilever` by the finite elements that other programs use: two nodes,
/// shift and turn in each, cubic shapes, the mass that belongs to them. Sparse matrices in the
/// coordinates of the nodes behind the clamp, and the rows of the clamp's couple.
/// Source: Przemieniecki, Theory of Matrix Structural Analysis (1968), 5.6 and 11.3.
struct HermiteBeam {
  Eigen::SparseMatrix<double> K, M;
  Eigen::RowVectorXd root_K, root_M;  ///< couple of the clamp = (root_K - omega^2 root_M) q
};

HermiteBeam hermite_cantilever(int elements);

/// Circular frequency of the k-th free vibration: sparse Cholesky factors and subspace iteration.
double hermite_omega(const HermiteBeam& beam, int k);

/// Shift of the free end under a force of one.
double hermite_deflection(const HermiteBeam& beam);

/// Couple at the clamp under a force of one that vibrates at the free end, by a sparse LU.
double hermite_root_moment(const HermiteBeam& beam, double omega);

}  // namespace boxbeam::charts
