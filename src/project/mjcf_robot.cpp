#include <fmt/format.h>

#include <Eigen/Geometry>
#include <set>

#include "mjcf_elements.hpp"
#include "text_file.hpp"

namespace boxbeam::robots {
namespace {

struct MjcfSite {
  std::size_t link;
  Pose pose;  ///< in the link's frame
};

std::vector<Turn> turns_of(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn{Eigen::Quaterniond(R)};
  if (turn.angle() == 0.0) return {};
  return {{turn.axis(), turn.angle()}};
}

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
    elements_.read_settings(model);
    for (const XmlElement& child : model.children)
      if (child.tag == "worldbody") collect_names(child);
    robot_.links.push_back({"world"});
    bodies_.push_back({&model, "the world"});
    for (const XmlElement& child : model.children) {
      if (child.tag != "worldbody") continue;
      std::vector<MjcfChild> inside;
      flatten(child, {}, elements_.class_in(child, "main"), inside);
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
      flatten(child, frame * elements_.pose_in(in), elements_.class_in(child, childclass), inside);
    }
  }

  /// Sites and bodies on a link.
  void read_inside(const std::vector<MjcfChild>& inside, std::size_t link) {
    for (const MjcfChild& child : inside) {
      const std::string& tag = child.element->tag;
      if (tag == "body") {
        read_body(child, link);
      } else if (tag == "site") {
        const MjcfElement in = elements_.with_class(*child.element, child.childclass);
        if (const std::string* const name = in.attribute("name"))
          sites_[*name] = {link, child.frame * elements_.pose_in(in)};
      } else if (tag != "geom" && tag != "joint" && tag != "freejoint" && tag != "inertial") {
        elements_.leave_out(tag);
      }
    }
  }

  void read_body(const MjcfChild& child, std::size_t parent) {
    const XmlElement& element = *child.element;
    const MjcfElement in{{&element, called(element)}, element.attributes};
    const std::string name =
        name_of(element, fmt::format("body-{}", robot_.links.size()), body_names_);
    if (elements_.number(in, "gravcomp", 0.0) != 0.0) elements_.leave_out("body gravcomp");
    std::vector<MjcfChild> inside;
    flatten(element, {}, elements_.class_in(element, child.childclass), inside);
    const std::size_t link =
        carry(in.of, name, parent, child.frame * elements_.pose_in(in), inside);
    robot_.links[link].inertial = mass_of(elements_, in.of, inside);
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
            ? elements_.with_class(*child.element, child.childclass)
            : MjcfElement{{child.element, called(*child.element)}, {{"type", "free"}}};
    joints_.push_back({child.element, fmt::format("joint \"{}\"", name)});
    Joint joint{name};
    constexpr JointType types[]{JointType::revolute, JointType::prismatic, JointType::spherical,
                                JointType::floating};
    joint.type = types[elements_.choice(in, "type", "hinge", {"hinge", "slide", "ball", "free"})];
    const bool turns = joint.type == JointType::revolute;
    const bool one = turns || joint.type == JointType::prismatic;
    if (joint.type != JointType::floating)
      joint.point = child.frame.p + child.frame.R * elements_.triple(in, "pos");
    joint.axis = child.frame.R * elements_.triple(in, "axis", Eigen::Vector3d::UnitZ());
    if (!(joint.axis.norm() > 1e-9)) {
      file_.problem(joints_.back(), "its axis is no direction", "write axis=\"0 0 1\"");
      joint.axis = Eigen::Vector3d::UnitZ();
    }
    joint.xyz = pose.p + pose.R * joint.point;
    joint.turns = turns_of(pose.R);
    const auto coordinate = [&](double given) { return turns ? elements_.angle(given) : given; };
    if (one) joint.reference = coordinate(elements_.number(in, "ref", 0.0));
    if (turns && joint.reference != 0.0) joint.turns.push_back({joint.axis, -joint.reference});
    if (joint.type == JointType::prismatic)
      joint.xyz -= pose.R * joint.axis.normalized() * joint.reference;
    read_limits(elements_, joints_.back(), in, joint);
    read_passive(elements_, joints_.back(), in, joint);
    return joint;
  }

  // -------------------------------------------------------------------------------- other sections

  void read_section(const XmlElement& section) {
    const auto leave_children_out = [&] {
      for (const XmlElement& child : section.children)
        elements_.leave_out(fmt::format("{} {}", section.tag, child.tag));
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
      elements_.leave_out(section.tag);
    }
  }

  void read_equality(const XmlElement& element) {
    const MjcfElement in = elements_.with_class(element, "main");
    const bool active = in.text("active", "true") != "false" && !elements_.settings().no_equality;
    const bool known = element.tag == "connect" || element.tag == "weld" || element.tag == "joint";
    if (!active || !known) {
      elements_.leave_out(fmt::format("equality {}{}", element.tag, active ? "" : " (not active)"));
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
      const auto relative = weld ? elements_.numbers(in, "relpose", 7, 7) : std::nullopt;
      if (relative) {
        const std::vector<double>& of = *relative;
        const Eigen::Quaterniond q(of[3], of[4], of[5], of[6]);
        if (q.norm() > 0.0)
          second_in_first = {q.normalized().toRotationMatrix(), {of[0], of[1], of[2]}};
      }
      const Pose anchor{Eigen::Matrix3d::Identity(), elements_.triple(in, "anchor")};
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
    std::vector<double> of =
        elements_.numbers(in, "polycoef", 1, 5).value_or(std::vector{0.0, 1.0});
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
  MjcfElements elements_{file_, robot_};
  std::vector<RobotElement> bodies_, joints_;  ///< of every link and joint
  std::set<std::string> body_names_, joint_names_;
  std::map<std::string, MjcfSite> sites_;
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
