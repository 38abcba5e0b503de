#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "robot_file.hpp"
#include "text_file.hpp"

namespace boxbeam::robots {
namespace {

using Attributes = std::map<std::string, std::string>;

/// An element with its attributes, those of its class where it does not say them.
struct MjcfElement {
  RobotElement of;
  Attributes attributes;

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

struct MjcfSite {
  std::size_t link;
  Pose pose;  ///< in the link's frame
};

/// Mass of a shape about its own centre, in its own axes.
struct ShapeMass {
  double volume = 0.0;                                 ///< [m^3]
  Eigen::Vector3d per_mass = Eigen::Vector3d::Zero();  ///< principal moments [m^2]
};

/// Shapes of MJCF by their sizes: radius, half lengths along z or x, y, z [m]. Source: moments of
/// inertia of solids, e.g. Meriam and Kraige, Dynamics, table D/4; of the capsule the sum of its
/// cylinder and of two hemispheres, each 83/320 m r^2 across its axis about its centre, which lies
/// 3/8 r from its flat side.
std::optional<ShapeMass> shape_mass(const std::string& type, const Eigen::Vector3d& size) {
  constexpr double pi = std::numbers::pi;
  const double x2 = size.x() * size.x(), y2 = size.y() * size.y(), z2 = size.z() * size.z();
  if (type == "sphere")
    return ShapeMass{4.0 / 3.0 * pi * size.x() * x2, Eigen::Vector3d::Constant(0.4 * x2)};
  if (type == "ellipsoid")
    return ShapeMass{4.0 / 3.0 * pi * size.prod(),
                     0.2 * Eigen::Vector3d(y2 + z2, x2 + z2, x2 + y2)};
  if (type == "box")
    return ShapeMass{8.0 * size.prod(), Eigen::Vector3d(y2 + z2, x2 + z2, x2 + y2) / 3.0};
  const double r = size.x(), h = size.y();
  if (type == "cylinder") {
    const double across = x2 / 4.0 + y2 / 3.0;
    return ShapeMass{2.0 * pi * x2 * h, {across, across, 0.5 * x2}};
  }
  if (type == "capsule") {
    const double tube = 2.0 * pi * x2 * h, balls = 4.0 / 3.0 * pi * r * x2;
    const double share = tube / (tube + balls);
    const double across =
        share * (x2 / 4.0 + y2 / 3.0) + (1.0 - share) * (0.4 * x2 + y2 + 0.75 * h * r);
    const double along = share * 0.5 * x2 + (1.0 - share) * 0.4 * x2;
    return ShapeMass{tube + balls, {across, across, along}};
  }
  return {};
}

/// How many sizes a shape has where it is no plane, mesh or field; else 0.
std::size_t sizes_of(const std::string& type, bool from_to) {
  if (type == "sphere") return 1;
  if (type == "capsule" || type == "cylinder") return from_to ? 1 : 2;
  if (type == "box" || type == "ellipsoid") return from_to ? 1 : 3;
  return 0;
}

/// One body of several that move alike.
Inertial joined(const std::vector<Inertial>& parts) {
  Inertial whole;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Inertial& part : parts) {
    whole.mass += part.mass;
    moment += part.mass * part.centre;
  }
  if (whole.mass > 0.0) whole.centre = moment / whole.mass;
  for (const Inertial& part : parts) {
    const Eigen::Vector3d d = part.centre - whole.centre;
    whole.inertia += part.inertia + part.mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() -
                                                 d * d.transpose());
  }
  return whole;
}

std::vector<Turn> turns_of(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn{Eigen::Quaterniond(R)};
  if (turn.angle() == 0.0) return {};
  return {{turn.axis(), turn.angle()}};
}

constexpr const char* orientations[]{"quat", "axisangle", "xyaxes", "zaxis", "euler"};

class MjcfReader {
 public:
  MjcfReader(const std::string& file, const std::string& text)
      : file_(file, text, "an MJCF", "<mujoco> <worldbody> ... </worldbody> </mujoco>") {
    robot_.file = file;
    robot_.format = "MJCF";
  }

