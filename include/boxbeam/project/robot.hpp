#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Robots as files of other programs describe them, and cases in space that begin with one. SI
/// units, angles in radians.
namespace boxbeam::robots {

/// Mass of a link, in the link's axes.
struct Inertial {
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass, from the link's origin [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre [kg m^2]
};

struct Link {
  std::string name;
  std::optional<Inertial> inertial = {};
};

enum class JointType { fixed, revolute, continuous, prismatic, planar, spherical, floating };

const char* to_text(JointType type);

/// What a joint may do; none where it is not said. SI units of its coordinate.
struct Limit {
  std::optional<double> lower, upper, effort, velocity;
};

/// The coordinate follows that of another joint: q = multiplier q_other + offset.
struct Mimic {
  std::size_t joint = 0;  ///< index of the other
  double multiplier = 1.0;
  double offset = 0.0;
};

/// A turn about an axis of any length.
struct Turn {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double angle = 0.0;
};

/// What acts along the coordinate of a joint beside its drive; SI units of the coordinate.
struct Passive {
  std::optional<double> damping;  ///< force or moment per rate
  std::optional<double> stiffness;
  double free = 0.0;  ///< coordinate at which the spring is free
  std::optional<double> friction, armature;
};

/// Carries a link by another: where the joint is at zero the point of the carried link, in whose
/// axes it is given, stands at xyz in the carrying link's frame, and the carried link is turned by
/// turns one after the other, each about axes that have turned by then.
struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  std::size_t parent = 0, child = 0;                ///< indices of links
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();    ///< [m]
  std::vector<Turn> turns = {};                     ///< R = R_1 R_2 ..
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of the carried link [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< in the carried link's axes, of any length
  double reference = 0.0;  ///< coordinate in the posture that the file describes; of one movement
  Limit limit = {};
  std::optional<Mimic> mimic = {};
  Passive passive = {};
  bool actuated = false;  ///< the file has an actuator for it
};

/// One of the movements of a joint, as a case in space calls it: "wrist", or of several "base.1".
struct Coordinate {
  std::string name;
  bool turns = true;  ///< else it shifts
};

std::vector<Coordinate> coordinates_of(const Joint& joint);

Eigen::Matrix3d rotation_of(const std::vector<Turn>& turns);

/// Closes a loop between two links that joints carry.
struct Closing {
  enum class Kind { point, weld };  ///< two places coincide; also two frames

  std::string name;
  Kind kind = Kind::point;
  std::size_t a = 0, b = 0;  ///< indices of links
  Eigen::Vector3d p_a = Eigen::Vector3d::Zero(), p_b = Eigen::Vector3d::Zero();  ///< link axes [m]
  std::vector<Turn> turns = {};  ///< of a weld: how b stands in the axes of a
};

/// Links form a tree, one joint carries each but the root; closings close loops in it.
struct Robot {
  std::string file;    ///< as it was named
  std::string format;  ///< "URDF"
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Closing> closings;
  std::size_t root = 0;                      ///< index of a link
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};  ///< [m/s^2]
  std::map<std::string, int> left_out;       ///< what is not read, and how often it stands

  /// A root without mass is the ground; another one is fixed to it.
  bool is_ground(std::size_t link) const { return link == root && !links[root].inertial; }
};

/// Where a frame stands in another one.
struct Pose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< [m]

  Pose operator*(const Pose& then) const { return {R * then.R, p + R * then.p}; }
  Pose inverse() const { return {R.transpose(), -(R.transpose() * p)}; }
};

/// The links' frames in that of the root where every joint is at its reference; joints of several
/// movements at zero.
std::vector<Pose> reference_poses(const Robot& robot);

/// Of every joint and each of its movements whether the closings decide it, so that no driver moves
/// it: as many as they have independent equations in the posture of reference. Actuated and
/// mimicked joints keep their drivers where others can be left, then those near the root. All false
/// without closings.
std::vector<std::vector<bool>> left_to_closings(const Robot& robot);

/// Read a URDF file, or the same from text under a name for messages. Throw InputError with all
/// problems. Source: the specification of URDF/XML, elements robot, link, joint (Open Robotics,
/// wiki.ros.org/urdf/XML).
Robot read_urdf(const std::string& path);
Robot parse_urdf(const std::string& file, const std::string& text);

/// Read an MJCF model, likewise. Bodies stand where they do at the joints' ref, coordinates are
/// MuJoCo's qpos but of ball and free joints, which are zero in that posture. Source: MuJoCo's XML
/// reference (mujoco.readthedocs.io/en/stable/XMLreference.html).
Robot read_mjcf(const std::string& path);
Robot parse_mjcf(const std::string& file, const std::string& text);

/// The skeleton of a case in space with the robot's bodies and joints, as the text of a TOML file:
/// it can be verified, and marks as PLACEHOLDER what the robot does not say: section, material,
/// drivers. `beam`: the link that is verified; "": the heaviest that is not the root. Throws
/// InputError where there is no such link.
std::string case_text(const Robot& robot, const std::string& beam);

}  // namespace boxbeam::robots
