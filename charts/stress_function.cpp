#include "charts/stress_function.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace boxbeam::charts {
namespace {

/// Grid lines from the middle of the box to its outer face.
struct Lines {
  std::vector<double> at;
  std::size_t inner_face = 0;  ///< the line on it
};

/// Finer towards the inner face from both sides, as the singularity of a re-entrant corner asks
/// (Grisvard's grading: the third power gives back order 2).
Lines lines_of(double half, double wall, int parts) {
  constexpr double power = 3.0;
  const double face = half - wall;
  const double reach = std::min(face, 8.0 * wall);
  Lines lines;
  if (reach < face) lines.at.push_back(0.0);
  for (int k = 2 * parts; k > 0; --k) {
    lines.at.push_back(face - reach * std::pow(k / (2.0 * parts), power));
  }
  if (reach == face) lines.at.front() = 0.0;
  lines.inner_face = lines.at.size();
  for (int k = 0; k <= parts; ++k)
    lines.at.push_back(face + wall * std::pow(k * 1.0 / parts, power));
  return lines;
}

/// phi = 0 outside, one value in the whole hollow, -laplace(phi) = 2; I_T = 2 int phi dA.
double constant_on(const Lines& y, const Lines& z) {
  const std::size_t rows = y.at.size(), cols = z.at.size();
  std::vector<int> unknown(rows * cols, -1);  // -1: on the outer face
  int count = 1;                              // 0: the hollow
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    for (std::size_t j = 0; j + 1 < cols; ++j) {
      const bool hollow = i <= y.inner_face && j <= z.inner_face;
      unknown[i * cols + j] = hollow ? 0 : count++;
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(count);
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    for (std::size_t j = 0; j + 1 < cols; ++j) {
      const double a = y.at[i + 1] - y.at[i], b = z.at[j + 1] - z.at[j];
      const int corner[4] = {unknown[i * cols + j], unknown[(i + 1) * cols + j],
                             unknown[(i + 1) * cols + j + 1], unknown[i * cols + j + 1]};
      // Of the gradients along y and z; corners go around.
      const double p = b / (6.0 * a), q = a / (6.0 * b);
      const double stiffness[4] = {2.0 * (p + q), q - 2.0 * p, -(p + q), p - 2.0 * q};
      for (int m = 0; m < 4; ++m) {
        if (corner[m] < 0) continue;
        load[corner[m]] += 0.5 * a * b;
        for (int n = 0; n < 4; ++n) {
          if (corner[n] < 0) continue;
          // Neighbours along y are 0-1 and 2-3, along z 1-2 and 3-0.
          const int kind = m == n ? 0 : (m + n == 1 || m + n == 5) ? 1 : (m - n) % 2 == 0 ? 2 : 3;
          entries.emplace_back(corner[m], corner[n], stiffness[kind]);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  return 4.0 * load.dot(solver.solve(load).eval());
}

}  // namespace

double torsion_constant_by_elements(double width, double height, double wall, int parts) {
  const auto with = [&](int n) {
    return constant_on(lines_of(0.5 * width, wall, n), lines_of(0.5 * height, wall, n));
  };
  // The errors fall with the squares of the elements' sizes, then with their fourth powers.
  const double coarse = with(parts / 4), middle = with(parts / 2), fine = with(parts);
  const double once = middle + (middle - coarse) / 3.0, again = fine + (fine - middle) / 3.0;
  return again + (again - once) / 15.0;
}

}  // namespace boxbeam::charts
