#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks.hpp"
#include "front_end_text.hpp"
#include "function_text.hpp"
#include "giving_way.hpp"

namespace boxbeam::report {
namespace {

using planar::Attachment;
using planar::Mechanism;

std::string vector_text(const Eigen::Vector2d& p) {
  return fmt::format("({}, {}) m", plain(p.x()), plain(p.y()));
}

/// Words for the attachments of one mechanism.
struct Names {
  const Mechanism& mechanism;

  std::string body(const Attachment& at) const {
    if (at.body == planar::ground) return "the ground";
    return mechanism.bodies[static_cast<std::size_t>(at.body)].name;
  }

  std::string point(const Attachment& at) const {
    if (at.body == planar::ground) return "the ground at " + vector_text(at.p);
    const Body& body = mechanism.bodies[static_cast<std::size_t>(at.body)];
    const auto named = std::find_if(body.points.begin(), body.points.end(),
                                    [&](const BodyPoint& point) { return point.p == at.p; });
    if (named != body.points.end()) return fmt::format("{}.{}", body.name, named->name);
    return fmt::format("{} at {} from its centre", body.name, vector_text(at.p));
  }

  /// "at 10 deg to x of sledge".
  std::string direction(double angle, const Attachment& of) const {
    const std::string axes = of.body == planar::ground ? "the world" : body(of);
    return fmt::format("at {} to x of {}", degrees(angle), axes);
  }

  std::string line(const Attachment& guide, double angle) const {
    return fmt::format("on a line through {} {}", point(guide), direction(angle, guide));
  }
};

/// Behind what a joint is.
std::string rubbing_text(const planar::Friction& friction) {
  const std::string text = friction_text(friction);
  return text.empty() ? text : ", " + text;
}

/// Constraints and drivers in words.
struct JointText {
  Names names;

  std::string operator()(const planar::Pin& pin) const {
    return fmt::format("pin, {} and {}", names.point(pin.a), names.point(pin.b));
  }

  std::string operator()(const planar::Slider& slider) const {
    return fmt::format("slider, {} {}; {} keeps {} to {}{}", names.point(slider.point),
                       names.line(slider.guide, slider.direction), names.body(slider.point),
                       degrees(slider.angle), names.body(slider.guide),
                       rubbing_text(slider.friction));
  }

  std::string operator()(const planar::PinInSlot& slot) const {
    return fmt::format("pin in slot, {} {}{}", names.point(slot.point),
                       names.line(slot.guide, slot.direction), rubbing_text(slot.friction));
  }

  std::string operator()(const planar::Rigid& rigid) const {
    return fmt::format("rigid, {} and {}; {} keeps {} to {}", names.point(rigid.a),
                       names.point(rigid.b), names.body(rigid.a), degrees(rigid.angle),
                       names.body(rigid.b));
  }

  std::string operator()(const planar::Distance& distance) const {
    return fmt::format("distance of {} m, {} and {}", plain(distance.length),
                       names.point(distance.a), names.point(distance.b));
  }

  std::string operator()(const planar::AngleCoupling& coupling) const {
    return fmt::format("angle coupling, angle of {} = {} * angle of {} + {}",
                       names.body(coupling.a), plain(coupling.ratio), names.body(coupling.b),
                       degrees(coupling.offset));
  }

  std::string operator()(const planar::Gear& gear) const {
    const auto wheel = [&](const Attachment& centre, double radius) {
      return fmt::format("{} of radius {} m about {}", radius < 0.0 ? "annulus" : "wheel",
                         plain(std::abs(radius)), names.point(centre));
    };
    return fmt::format("gear, {} and {}, offset {} m", wheel(gear.a, gear.radius_a),
                       wheel(gear.b, gear.radius_b), plain(gear.offset));
  }

  std::string operator()(const planar::Rack& rack) const {
    return fmt::format(
        "rack, wheel of radius {} m about {}, {} of the pitch line through {} {}, "
        "offset {} m",
        plain(std::abs(rack.radius)), names.point(rack.pinion),
        rack.radius > 0.0 ? "left" : "right", names.point(rack.rack),
        names.direction(rack.direction, rack.rack), plain(rack.offset));
  }

  std::string operator()(const planar::Driven& driven) const {
    const bool turns = driven.coordinate == planar::Coordinate::angle;
    return fmt::format("{} = {}", coordinate(driven),
                       function_text(driven.driver, turns ? "rad" : "m"));
  }

