#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/urdf.hpp"
#include "text_file.hpp"

namespace boxbeam::urdf {
namespace {

using XmlTree = boost::property_tree::ptree;

/// An element of the robot, where it begins in the text, and how messages call it.
struct RobotElement {
  const XmlTree* tree;
  std::size_t at;
  std::string what;
};

/// Behind the tag that begins at a place, or npos; ">" may stand in quotes.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
  char quote = 0;
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

/// The numbers of a text that holds nothing else; all finite.
std::optional<std::vector<double>> numbers_in_text(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const char* const end = word.data() + word.size();
    double number = 0.0;
    const auto [behind, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || behind != end || !std::isfinite(number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

std::optional<std::string> attribute_of(const XmlTree& element, const char* name) {
  const auto attributes = element.find("<xmlattr>");
  if (attributes == element.not_found()) return {};
  const auto found = attributes->second.find(name);
  if (found == attributes->second.not_found()) return {};
  return found->second.data();
}

class RobotReader {
 public:
  RobotReader(const std::string& file, const std::string& text) : text_(text) {
    robot_.file = file;
  }

  Robot read() {
    if (const std::size_t at = std::min(find_not_utf8(text_), text_.find('\0'));
        at != std::string::npos)
      problem(at, "this is no text in UTF-8", "a URDF file is XML; convert it to UTF-8");
    raise();
    const std::vector<std::size_t> places = places_of_elements();
    raise();
    const XmlTree document = parsed();
    if (document.size() != 1 || document.front().first != "robot")
      problem_of_file("there is no <robot>", "a URDF file is <robot name=\"...\"> ... </robot>");
    raise();
    const XmlTree& robot = document.front().second;
    robot_.name = attribute_of(robot, "name").value_or("");
    if (robot_.name.empty()) robot_.name = "robot";
    if (!is_plain(robot_.name)) problem_of_file("the name of the robot has control characters", "");
    sort_elements(robot, places);
    for (const RobotElement& element : links_) read_link(element);
    raise();
    for (const RobotElement& element : joints_) read_joint(element);
    raise();
    find_mimicked();
    check_names();
    raise();
    check_tree();
    raise();
    return std::move(robot_);
  }

 private:
  void problem(std::size_t at, std::string message, std::string hint) {
    const LineColumn place = position_of(text_, at);
    const std::size_t begin = at == 0 ? 0 : text_.rfind('\n', at - 1) + 1;
    std::string line = text_.substr(begin, text_.find('\n', begin) - begin);
    if (line.ends_with('\r')) line.pop_back();
    problems_.push_back({robot_.file, place.line, place.column, std::move(line), std::move(message),
                         std::move(hint)});
  }
  void problem(const RobotElement& of, const std::string& message, std::string hint) {
    problem(of.at, of.what + ": " + message, std::move(hint));
  }
  void problem_of_file(std::string message, std::string hint) {
    problems_.push_back({robot_.file, 0, 0, {}, std::move(message), std::move(hint)});
  }
  void raise() const {
    if (!problems_.empty()) throw InputError(problems_);
  }

  static bool is_plain(const std::string& name) {
    return std::none_of(name.begin(), name.end(),
                        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  }

  /// Where the elements in the outermost one begin, in their order. Boost.PropertyTree keeps no
  /// places, compares no names of closing tags and calls itself as deep as elements lie in each
  /// other: this looks at all three.
  std::vector<std::size_t> places_of_elements() {
    constexpr std::size_t deepest = 100;
    constexpr std::size_t none = std::string_view::npos;
    const std::string_view text = text_;
    std::vector<std::string_view> open;
    std::vector<std::size_t> places;
    const auto behind = [&](std::size_t from, std::string_view end) {
      const std::size_t found = text.find(end, from);
      return found == none ? none : found + end.size();
    };
    std::size_t end = 0;
    for (std::size_t at = text.find('<'); at != none; at = text.find('<', end)) {
      const std::string_view rest = text.substr(at);
      if (rest.starts_with("<!--")) {
        end = behind(at + 4, "-->");
      } else if (rest.starts_with("<![CDATA[")) {
        end = behind(at, "]]>");
      } else if (rest.starts_with("<?")) {
        end = behind(at, "?>");
      } else if (rest.starts_with("<!")) {
        end = behind(at, ">");
      } else {
        end = end_of_tag(text, at);
        const std::string_view tag = text.substr(at, end == none ? none : end - at);
        const std::size_t first = tag.starts_with("</") ? 2 : 1;
        const std::string_view name =
            tag.substr(first, tag.find_first_of(" \t\r\n/>", first) - first);
        if (first == 2) {
          if (open.empty() || open.back() != name) {
            problem(at, fmt::format("</{}> closes nothing that is open", name),
                    open.empty() ? "" : fmt::format("<{}> is open", open.back()));
            return places;
          }
          open.pop_back();
          continue;
        }
        if (name.starts_with("xacro:") || tag.find("${") != none) {
          problem(at, "this is a xacro file, from which a URDF file is made first",
                  "write: xacro ROBOT.xacro > ROBOT.urdf");
          return places;
        }
        if (open.size() == 1) places.push_back(at);
        if (!tag.ends_with("/>")) open.push_back(name);
        if (open.size() > deepest) {
          problem(at, "elements lie too deep in each other", "");
          return places;
        }
      }
      if (end == none) {
        problem(at, "this is no XML: what begins here has no end", "");
        return places;
      }
    }
    return places;
  }

  XmlTree parsed() {
    namespace xml = boost::property_tree::xml_parser;
    XmlTree document;
    std::istringstream stream(text_);
    try {
      xml::read_xml(stream, document, xml::no_comments);
    } catch (const xml::xml_parser_error& error) {
      std::size_t at = 0;
      for (unsigned long line = 1; line < error.line(); ++line) at = text_.find('\n', at) + 1;
      problem(at, fmt::format("this is no XML: {}", error.message()),
              "a URDF file is <robot name=\"...\"> ... </robot>");
      raise();
    }
    return document;
  }

  void sort_elements(const XmlTree& robot, const std::vector<std::size_t>& places) {
    std::size_t next = 0;
    for (const auto& [tag, tree] : robot) {
      if (tag == "<xmlattr>") continue;
      const std::size_t at = next < places.size() ? places[next] : 0;
      ++next;
      if (tag != "link" && tag != "joint") {
        ++robot_.left_out[tag];
        continue;
      }
      const std::string name = attribute_of(tree, "name").value_or("");
      RobotElement element{&tree, at, fmt::format("{} \"{}\"", tag, name)};
      if (name.empty() || !is_plain(name))
        problem(element, "it has no name of letters", fmt::format("write <{} name=\"...\">", tag));
      (tag == "link" ? links_ : joints_).push_back(std::move(element));
    }
    if (links_.empty() && problems_.empty())
      problem_of_file("the robot has no <link>", "links are its bodies, and joints connect them");
  }

  /// The one element of a name in another, or nullptr.
  const XmlTree* element_in(const RobotElement& of, const XmlTree& tree, const char* tag) {
    const std::size_t count = tree.count(tag);
    if (count > 1) problem(of, fmt::format("<{}> stands there twice", tag), "leave one of them");
    return count == 0 ? nullptr : &tree.find(tag)->second;
  }

  /// The numbers of an attribute; nothing where it is not there, or is wrong and noted.
  std::optional<std::vector<double>> numbers(const RobotElement& of, const XmlTree* tree,
                                             const char* tag, const char* name, std::size_t count) {
    if (tree == nullptr) return {};
    const std::optional<std::string> text = attribute_of(*tree, name);
    if (!text) return {};
    std::optional<std::vector<double>> found = numbers_in_text(*text);
    if (found && found->size() == count) return found;
    problem(of,
            fmt::format("{} = \"{}\" of <{}> wants {}", name, *text, tag,
                        count == 1 ? "a number" : fmt::format("{} numbers", count)),
            count == 1 ? "write for example \"0.5\"" : "write for example \"0 0 0.5\"");
    return {};
  }

  std::optional<double> number(const RobotElement& of, const XmlTree* tree, const char* tag,
                               const char* name) {
    const auto found = numbers(of, tree, tag, name, 1);
    return found ? std::optional(found->front()) : std::nullopt;
  }

  Eigen::Vector3d triple(const RobotElement& of, const XmlTree* tree, const char* tag,
                         const char* name, const Eigen::Vector3d& otherwise) {
    const auto found = numbers(of, tree, tag, name, 3);
    return found ? Eigen::Vector3d((*found)[0], (*found)[1], (*found)[2]) : otherwise;
  }

  void read_link(const RobotElement& of) {
    Link link{attribute_of(*of.tree, "name").value_or("")};
    for (const char* shapes : {"visual", "collision"}) {
      if (const std::size_t count = of.tree->count(shapes); count > 0)
        robot_.left_out[shapes] += static_cast<int>(count);
    }
    if (const XmlTree* const inertial = element_in(of, *of.tree, "inertial"))
      link.inertial = read_inertial(of, *inertial);
    robot_.links.push_back(std::move(link));
  }

  Inertial read_inertial(const RobotElement& of, const XmlTree& tree) {
    Inertial inertial;
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const XmlTree* const origin = element_in(of, tree, "origin");
    inertial.centre = triple(of, origin, "origin", "xyz", zero);
    const Eigen::Matrix3d R = rotation_of(triple(of, origin, "origin", "rpy", zero));
    const std::size_t before = problems_.size();
    const auto mass = number(of, element_in(of, tree, "mass"), "mass", "value");
    if (!mass && problems_.size() == before)
      problem(of, "<inertial> has no mass", "write <mass value=\"...\"/>, in kg");
    if (mass && *mass < 0.0)
      problem(of, fmt::format("its mass is {} kg", *mass), "no mass is below zero");
    inertial.mass = mass.value_or(0.0);
    if (const XmlTree* const tensor = element_in(of, tree, "inertia")) {
      const auto part = [&](const char* name) {
        return number(of, tensor, "inertia", name).value_or(0.0);
      };
      const double xx = part("ixx"), xy = part("ixy"), xz = part("ixz");
      const double yy = part("iyy"), yz = part("iyz"), zz = part("izz");
      Eigen::Matrix3d I;
      I << xx, xy, xz, xy, yy, yz, xz, yz, zz;
      inertial.inertia = R * I * R.transpose();
      inertial.inertia = 0.5 * (inertial.inertia + inertial.inertia.transpose()).eval();
    }
    return inertial;
  }

  std::size_t link_named(const RobotElement& of, const char* tag) {
    const XmlTree* const end = element_in(of, *of.tree, tag);
    const std::string name = end ? attribute_of(*end, "link").value_or("") : "";
    std::vector<std::string> known;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (robot_.links[i].name == name) return i;
      known.push_back(robot_.links[i].name);
    }
    const std::string near = nearest_word(name, known);
    if (name.empty())
      problem(of, fmt::format("it has no {}", tag), fmt::format("write <{} link=\"...\"/>", tag));
    else
      problem(of, fmt::format("there is no link \"{}\"", name),
              near.empty() ? fmt::format("write <link name=\"{}\">", name)
                           : fmt::format("did you mean \"{}\"?", near));
    return 0;
  }

  void read_joint(const RobotElement& of) {
    constexpr std::array types{JointType::fixed,     JointType::revolute, JointType::continuous,
                               JointType::prismatic, JointType::planar,   JointType::floating};
    const XmlTree& tree = *of.tree;
    Joint joint{attribute_of(tree, "name").value_or("")};
    const std::string word = attribute_of(tree, "type").value_or("");
    const auto* const type = std::find_if(types.begin(), types.end(),
                                          [&](JointType each) { return word == to_text(each); });
    if (type == types.end())
      problem(of, fmt::format("type = \"{}\" is no type of joint", word),
              "fixed, revolute, continuous, prismatic, planar or floating");
    else
      joint.type = *type;
    joint.parent = link_named(of, "parent");
    joint.child = link_named(of, "child");
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const XmlTree* const origin = element_in(of, tree, "origin");
    joint.xyz = triple(of, origin, "origin", "xyz", zero);
    joint.rpy = triple(of, origin, "origin", "rpy", zero);
    joint.axis = triple(of, element_in(of, tree, "axis"), "axis", "xyz", joint.axis);
    const bool has_axis = joint.type != JointType::fixed && joint.type != JointType::floating;
    if (has_axis && !(joint.axis.norm() > 1e-9))
      problem(of, "its axis is no direction", "write <axis xyz=\"0 0 1\"/>");
    read_limit(of, element_in(of, tree, "limit"), joint.limit);
    if (const XmlTree* const mimic = element_in(of, tree, "mimic")) {
      joint.mimic = Mimic{};
      joint.mimic->multiplier = number(of, mimic, "mimic", "multiplier").value_or(1.0);
      joint.mimic->offset = number(of, mimic, "mimic", "offset").value_or(0.0);
    }
    const XmlTree* const dynamics = element_in(of, tree, "dynamics");
    joint.damping = number(of, dynamics, "dynamics", "damping");
    joint.friction = number(of, dynamics, "dynamics", "friction");
    for (const char* other : {"safety_controller", "calibration"})
      if (tree.count(other) > 0) ++robot_.left_out[other];
    robot_.joints.push_back(std::move(joint));
  }

  void read_limit(const RobotElement& of, const XmlTree* tree, Limit& limit) {
    limit.lower = number(of, tree, "limit", "lower");
    limit.upper = number(of, tree, "limit", "upper");
    limit.effort = number(of, tree, "limit", "effort");
    limit.velocity = number(of, tree, "limit", "velocity");
    if (limit.lower && limit.upper && *limit.lower > *limit.upper)
      problem(
          of,
          fmt::format("its lower limit {} is above its upper one {}", *limit.lower, *limit.upper),
          "write the smaller one as lower");
  }

  void find_mimicked() {
    std::vector<Joint>& joints = robot_.joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (!joints[i].mimic) continue;
      const std::string name =
          attribute_of(joints_[i].tree->find("mimic")->second, "joint").value_or("");
      const auto other = std::find_if(joints.begin(), joints.end(),
                                      [&](const Joint& joint) { return joint.name == name; });
      if (other == joints.end() || coordinates_of(*other).size() != 1 ||
          coordinates_of(joints[i]).size() != 1)
        problem(joints_[i], fmt::format("it cannot mimic \"{}\"", name),
                "both are joints of one movement: revolute, continuous or prismatic");
      else
        joints[i].mimic->joint = static_cast<std::size_t>(other - joints.begin());
    }
    raise();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      std::size_t at = i;
      for (std::size_t steps = 0; joints[at].mimic; at = joints[at].mimic->joint) {
        if (++steps <= joints.size()) continue;
        problem(joints_[i], "it mimics itself by way of others", "let one of them mimic none");
        return;
      }
    }
  }

  /// Notes two things of one name, and names that mean something else in a case.
  void check_names() {
    std::set<std::string> links, joints;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (!links.insert(robot_.links[i].name).second)
        problem(links_[i], "another link has this name", "each link has a name of its own");
    }
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const std::vector<Coordinate> coordinates = coordinates_of(robot_.joints[i]);
      std::vector<std::string> names{robot_.joints[i].name};
      if (coordinates.size() > 1)
        for (const Coordinate& of : coordinates) names.push_back(of.name);
      for (const std::string& name : names) {
        if (joints.insert(name).second) continue;
        problem(joints_[i], fmt::format("another joint is called \"{}\"", name),
                "each joint has a name of its own; the movements of a joint \"a\" with several are "
                "\"a.1\", \"a.2\" ...");
      }
    }
  }

