#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/robot.hpp"
#include "boxbeam/project/toml_text.hpp"
#include "placeholder_beam.hpp"
#include "robot_text.hpp"

namespace boxbeam::robots {
namespace {

/// A name that nothing else has yet.
std::string free_name(std::string name, const std::set<std::string>& taken) {
  while (taken.count(name) > 0) name += "_";
  return name;
}

class CaseOfRobot {
 public:
  CaseOfRobot(const Robot& robot, const std::string& beam)
      : robot_(robot),
        beam_(beam_link_of(robot, beam)),
        placeholder_(placeholder_beam(robot, beam_)),
        left_(left_to_closings(robot)) {
    std::set<std::string> joints;
    for (const Joint& joint : robot.joints) joints.insert(joint.name);
    base_ = free_name("base", joints);
    name_points();
  }

  std::string text() {
    write_head();
    write_bodies();
    write_joints();
    write_drivers();
    write_springs();
    write_beam();
    return std::move(text_);
  }

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  void rule(const std::string& name) {
    put("\n# {} {}\n", std::string(97 - name.size(), '-'), name);
  }

  /// Points are called as the joints there; a reference "body.point" ends at its last dot.
  void name_points() {
    std::set<std::string> taken;
    for (const Joint& joint : robot_.joints) {
      std::string name = joint.name;
      std::replace(name.begin(), name.end(), '.', '_');
      points_.push_back(free_name(name, taken));
      taken.insert(points_.back());
    }
    origin_ = free_name("origin", taken);
    taken.insert(origin_);
    start_ = free_name("beam_start", taken);
    for (const Closing& closing : robot_.closings) {
      std::string name = closing.name;
      std::replace(name.begin(), name.end(), '.', '_');
      closing_points_.push_back(free_name(name, taken));
      taken.insert(closing_points_.back());
    }
  }

  /// The point of the carried link at which a joint has it: its origin, or one called as the joint.
  const std::string& carried_point(std::size_t joint) const {
    return robot_.joints[joint].point.isZero(0.0) ? origin_ : points_[joint];
  }

  void write_head() {
    std::string name;
    for (const char c : robot_.name)
      name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ? c : '-';
    const std::string file = toml_quoted(std::filesystem::path(robot_.file).filename().string());
    put("#:schema ./boxbeam-case.schema.json\n"
        "# A case of boxbeam begun from the robot {} of {}:\n"
        "# its bodies, joints and axes. It runs as it is, and says nothing of the machine yet: "
        "what is\n"
        "# marked PLACEHOLDER is not the robot's. Write, in this order,\n"
        "#\n"
        "#   1. [beam], [sections]   which link is the beam, its axis, segments and "
        "cross-sections\n"
        "#   2. [drivers]            how each joint moves; here all stand still\n"
        "#   3. [forces]             what acts beside weight and inertia, for example at a tool\n"
        "#   4. [material], [strength], [fatigue]   its steel, and what is wanted\n"
        "#\n"
        "# `boxbeam validate` says what is wrong, line by line; `boxbeam init spatial` writes an "
        "example\n"
        "# of every part. Units: m, kg, s, rad.\n",
        toml_quoted(robot_.name), file);
    if (!robot_.left_out.empty()) {
      put("#\n# Not read of the robot:\n");
      for (const auto& [element, count] : robot_.left_out)
        put("#   <{}> ({})\n", toml_key(element), count);
    }
    // Name and title stand beside every verdict.
    put("\n[case]\nname = {}\n", toml_quoted(name.substr(0, 60) + "-with-placeholders"));
    put("title = {}\nkind = \"spatial\"\n",
        toml_quoted(robot_.name + ", with PLACEHOLDERS for section, steel and drivers"));
    put("assumptions = [\n  \"bodies and joints are those of a robot's description ({})\",\n{}"
        "  \"PLACEHOLDER: beam, section, steel and drivers are not those of the machine "
        "yet\",\n]\n",
        robot_.format, robot_.closings.empty() ? "" : "  \"joints that close loops are rigid\",\n");
    const auto part = [&](int k) {
      return quantity(robot_.gravity[k], wanted::acceleration, "m/s^2");
    };
    put("\n[mechanism]\ngravity = [{}, {}, {}]\n", part(0), part(1), part(2));
  }

