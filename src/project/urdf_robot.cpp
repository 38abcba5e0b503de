#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "boxbeam/project/quantity_text.hpp"
#include "robot_file.hpp"
#include "text_file.hpp"

namespace boxbeam::robots {
namespace {

class UrdfReader {
 public:
  UrdfReader(const std::string& file, const std::string& text)
      : file_(file, text, "a URDF", "<robot name=\"...\"> ... </robot>") {
    robot_.file = file;
    robot_.format = "URDF";
  }

  Robot read() {
    const XmlElement robot = file_.outermost("robot");
    if (const std::string* const name = robot.attribute("name")) robot_.name = *name;
    if (robot_.name.empty()) robot_.name = "robot";
    if (!is_plain(robot_.name))
      file_.problem_of_file("the name of the robot has control characters", "");
    sort_elements(robot);
    for (const RobotElement& element : links_) read_link(element);
    file_.raise();
    for (const RobotElement& element : joints_) read_joint(element);
    file_.raise();
    find_mimicked();
    file_.check_names(robot_, links_, joints_);
    file_.raise();
    check_tree();
    file_.raise();
    return std::move(robot_);
  }

 private:
  static std::string name_of(const XmlElement& element) {
    const std::string* const name = element.attribute("name");
    return name == nullptr ? "" : *name;
  }

  void sort_elements(const XmlElement& robot) {
    for (const XmlElement& child : robot.children) {
      if (child.tag != "link" && child.tag != "joint") {
        ++robot_.left_out[child.tag];
        continue;
      }
      const std::string name = name_of(child);
      RobotElement element{&child, fmt::format("{} \"{}\"", child.tag, name)};
      if (name.empty() || !is_plain(name))
        file_.problem(element, "it has no name of letters",
                      fmt::format("write <{} name=\"...\">", child.tag));
      (child.tag == "link" ? links_ : joints_).push_back(std::move(element));
    }
    if (links_.empty() && file_.problems() == 0)
      file_.problem_of_file("the robot has no <link>",
                            "links are its bodies, and joints connect them");
  }

  /// The numbers of an attribute; nothing where it is not there, or is wrong and noted.
  std::optional<std::vector<double>> numbers(const RobotElement& of, const XmlElement* element,
                                             const char* name, std::size_t count) {
    if (element == nullptr) return {};
    const std::string* const text = element->attribute(name);
    if (text == nullptr) return {};
    return file_.numbers(of, element->tag, name, *text, count, count);
  }

  std::optional<double> number(const RobotElement& of, const XmlElement* element,
                               const char* name) {
    const auto found = numbers(of, element, name, 1);
    return found ? std::optional(found->front()) : std::nullopt;
  }

  Eigen::Vector3d triple(const RobotElement& of, const XmlElement* element, const char* name,
                         const Eigen::Vector3d& otherwise = Eigen::Vector3d::Zero()) {
    const auto found = numbers(of, element, name, 3);
    return found ? Eigen::Vector3d((*found)[0], (*found)[1], (*found)[2]) : otherwise;
  }

  /// R = Rz(yaw) Ry(pitch) Rx(roll).
  std::vector<Turn> turns_in(const RobotElement& of, const XmlElement* origin) {
    const Eigen::Vector3d rpy = triple(of, origin, "rpy");
    std::vector<Turn> turns;
    for (const int k : {2, 1, 0}) turns.push_back({Eigen::Vector3d::Unit(k), rpy[k]});
    return turns;
  }

  const XmlElement* element_in(const RobotElement& of, const XmlElement& in, const char* tag) {
    return file_.element_in(of, in, tag);
  }

  void read_link(const RobotElement& of) {
    Link link{name_of(*of.element)};
    for (const char* shapes : {"visual", "collision"}) {
      if (const std::size_t count = of.element->count(shapes); count > 0)
        robot_.left_out[shapes] += static_cast<int>(count);
    }
    if (const XmlElement* const inertial = element_in(of, *of.element, "inertial"))
      link.inertial = read_inertial(of, *inertial);
    robot_.links.push_back(std::move(link));
  }

  Inertial read_inertial(const RobotElement& of, const XmlElement& inside) {
    Inertial inertial;
    const XmlElement* const origin = element_in(of, inside, "origin");
    inertial.centre = triple(of, origin, "xyz");
    const Eigen::Matrix3d R = rotation_of(turns_in(of, origin));
    const std::size_t before = file_.problems();
    const auto mass = number(of, element_in(of, inside, "mass"), "value");
    if (!mass && file_.problems() == before)
      file_.problem(of, "<inertial> has no mass", "write <mass value=\"...\"/>, in kg");
    if (mass && *mass < 0.0)
      file_.problem(of, fmt::format("its mass is {} kg", *mass), "no mass is below zero");
    inertial.mass = mass.value_or(0.0);
    if (const XmlElement* const tensor = element_in(of, inside, "inertia")) {
      const auto part = [&](const char* name) { return number(of, tensor, name).value_or(0.0); };
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
    const XmlElement* const end = element_in(of, *of.element, tag);
    const std::string name = end && end->attribute("link") ? *end->attribute("link") : "";
    std::vector<std::string> known;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (robot_.links[i].name == name) return i;
      known.push_back(robot_.links[i].name);
    }
    const std::string near = nearest_word(name, known);
    if (name.empty())
      file_.problem(of, fmt::format("it has no {}", tag),
                    fmt::format("write <{} link=\"...\"/>", tag));
    else
      file_.problem(of, fmt::format("there is no link \"{}\"", name),
                    near.empty() ? fmt::format("write <link name=\"{}\">", name)
                                 : fmt::format("did you mean \"{}\"?", near));
    return 0;
  }