  Robot read() {
    const XmlElement model = file_.outermost("mujoco");
    if (const std::string* const name = model.attribute("model")) robot_.name = *name;
    if (robot_.name.empty()) robot_.name = "robot";
    if (!is_plain(robot_.name))
      file_.problem_of_file("the name of the model has control characters", "");
    refuse_what_makes_elements(model);
    file_.raise();
    classes_["main"];
    for (const XmlElement& child : model.children) {
      if (child.tag == "compiler") read_compiler(child);
      if (child.tag == "option") read_option(child);
      if (child.tag == "default") read_class(child, "main", true);
    }
    file_.raise();
    for (const XmlElement& child : model.children)
      if (child.tag == "worldbody") collect_names(child);
    robot_.links.push_back({"world"});
    bodies_.push_back({&model, "the world"});
    for (const XmlElement& child : model.children) {
      if (child.tag != "worldbody") continue;
      std::vector<MjcfChild> inside;
      flatten(child, {}, class_in(child, "main"), inside);
      read_inside(inside, 0);
    }
    if (robot_.links.size() == 1 && file_.problems() == 0)
      file_.problem_of_file("the model has no <body>", "bodies stand in <worldbody>");
    file_.raise();
    for (std::size_t i = 1; i < robot_.links.size(); ++i) {
      const std::string& name = robot_.links[i].name;
      if (name == "world" || name == "ground")
        file_.problem(bodies_[i], "a case calls the fixed world so, which this body is not",
                      "give the body another name");
    }
    file_.check_names(robot_, bodies_, joints_);
    file_.raise();
    for (const XmlElement& child : model.children) read_section(child);
    file_.raise();
    file_.check_mimics(robot_, joints_);
    file_.raise();
    return std::move(robot_);
  }

 private:
  enum class MassFrom { elements, shapes, what_is_there };

  // ------------------------------------------------------------------------------ texts and
  // numbers

  static std::string called(const XmlElement& element) {
    const std::string* const name = element.attribute("name");
    return name == nullptr || name->empty() ? fmt::format("<{}>", element.tag)
                                            : fmt::format("{} \"{}\"", element.tag, *name);
  }

  std::optional<std::vector<double>> numbers(const MjcfElement& in, const char* name,
                                             std::size_t least, std::size_t most) {
    const std::string* const text = in.attribute(name);
    if (text == nullptr) return {};
    return file_.numbers(in.of, in.of.element->tag, name, *text, least, most);
  }
  double number(const MjcfElement& in, const char* name, double otherwise) {
    const auto found = numbers(in, name, 1, 1);
    return found ? found->front() : otherwise;
  }
  Eigen::Vector3d triple(const MjcfElement& in, const char* name,
                         const Eigen::Vector3d& otherwise = Eigen::Vector3d::Zero()) {
    const auto found = numbers(in, name, 3, 3);
    return found ? Eigen::Vector3d((*found)[0], (*found)[1], (*found)[2]) : otherwise;
  }
  /// Notes a word that is none of these; then the first.
  std::size_t choice(const MjcfElement& in, const char* name, const std::string& otherwise,
                     const std::vector<std::string>& words) {
    const std::string word = in.text(name, otherwise);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    file_.problem(in.of, fmt::format("{} = \"{}\" is no word for it", name, word),
                  fmt::format("{}", fmt::join(words, ", ")));
    return 0;
  }

  /// What is left out of the model is said in the case.
  void leave_out(const std::string& what) { ++robot_.left_out[what]; }

  // -------------------------------------------------------------------------- settings and classes

  void refuse_what_makes_elements(const XmlElement& element) {
    for (const XmlElement& child : element.children) {
      for (const char* tag : {"include", "replicate", "attach", "composite", "flexcomp"}) {
        if (child.tag != tag) continue;
        file_.problem({&child, called(child)}, "what it stands for is not read",
                      "load the model into MuJoCo and save it by mj_saveLastXML, which writes the "
                      "elements themselves");
      }
      if (child.tag != "asset" && child.tag != "extension") refuse_what_makes_elements(child);
    }
  }

  void read_compiler(const XmlElement& element) {
    const MjcfElement in{{&element, "<compiler>"}, element.attributes};
    if (in.attribute("angle")) degrees_ = choice(in, "angle", "degree", {"degree", "radian"}) == 0;
    if (in.attribute("coordinate")) choice(in, "coordinate", "local", {"local"});
    if (in.attribute("autolimits"))
      autolimits_ = choice(in, "autolimits", "true", {"false", "true"}) == 1;
    if (in.attribute("inertiafromgeom"))
      mass_from_ =
          static_cast<MassFrom>(choice(in, "inertiafromgeom", "auto", {"false", "true", "auto"}));
    least_mass_ = number(in, "boundmass", least_mass_);
    least_moment_ = number(in, "boundinertia", least_moment_);
    if (number(in, "settotalmass", -1.0) > 0.0 || in.text("balanceinertia", "false") == "true")
      file_.problem(in.of, "settotalmass and balanceinertia change masses, which is not computed",
                    "write the masses as they are to be");
    if (const auto range = numbers(in, "inertiagrouprange", 2, 2)) {
      first_group_ = (*range)[0];
      last_group_ = (*range)[1];
    }
    if (!in.attribute("eulerseq")) return;
    euler_ = in.text("eulerseq");
    if (euler_.size() != 3 || euler_.find_first_not_of("xyzXYZ") != std::string::npos) {
      file_.problem(in.of, fmt::format("eulerseq = \"{}\" is no sequence of three axes", euler_),
                    "write for example \"xyz\"; capitals are axes that do not turn");
      euler_ = "xyz";
    }
  }