  void write_bodies() {
    rule("bodies");
    put("# In the axes of the link's frame.\n");
    if (robot_.is_ground(robot_.root))
      put("# The root {} has no mass: it is the ground.\n",
          toml_quoted(robot_.links[robot_.root].name));
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (robot_.is_ground(i)) continue;
      const Link& link = robot_.links[i];
      put("\n");
      if (i == beam_) put("# The beam: its mass comes from its sections.\n");
      put("[bodies.{}]\n", toml_key(link.name));
      if (link.inertial)
        write_mass(*link.inertial, i == beam_);
      else if (i != beam_)
        put("# without mass\n");
      put("\n[bodies.{}.points]\n{} = {}\n", toml_key(link.name), origin_,
          place_text(Eigen::Vector3d::Zero()));
      for (std::size_t k = 0; k < robot_.joints.size(); ++k)
        if (robot_.joints[k].parent == i)
          put("{} = {}\n", toml_key(points_[k]), place_text(robot_.joints[k].xyz));
      for (std::size_t k = 0; k < robot_.joints.size(); ++k)
        if (robot_.joints[k].child == i && carried_point(k) != origin_)
          put("{} = {}\n", toml_key(points_[k]), place_text(robot_.joints[k].point));
      for (std::size_t k = 0; k < robot_.closings.size(); ++k) {
        const Closing& closing = robot_.closings[k];
        if (closing.a == i || closing.b == i)
          put("{} = {}\n", toml_key(closing_points_[k]),
              place_text(closing.a == i ? closing.p_a : closing.p_b));
      }
      if (i == beam_ && begins_elsewhere())
        put("{} = {}\n", start_,
            place_text(placeholder_.joint + placeholder_.start * placeholder_.axis));
    }
  }

  /// Whether the beam begins at another place than its link's origin.
  bool begins_elsewhere() const {
    return placeholder_.start < 0.0 || !placeholder_.joint.isZero(0.0);
  }

  void write_mass(const Inertial& of, bool is_beam) {
    const InertiaDoubt doubt = doubt_of(of);
    const char* const out = is_beam ? "# the robot's: " : "";
    put("{}mass = {}\n", out, quantity(of.mass, wanted::mass, "kg"));
    put("{}centre = {}\n", out, place_text(of.centre));
    if (!doubt.words.empty())
      put("# WARNING: {}{}\n", doubt.words, doubt.refused && !is_beam ? "; left out" : "");
    put("{}inertia = {}\n", doubt.refused && !is_beam ? "# " : out, inertia_text(of.inertia));
  }

  void write_joints() {
    rule("joints");
    put("# Axes are those of the carried link. Limits of a robot are not looked at.\n");
    if (!robot_.is_ground(robot_.root)) {
      put("\n[joints.{}]\nkind = \"fixed\"\nconnect = [\"ground\", {}]\n", toml_key(base_),
          toml_quoted(robot_.links[robot_.root].name + "." + origin_));
    }
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) write_joint(k);
    for (std::size_t k = 0; k < robot_.closings.size(); ++k) write_closing(k);
  }

  void write_closing(std::size_t index) {
    const Closing& closing = robot_.closings[index];
    const bool on_ground = robot_.is_ground(closing.a);
    const auto end = [&](std::size_t link) {
      return toml_quoted(robot_.links[link].name + "." + closing_points_[index]);
    };
    put("\n[joints.{}]\nkind = \"{}\"\ncloses = true\nconnect = [{}, {}]\n", toml_key(closing.name),
        closing.kind == Closing::Kind::weld ? "fixed" : "spherical",
        on_ground ? "\"ground\"" : end(closing.a), end(closing.b));
    if (on_ground) put("at = {}\n", place_text(closing.p_a));
    if (closing.kind == Closing::Kind::weld) text_ += turn_text(closing.turns);
  }