  std::string coordinate(const planar::Driven& driven) const {
    switch (driven.coordinate) {
      case planar::Coordinate::x: return "x of " + names.point(driven.point);
      case planar::Coordinate::y: return "y of " + names.point(driven.point);
      case planar::Coordinate::length:
        return fmt::format("length from {} to {}", names.point(driven.point),
                           names.point(driven.other));
      case planar::Coordinate::angle: break;
    }
    const bool relative = driven.other.body != planar::ground;
    return fmt::format("angle of {}{}", names.body(driven.point),
                       relative ? " against " + names.body(driven.other) : "");
  }
};

struct ForceText {
  Names names;

  static const char* unit_of(const std::optional<Impact>& impact) {
    return impact && impact->exponent != 1.0 ? "N/m^1.5" : "N/m";
  }

  std::string operator()(const planar::Spring& spring) const {
    return fmt::format("spring of {} {}, {} and {}, free length {} m, damping {} N s/m{}",
                       plain(spring.stiffness), unit_of(spring.impact), names.point(spring.a),
                       names.point(spring.b), plain(spring.free_length), plain(spring.damping),
                       acting_text(spring.acts, spring.impact));
  }

  std::string operator()(const planar::PinWithClearance& pin) const {
    return fmt::format(
        "pin with a clearance of {} m, {} and {}; its contact {} {}{}; at t = 0 {}",
        plain(pin.clearance), names.point(pin.a), names.point(pin.b), plain(pin.stiffness),
        unit_of(pin.impact), acting_text(Acts::pulling, pin.impact),
        pin.start.isZero(0.0) ? std::string("in the middle, without velocity there")
                              : fmt::format("({}, {}) m from the middle, without velocity there",
                                            plain(pin.start.x()), plain(pin.start.y())));
  }

  std::string operator()(const planar::TorsionSpring& spring) const {
    return fmt::format(
        "torsion spring of {} N m/rad, {} and {}, free angle {}, damping {} N m s/rad",
        plain(spring.stiffness), names.body(spring.a), names.body(spring.b),
        degrees(spring.free_angle), plain(spring.damping));
  }

  std::string operator()(const planar::PointForce& force) const {
    const Attachment axes = force.turns ? force.at : Attachment{};
    return fmt::format("force on {} {} = {}", names.point(force.at),
                       names.direction(force.direction, axes), function_text(force.size, "N"));
  }

