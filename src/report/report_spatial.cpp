#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "blocks.hpp"
#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/spatial/friction.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "front_end_text.hpp"
#include "function_text.hpp"
#include "giving_way.hpp"

namespace boxbeam::report {
namespace {

using spatial::Mechanism;

/// Components; round-off beside the vector's length reads as 0.
std::string triple(const Eigen::Vector3d& v) {
  const auto component = [&](double x) { return plain(std::abs(x) <= 1e-12 * v.norm() ? 0.0 : x); };
  return fmt::format("({}, {}, {})", component(v.x()), component(v.y()), component(v.z()));
}

std::string body_name(const Mechanism& mechanism, int body) {
  if (body == spatial::ground) return "the ground";
  return mechanism.bodies[static_cast<std::size_t>(body)].name;
}

/// "z" for an axis of the body itself, else its components.
std::string direction_text(const Eigen::Vector3d& direction) {
  for (int k = 0; k < 3; ++k) {
    const double along = direction[k];
    if (std::abs(std::abs(along) - 1.0) > 1e-9) continue;
    return fmt::format("{}{}", along < 0.0 ? "-" : "", "xyz"[k]);
  }
  return triple(direction);
}

std::string axes_text(const Mechanism& mechanism, int axes) {
  return axes == spatial::ground ? "the world" : body_name(mechanism, axes);
}

/// "leg.B", or the components from the body's origin.
std::string place_text(const Mechanism& mechanism, const spatial::Attachment& at) {
  if (at.body == spatial::ground) return triple(at.p) + " m of the world";
  const spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(at.body)];
  const auto named = std::find_if(body.points.begin(), body.points.end(),
                                  [&](const auto& point) { return point.p == at.p; });
  if (named != body.points.end()) return body.name + "." + named->name;
  return fmt::format("{} at {} m", body.name, triple(at.p));
}

/// "0.1 rad about x".
std::string turn_text(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d turn = spatial::turn_of(R);
  const double angle = turn.norm();
  if (angle < 1e-12) return "-";
  return fmt::format("{} rad about {}", plain(angle), direction_text(turn / angle));
}

/// "screw, lead 0.005 m", or the kind alone.
std::string kind_with_lead(const auto& joint) {
  using Kind = std::decay_t<decltype(joint.kind)>;
  if (joint.kind != Kind::screw) return spatial::to_text(joint.kind);
  return fmt::format("screw, lead {} m", plain(joint.lead));
}

/// "-0.25 m * sun + 0.1 m * planet = 0 m, ..": what teeth tie, where they meet and how they push.
std::string mesh_text(const Mechanism& mechanism, const spatial::Mesh& mesh) {
  std::string out;
  for (const spatial::Mesh::Part& part : mesh.parts) {
    const spatial::Joint& joint = mechanism.joints[part.joint];
    const bool turns = spatial::is_angle(joint.kind);
    if (!out.empty()) out += part.factor < 0.0 ? " - " : " + ";
    const double factor = out.empty() ? part.factor : std::abs(part.factor);
    out += turns ? fmt::format("{} m * {}", plain(factor), joint.name)
                 : fmt::format("{}{}", factor < 0.0 ? "-" : "", joint.name);
  }
  return fmt::format(
      "{} = {} m; teeth meet at {} m of {}, their force along {}, with {} of it apart", out,
      plain(mesh.offset), triple(mesh.at.p), body_name(mechanism, mesh.at.body),
      direction_text(mesh.along), plain(mesh.apart.norm()));
}

Table joints_table(const Mechanism& mechanism) {
  Table table = table_of("", {"joint", "kind", "carries", "on", "at [m]",
                              "axis, of the carried body", "turned at zero"});
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    const bool fixed = joint.kind == spatial::JointKind::fixed;
    add_row(table,
            row_of(joint.name, kind_with_lead(joint), mechanism.bodies[i].name,
                   body_name(mechanism, joint.parent), triple(joint.at),
                   fixed ? std::string("-") : direction_text(joint.turn.transpose() * joint.axis),
                   turn_text(joint.turn)));
  }
  return table;
}

/// The joints that close loops.
Table closing_table(const Mechanism& mechanism) {
  Table table = table_of(
      "", {"closing joint", "kind", "on", "at [m]", "and on", "at [m]", "axis, of the first body"});
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    const bool has_axis = joint.kind != spatial::ClosingKind::fixed &&
                          joint.kind != spatial::ClosingKind::spherical &&
                          joint.kind != spatial::ClosingKind::distance &&
                          !spatial::has_teeth(joint.kind);
    add_row(table, row_of(joint.name, kind_with_lead(joint), body_name(mechanism, joint.a.body),
                          triple(joint.a.p), body_name(mechanism, joint.b.body), triple(joint.b.p),
                          has_axis ? direction_text(joint.axis) : std::string("-")));
  }
  return table;
}

