#pragma once

#include <Eigen/Core>
#include <span>
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
  /// q, q', q'' of every joint that carries a body [rad or m]; zero of a fixed one.
  std::vector<DriverState> coordinates;
  /// Of every contact (`friction_contacts_of`), on the body that a joint carries or a closing
  /// joint's body b, along the joint's axis [N]; empty where it is not known.
  std::vector<double> friction = {};
  /// Of every spring, the lambda of its impact; whether it touches follows from the position. Empty
  /// where nothing is lost.
  std::vector<Touch> touches = {};
};

/// A force and a moment.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N m]
};

/// A wrench on a body, about a place in the world.
struct BodyWrench {
  int on = ground;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m]
  Wrench wrench;
};

/// The joints that carry bodies, prepared for many instants. Keeps a reference to its mechanism.
class Tree {
 public:
  explicit Tree(const Mechanism& mechanism);

  const Mechanism& mechanism() const { return *mechanism_; }

  /// Sets a state's time, and the coordinates that drivers move.
  void drive(State& state, double time) const;
  /// The same of t = 0, with what forces move at its start.
  void begin(State& state) const;

  /// All bodies from the state's coordinates, from the ground outwards:
  ///
  ///     omega_B = omega_P + u,  alpha_B = alpha_P + a q'' + omega_P x u,   u = a q'
  ///
  /// a the joint's axis in the world; velocities and accelerations are exact derivatives of the
  /// positions. Source: Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 5.
  void move(State& state) const;

  /// The same step by step: positions alone,
  void place(State& state) const;
  /// of these the velocities, linear in the rates of the joints, and with a rate of one what Kane
  /// calls partial velocities (Kane and Levinson, Dynamics: Theory and Applications, 1985, 2.14),
  void move_at_rates(State& state) const;
  /// of both the accelerations.
  void accelerate(State& state) const;

  /// What each joint does to the body that it carries, at the joint's point, where `others` act
  /// beside the mechanism's loads: recursive Newton-Euler from the free ends to the ground. Source:
  /// Luh, Walker and Paul (1980).
  void wrenches(const State& state, std::span<const BodyWrench> others,
                std::vector<Wrench>& joints) const;

 private:
  /// What is needed of a joint at every instant, side by side:
  /// turned(q) = fixed + cos q along_cosine + sin q along_sine.
  struct Link {
    Eigen::Matrix3d fixed, along_cosine, along_sine;
    Eigen::Vector3d at, axis, point;
    double advance;  ///< along the axis per unit of q
    int parent;
    bool turns;    ///< q is an angle
    bool shifted;  ///< the body's origin lies elsewhere than the joint
  };
  template <bool positions, bool velocities, bool accelerations>
  void move_outwards(State& state) const;

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

/// What a wrench about a joint's place does along its coordinate, its axis given in the world
/// [N m or N]; 0 of a fixed one.
double along_coordinate(const Joint& joint, const Eigen::Vector3d& axis, const Wrench& wrench);

/// The tension of a spring as one that both pushes and pulls, and its rate of change [N, N/s].
struct Tension {
  double value = 0.0, rate = 0.0;
};
Tension tension_of(const Spring& spring, const State& state);

/// What must be positive where a spring only pulls, negative where it only pushes, for it to act:
/// its own tension, and where a damper is in it how far it is longer than its free length, as the
/// tension of a spring of 1 N/m. None for a spring that acts both ways.
std::vector<Spring> switches_of(const Spring& spring);

/// Whether a spring acts. A stop that is not touched and a slack cable do not, however fast its
/// ends approach each other or part.
bool acts(const Spring& spring, const State& state);

/// What spring i does to its place on b, world axes [N]; to that on a the opposite.
Eigen::Vector3d force_of(const Mechanism& mechanism, std::size_t i, const State& state);

/// What a torsion spring does to the body that its joint carries, world axes [N m]; to the carrying
/// body the opposite.
Eigen::Vector3d couple_of(const Mechanism& mechanism, const TorsionSpring& spring,
                          const State& state);

/// How a body moves; the ground does not.
const BodyMotion& motion_of(const State& state, int body);

}  // namespace boxbeam::spatial
