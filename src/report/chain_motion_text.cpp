#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/motion_text.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

using layout::number_beside;
using layout::Table;

/// Adds the three components of a vector to a row. Round-off is judged beside `size`, the largest
/// length in the column, so that a vector that is nothing reads as 0.
void add(std::vector<std::string>& row, const Eigen::Vector3d& v, double size) {
  for (const double component : v) row.push_back(number_beside(component, size));
}

/// The largest length of a vector among all things of a list.
template <class Things, class Vector>
double largest(const Things& things, Vector Things::value_type::*vector) {
  double size = 0.0;
  for (const auto& thing : things) size = std::max(size, (thing.*vector).norm());
  return size;
}

std::string bodies_table(const std::vector<ChainBody>& bodies) {
  Table table({"body", "omega x", "y", "z [rad/s]", "alpha x", "y", "z [rad/s^2]"});
  const double omega = largest(bodies, &ChainBody::omega);
  const double alpha = largest(bodies, &ChainBody::alpha);
  for (const ChainBody& body : bodies) {
    std::vector<std::string> row{body.name};
    add(row, body.omega, omega);
    add(row, body.alpha, alpha);
    table.row(row);
  }
  return table.text();
}

/// Bodies without mass have no inertia loads.
std::string inertia_table(const std::vector<ChainBody>& bodies) {
  Table table({"inertia of", "force x", "y", "z [N]", "moment x", "y", "z [N m]",
               "of it gyroscopic x", "y", "z [N m]"});
  const double force = largest(bodies, &ChainBody::inertia_force);
  const double moment = largest(bodies, &ChainBody::inertia_moment);
  bool any = false;
  for (const ChainBody& body : bodies) {
    if (body.inertia_force.isZero(0.0) && body.inertia_moment.isZero(0.0)) continue;
    any = true;
    std::vector<std::string> row{body.name};
    add(row, body.inertia_force, force);
    add(row, body.inertia_moment, moment);
    add(row, body.gyroscopic_moment, moment);
    table.row(row);
  }
  return any ? "\n" + table.text() : "";
}

std::string points_table(const std::vector<ChainPoint>& points) {
  if (points.empty()) return "";
  Table table({"point", "position x", "y", "z [m]", "velocity x", "y", "z [m/s]", "acceleration x",
               "y", "z [m/s^2]"});
  const double position = largest(points, &ChainPoint::position);
  const double velocity = largest(points, &ChainPoint::velocity);
  const double acceleration = largest(points, &ChainPoint::acceleration);
  for (const ChainPoint& point : points) {
    std::vector<std::string> row{point.name};
    add(row, point.position, position);
    add(row, point.velocity, velocity);
    add(row, point.acceleration, acceleration);
    table.row(row);
  }
  return "\n" + table.text();
}

std::string joints_table(const spatial::Mechanism& mechanism,
                         const std::vector<ChainJoint>& joints) {
  const bool rubs = std::any_of(joints.begin(), joints.end(),
                                [](const ChainJoint& joint) { return joint.friction.has_value(); });
  std::vector<std::string> titles{"joint",    "on", "force x", "y",     "z [N]",
                                  "moment x", "y",  "z [N m]", "drive", "stands at"};
  if (rubs) titles.emplace_back("friction [N]");
  Table table(titles);
  const double force = largest(joints, &ChainJoint::force);
  const double moment = largest(joints, &ChainJoint::moment);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const ChainJoint& joint = joints[i];
    std::vector<std::string> row{joint.name, joint.on};
    if (joint.unique) {
      add(row, joint.force, force);
      add(row, joint.moment, moment);
    } else {
      row.insert(row.end(), 6, "shared");
    }
    const bool carries = i < mechanism.joints.size();
    const bool turns = carries && spatial::is_angle(mechanism.joints[i].kind);
    const bool fixed = carries && mechanism.joints[i].kind == spatial::JointKind::fixed;
    row.push_back(joint.drive ? number_beside(*joint.drive, turns ? moment : force) +
                                    (turns ? " N m" : " N")
                              : (fixed ? "fixed" : "-"));
    row.push_back(joint.coordinate
                      ? number_beside(joint.coordinate->value, 0.0) + (turns ? " rad" : " m")
                      : "-");
    if (rubs) row.push_back(joint.friction ? number_beside(*joint.friction, force) : "-");
    table.row(row);
  }
  return "\n" + table.text();
}