  void read_option(const XmlElement& element) {
    const MjcfElement in{{&element, "<option>"}, element.attributes};
    robot_.gravity = triple(in, "gravity", robot_.gravity);
    for (const char* fluid : {"density", "viscosity"})
      if (number(in, fluid, 0.0) != 0.0) leave_out(fmt::format("option {}", fluid));
    for (const XmlElement& child : element.children) {
      if (child.tag != "flag") continue;
      const auto off = [&](const char* what) {
        const std::string* const word = child.attribute(what);
        return word != nullptr && *word == "disable";
      };
      if (off("gravity")) no_gravity_ = true;
      if (off("equality")) no_equality_ = true;
    }
    if (no_gravity_) robot_.gravity.setZero();
  }

  void read_class(const XmlElement& element, const std::string& parent, bool outermost) {
    const std::string* const given = element.attribute("class");
    if (given == nullptr && !outermost) {
      file_.problem({&element, "<default>"}, "it has no class", "write <default class=\"...\">");
      return;
    }
    const std::string name = outermost ? "main" : *given;
    if (!outermost) {
      if (classes_.count(name) > 0) {
        file_.problem({&element, called(element)},
                      fmt::format("another class is called \"{}\"", name),
                      "each class has a name of its own");
        return;
      }
      classes_[name] = classes_[parent];
    }
    for (const XmlElement& child : element.children) {
      if (child.tag == "default") continue;
      merge(child.attributes, classes_[name][child.tag]);
    }
    if (outermost && given != nullptr && *given != name) classes_[*given] = classes_[name];
    for (const XmlElement& child : element.children)
      if (child.tag == "default") read_class(child, name, false);
  }

  /// Attributes over others. Who says how something is turned, or from where to where it goes,
  /// takes what others say of that away.
  static void merge(const Attributes& over, Attributes& under) {
    const auto says = [&](const char* name) { return over.count(name) > 0; };
    if (std::any_of(std::begin(orientations), std::end(orientations), says))
      for (const char* name : orientations) under.erase(name);
    for (const auto& [name, value] : over) under[name] = value;
  }

  MjcfElement with_class(const XmlElement& element, const std::string& childclass) {
    MjcfElement with{{&element, called(element)}, {}};
    const std::string* const given = element.attribute("class");
    const auto found = classes_.find(given == nullptr ? childclass : *given);
    if (found == classes_.end())
      file_.problem(with.of, fmt::format("there is no class \"{}\"", *given),
                    "write it in <default>, or leave it out");
    else if (const auto of_tag = found->second.find(element.tag); of_tag != found->second.end())
      with.attributes = of_tag->second;
    merge(element.attributes, with.attributes);
    return with;
  }

  /// The class of what stands in a body or frame.
  std::string class_in(const XmlElement& element, const std::string& before) {
    const std::string* const given = element.attribute("childclass");
    if (given == nullptr) return before;
    if (classes_.count(*given) > 0) return *given;
    file_.problem({&element, called(element)}, fmt::format("there is no class \"{}\"", *given),
                  "write it in <default>, or leave it out");
    return before;
  }

  // ---------------------------------------------------------------------------------------- frames

  double angle(double given) const { return degrees_ ? given * std::numbers::pi / 180.0 : given; }

