#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

/// The largest distance of a named point from its body's centre of mass.
double size_of(const Mechanism& mechanism) {
  double size = 0.0;
  for (const Body& body : mechanism.bodies) {
    for (const BodyPoint& point : body.points) size = std::max(size, point.p.norm());
  }
  return size > 0.0 ? size : 1.0;
}

bool is_length_equation(const Joint& joint, int row_in_joint) {
  if (std::holds_alternative<Pin>(joint.kind)) return true;
  if (std::holds_alternative<Slider>(joint.kind)) return row_in_joint == 0;
  if (const auto* driven = std::get_if<Driven>(&joint.kind)) {
    return driven->coordinate != Coordinate::angle;
  }
  return false;
}

}  // namespace

DegreesOfFreedom degrees_of_freedom_of(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  const Eigen::Index rows = mechanism.equations();
  Eigen::VectorXd phi(rows);
  Eigen::MatrixXd jacobian(rows, mechanism.coordinates());
  evaluate_constraints(mechanism, 0.0, q, phi, jacobian);

  const double size = size_of(mechanism);
  std::vector<Eigen::Index> of_joints;
  DegreesOfFreedom result;
  Eigen::Index row = 0;
  for (const Joint& joint : mechanism.joints) {
    const bool driver = std::holds_alternative<Driven>(joint.kind);
    result.drivers += driver ? 1 : 0;
    for (int k = 0; k < equations_of(joint); ++k, ++row) {
      if (!driver) of_joints.push_back(row);
      if (is_length_equation(joint, k)) jacobian.row(row) /= size;
    }
  }
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i) {
    if (i % 3 != 2) jacobian.col(i) *= size;
  }

  const Eigen::MatrixXd joints_only = jacobian(of_joints, Eigen::all);
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(joints_only);
  svd.setThreshold(1e-9);
  const int rank = static_cast<int>(svd.rank());
  const int equations = static_cast<int>(of_joints.size());
  result.gruebler = static_cast<int>(mechanism.coordinates()) - equations;
  result.by_rank = static_cast<int>(mechanism.coordinates()) - rank;
  result.redundant = equations - rank;
  if (rows == mechanism.coordinates()) {
    const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
    result.condition = values.minCoeff() > 0.0 ? values.maxCoeff() / values.minCoeff() : 0.0;
  }
  return result;
}

}  // namespace boxbeam::planar
