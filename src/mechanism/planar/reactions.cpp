#include "boxbeam/mechanism/planar/reactions.hpp"

#include <algorithm>
#include <variant>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "joint_kinds.hpp"

namespace boxbeam::planar {

double tension_in_joint(const Mechanism& mechanism, const State& state, std::size_t joint) {
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < joint; ++i) row += equations_of(mechanism.joints[i]);
  return state.lambda[row];
}

double tension_in_spring(const Mechanism& mechanism, const State& state, std::size_t force) {
  const auto& spring = std::get<Spring>(mechanism.forces[force].kind);
  const Eigen::Vector2d line = position_of(spring.b, state.q) - position_of(spring.a, state.q);
  if (line.norm() == 0.0) return 0.0;
  for (const AppliedLoad& load :
       applied_loads_of(mechanism, state.time, state.q, state.v, state.touches)) {
    if (load.force != static_cast<int>(force)) continue;
    const bool on_a = load.on == spring.a.body && load.point == spring.a.p;
    return load.vector.dot(line.normalized()) * (on_a ? 1.0 : -1.0);
  }
  return 0.0;
}

std::optional<Spring> spring_in(const Mechanism& mechanism, const State& state, std::size_t force) {
  Spring spring = std::get<Spring>(mechanism.forces[force].kind);
  if (spring.acts == Acts::both) return spring;
  if (tension_in_spring(mechanism, state, force) == 0.0) return std::nullopt;
  const double length = (position_of(spring.b, state.q) - position_of(spring.a, state.q)).norm();
  spring.stiffness = stiffness_at(law_of(spring), length);
  spring.acts = Acts::both;
  spring.impact.reset();
  return spring;
}

std::vector<bool> acting_springs(const Mechanism& mechanism, const State& state) {
  std::vector<bool> acting;
  for (std::size_t i = 0; i < mechanism.forces.size(); ++i)
    acting.push_back(std::holds_alternative<Spring>(mechanism.forces[i].kind) &&
                     spring_in(mechanism, state, i).has_value());
  return acting;
}

bool has_damped_touches(const Mechanism& mechanism) {
  return std::any_of(mechanism.forces.begin(), mechanism.forces.end(),
                     [](const AppliedForce& force) {
                       const auto* const spring = std::get_if<Spring>(&force.kind);
                       return spring != nullptr && spring->acts != Acts::both &&
                              (spring->damping > 0.0 || spring->impact);
                     });
}

std::vector<Reaction> reactions_of(const Mechanism& mechanism, const State& state) {
  std::vector<Reaction> reactions;
  reactions.reserve(2 * mechanism.joints.size());
  Eigen::Index contact = 0;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const double friction = rubs(joint) ? state.friction[contact++] : 0.0;
    std::visit(
        ReactionsOfKind{state, reactions, static_cast<int>(i), state.lambda.data() + row, friction},
        joint.kind);
    row += equations_of(joint);
  }
  return reactions;
}

std::vector<Reaction> reactions_per_joint(const Mechanism& mechanism, const State& state,
                                          int preferred) {
  std::vector<Reaction> chosen;
  for (const Reaction& reaction : reactions_of(mechanism, state)) {
    if (chosen.empty() || chosen.back().joint != reaction.joint) {
      chosen.push_back(reaction);
    } else if (reaction.on == preferred) {
      chosen.back() = reaction;
    }
  }
  return chosen;
}

}  // namespace boxbeam::planar