  void check_tree() {
    constexpr std::size_t nobody = static_cast<std::size_t>(-1);
    const std::vector<Joint>& joints = robot_.joints;
    const std::size_t count = robot_.links.size();
    std::vector<std::size_t> carrier(count, nobody);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      std::size_t& of = carrier[joints[i].child];
      if (of == nobody) {
        of = i;
        continue;
      }
      problem(joints_[i],
              fmt::format("it carries link \"{}\", which joint \"{}\" carries already",
                          robot_.links[joints[i].child].name, joints[of].name),
              "one joint carries each link; a loop is closed in the case, by a joint with closes = "
              "true");
    }
    raise();
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < count; ++i)
      if (carrier[i] == nobody) roots.push_back(i);
    if (roots.size() > 1)
      problem(links_[roots[1]],
              fmt::format("no joint carries it, nor link \"{}\": a robot has one root",
                          robot_.links[roots[0]].name),
              "connect them by a joint, for example of type = \"fixed\"");
    raise();
    // Whoever walks towards the root for longer than there are links walks in a ring.
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t at = i;
      for (std::size_t steps = 0; carrier[at] != nobody; at = joints[carrier[at]].parent) {
        if (++steps <= count) continue;
        problem(joints_[carrier[i]],
                fmt::format("link \"{}\" is carried by what it carries itself, in a ring",
                            robot_.links[i].name),
                "links form a tree; a loop is closed in the case, by a joint with closes = true");
        raise();
      }
    }
    robot_.root = roots.front();
    for (std::size_t i = 0; i < count; ++i) {
      const std::string& name = robot_.links[i].name;
      if ((name == "world" || name == "ground") && !robot_.is_ground(i))
        problem(links_[i], "a case calls the fixed world so, which this link is not",
                "give the link another name; the world is a root without <inertial>");
    }
  }

  const std::string& text_;
  Robot robot_;
  std::vector<RobotElement> links_, joints_;
  std::vector<Problem> problems_;
};

}  // namespace

