#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/mechanism/flexible/modal_response.hpp"

/// What the harmonic response by modes and the sudden start have in common.
namespace boxbeam::flexible {

/// omega^2 of the modes.
Eigen::VectorXd squares_of(const ModalModel& model);

/// How motions and joint forces follow from the coordinates eta of the modes:
///
///     q = K^-1 f + sum of phi_j x_j + sum of r_j eta_j',  x_j = -eta_j''/omega_j^2
///
/// r_j = -K^-1 C phi_j, its joint forces with those that damping itself bears. Without static
/// correction, and where a mode is without strain, x_j = eta_j.
struct Recovery {
  Deformation<Complex> of_loads;
  std::vector<Deformation<double>> of_speed;
  Eigen::VectorXd flexibility;  ///< 1/omega^2 where x is of the acceleration, else 0

  template <class Vector>
  Vector x(const Vector& place, const Vector& acceleration) const {
    Vector result = -flexibility.cwiseProduct(acceleration);
    for (Eigen::Index j = 0; j < flexibility.size(); ++j) {
      if (flexibility[j] == 0.0) result[j] = place[j];
    }
    return result;
  }
};

Recovery recovery_of(const ModalModel& model, bool static_correction);

/// Joint forces of the modes alone.
template <class Vector>
auto joints_of(const ModalModel& model, const Recovery& recovery, const Vector& x,
               const Vector& speed) {
  using Scalar = typename Vector::Scalar;
  Eigen::Matrix<Scalar, 3, Eigen::Dynamic> joints = Eigen::Matrix<Scalar, 3, Eigen::Dynamic>::Zero(
      3, static_cast<Eigen::Index>(model.structure->joints.size()));
  for (std::size_t j = 0; j < model.modes.size(); ++j) {
    const auto at = static_cast<Eigen::Index>(j);
    joints += x[at] * model.modes[j].shape.joints;
    if (!recovery.of_speed.empty()) joints += speed[at] * recovery.of_speed[j].joints;
  }
  return joints;
}

/// phi^T f, and how much it could be: with all loads where the mode moves and turns most.
struct ModalLoads {
  Eigen::VectorXcd p;
  Eigen::VectorXd size;
};

ModalLoads modal_loads_of(const ModalModel& model);

}  // namespace boxbeam::flexible