  void read_joint(const RobotElement& of) {
    constexpr std::array types{JointType::fixed,     JointType::revolute, JointType::continuous,
                               JointType::prismatic, JointType::planar,   JointType::floating};
    const XmlElement& tree = *of.element;
    Joint joint{name_of(tree)};
    const std::string* const given = tree.attribute("type");
    const std::string word = given == nullptr ? "" : *given;
    const auto* const type = std::find_if(types.begin(), types.end(),
                                          [&](JointType each) { return word == to_text(each); });
    if (type == types.end())
      file_.problem(of, fmt::format("type = \"{}\" is no type of joint", word),
                    "fixed, revolute, continuous, prismatic, planar or floating");
    else
      joint.type = *type;
    joint.parent = link_named(of, "parent");
    joint.child = link_named(of, "child");
    const XmlElement* const origin = element_in(of, tree, "origin");
    joint.xyz = triple(of, origin, "xyz");
    joint.turns = turns_in(of, origin);
    joint.axis = triple(of, element_in(of, tree, "axis"), "xyz", joint.axis);
    const bool has_axis = joint.type != JointType::fixed && joint.type != JointType::floating;
    if (has_axis && !(joint.axis.norm() > 1e-9))
      file_.problem(of, "its axis is no direction", "write <axis xyz=\"0 0 1\"/>");
    read_limit(of, element_in(of, tree, "limit"), joint.limit);
    if (const XmlElement* const mimic = element_in(of, tree, "mimic")) {
      joint.mimic = Mimic{};
      joint.mimic->multiplier = number(of, mimic, "multiplier").value_or(1.0);
      joint.mimic->offset = number(of, mimic, "offset").value_or(0.0);
    }
    const XmlElement* const dynamics = element_in(of, tree, "dynamics");
    joint.passive.damping = number(of, dynamics, "damping");
    joint.passive.friction = number(of, dynamics, "friction");
    for (const char* other : {"safety_controller", "calibration"})
      if (tree.count(other) > 0) ++robot_.left_out[other];
    robot_.joints.push_back(std::move(joint));
  }

  void read_limit(const RobotElement& of, const XmlElement* tree, Limit& limit) {
    limit.lower = number(of, tree, "lower");
    limit.upper = number(of, tree, "upper");
    limit.effort = number(of, tree, "effort");
    limit.velocity = number(of, tree, "velocity");
    if (limit.lower && limit.upper && *limit.lower > *limit.upper)
      file_.problem(
          of,
          fmt::format("its lower limit {} is above its upper one {}", *limit.lower, *limit.upper),
          "write the smaller one as lower");
  }

  static std::string mimicked_in(const XmlElement& joint) {
    for (const XmlElement& child : joint.children) {
      if (child.tag == "mimic" && child.attribute("joint")) return *child.attribute("joint");
    }
    return "";
  }

  void find_mimicked() {
    std::vector<Joint>& joints = robot_.joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (!joints[i].mimic) continue;
      const std::string name = mimicked_in(*joints_[i].element);
      const auto other = std::find_if(joints.begin(), joints.end(),
                                      [&](const Joint& joint) { return joint.name == name; });
      if (other == joints.end() || coordinates_of(*other).size() != 1 ||
          coordinates_of(joints[i]).size() != 1)
        file_.problem(joints_[i], fmt::format("it cannot mimic \"{}\"", name),
                      "both are joints of one movement: revolute, continuous or prismatic");
      else
        joints[i].mimic->joint = static_cast<std::size_t>(other - joints.begin());
    }
    file_.raise();
    file_.check_mimics(robot_, joints_);
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
      file_.problem(
          joints_[i],
          fmt::format("it carries link \"{}\", which joint \"{}\" carries already",
                      robot_.links[joints[i].child].name, joints[of].name),
          "one joint carries each link; a loop is closed in the case, by a joint with closes = "
          "true");
    }
    file_.raise();
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < count; ++i)
      if (carrier[i] == nobody) roots.push_back(i);
    if (roots.size() > 1)
      file_.problem(links_[roots[1]],
                    fmt::format("no joint carries it, nor link \"{}\": a robot has one root",
                                robot_.links[roots[0]].name),
                    "connect them by a joint, for example of type = \"fixed\"");
    file_.raise();
    // Whoever walks towards the root for longer than there are links walks in a ring.
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t at = i;
      for (std::size_t steps = 0; carrier[at] != nobody; at = joints[carrier[at]].parent) {
        if (++steps <= count) continue;
        file_.problem(
            joints_[carrier[i]],
            fmt::format("link \"{}\" is carried by what it carries itself, in a ring",
                        robot_.links[i].name),
            "links form a tree; a loop is closed in the case, by a joint with closes = true");
        file_.raise();
      }
    }
    robot_.root = roots.front();
    for (std::size_t i = 0; i < count; ++i) {
      const std::string& name = robot_.links[i].name;
      if ((name == "world" || name == "ground") && !robot_.is_ground(i))
        file_.problem(links_[i], "a case calls the fixed world so, which this link is not",
                      "give the link another name; the world is a root without <inertial>");
    }
  }

  RobotFile file_;
  Robot robot_;
  std::vector<RobotElement> links_, joints_;
};

}  // namespace

Robot parse_urdf(const std::string& file, const std::string& text) {
  return UrdfReader(file, text).read();
}

Robot read_urdf(const std::string& path) {
  const FileText file = read_text_file(path);
  if (file.trouble != FileText::Trouble::none)
    throw InputError(std::vector<Problem>{{path, 0, 0, {}, file.why, "name a URDF file"}});
  return parse_urdf(path, file.text);
}

}  // namespace boxbeam::robots