Table bodies_table(const Mechanism& mechanism) {
  Table table = table_of("", {"body", "mass [kg]", "centre, body axes [m]",
                              "principal inertias about the centre [kg m^2]"});
  for (const spatial::Body& body : mechanism.bodies) {
    if (body.mass == 0.0) {
      add_row(table, row_of(body.name, cell(text::Quantity::mass, 0.0), "-",
                            "none: a frame that turns or shifts what it carries"));
      continue;
    }
    const Eigen::Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia, Eigen::EigenvaluesOnly)
            .eigenvalues();
    const auto inertia = [](double J) { return text::rounded(text::Quantity::inertia, J); };
    add_row(table, row_of(body.name, cell(text::Quantity::mass, body.mass), triple(body.centre),
                          fmt::format("{}, {}, {}", inertia(principal[2]), inertia(principal[1]),
                                      inertia(principal[0]))));
  }
  return table;
}

void add_drivers(const Mechanism& mechanism, Entries& entries) {
  for (const spatial::Joint& joint : mechanism.joints) {
    const bool turns = spatial::is_angle(joint.kind);
    if (spatial::is_forced(joint)) {
      entries.emplace_back(
          "moved by forces",
          fmt::format("{}: from {:.4g} {}, {:.4g} {}/s at t = 0", joint.name, joint.start,
                      turns ? "rad" : "m", joint.start_rate, turns ? "rad" : "m"));
    }
    if (!spatial::is_driven(joint)) continue;
    entries.emplace_back(
        "driver", fmt::format("{}: {} = {}", spatial::driver_text(joint), turns ? "angle" : "shift",
                              function_text(joint.driver, turns ? "rad" : "m")));
  }
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    if (spatial::has_teeth(joint.kind))
      entries.emplace_back(spatial::to_text(joint.kind),
                           fmt::format("{}: {}", joint.name, mesh_text(mechanism, joint.mesh)));
    if (joint.kind != spatial::ClosingKind::distance) continue;
    entries.emplace_back(joint.driver_name.empty() ? "rod" : "driver",
                         fmt::format("{}: length = {}", spatial::driver_text(joint),
                                     function_text(joint.length, "m")));
  }
}

void add_branches(const Mechanism& mechanism, Entries& entries) {
  for (const spatial::Branch& branch : mechanism.branches) {
    const std::string over =
        branch.via ? "over " + place_text(mechanism, *branch.via) + " to " : "to ";
    entries.emplace_back(
        "branch",
        fmt::format("loop {}: at t = 0 from {} {}{} {} {} of {}, and followed from "
                    "there",
                    branch.name, place_text(mechanism, branch.from), over,
                    place_text(mechanism, branch.to),
                    branch.via ? (branch.sign > 0 ? "right-handed about" : "left-handed about")
                               : (branch.sign > 0 ? "along" : "against"),
                    direction_text(branch.direction), axes_text(mechanism, branch.axes)));
  }
}

void add_loads(const Mechanism& mechanism, Entries& entries) {
  for (const spatial::AppliedLoad& load : mechanism.loads) {
    const bool force = load.kind == spatial::LoadKind::force;
    entries.emplace_back(
        "load", fmt::format("{}: {} on {}, {} {}, along {} of {}, = {}", load.name,
                            force ? "force" : "couple", body_name(mechanism, load.on),
                            force ? "acting at" : "entering at", place_text(mechanism, load.at),
                            direction_text(load.direction), axes_text(mechanism, load.axes),
                            function_text(load.size, force ? "N" : "N m")));
  }
  for (const spatial::LineForce& line : mechanism.line_forces) {
    entries.emplace_back(
        "load",
        fmt::format("{}: force per length on {}, from {} to {}, along {} of {}, = {}", line.name,
                    body_name(mechanism, line.on), place_text(mechanism, {line.on, line.from}),
                    place_text(mechanism, {line.on, line.to}), direction_text(line.direction),
                    axes_text(mechanism, line.axes), function_text(line.size, "N/m")));
  }
}

void add_springs(const Mechanism& mechanism, Entries& entries) {
  for (const spatial::Spring& spring : mechanism.springs) {
    const bool round = spring.impact && spring.impact->exponent != 1.0;
    if (spring.clearance) {
      entries.emplace_back(
          "joint",
          fmt::format("{}: ball with a clearance of {} m, {} and {}; its contact {} {}{}",
                      spring.name, plain(spring.free_length), place_text(mechanism, spring.a),
                      place_text(mechanism, spring.b), plain(spring.stiffness),
                      round ? "N/m^1.5" : "N/m", acting_text(spring.acts, spring.impact)));
      continue;
    }
    entries.emplace_back(
        "load",
        fmt::format("{}: spring of {} {} between {} and {}, free length {} m, damping {} N s/m{}",
                    spring.name, plain(spring.stiffness), round ? "N/m^1.5" : "N/m",
                    place_text(mechanism, spring.a), place_text(mechanism, spring.b),
                    plain(spring.free_length), plain(spring.damping),
                    acting_text(spring.acts, spring.impact)));
  }
  for (const spatial::TorsionSpring& spring : mechanism.torsion_springs) {
    const auto joint = static_cast<std::size_t>(spring.joint);
    entries.emplace_back(
        "load",
        fmt::format("{}: torsion spring of {} N m/rad at {}, free angle {}, damping {} N m s/rad",
                    spring.name, plain(spring.stiffness), mechanism.joints[joint].name,
                    degrees(spring.free_angle), plain(spring.damping)));
  }
}