  void write_joint(std::size_t index) {
    const Joint& joint = robot_.joints[index];
    put("\n[joints.{}]\n", toml_key(joint.name));
    const std::string to = toml_quoted(robot_.links[joint.child].name + "." + carried_point(index));
    const bool on_ground = robot_.is_ground(joint.parent);
    const std::string from =
        on_ground ? "\"ground\""
                  : toml_quoted(robot_.links[joint.parent].name + "." + points_[index]);
    const auto kind = [&](const char* word) {
      put("kind = \"{}\"\nconnect = [{}, {}]\n", word, from, to);
      if (on_ground) put("at = {}\n", place_text(joint.xyz));
      text_ += turn_text(joint.turns);
    };
    switch (joint.type) {
      case JointType::fixed: kind("fixed"); return;
      case JointType::revolute: kind("revolute"); break;
      case JointType::continuous:
        put("# continuous: turns without end\n");
        kind("revolute");
        break;
      case JointType::prismatic: kind("prismatic"); break;
      case JointType::planar:
        put("# planar: {0}.1 and {0}.2 shift square to the axis, {0}.3 turns about it\n",
            toml_key(joint.name));
        kind("planar");
        break;
      case JointType::spherical:
        put("# {0}.1 to {0}.3 turn about z, y and x, one after the other\n", toml_key(joint.name));
        kind("spherical");
        return;
      case JointType::floating:
        put("# floating: nothing of the robot holds it; {0}.1 to {0}.3 shift, {0}.4 to {0}.6 "
            "turn\n",
            toml_key(joint.name));
        kind("free");
        return;
    }
    put("axis = {}\n", direction_text(joint.axis));
    if (left_[index].size() == 1 && left_[index][0])
      put("start = {}\n", coordinate_text(joint, held_at(joint)));
    if (joint.type == JointType::prismatic && joint.passive.damping.value_or(0.0) > 0.0)
      put("friction = {{ viscous = {} }}\n",
          quantity(*joint.passive.damping, wanted::damping, "N s/m"));
  }

  /// A value of the one coordinate of a joint.
  static std::string coordinate_text(const Joint& joint, double value) {
    return joint.type == JointType::prismatic ? quantity(value, wanted::length, "m")
                                              : quantity(value, wanted::angle, "rad");
  }

  /// The coordinate at which a joint is held: its reference, or what is next to it within its
  /// limits; of one that mimics, what follows from the other's.
  double held_at(const Joint& joint) const {
    if (joint.mimic)
      return joint.mimic->multiplier * held_at(robot_.joints[joint.mimic->joint]) +
             joint.mimic->offset;
    if (joint.type == JointType::continuous) return joint.reference;
    double value = joint.reference;
    if (joint.limit.lower) value = std::max(value, *joint.limit.lower);
    if (joint.limit.upper) value = std::min(value, *joint.limit.upper);
    return value;
  }

