#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/common/sign_changes.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "boxbeam/mechanism/planar/state.hpp"

namespace boxbeam::planar {

/// What an applied force (spring, damper, force, couple) does to one body, at a point.
struct AppliedLoad {
  int force = 0;  ///< index in the mechanism's forces
  int on = ground;
  Eigen::Vector2d vector = Eigen::Vector2d::Zero();  ///< world axes [N]
  double moment = 0.0;                               ///< counter-clockwise [N m]
  Eigen::Vector2d point = Eigen::Vector2d::Zero();   ///< where, in the body's axes [m]
};

/// `touches`: as those of a state.
std::vector<AppliedLoad> applied_loads_of(const Mechanism& mechanism, double time,
                                          const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                          const std::vector<Touch>& touches = {});

/// Adds the generalised applied forces to Q.
void add_applied_forces(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                        const Eigen::VectorXd& v, Eigen::VectorXd& Q,
                        const std::vector<Touch>& touches = {});

/// A force that acts one way from a length of the line between its ends on.
struct OneSided {
  std::size_t force = 0;  ///< index in the mechanism's forces
  Attachment a, b;
  LineLaw law;
};

std::vector<OneSided> one_sided_in(const Mechanism& mechanism);

/// How far the ends are beyond the length from which it acts, and the rate of that [m, m/s].
ValueAndRate depth_of(const OneSided& of, const Eigen::VectorXd& q, const Eigen::VectorXd& v);

/// The times at which springs begin and end to act one way in a motion that drivers decide, in no
/// order. `at`: the state at any time within [begin, begin + length].
std::vector<double> changes_by_drivers(const Mechanism& mechanism, double begin, double length,
                                       const std::function<const State&(double)>& at);

/// A sliding contact with friction, prepared for evaluation.
struct FrictionContact {
  int joint = 0;
  Eigen::Index row = 0;  ///< of the constraint whose multiplier is the normal force N
  bool moment = false;   ///< whether the next row's multiplier is a moment that presses as well
  Attachment point, guide;
  double direction = 0.0;
  Friction law;
};

/// Whether a joint slides with friction.
bool rubs(const Joint& joint);

std::vector<FrictionContact> friction_contacts_of(const Mechanism& mechanism);

/// Direction of a contact's guide in the world.
Eigen::Vector2d tangent_of(const FrictionContact& contact, const Eigen::VectorXd& q);

/// Velocity of the sliding point along the guide, relative to the guide's body [m/s].
double sliding_velocity_of(const FrictionContact& contact, const Eigen::VectorXd& q,
                           const Eigen::VectorXd& v);

/// Rate of change of the sliding velocity [m/s^2].
double sliding_acceleration_of(const FrictionContact& contact, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& v, const Eigen::VectorXd& a);

/// What presses on the guide, by the multipliers [N].
double pressure_on(const FrictionContact& contact, const Eigen::VectorXd& lambda);

/// The generalised force of a unit friction force: on the sliding body along the guide, and its
/// opposite on the guide's body at the same place.
void unit_friction(const FrictionContact& contact, const Eigen::VectorXd& q, Eigen::VectorXd& Q);

/// Velocities and loads of all contacts; rates are left zero. `lambda_0`: the multipliers without
/// friction; `by_unit`: their change per unit of each force, a column each.
FrictionResponse friction_response_of(const std::vector<FrictionContact>& contacts,
                                      const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                      const Eigen::VectorXd& lambda_0,
                                      const Eigen::MatrixXd& by_unit);

/// The friction forces of all contacts by `boxbeam::solve_friction`. Throws AnalysisError where
/// friction locks the mechanism.
Eigen::VectorXd solve_friction(const Mechanism& mechanism,
                               const std::vector<FrictionContact>& contacts, double time,
                               const std::vector<Slip>& slips, const FrictionResponse& response);

std::vector<Friction> laws_of(const std::vector<FrictionContact>& contacts);
std::vector<std::string> names_of(const Mechanism& mechanism,
                                  const std::vector<FrictionContact>& contacts);

}  // namespace boxbeam::planar
