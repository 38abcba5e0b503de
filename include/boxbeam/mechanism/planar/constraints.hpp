#pragma once

#include <Eigen/Core>

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// Position of an attached point in world axes [m].
Eigen::Vector2d position_of(const Attachment& point, const Eigen::VectorXd& q);
/// Velocity and acceleration of an attached point in world axes.
Eigen::Vector2d velocity_of(const Attachment& point, const Eigen::VectorXd& q,
                            const Eigen::VectorXd& v);
Eigen::Vector2d acceleration_of(const Attachment& point, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& v, const Eigen::VectorXd& a);

/// Constraint equations Phi(q, t), metres and radians; `phi` must have the mechanism's size.
void evaluate_constraints(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                          Eigen::VectorXd& phi);

/// Constraints and their Jacobian dPhi/dq at once; analytic.
void evaluate_constraints(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                          Eigen::VectorXd& phi, Eigen::MatrixXd& jacobian);

/// Right side of J v = -dPhi/dt.
void velocity_right_side(const Mechanism& mechanism, double time, Eigen::VectorXd& nu);

/// Right side of J a = -(J v)_q v - d2Phi/dt2.
void acceleration_right_side(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                             const Eigen::VectorXd& v, Eigen::VectorXd& gamma);

}  // namespace boxbeam::planar