const char* to_text(JointType type) {
  switch (type) {
    case JointType::fixed: return "fixed";
    case JointType::revolute: return "revolute";
    case JointType::continuous: return "continuous";
    case JointType::prismatic: return "prismatic";
    case JointType::planar: return "planar";
    case JointType::floating: return "floating";
  }
  return "";
}

std::vector<Coordinate> coordinates_of(const Joint& joint) {
  const std::string& name = joint.name;
  switch (joint.type) {
    case JointType::fixed: return {};
    case JointType::revolute:
    case JointType::continuous: return {{name, true}};
    case JointType::prismatic: return {{name, false}};
    case JointType::planar:
      return {{name + ".1", false}, {name + ".2", false}, {name + ".3", true}};
    case JointType::floating:
      return {{name + ".1", false}, {name + ".2", false}, {name + ".3", false},
              {name + ".4", true},  {name + ".5", true},  {name + ".6", true}};
  }
  return {};
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Robot parse_robot(const std::string& file, const std::string& text) {
  return RobotReader(file, text).read();
}

Robot read_robot(const std::string& path) {
  const FileText file = read_text_file(path);
  if (file.trouble != FileText::Trouble::none)
    throw InputError(std::vector<Problem>{{path, 0, 0, {}, file.why, "name a URDF file"}});
  return parse_robot(path, file.text);
}

}  // namespace boxbeam::urdf
