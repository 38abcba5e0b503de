#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {

/// Where the search for an assembly ended.
struct Assembly {
  Eigen::VectorXd q;
  bool closed = false;  ///< all constraints hold, to round-off
  double gap = 0.0;     ///< what the joint that is open most is open by [m, or rad]
  int joint = -1;       ///< that joint
  int iterations = 0;
};

/// Assembles a mechanism from a rough position: the closest approach of all constraints in the
/// sense of least squares, lengths by the mechanism's size, by the damped method of Levenberg and
/// Marquardt; a zero of it is an assembly. It does not need independent equations, nor as many as
/// coordinates. Source: Madsen, Nielsen, Tingleff, Methods for Non-Linear Least Squares Problems
/// (2004), section 3.2.
class Assembler {
 public:
  explicit Assembler(const Mechanism& mechanism);

  Assembly assemble(double time, const Eigen::VectorXd& start);
  /// With values of the drivers instead of a time.
  Assembly assemble_at(const std::vector<double>& driver_values, const Eigen::VectorXd& start);

 private:
  Assembly search(const Eigen::VectorXd& start);
  /// Sum of squares of the scaled residuals, which it leaves behind.
  double merit_at(const Eigen::VectorXd& q);
  void linearise();

  const Mechanism* mechanism_;
  ConstraintEquations equations_;
  std::vector<double> values_;
  Eigen::VectorXd phi_, scaled_, gradient_, step_, trial_;
  Eigen::SparseMatrix<double> jacobian_;
  std::vector<std::size_t> order_;  ///< of the Jacobian's values, column by column
  std::vector<double> scale_;       ///< of each of these
  Eigen::SparseMatrix<double> normal_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// Starts that fill the space of positions evenly, without randomness: number `index` of a sequence
/// (Halton, 1960) about the sketch, each body turned anyhow and shifted by up to half the reach of
/// all bodies together.
Eigen::VectorXd other_start(const Mechanism& mechanism, const Eigen::VectorXd& sketch, int index);

/// Largest difference of two positions, lengths by `size`; whole turns are none.
double distance_between(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double size);

/// Angles to the turn of a reference: they are only defined up to whole turns.
Eigen::VectorXd unwound(Eigen::VectorXd q, const Eigen::VectorXd& reference);

/// All assemblies found at an instant from the sketch and `starts` other starts, whatever their
/// branch; the sketch's own first. Assemblies apart by whole turns are one.
std::vector<Eigen::VectorXd> list_assemblies(const Mechanism& mechanism, double time,
                                             int starts = 512);

}  // namespace boxbeam::planar
