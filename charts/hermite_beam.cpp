#include "charts/hermite_beam.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <cmath>
#include <vector>

namespace boxbeam::charts {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

HermiteBeam hermite_cantilever(int elements) {
  const double h = 1.0 / elements;
  Eigen::Matrix4d K, M;
  K << 12.0, 6.0 * h, -12.0, 6.0 * h,               //
      6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h,  //
      -12.0, -6.0 * h, 12.0, -6.0 * h,              //
      6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h;
  K /= h * h * h;
  M << 156.0, 22.0 * h, 54.0, -13.0 * h,              //
      22.0 * h, 4.0 * h * h, 13.0 * h, -3.0 * h * h,  //
      54.0, 13.0 * h, 156.0, -22.0 * h,               //
      -13.0 * h, -3.0 * h * h, -22.0 * h, 4.0 * h * h;
  M *= h / 420.0;
  const Index size = 2 * Index{elements};
  HermiteBeam beam;
  beam.root_K = beam.root_M = Eigen::RowVectorXd::Zero(size);
  std::vector<Eigen::Triplet<double>> stiffness, mass;
  for (Index element = 0; element < elements; ++element) {
    const Index first = 2 * element - 2;  // -2: the clamp's two coordinates are left out
    for (Index i = 0; i < 4; ++i) {
      for (Index j = 0; j < 4; ++j) {
        const Index row = first + i, column = first + j;
        if (column < 0) continue;
        if (row == -1) {
          beam.root_K[column] += K(i, j);
          beam.root_M[column] += M(i, j);
        }
        if (row < 0) continue;
        stiffness.emplace_back(row, column, K(i, j));
        mass.emplace_back(row, column, M(i, j));
      }
    }
  }
  beam.K.resize(size, size);
  beam.M.resize(size, size);
  beam.K.setFromTriplets(stiffness.begin(), stiffness.end());
  beam.M.setFromTriplets(mass.begin(), mass.end());
  return beam;
}

double hermite_omega(const HermiteBeam& beam, int k) {
  constexpr int most_steps = 30;
  constexpr double agreed = 1e-15;
  const Index size = beam.K.rows();
  const Index columns = std::min<Index>(size, k + 3);
  // Shapes x^2, x^3, ... satisfy the clamp.
  MatrixXd X(size, columns);
  for (Index i = 0; i < size; i += 2) {
    const double x = static_cast<double>(i + 2) / static_cast<double>(size);
    for (Index j = 0; j < columns; ++j) {
      const auto power = static_cast<double>(j + 2);
      X(i, j) = std::pow(x, power);
      X(i + 1, j) = power * std::pow(x, power - 1.0);
    }
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(beam.K);
  double square = 0.0;
  for (int step = 0; step < most_steps; ++step) {
    const MatrixXd load = beam.M * X;
    const MatrixXd Y = factors.solve(load);
    // K and M on the subspace; Y^T K Y without the round-off of K.
    const MatrixXd stiffness = Y.transpose() * load;
    const MatrixXd mass = Y.transpose() * (beam.M * Y);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(
        0.5 * (stiffness + stiffness.transpose()), 0.5 * (mass + mass.transpose()));
    X = Y * ritz.eigenvectors();
    const double next = ritz.eigenvalues()[k - 1];
    const bool settled = std::abs(next - square) <= agreed * next;
    square = next;
    if (settled) break;
  }
  return std::sqrt(square);
}

double hermite_deflection(const HermiteBeam& beam) {
  const Index size = beam.K.rows();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(beam.K);
  const VectorXd q = factors.solve(VectorXd::Unit(size, size - 2));
  return q[size - 2];
}

double hermite_root_moment(const HermiteBeam& beam, double omega) {
  const Index size = beam.K.rows();
  const double square = omega * omega;
  const Eigen::SparseMatrix<double> dynamic = beam.K - square * beam.M;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(dynamic);
  const VectorXd load = VectorXd::Unit(size, size - 2);
  const VectorXd q = factors.solve(load);
  return (beam.root_K - square * beam.root_M) * q;
}

}  // namespace boxbeam::charts
