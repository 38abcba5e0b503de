#include <fmt/format.h>

#include <algorithm>

#include "mjcf_elements.hpp"

namespace boxbeam::robots {
namespace {

/// A value of its one coordinate, of one as it is written.
double coordinate_in(const MjcfElements& elements, const Joint& joint, double given) {
  return joint.type == JointType::revolute ? elements.angle(given) : given;
}

}  // namespace

void read_limits(MjcfElements& elements, const RobotElement& of, const MjcfElement& in,
                 Joint& joint) {
  const auto range = elements.numbers(in, "range", 2, 2);
  const std::size_t limited =
      in.attribute("limited") ? elements.choice(in, "limited", "auto", {"false", "true", "auto"})
                              : 2;
  if (!range || limited == 0 || (limited == 2 && !elements.settings().autolimits)) return;
  if (joint.type == JointType::spherical) {
    elements.leave_out("range of ball joints");
    return;
  }
  joint.limit.lower = coordinate_in(elements, joint, (*range)[0]);
  joint.limit.upper = coordinate_in(elements, joint, (*range)[1]);
  if ((*range)[0] > (*range)[1])
    elements.problem(
        of, fmt::format("its lower limit {} is above its upper one {}", (*range)[0], (*range)[1]),
        "write the smaller one first");
}

void read_passive(MjcfElements& elements, const RobotElement& of, const MjcfElement& in,
                  Joint& joint) {
  const bool one = joint.type == JointType::revolute || joint.type == JointType::prismatic;
  // Polynomials of the coordinate or rate: the first number is the straight line.
  const auto law = [&](const char* name) -> std::optional<double> {
    const auto given = elements.numbers(in, name, 1, 5);
    if (!given) return {};
    if (std::any_of(given->begin() + 1, given->end(), [](double more) { return more != 0.0; })) {
      elements.leave_out(fmt::format("{} that is no straight line", name));
      return {};
    }
    return given->front() != 0.0 ? std::optional(given->front()) : std::nullopt;
  };
  const auto not_zero = [&](const char* name) -> std::optional<double> {
    const double value = elements.number(in, name, 0.0);
    return value != 0.0 ? std::optional(value) : std::nullopt;
  };
  Passive passive;
  passive.damping = law("damping");
  passive.stiffness = law("stiffness");
  passive.free = coordinate_in(elements, joint, elements.number(in, "springref", 0.0));
  passive.friction = not_zero("frictionloss");
  passive.armature = not_zero("armature");
  for (const auto& [name, value] :
       {std::pair{"damping", passive.damping}, std::pair{"stiffness", passive.stiffness},
        std::pair{"frictionloss", passive.friction}, std::pair{"armature", passive.armature}}) {
    if (!value) continue;
    if (*value < 0.0) elements.problem(of, fmt::format("its {} is below zero", name), "");
    if (!one) elements.leave_out(fmt::format("{} of ball and free joints", name));
  }
  if (one) joint.passive = passive;
}

}  // namespace boxbeam::robots
