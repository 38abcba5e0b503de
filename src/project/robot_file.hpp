#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/robot.hpp"

namespace boxbeam::robots {

/// An element of an XML file and where it begins in the text.
struct XmlElement {
  std::string tag;
  std::map<std::string, std::string> attributes;
  std::vector<XmlElement> children;
  std::size_t at = 0;

  /// An attribute, or nothing.
  const std::string* attribute(const std::string& name) const;
  std::size_t count(const std::string& of_tag) const;
};

/// An element of a robot, and how messages call it.
struct RobotElement {
  const XmlElement* element;
  std::string what;
};

/// The text of a robot's file, with the problems found in it.
class RobotFile {
 public:
  /// `example`: what such a file is, for hints.
  RobotFile(std::string file, const std::string& text, std::string format, std::string example);

  /// The outermost element. Throws InputError where the text is no XML with this one.
  XmlElement outermost(const std::string& tag);

  void problem(std::size_t at, std::string message, std::string hint);
  void problem(const RobotElement& of, const std::string& message, std::string hint);
  void problem_of_file(std::string message, std::string hint);
  std::size_t problems() const { return problems_.size(); }
  /// Throws InputError where problems were noted.
  void raise() const;

  /// The one element of a name in another, or nullptr. Notes a second one.
  const XmlElement* element_in(const RobotElement& of, const XmlElement& in, const char* tag);

  /// The numbers of an attribute, from `least` to `most` of them; nothing where it is not there, or
  /// is wrong and noted.
  std::optional<std::vector<double>> numbers(const RobotElement& of, const std::string& tag,
                                             const std::string& name, const std::string& text,
                                             std::size_t least, std::size_t most);

  /// Notes two things of one name, and names that mean something else in a case. `links` and
  /// `joints`: the elements of the robot's, in their order.
  void check_names(const Robot& robot, const std::vector<RobotElement>& links,
                   const std::vector<RobotElement>& joints);

  /// Notes a joint that follows itself by way of others.
  void check_mimics(const Robot& robot, const std::vector<RobotElement>& joints);

 private:
  std::vector<std::size_t> places_of_elements();

  std::string file_;
  const std::string& text_;
  std::string format_, example_;
  std::vector<Problem> problems_;
};

/// Whether a name is without control characters.
bool is_plain(const std::string& name);

/// Of the joint that carries each link its index; of the root the number of joints.
std::vector<std::size_t> carriers_of(const Robot& robot);

}  // namespace boxbeam::robots
