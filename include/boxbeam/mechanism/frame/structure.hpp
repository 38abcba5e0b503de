#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/mechanism/common/time_span.hpp"

/// Beams and frames at rest, on supports: members of tapered sections in space, joined to each
/// other and to the ground, under load cases.
namespace boxbeam::frame {

inline constexpr int ground = -1;

/// A named place of a member, in its axes from its start [m].
struct MemberPoint {
  std::string name;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// A straight beam, elastic all along.
struct Member {
  std::string name;
  TaperedBeam beam;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();         ///< world [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();      ///< R_WM, columns x (along it), y, z
  double youngs_modulus = 2.1e11, shear_modulus = 8.1e10;  ///< [Pa]
  double expansion = 1.2e-5;                               ///< of heat [1/K]
  std::vector<MemberPoint> points = {};
};

/// A place of a member, in its axes from its start (x along it, y and z off its axis, rigidly
/// joined to it), or of the ground, in world axes [m].
struct Place {
  int member = ground;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// Holds a place of one member to one of another or of the ground.
///
/// Its gap is the motion of b less that of a: shifts along its three axes, turns about them. What
/// it does to a is stiffness times gap, to b the opposite. Infinite stiffness is rigid, zero free:
/// a support is a joint with the ground, a hinge is free to turn about one axis.
struct Joint {
  std::string name;
  Place a, b;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< world, as columns
  std::array<double, 6> stiffness{};                   ///< [N/m] along, [N m/rad] about its axes
};

/// A force and a couple on a place of a member, world axes [N, N m].
struct PointAction {
  Place at;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

/// A force or a couple on a place of a member whose size follows a function of time.
struct DrivenAction {
  Place at;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< world axes
  bool couple = false;
  Driver size;  ///< [N, N m]
};

/// Force per length of a member's axis that varies linearly between two stations, world axes.
struct LineAction {
  int member = 0;
  double from = 0.0, to = 0.0;                        ///< [m]
  Eigen::Vector3d at_from = Eigen::Vector3d::Zero();  ///< [N/m]
  Eigen::Vector3d at_to = Eigen::Vector3d::Zero();    ///< [N/m]
};

/// A member warmer than it was when it was built: by `mean` in its axis, by so much more per length
/// across it.
struct HeatAction {
  int member = 0;
  double mean = 0.0;                    ///< [K]
  double along_y = 0.0, along_z = 0.0;  ///< [K/m]
};

/// The ground, or the end b of a joint, shifted and turned from where it would fit, world axes.
struct Settlement {
  int joint = 0;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();   ///< [rad]
};

/// The weight of all members.
struct OwnWeight {};

/// Wheels that run along a member: the first stands at `from + speed t`, the others `behind` it.
/// What is beyond an end of the member does not load it.
struct Wheels {
  struct Wheel {
    double behind = 0.0;                              ///< the first [m]
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< world axes [N]
  };
  int member = 0;
  double from = 0.0, to = 0.0;  ///< stations of the first wheel [m]
  double speed = 1.0;           ///< [m/s]
  double y = 0.0, z = 0.0;      ///< of the rail, off the member's axis [m]
  std::vector<Wheel> wheels;

  double duration() const { return (to - from) / speed; }
};

struct Action {
  std::string name;
  std::variant<OwnWeight, PointAction, DrivenAction, LineAction, HeatAction, Settlement, Wheels>
      kind;
};

/// Actions that come and go together.
struct LoadCase {
  std::string name;
  std::vector<Action> actions;
};

/// A frame with its load cases, and how often each of them counts.
struct Structure {
  std::vector<Member> members;
  std::size_t beams = 1;  ///< the first members, which are verified
  std::vector<Joint> joints;
  std::vector<LoadCase> cases;
  std::vector<double> factors;                        ///< of each case
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s^2]
  /// Members, joints and actions in the plane z = 0 of the world, with their z axes in it: motion
  /// out of it is not looked at.
  bool plane = false;
  Duration duration = {};  ///< of what follows functions of time; wheels take as long as they need
};

/// The functions of time of the load cases that count, and what follows them.
std::vector<DriverUse> functions_of(const Structure& structure);

/// Whether an action, or one of any load case, changes over time.
bool changes_over_time(const Action& action);
bool changes_over_time(const Structure& structure);

/// The place in the world [m].
Eigen::Vector3d in_world(const Structure& structure, const Place& at);

}  // namespace boxbeam::frame
