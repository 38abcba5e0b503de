#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/mechanism/spatial/mechanism.hpp"

namespace boxbeam::spatial {

/// How a body stands and moves at an instant; of its origin where a point is meant.
struct BodyMotion {
  Eigen::Matrix3d R_WB;  ///< columns: the body's axes in the world
  Eigen::Vector3d omega, alpha;
  Eigen::Vector3d position, velocity, acceleration;
  Eigen::Vector3d joint;  ///< place of the body's own point of the joint that carries it [m]
};

struct State {
  double time = 0.0;  ///< [s]
  std::vector<BodyMotion> bodies;
};

/// A force and a moment.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N m]
};

/// What a body's inertia puts on the mechanism (d'Alembert), about its centre of mass.
struct InertiaLoad {
  Eigen::Vector3d force;   ///< -m a
  Eigen::Vector3d moment;  ///< -(I alpha + omega x I omega)
  /// The part of the moment that there is only because the body turns in its own joint, u against
  /// the body that carries it, whose rate of turn is O:
  ///
  ///     -(I (O x u) + O x I u + u x I O + u x I u)
  ///
  /// For a wheel of inertia I_1 about its axle this is -I_1 O x u, the gyroscopic moment.
  Eigen::Vector3d gyroscopic;
};

/// The tree of joints, prepared for many instants. Keeps a reference to its mechanism.
class Chain {
 public:
  explicit Chain(const Mechanism& mechanism);

  const Mechanism& mechanism() const { return *mechanism_; }

  /// All bodies at a time, from the ground outwards:
  ///
  ///     omega_B = omega_P + u,  alpha_B = alpha_P + a q'' + omega_P x u,   u = a q'
  ///
  /// a the joint's axis in the world; velocities and accelerations are exact derivatives of the
  /// positions. Source: Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 5.
  State at(double time) const;
  void at(double time, State& state) const;

  /// What each joint does to the body that it carries, at the joint's point: recursive
  /// Newton-Euler from the free ends to the ground. Source: Luh, Walker and Paul (1980).
  std::vector<Wrench> joint_wrenches(const State& state) const;
  void joint_wrenches(const State& state, std::vector<Wrench>& joints) const;

 private:
  /// What is needed of a joint at every instant, side by side:
  /// turned(q) = fixed + cos q along_cosine + sin q along_sine.
  struct Link {
    Eigen::Matrix3d fixed, along_cosine, along_sine;
    Eigen::Vector3d at, axis, point;
    const Driver* driver;
    JointKind kind;
    int parent;
    bool shifted;  ///< the body's origin lies elsewhere than the joint
  };

  const Mechanism* mechanism_;
  std::vector<Link> links_;
};

/// A place's position [m], velocity [m/s] and acceleration [m/s^2] in the world.
Eigen::Vector3d position_of(const State& state, const Attachment& at);
Eigen::Vector3d velocity_of(const State& state, const Attachment& at);
Eigen::Vector3d acceleration_of(const State& state, const Attachment& at);

/// A vector given in a body's axes, in the world; that of the ground as it is.
Eigen::Vector3d in_world(const State& state, int axes, const Eigen::Vector3d& vector);
/// The other way: a vector of the world in a body's axes.
Eigen::Vector3d in_axes(const State& state, int axes, const Eigen::Vector3d& vector);

InertiaLoad inertia_of(const Mechanism& mechanism, const State& state, std::size_t body);

}  // namespace boxbeam::spatial