Entries entries_of(const Project& project) {
  const Mechanism& mechanism = spatial_of(project);
  const spatial::BeamPlacement& placement = project.placement;
  Entries entries;
  entries.emplace_back(
      "beam",
      fmt::format("in body {}: from {} m, x along {}, z along {} of its axes",
                  body_name(mechanism, placement.body), triple(placement.start),
                  direction_text(placement.axes.col(0)), direction_text(placement.axes.col(2))));
  add_drivers(mechanism, entries);
  add_branches(mechanism, entries);
  for (const ElasticBeside& of : project.elastic_beside) {
    if (const auto* const joint = std::get_if<spatial::ElasticJoint>(&of.place))
      entries.emplace_back("joint", fmt::format("{}: {}{}", of.name, spatial::to_text(joint->kind),
                                                giving_way_text(*joint)));
  }
  for (const spatial::FrictionContact& contact : spatial::friction_contacts_of(mechanism)) {
    entries.emplace_back("friction",
                         fmt::format("{}: {}", spatial::name_of_contact(mechanism, contact),
                                     friction_text(contact.law)));
  }
  add_loads(mechanism, entries);
  add_springs(mechanism, entries);
  add_duration(mechanism.duration, entries);
  return entries;
}

/// "the driver of joint hinge", "load push".
std::string name_of(const DriverUse& function) {
  const char* word = function.on == DriverUse::On::joint ? "the driver of joint" : "load";
  return fmt::format("{} {}", word, function.name);
}

/// Notes drivers and loads that the time looked at cuts off.
void add_cut_off(const spatial::Mechanism& mechanism, const MotionSummary& motion,
                 std::vector<std::string>& remarks) {
  const double end = (motion.begin + motion.period).value();
  for (const DriverUse& function : functions_of(mechanism)) {
    const std::string name = name_of(function);
    const DriverTiming timing = timing_of(*function.driver, false);
    if (timing.end > end * (1.0 + 1e-9)) {
      remarks.push_back(fmt::format("the time looked at ends at {}, before {} does at {}",
                                    text::seconds(end), name, text::seconds(timing.end)));
    }
    for (const double omega : timing.omegas) {
      const double waves = motion.period.value() * omega / full_turn;
      if (std::abs(waves - std::round(waves)) < 1e-6 * waves) continue;
      remarks.push_back(
          fmt::format("the time looked at, {}, holds {:.4g} cycles of {}, not a whole number",
                      text::seconds(motion.period.value()), waves, name));
    }
  }
}

class SpatialText : public FrontEndText {
 public:
  using FrontEndText::FrontEndText;

  std::string gravity() const override {
    const Eigen::Vector3d& g = spatial_of(*project_).gravity;
    return fmt::format("({}, {}, {}) m/s^2", plain(g.x()), plain(g.y()), plain(g.z()));
  }

  Entries entries() const override { return entries_of(*project_); }

  std::vector<Block> blocks(const Verification&) const override {
    const Mechanism& mechanism = spatial_of(*project_);
    std::vector<Block> blocks{joints_table(mechanism)};
    if (!mechanism.closing.empty()) blocks.push_back(closing_table(mechanism));
    blocks.push_back(bodies_table(mechanism));
    return blocks;
  }

  std::optional<RigidBodies> rigid_bodies() const override {
    const Mechanism& mechanism = spatial_of(*project_);
    RigidBodies of;
    of.gravity.assign(mechanism.gravity.begin(), mechanism.gravity.end());
    for (const spatial::Body& body : mechanism.bodies) {
      of.bodies.push_back({body.name, body.mass, {}});
    }
    return of;
  }

  void add_remarks(const MotionSummary& motion, std::vector<std::string>& remarks) const override {
    const Mechanism& mechanism = spatial_in(*project_, project_->situations[motion.situation]);
    add_cut_off(mechanism, motion, remarks);
    add_overshoots(functions_of(mechanism), name_of, remarks);
    for (const spatial::ClosingJoint& joint : mechanism.closing) {
      if (!spatial::has_teeth(joint.kind)) continue;
      remarks.push_back(
          fmt::format("the teeth of {} are straight, without play and friction: what helical ones "
                      "push along their axes is to be given as a force",
                      joint.name));
    }
  }

  using FrontEndText::add_remarks;
};

}  // namespace

std::unique_ptr<const FrontEndText> text_for(const spatial::Mechanism&, const Project& project) {
  return std::make_unique<SpatialText>(project);
}

}  // namespace boxbeam::report