  std::string operator()(const planar::Couple& couple) const {
    const std::string other = couple.b.body == planar::ground
                                  ? ""
                                  : fmt::format(", its opposite on {}", names.point(couple.b));
    return fmt::format("couple on {}{} = {}", names.point(couple.a), other,
                       function_text(couple.size, "N m"));
  }
};

/// Behind what a joint is, where it gives way.
std::string where_it_gives_way(const std::vector<ElasticBeside>& elastic, std::size_t joint) {
  for (const ElasticBeside& of : elastic) {
    const auto* const gives_way = std::get_if<planar::ElasticJoint>(&of.place);
    if (gives_way != nullptr && gives_way->joint == static_cast<int>(joint))
      return giving_way_text(*gives_way);
  }
  return "";
}

Entries entries_of(const Mechanism& mechanism, const std::vector<ElasticBeside>& elastic) {
  const Names names{mechanism};
  Entries entries;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const planar::Joint& joint = mechanism.joints[i];
    entries.emplace_back(
        planar::is_driver(joint) ? "driver" : "joint",
        fmt::format("{}: {}{}", joint.name, std::visit(JointText{names}, joint.kind),
                    where_it_gives_way(elastic, i)));
  }
  for (const planar::AppliedForce& force : mechanism.forces) {
    const bool loose = std::holds_alternative<planar::PinWithClearance>(force.kind);
    entries.emplace_back(
        loose ? "joint" : "force",
        fmt::format("{}: {}", force.name, std::visit(ForceText{names}, force.kind)));
  }
  for (const Body& body : mechanism.bodies) {
    const Eigen::Vector3d& v = body.start_velocity;
    if (v.isZero(0.0)) continue;
    entries.emplace_back("start", fmt::format("{}: centre at ({}, {}) m/s, turning at {} rad/s",
                                              body.name, plain(v.x()), plain(v.y()), plain(v.z())));
  }
  add_duration(mechanism.duration, entries);
  return entries;
}

std::vector<Block> blocks_of(const Mechanism& mechanism, const ClosureSummary& closure) {
  const planar::DegreesOfFreedom& freedom = closure.freedom;
  Facts facts;
  const auto add = [&](const char* name, std::string text) {
    facts.entries.emplace_back(name, std::move(text));
  };
  add("degrees of freedom",
      fmt::format("{} by Gruebler, {} by the rank of the Jacobian; {} driver{}", freedom.gruebler,
                  freedom.by_rank, freedom.drivers, freedom.drivers == 1 ? "" : "s"));
  if (freedom.redundant > 0) {
    add("redundant",
        fmt::format("{} equations, shared by {}", freedom.redundant,
                    fmt::join(planar::names_of_joints(mechanism, freedom.repeating), ", ")));
  }
  if (freedom.undriven > 0) {
    add("moved by forces", fmt::format("{} degree{} of freedom, integrated over time",
                                       freedom.undriven, freedom.undriven == 1 ? "" : "s"));
  } else {
    add("digits left",
        fmt::format("{:.0f} of velocities, at worst (t = {})", std::floor(closure.digits.left),
                    text::seconds(closure.digits.time.value())));
  }
  std::vector<std::string> loose;
  for (const planar::AppliedForce& force : mechanism.forces)
    if (std::holds_alternative<planar::PinWithClearance>(force.kind)) loose.push_back(force.name);
  if (!loose.empty()) {
    add("with clearance", fmt::format("{}: without equations, each leaves two freedoms to forces",
                                      fmt::join(loose, ", ")));
  }
  for (std::size_t i = 0; i < closure.branch.size(); ++i) {
    add("branch",
        fmt::format("loop {}: {}", mechanism.loops[i].name, closure.branch[i] > 0 ? "+" : "-"));
  }
  add("joints closed to",
      fmt::format("{:.1e} of the mechanism's size at all instants", closure.largest_residual));
  Table table = table_of("", {"body", "mass [kg]", "J about centre [kg m^2]"});
  for (const Body& body : mechanism.bodies) {
    add_row(table, row_of(body.name, cell(text::Quantity::mass, body.mass),
                          cell(text::Quantity::inertia, body.inertia)));
  }
  return {std::move(facts), std::move(table)};
}

void add_closure(const planar::Mechanism& mechanism, const ClosureSummary& closure,
                 std::vector<std::string>& remarks) {
  for (const double time : closure.change_points) {
    remarks.push_back(fmt::format(
        "at t = {} the mechanism passes a change point, where it could go over to another branch; "
        "the smooth one is followed, and a real mechanism needs a guide there",
        text::seconds(time)));
  }
  const planar::DegreesOfFreedom& freedom = closure.freedom;
  if (freedom.redundant > 0) {
    remarks.push_back(
        fmt::format("{} repeat each other: the beam's loads are determined, theirs are not",
                    fmt::join(planar::names_of_joints(mechanism, freedom.repeating), ", ")));
  }
  if (freedom.undriven == 0 && closure.digits.left < 9.0) {
    remarks.push_back(fmt::format(
        "close to a dead point only {:.0f} digits of velocities are left (t = {}): loads there "
        "depend strongly on lengths and on the driver",
        std::floor(closure.digits.left), text::seconds(closure.digits.time.value())));
  }
}

/// "driver crank", "force push", "couple brake".
std::string name_of(const DriverUse& function) {
  const auto as = [&](const char* word) { return fmt::format("{} {}", word, function.name); };
  switch (function.on) {
    case DriverUse::On::joint: return as("driver");
    case DriverUse::On::force: return as("force");
    case DriverUse::On::couple: return as("couple");
  }
  return "";
}

class PlanarText : public FrontEndText {
 public:
  using FrontEndText::FrontEndText;

  std::string gravity() const override {
    const Eigen::Vector2d& g = planar_of(*project_).gravity;
    return fmt::format("({:.6g}, {:.6g}) m/s^2", g.x(), g.y());
  }

  Entries entries() const override {
    return entries_of(planar_of(*project_), project_->elastic_beside);
  }

  std::vector<Block> blocks(const Verification& verification) const override {
    return blocks_of(planar_of(*project_), *verification.motions.front().closure);
  }

  std::optional<RigidBodies> rigid_bodies() const override {
    const Mechanism& mechanism = planar_of(*project_);
    RigidBodies of;
    of.gravity.assign(mechanism.gravity.begin(), mechanism.gravity.end());
    for (const Body& body : mechanism.bodies) {
      of.bodies.push_back({body.name, body.mass, body.inertia});
    }
    return of;
  }

  void add_remarks(std::vector<std::string>& remarks) const override {
    if (!planar_of(*project_).loops.empty()) return;
    remarks.emplace_back(
        "the case names no loop: the motion is on the branch to which the sketch leads, which is "
        "neither checked nor reported; add [loops] where a loop has two assemblies");
  }

  void add_remarks(const MotionSummary& motion, std::vector<std::string>& remarks) const override {
    add_closure(planar_of(*project_), *motion.closure, remarks);
    const Situation& situation = project_->situations[motion.situation];
    add_overshoots(functions_of(planar_in(*project_, situation)), name_of, remarks);
  }
};

}  // namespace

std::unique_ptr<const FrontEndText> text_for(const planar::Mechanism&, const Project& project) {
  return std::make_unique<PlanarText>(project);
}

}  // namespace boxbeam::report