  Eigen::Matrix3d rotation_in(const MjcfElement& in) {
    using Eigen::Quaterniond;
    using Eigen::Vector3d;
    int said = 0;
    Quaterniond q = Quaterniond::Identity();
    const auto is_none = [&](double length, const char* name) {
      ++said;
      if (length > 1e-9) return false;
      file_.problem(in.of, fmt::format("{} says no direction", name), "its numbers are all zero");
      return true;
    };
    if (const auto of = numbers(in, "quat", 4, 4)) {
      const Quaterniond given((*of)[0], (*of)[1], (*of)[2], (*of)[3]);
      if (!is_none(given.norm(), "quat")) q = given.normalized();
      said = 0;  // the others replace it
    }
    if (const auto of = numbers(in, "axisangle", 4, 4)) {
      const Vector3d axis((*of)[0], (*of)[1], (*of)[2]);
      if (!is_none(axis.norm(), "axisangle"))
        q = Eigen::AngleAxisd(angle((*of)[3]), axis.normalized());
    }
    if (const auto of = numbers(in, "euler", 3, 3)) {
      ++said;
      q = Quaterniond::Identity();
      for (std::size_t k = 0; k < 3; ++k) {
        const bool with_body = euler_[k] >= 'x';
        const Eigen::AngleAxisd turn(angle((*of)[k]),
                                     Vector3d::Unit(euler_[k] - (with_body ? 'x' : 'X')));
        q = with_body ? q * turn : Quaterniond(turn * q);
      }
    }
    if (const auto of = numbers(in, "zaxis", 3, 3)) {
      const Vector3d z((*of)[0], (*of)[1], (*of)[2]);
      if (!is_none(z.norm(), "zaxis")) q = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), z);
    }
    if (const auto of = numbers(in, "xyaxes", 6, 6)) {
      const Vector3d x = Vector3d((*of)[0], (*of)[1], (*of)[2]).stableNormalized();
      const Vector3d y((*of)[3], (*of)[4], (*of)[5]);
      const Vector3d square = y - y.dot(x) * x;
      if (!is_none(std::min(x.norm(), square.norm()), "xyaxes")) {
        Eigen::Matrix3d R;
        R.col(0) = x;
        R.col(1) = square.normalized();
        R.col(2) = R.col(0).cross(R.col(1));
        q = R;
      }
    }
    if (said > 1)
      file_.problem(in.of, "it says more than once how it is turned",
                    "leave one of axisangle, euler, zaxis and xyaxes");
    return q.toRotationMatrix();
  }

  Pose pose_in(const MjcfElement& in) { return {rotation_in(in), triple(in, "pos")}; }

  // ---------------------------------------------------------------------------------------- bodies

  /// Names that bodies and joints are given, so that those without get others.
  void collect_names(const XmlElement& element) {
    for (const XmlElement& child : element.children) {
      const bool joint = child.tag == "joint" || child.tag == "freejoint";
      if (!joint && child.tag != "body" && child.tag != "frame") continue;
      if (const std::string* const name = child.attribute("name")) {
        if (!is_plain(*name))
          file_.problem({&child, fmt::format("<{}>", child.tag)}, "its name has control characters",
                        "");
        if (child.tag != "frame") (joint ? joint_names_ : body_names_).insert(*name);
      }
      collect_names(child);
    }
  }

  static std::string free_name(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = wanted;
    for (int k = 2; !taken.insert(name).second; ++k) name = fmt::format("{}-{}", wanted, k);
    return name;
  }

  /// The name that an element has, or one that is free.
  static std::string name_of(const XmlElement& element, const std::string& otherwise,
                             std::set<std::string>& taken) {
    const std::string* const given = element.attribute("name");
    return given != nullptr && !given->empty() ? *given : free_name(otherwise, taken);
  }

  /// What stands in a body and in its frames.
  void flatten(const XmlElement& element, const Pose& frame, const std::string& childclass,
               std::vector<MjcfChild>& inside) {
    for (const XmlElement& child : element.children) {
      if (child.tag != "frame") {
        inside.push_back({&child, frame, childclass});
        continue;
      }
      const MjcfElement in{{&child, called(child)}, child.attributes};
      flatten(child, frame * pose_in(in), class_in(child, childclass), inside);
    }
  }

  /// Sites and bodies on a link.
  void read_inside(const std::vector<MjcfChild>& inside, std::size_t link) {
    for (const MjcfChild& child : inside) {
      const std::string& tag = child.element->tag;
      if (tag == "body") {
        read_body(child, link);
      } else if (tag == "site") {
        const MjcfElement in = with_class(*child.element, child.childclass);
        if (const std::string* const name = in.attribute("name"))
          sites_[*name] = {link, child.frame * pose_in(in)};
      } else if (tag != "geom" && tag != "joint" && tag != "freejoint" && tag != "inertial") {
        leave_out(tag);
      }
    }
  }

  void read_body(const MjcfChild& child, std::size_t parent) {
    const XmlElement& element = *child.element;
    const MjcfElement in{{&element, called(element)}, element.attributes};
    const std::string name =
        name_of(element, fmt::format("body-{}", robot_.links.size()), body_names_);
    if (number(in, "gravcomp", 0.0) != 0.0) leave_out("body gravcomp");
    std::vector<MjcfChild> inside;
    flatten(element, {}, class_in(element, child.childclass), inside);
    const std::size_t link = carry(in.of, name, parent, child.frame * pose_in(in), inside);
    robot_.links[link].inertial = mass_of(in.of, inside);
    read_inside(inside, link);
  }

  std::size_t add_link(const RobotElement& of, const std::string& name) {
    robot_.links.push_back({name});
    bodies_.push_back(of);
    return robot_.links.size() - 1;
  }

  /// Adds a body's link and the joints that carry it, between several joints links without mass; in
  /// the posture of reference all of them stand as the body does. Returns the link's index.
  std::size_t carry(const RobotElement& of, const std::string& name, std::size_t parent, Pose pose,
                    const std::vector<MjcfChild>& inside) {
    std::vector<const MjcfChild*> joints;
    for (const MjcfChild& child : inside)
      if (child.element->tag == "joint" || child.element->tag == "freejoint")
        joints.push_back(&child);
    if (joints.empty()) {
      const std::size_t link = add_link(of, name);
      Joint joint{free_name(name, joint_names_), JointType::fixed, parent, link, pose.p};
      joint.turns = turns_of(pose.R);
      robot_.joints.push_back(std::move(joint));
      joints_.push_back(of);
      return link;
    }
    for (const MjcfChild* const child : joints) {
      const bool last = child == joints.back();
      const std::string joint_name = name_of(*child->element, name, joint_names_);
      const std::size_t link = add_link(
          of, last ? name : free_name(fmt::format("{}-{}", name, joint_name), body_names_));
      Joint joint = read_joint(*child, joint_name, pose);
      joint.parent = parent;
      joint.child = link;
      if (joint.type == JointType::floating && (joints.size() > 1 || parent != 0))
        file_.problem(joints_.back(), "a free joint moves a body of the world, and is its only one",
                      "put the body into <worldbody>, with this joint alone");
      robot_.joints.push_back(std::move(joint));
      parent = link;
      pose = {};
    }
    return parent;
  }

  /// A joint whose carried frame stands as `pose` in the carrying link's at its reference.
  Joint read_joint(const MjcfChild& child, const std::string& name, const Pose& pose) {
    const MjcfElement in =
        child.element->tag == "joint"
            ? with_class(*child.element, child.childclass)
            : MjcfElement{{child.element, called(*child.element)}, {{"type", "free"}}};
    joints_.push_back({child.element, fmt::format("joint \"{}\"", name)});
    Joint joint{name};
    constexpr JointType types[]{JointType::revolute, JointType::prismatic, JointType::spherical,
                                JointType::floating};
    joint.type = types[choice(in, "type", "hinge", {"hinge", "slide", "ball", "free"})];
    const bool turns = joint.type == JointType::revolute;
    const bool one = turns || joint.type == JointType::prismatic;
    if (joint.type != JointType::floating)
      joint.point = child.frame.p + child.frame.R * triple(in, "pos");
    joint.axis = child.frame.R * triple(in, "axis", Eigen::Vector3d::UnitZ());
    if (!(joint.axis.norm() > 1e-9)) {
      file_.problem(joints_.back(), "its axis is no direction", "write axis=\"0 0 1\"");
      joint.axis = Eigen::Vector3d::UnitZ();
    }
    joint.xyz = pose.p + pose.R * joint.point;
    joint.turns = turns_of(pose.R);
    const auto coordinate = [&](double given) { return turns ? angle(given) : given; };
    if (one) joint.reference = coordinate(number(in, "ref", 0.0));
    if (turns && joint.reference != 0.0) joint.turns.push_back({joint.axis, -joint.reference});
    if (joint.type == JointType::prismatic)
      joint.xyz -= pose.R * joint.axis.normalized() * joint.reference;
    read_range(in, joint, coordinate);
    read_passive(in, joint, one, coordinate);
    return joint;
  }

  void read_range(const MjcfElement& in, Joint& joint, const auto& coordinate) {
    const auto range = numbers(in, "range", 2, 2);
    const std::size_t limited =
        in.attribute("limited") ? choice(in, "limited", "auto", {"false", "true", "auto"}) : 2;
    if (!range || limited == 0 || (limited == 2 && !autolimits_)) return;
    if (joint.type == JointType::spherical) {
      leave_out("range of ball joints");
      return;
    }
    joint.limit.lower = coordinate((*range)[0]);
    joint.limit.upper = coordinate((*range)[1]);
    if ((*range)[0] > (*range)[1])
      file_.problem(
          joints_.back(),
          fmt::format("its lower limit {} is above its upper one {}", (*range)[0], (*range)[1]),
          "write the smaller one first");
  }

  void read_passive(const MjcfElement& in, Joint& joint, bool one, const auto& coordinate) {
    // Polynomials of the coordinate or rate: the first number is the straight line.
    const auto law = [&](const char* name) -> std::optional<double> {
      const auto of = numbers(in, name, 1, 5);
      if (!of) return {};
      if (std::any_of(of->begin() + 1, of->end(), [](double more) { return more != 0.0; })) {
        leave_out(fmt::format("{} that is no straight line", name));
        return {};
      }
      return of->front() != 0.0 ? std::optional(of->front()) : std::nullopt;
    };
    const auto not_zero = [&](const char* name) -> std::optional<double> {
      const double value = number(in, name, 0.0);
      return value != 0.0 ? std::optional(value) : std::nullopt;
    };
    Passive passive;
    passive.damping = law("damping");
    passive.stiffness = law("stiffness");
    passive.free = coordinate(number(in, "springref", 0.0));
    passive.friction = not_zero("frictionloss");
    passive.armature = not_zero("armature");
    for (const auto& [name, value] :
         {std::pair{"damping", passive.damping}, std::pair{"stiffness", passive.stiffness},
          std::pair{"frictionloss", passive.friction}, std::pair{"armature", passive.armature}}) {
      if (!value) continue;
      if (*value < 0.0)
        file_.problem(joints_.back(), fmt::format("its {} is below zero", name), "");
      if (!one) leave_out(fmt::format("{} of ball and free joints", name));
    }
    if (one) joint.passive = passive;
  }

  // ---------------------------------------------------------------------------------------- masses

  std::optional<Inertial> mass_of(const RobotElement& of, const std::vector<MjcfChild>& inside) {
    const MjcfChild* given = nullptr;
    for (const MjcfChild& child : inside) {
      if (child.element->tag != "inertial") continue;
      if (given != nullptr) file_.problem(of, "<inertial> stands there twice", "leave one of them");
      given = &child;
    }
    const bool from_shapes =
        mass_from_ == MassFrom::shapes || (mass_from_ == MassFrom::what_is_there && !given);
    if (!from_shapes && given == nullptr) return {};
    Inertial inertial;
    if (from_shapes) {
      std::vector<Inertial> parts;
      for (const MjcfChild& child : inside)
        if (child.element->tag == "geom")
          if (const auto part = shape_of(child)) parts.push_back(*part);
      inertial = joined(parts);
    } else {
      inertial = read_inertial(*given);
    }
    if (!(inertial.mass > 0.0) && least_mass_ == 0.0) return {};
    inertial.mass = std::max(inertial.mass, least_mass_);
    if (least_moment_ > 0.0) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertial.inertia);
      const Eigen::Vector3d moments = principal.eigenvalues().cwiseMax(least_moment_);
      inertial.inertia =
          principal.eigenvectors() * moments.asDiagonal() * principal.eigenvectors().transpose();
    }
    inertial.inertia = 0.5 * (inertial.inertia + inertial.inertia.transpose()).eval();
    return inertial;
  }

  Inertial read_inertial(const MjcfChild& child) {
    const MjcfElement in{{child.element, called(*child.element)}, child.element->attributes};
    Inertial inertial;
    if (!in.attribute("mass")) file_.problem(in.of, "it has no mass", "write mass=\"...\", in kg");
    inertial.mass = number(in, "mass", 0.0);
    if (inertial.mass < 0.0)
      file_.problem(in.of, fmt::format("its mass is {} kg", inertial.mass),
                    "no mass is below zero");
    const Pose pose = child.frame * pose_in(in);
    inertial.centre = pose.p;
    Eigen::Matrix3d I = triple(in, "diaginertia").asDiagonal();
    if (const auto full = numbers(in, "fullinertia", 6, 6)) {
      const std::vector<double>& m = *full;
      if (in.attribute("diaginertia"))
        file_.problem(in.of, "it has diaginertia and fullinertia", "leave one of them");
      I << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
    }
    inertial.inertia = pose.R * I * pose.R.transpose();
    return inertial;
  }

  /// The mass of a shape in the body's frame, or nothing where it has none.
  std::optional<Inertial> shape_of(const MjcfChild& child) {
    const MjcfElement in = with_class(*child.element, child.childclass);
    const double group = number(in, "group", 0.0);
    if (group < first_group_ || group > last_group_) return {};
    const bool has_mass = in.attribute("mass") != nullptr;
    const double mass = number(in, "mass", 0.0), density = number(in, "density", 1000.0);
    if (mass < 0.0 || density < 0.0)
      file_.problem(in.of, "its mass is below zero", "no mass is below zero");
    if (has_mass ? mass == 0.0 : density == 0.0) return {};
    const std::string type = in.text("type", in.attribute("mesh") ? "mesh" : "sphere");
    if (type == "plane" || type == "hfield") return {};
    const auto ends = numbers(in, "fromto", 6, 6);
    const std::size_t count = sizes_of(type, ends.has_value());
    if (count == 0 || in.text("shellinertia", "false") == "true") {
      file_.problem(in.of,
                    count == 0
                        ? fmt::format("the mass of a shape of type \"{}\" is not computed", type)
                        : "the mass of a shell is not computed",
                    "write <inertial> in its body, or mass=\"0\" in the shape");
      return {};
    }
    if (ends && type == "sphere") {
      file_.problem(in.of, "a sphere goes from nowhere to anywhere", "leave fromto out");
      return {};
    }
    Eigen::Vector3d size = Eigen::Vector3d::Zero();
    const auto sizes = numbers(in, "size", count, 3);
    if (!sizes) {
      if (!in.attribute("size"))
        file_.problem(in.of, "it has no size", fmt::format("a {} has {}", type, count));
      return {};
    }
    for (std::size_t k = 0; k < sizes->size(); ++k)
      size[static_cast<Eigen::Index>(k)] = (*sizes)[k];
    Pose pose = pose_in(in);
    if (ends) {
      const Eigen::Vector3d from((*ends)[0], (*ends)[1], (*ends)[2]);
      const Eigen::Vector3d along = Eigen::Vector3d((*ends)[3], (*ends)[4], (*ends)[5]) - from;
      if (!(along.norm() > 1e-9)) {
        file_.problem(in.of, "fromto names one place twice", "");
        return {};
      }
      pose.p = from + 0.5 * along;
      pose.R =
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along).toRotationMatrix();
      if (type == "box" || type == "ellipsoid") {
        size.y() = size.x();
        size.z() = 0.5 * along.norm();
      } else {
        size.y() = 0.5 * along.norm();
      }
    }
    const std::size_t used = sizes_of(type, false);
    for (std::size_t k = 0; k < used; ++k)
      if (!(size[static_cast<Eigen::Index>(k)] > 0.0)) {
        file_.problem(in.of, "its sizes are not above zero", "");
        return {};
      }
    const ShapeMass shape = *shape_mass(type, size);
    pose = child.frame * pose;
    Inertial part;
    part.mass = has_mass ? mass : density * shape.volume;
    part.centre = pose.p;
    part.inertia = pose.R * (part.mass * shape.per_mass).asDiagonal() * pose.R.transpose();
    return part;
  }

  // -------------------------------------------------------------------------------- other sections

  void read_section(const XmlElement& section) {
    const auto leave_children_out = [&] {
      for (const XmlElement& child : section.children)
        leave_out(fmt::format("{} {}", section.tag, child.tag));
    };
    if (section.tag == "equality") {
      for (const XmlElement& child : section.children) read_equality(child);
    } else if (section.tag == "actuator") {
      for (const XmlElement& child : section.children)
        for (const char* name : {"joint", "jointinparent"})
          if (const std::string* const joint = child.attribute(name))
            for (Joint& of : robot_.joints)
              if (of.name == *joint) of.actuated = true;
      leave_children_out();
    } else if (section.tag == "tendon" || section.tag == "contact" || section.tag == "sensor" ||
               section.tag == "keyframe" || section.tag == "deformable") {
      leave_children_out();
    } else if (section.tag != "worldbody" && section.tag != "compiler" && section.tag != "option" &&
               section.tag != "default") {
      leave_out(section.tag);
    }
  }

  void read_equality(const XmlElement& element) {
    const MjcfElement in = with_class(element, "main");
    const bool active = in.text("active", "true") != "false" && !no_equality_;
    const bool known = element.tag == "connect" || element.tag == "weld" || element.tag == "joint";
    if (!active || !known) {
      leave_out(fmt::format("equality {}{}", element.tag, active ? "" : " (not active)"));
      return;
    }
    if (element.tag == "joint")
      read_tie(in);
    else
      read_closing(in, element.tag == "weld");
  }

  std::optional<std::size_t> body_named(const MjcfElement& in, const char* name) {
    const std::string body = in.text(name, "world");
    for (std::size_t i = 0; i < robot_.links.size(); ++i)
      if (robot_.links[i].name == body) return i;
    file_.problem(in.of, fmt::format("there is no body \"{}\"", body),
                  "write the name of a body in <worldbody>");
    return {};
  }

  std::optional<MjcfSite> site_named(const MjcfElement& in, const char* name) {
    const std::string site = in.text(name);
    if (const auto found = sites_.find(site); found != sites_.end()) return found->second;
    file_.problem(in.of, fmt::format("there is no site \"{}\"", site),
                  "write the name of a site in a body");
    return {};
  }

  void read_closing(const MjcfElement& in, bool weld) {
    MjcfSite a, b;  // the frames that coincide
    if (in.attribute("site1") || in.attribute("site2")) {
      const auto first = site_named(in, "site1"), second = site_named(in, "site2");
      if (!first || !second) return;
      a = *first;
      b = *second;
    } else {
      if (!in.attribute("body1") || (!weld && !in.attribute("anchor"))) {
        file_.problem(in.of, "it says not what it connects where",
                      weld ? "write body1 and body2" : "write body1, body2 and anchor");
        return;
      }
      const auto first = body_named(in, "body1"), second = body_named(in, "body2");
      if (!first || !second) return;
      const std::vector<Pose> poses = reference_poses(robot_);
      Pose second_in_first = poses[*first].inverse() * poses[*second];
      const auto relative = weld ? numbers(in, "relpose", 7, 7) : std::nullopt;
      if (relative) {
        const std::vector<double>& of = *relative;
        const Eigen::Quaterniond q(of[3], of[4], of[5], of[6]);
        if (q.norm() > 0.0)
          second_in_first = {q.normalized().toRotationMatrix(), {of[0], of[1], of[2]}};
      }
      const Pose anchor{Eigen::Matrix3d::Identity(), triple(in, "anchor")};
      // Of a weld the anchor is a place of the second body, else of the first.
      a = {*first, weld ? second_in_first * anchor : anchor};
      b = {*second, weld ? anchor : second_in_first.inverse() * anchor};
    }
    if (a.link == b.link) {
      file_.problem(in.of, "it connects a body with itself", "name two bodies");
      return;
    }
    if (b.link == 0) std::swap(a, b);
    Closing closing;
    closing.name = name_of(*in.of.element, in.of.element->tag, joint_names_);
    if (in.of.element->attribute("name")) closing.name = free_name(closing.name, joint_names_);
    closing.kind = weld ? Closing::Kind::weld : Closing::Kind::point;
    closing.a = a.link;
    closing.b = b.link;
    closing.p_a = a.pose.p;
    closing.p_b = b.pose.p;
    if (weld) closing.turns = turns_of(a.pose.R * b.pose.R.transpose());
    robot_.closings.push_back(std::move(closing));
  }

  std::optional<std::size_t> tied_joint(const MjcfElement& in, const char* name) {
    const std::string wanted = in.text(name);
    for (std::size_t i = 0; i < robot_.joints.size(); ++i)
      if (robot_.joints[i].name == wanted && coordinates_of(robot_.joints[i]).size() == 1) return i;
    file_.problem(in.of, fmt::format("there is no joint \"{}\" of one movement", wanted),
                  "it ties hinges and slides");
    return {};
  }

  /// y - y0 = a0 + a1 (x - x0), where y0 and x0 are the references of the joints.
  void read_tie(const MjcfElement& in) {
    const auto first = tied_joint(in, "joint1");
    std::vector<double> of = numbers(in, "polycoef", 1, 5).value_or(std::vector{0.0, 1.0});
    of.resize(5, 0.0);
    if (of[2] != 0.0 || of[3] != 0.0 || of[4] != 0.0) {
      file_.problem(in.of, "it ties joints by a curve, which no case holds",
                    "leave the curve out and write the driver of one of them as it follows");
      return;
    }
    if (!first) return;
    Joint& joint = robot_.joints[*first];
    if (!in.attribute("joint2")) {
      joint.reference += of[0];
      joint.limit.lower = joint.limit.upper = joint.reference;
      joint.actuated = true;
      return;
    }
    const auto second = tied_joint(in, "joint2");
    if (!second) return;
    if (joint.mimic) {
      file_.problem(in.of, fmt::format("joint \"{}\" is tied already", joint.name),
                    "tie each joint to one");
      return;
    }
    const double other = robot_.joints[*second].reference;
    joint.mimic = Mimic{*second, of[1], joint.reference + of[0] - of[1] * other};
  }

  RobotFile file_;
  Robot robot_;
  std::vector<RobotElement> bodies_, joints_;  ///< of every link and joint
  std::set<std::string> body_names_, joint_names_;
  std::map<std::string, std::map<std::string, Attributes>> classes_;  ///< by tag
  std::map<std::string, MjcfSite> sites_;
  bool degrees_ = true, autolimits_ = true, no_gravity_ = false, no_equality_ = false;
  std::string euler_ = "xyz";
  MassFrom mass_from_ = MassFrom::what_is_there;
  double least_mass_ = 0.0, least_moment_ = 0.0;
  double first_group_ = 0.0, last_group_ = 5.0;
};

}  // namespace

Robot parse_mjcf(const std::string& file, const std::string& text) {
  return MjcfReader(file, text).read();
}

Robot read_mjcf(const std::string& path) {
  const FileText file = read_text_file(path);
  if (file.trouble != FileText::Trouble::none)
    throw InputError(std::vector<Problem>{{path, 0, 0, {}, file.why, "name an MJCF file"}});
  return parse_mjcf(path, file.text);
}

}  // namespace boxbeam::robots