const char* unit_of(HandFormula::Quantity quantity) {
  switch (quantity) {
    case HandFormula::Quantity::omega: return "rad/s";
    case HandFormula::Quantity::alpha: return "rad/s^2";
    case HandFormula::Quantity::position: return "m";
    case HandFormula::Quantity::velocity: return "m/s";
    case HandFormula::Quantity::acceleration: return "m/s^2";
  }
  return "";
}

std::string hand_formula_text(const HandComparison& hand) {
  const HandFormula& formula = hand.formula;
  std::string out = fmt::format("\n{}: {} of {} at t = {:.6g} s\n", formula.name,
                                to_text(formula.quantity), hand.of, formula.time.value());
  Table table({"", fmt::format("formula [{}]", unit_of(formula.quantity)), "computed", "difference",
               "over the length"});
  const double size = std::max(formula.value.norm(), hand.computed.norm());
  std::string written;
  for (int i = 0; i < 3; ++i) {
    const double open = formula.value[i] - hand.computed[i];
    const auto component = static_cast<std::size_t>(i);
    const std::string axis(1, "xyz"[component]);
    table.row({axis, number_beside(formula.value[i], size), number_beside(hand.computed[i], size),
               fmt::format("{:.3g}", open == 0.0 ? 0.0 : open),
               fmt::format("{:.1e}", size > 0.0 ? std::abs(open) / size : 0.0)});
    written += layout::entry(axis, "= " + formula.formula[component]);
  }
  out += table.text() + written;
  if (!formula.note.empty()) out += layout::entry("note", formula.note);
  return out;
}

}  // namespace

std::string motion_text(const Project& project, const ChainMotionResult& motion) {
  const std::string axes =
      motion.axes == "world" ? "world axes" : fmt::format("axes of body {}", motion.axes);
  std::string out = layout::line(fmt::format(
      "{}: {} driven joint{}{}; vectors in {}", visible(project.title), motion.driven,
      motion.driven == 1 ? "" : "s",
      motion.forced > 0 ? fmt::format(", {} moved by forces", motion.forced) : "", axes));
  out += layout::paragraph(
      "A joint's force and moment are about its point, on the body that is named; its drive is "
      "what moves the body that it carries, along its axis. Inertia loads are about the centre of "
      "mass; the gyroscopic part is there because a body turns in a joint on a body that turns.");
  if (motion.loops) {
    const ChainLoops& loops = *motion.loops;
    out += layout::paragraph(fmt::format(
        "Loops are closed by {}: {} equation{} {} {} coordinate{}{}.",
        fmt::join(loops.closing, ", "), loops.equations, loops.equations == 1 ? "" : "s",
        loops.equations == 1 ? "decides" : "decide", loops.freedoms, loops.freedoms == 1 ? "" : "s",
        loops.repeating == 0 ? "" : fmt::format(", {} of them repeat others", loops.repeating)));
    std::vector<std::string> branches;
    for (const spatial::Branch& branch : spatial_of(project).branches)
      branches.push_back(fmt::format("loop {} {}", branch.name, branch.sign > 0 ? "+" : "-"));
    if (!branches.empty())
      out += layout::paragraph(fmt::format(
          "The branch is that which the case asks for at t = 0, {}, and is followed from there.",
          fmt::join(branches, ", ")));
    if (!loops.not_unique.empty()) {
      out += layout::paragraph(fmt::format(
          "How {} share their loads depends on their elasticity: their forces are not printed. One "
          "that leaves more freedom (\"spherical\" for \"revolute\") makes them known.",
          fmt::join(loops.not_unique, ", ")));
    }
  }
  for (const StickingContact& contact : motion.sticking)
    out += layout::paragraph(to_text(contact) + ".");
  if (project.situations.size() > 1) {
    out += layout::paragraph(
        "This is the case as it stands; what its situations change is not part of it.");
  }
  for (const ChainInstant& state : motion.states) {
    out += fmt::format("\nt = {:.6g} s\n", state.time == 0.0 ? 0.0 : state.time);
    out += bodies_table(state.bodies) + inertia_table(state.bodies);
    out += points_table(state.points) + joints_table(spatial_of(project), state.joints);
  }
  if (motion.hand_formulas.empty()) return out;
  out += "\n" + layout::heading("Hand formulas of the case, world axes");
  out += layout::paragraph(
      "The difference is the formula's value minus the computed one, then over the vector's "
      "length.");
  for (const HandComparison& hand : motion.hand_formulas) out += hand_formula_text(hand);
  return out;
}

}  // namespace boxbeam