  void write_drivers() {
    rule("drivers");
    put("# PLACEHOLDER: all stand still. Kinds: harmonic, constant rate, polynomial, smooth step, "
        "table (a\n"
        "# CSV file), hold. Where a load moves a joint: moved_by = \"forces\" in the joint, and no "
        "driver.\n");
    if (!robot_.closings.empty())
      put("# As many as the loops leave freedoms where the robot stands; other joints may have "
          "them "
          "instead.\n");
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) {
      const Joint& joint = robot_.joints[k];
      const std::vector<Coordinate> coordinates = coordinates_of(joint);
      for (std::size_t c = 0; c < coordinates.size(); ++c) {
        const Coordinate& of = coordinates[c];
        if (left_[k][c]) {
          put("\n# {} follows the loops.\n", toml_key(of.name));
          if (coordinates.size() == 1) write_facts(joint, of.turns, held_at(joint));
          continue;
        }
        const double value = coordinates.size() == 1 ? held_at(joint) : 0.0;
        put("\n[drivers.{}]\njoint = {}\n", toml_key(of.name), toml_quoted(of.name));
        put("kind = \"hold\"\nvalue = {}\n", of.turns ? quantity(value, wanted::angle, "rad")
                                                      : quantity(value, wanted::length, "m"));
        if (coordinates.size() == 1) write_facts(joint, of.turns, value);
      }
    }
  }

  /// What the robot says of a joint's drive that a case does not.
  void write_facts(const Joint& joint, bool turns, double value) {
    std::string facts;
    const auto fact = [&](const char* name, const std::optional<double>& of, const char* unit) {
      if (of) facts += fmt::format("{}{} {} {}", facts.empty() ? "" : ", ", name, *of, unit);
    };
    fact("lower", joint.limit.lower, turns ? "rad" : "m");
    fact("upper", joint.limit.upper, turns ? "rad" : "m");
    fact("effort", joint.limit.effort, turns ? "N m" : "N");
    fact("velocity", joint.limit.velocity, turns ? "rad/s" : "m/s");
    const Passive& passive = joint.passive;
    if (!turns) fact("stiffness", passive.stiffness, "N/m");
    fact("friction", passive.friction, turns ? "N m" : "N");
    fact("inertia of its drive", passive.armature, turns ? "kg m^2" : "kg");
    if (!facts.empty()) put("# the robot's, not looked at: {}\n", facts);
    const bool beyond =
        joint.type != JointType::continuous && ((joint.limit.lower && value < *joint.limit.lower) ||
                                                (joint.limit.upper && value > *joint.limit.upper));
    if (beyond) put("# WARNING: this is beyond its limits\n");
    if (!joint.mimic) return;
    // No gear: a mimic says nothing of teeth, of where they meet, nor that the other's drive bears
    // what moves this joint.
    put("# mimics {}: {} times its coordinate, and {} more; write its driver so, or where teeth "
        "do\n"
        "# it a joint of kind = \"gear\" or \"rack\" and no driver here\n",
        toml_quoted(robot_.joints[joint.mimic->joint].name), joint.mimic->multiplier,
        joint.mimic->offset);
  }

  /// Springs and dampers of joints that turn.
  void write_springs() {
    bool any = false;
    for (const Joint& joint : robot_.joints) {
      const Passive& passive = joint.passive;
      const bool turns = joint.type == JointType::revolute || joint.type == JointType::continuous;
      const double stiffness = passive.stiffness.value_or(0.0);
      const double damping = passive.damping.value_or(0.0);
      if (!turns || !(stiffness > 0.0 || damping > 0.0)) continue;
      if (!any) rule("springs and dampers");
      any = true;
      put("\n[forces.{}]\nkind = \"torsion spring\"\njoint = {}\n", toml_key(joint.name),
          toml_quoted(joint.name));
      put("stiffness = {}\n", quantity(stiffness, wanted::torsional_stiffness, "N m/rad"));
      if (stiffness > 0.0) put("free_angle = {}\n", quantity(passive.free, wanted::angle, "rad"));
      if (damping > 0.0)
        put("damping = {}\n", quantity(damping, wanted::torsional_damping, "N m s/rad"));
    }
  }

  void write_beam() {
    rule("beam");
    const bool has_mass = robot_.links[beam_].inertial && robot_.links[beam_].inertial->mass > 0.0;
    put("# PLACEHOLDER: a square box of steel, {}. Kinds: box, rectangular\n"
        "# tube, round tube, plate, polygon, thin-walled, standard (\"RHS 200x100x8\"), nested.\n",
        has_mass ? "as heavy as the robot's link" : "as deep as L/20");
    const auto metres = [](double value) { return quantity(value, wanted::length, "m"); };
    const auto millimetres = [](double value) { return fmt::format("\"{:.6g} mm\"", value * 1e3); };
    put("[sections.placeholder]\nkind = \"box\"\nwidth = {0}\nheight = {0}\nflange = {1}\n"
        "web = {1}\n",
        millimetres(placeholder_.width), millimetres(placeholder_.wall));
    put("\n# PLACEHOLDER: {}.\n", placeholder_.why);
    put("[beam]\nbody = {}\nstart = {}\naxis = {}\nz = {}\ndensity = \"{} kg/m^3\"\n",
        toml_quoted(robot_.links[beam_].name), toml_quoted(begins_elsewhere() ? start_ : origin_),
        direction_text(placeholder_.axis), direction_text(placeholder_.z), steel_density);
    put("\n[[beam.segments]]\nlength = {}\nsection = \"placeholder\"\n",
        metres(placeholder_.length));
    put("\n# PLACEHOLDER: plates across the box, where torque comes in and goes.\n");
    for (const double station : {0.0, placeholder_.length})
      put("[[beam.diaphragms]]\nstation = {}\nthickness = {}\n\n", metres(station),
          millimetres(placeholder_.wall));
    put("# PLACEHOLDER\n[material]\nsteel = \"S355\"\n"
        "\n# PLACEHOLDER: the factor against yielding.\n[strength]\nrequired = 1.5\n"
        "\n# Where it moves again and again, with the cycles of its life:\n#\n"
        "# [fatigue]\n# category = 71\n# cycles = 2e6\n# loading = \"spectrum\"\n"
        "# gamma_Ff = 1.0\n# gamma_Mf = 1.35\n# required = 1.0\n"
        "\n# PLACEHOLDER: how long drivers are looked at that do not repeat.\n"
        "[motion]\nduration = \"1 s\"\n");
  }

  const Robot& robot_;
  std::size_t beam_;
  PlaceholderBeam placeholder_;
  std::vector<std::vector<bool>> left_;  ///< to closings, of every joint its coordinates
  std::string base_, origin_, start_;
  std::vector<std::string> points_;  ///< of every joint, on its links
  std::vector<std::string> closing_points_;
  std::string text_;
};

}  // namespace

std::string case_text(const Robot& robot, const std::string& beam) {
  return CaseOfRobot(robot, beam).text();
}

}  // namespace boxbeam::robots
