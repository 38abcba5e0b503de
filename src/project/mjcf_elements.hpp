#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot_file.hpp"

namespace boxbeam::robots {

/// How a model is to be read, by its <compiler> and <option>.
struct MjcfSettings {
  /// Of what the mass of a body is made.
  enum class MassFrom { elements, shapes, what_is_there };

  bool degrees = true, autolimits = true;
  bool no_gravity = false, no_equality = false;
  std::string euler = "xyz";  ///< axes of three turns, capitals for those that do not turn
  MassFrom mass_from = MassFrom::what_is_there;
  double least_mass = 0.0;                     ///< [kg]
  double least_moment = 0.0;                   ///< [kg m^2]
  double first_group = 0.0, last_group = 5.0;  ///< of shapes whose masses count
};

using MjcfAttributes = std::map<std::string, std::string>;

/// An element with its attributes, those of its class where it does not say them.
struct MjcfElement {
  RobotElement of;
  MjcfAttributes attributes;

  const std::string* attribute(const std::string& name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? nullptr : &found->second;
  }
  std::string text(const std::string& name, const std::string& otherwise = "") const {
    const std::string* const given = attribute(name);
    return given == nullptr ? otherwise : *given;
  }
};

/// An element in a body, or in a frame of it.
struct MjcfChild {
  const XmlElement* element;
  Pose frame;  ///< in which it is written, in the body's
  std::string childclass;
};

/// How messages call an element: by its name, or its tag.
std::string called(const XmlElement& element);

/// The elements of a model with the attributes that their classes give them, and their numbers,
/// words and poses. What is wrong is noted in the file, what is left out in the robot.
class MjcfElements {
 public:
  /// Both stay.
  MjcfElements(RobotFile& file, Robot& robot) : file_(&file), robot_(&robot) {}

  /// Reads <compiler>, <option> and <default>, and notes elements that stand for others.
  void read_settings(const XmlElement& model);
  const MjcfSettings& settings() const { return settings_; }

  /// The numbers of an attribute; nothing where it is not there, or is wrong and noted.
  std::optional<std::vector<double>> numbers(const MjcfElement& in, const char* name,
                                             std::size_t least, std::size_t most);
  double number(const MjcfElement& in, const char* name, double otherwise);
  Eigen::Vector3d triple(const MjcfElement& in, const char* name,
                         const Eigen::Vector3d& otherwise = Eigen::Vector3d::Zero());
  /// The place of a word among these. Notes a word that is none of them; then the first.
  std::size_t choice(const MjcfElement& in, const char* name, const std::string& otherwise,
                     const std::vector<std::string>& words);
  /// An angle [rad] of one as it is written.
  double angle(double given) const;
  Pose pose_in(const MjcfElement& in);

  MjcfElement with_class(const XmlElement& element, const std::string& childclass);
  /// The class of what stands in a body or frame.
  std::string class_in(const XmlElement& element, const std::string& before);

  void problem(const RobotElement& of, const std::string& message, const std::string& hint) {
    file_->problem(of, message, hint);
  }
  /// What is left out of the model is said in the case.
  void leave_out(const std::string& what) { ++robot_->left_out[what]; }

 private:
  void refuse_what_makes_elements(const XmlElement& element);
  void read_compiler(const XmlElement& element);
  void read_option(const XmlElement& element);
  void read_class(const XmlElement& element, const std::string& parent, bool outermost);
  Eigen::Matrix3d rotation_in(const MjcfElement& in);

  RobotFile* file_;
  Robot* robot_;
  MjcfSettings settings_;
  std::map<std::string, std::map<std::string, MjcfAttributes>> classes_;  ///< by tag
};

/// The mass of a body, by its <inertial> or by its shapes; nothing where it has none. `inside`:
/// what stands in it.
std::optional<Inertial> mass_of(MjcfElements& elements, const RobotElement& of,
                                const std::vector<MjcfChild>& inside);

/// Where a joint may stand, and what it does where nothing drives it: spring, damper, friction.
/// `of`: how messages call it.
void read_limits(MjcfElements& elements, const RobotElement& of, const MjcfElement& in,
                 Joint& joint);
void read_passive(MjcfElements& elements, const RobotElement& of, const MjcfElement& in,
                  Joint& joint);

}  // namespace boxbeam::robots
