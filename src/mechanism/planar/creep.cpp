#include "boxbeam/mechanism/planar/creep.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"

namespace boxbeam::planar {
namespace {

/// The friction of a joint, nullptr where it cannot have any.
Friction* friction_of(Joint& joint) {
  return std::visit(
      [](auto& kind) -> Friction* {
        if constexpr (requires { kind.friction; })
          return &kind.friction;
        else
          return nullptr;
      },
      joint.kind);
}

/// Largest sliding velocity of each contact of a motion [m/s].
std::vector<double> largest_velocities(const std::vector<FrictionContact>& contacts,
                                       const Motion& motion) {
  std::vector<double> largest(contacts.size(), 0.0);
  for (std::size_t j = 0; j < contacts.size(); ++j) {
    for (const State& state : motion.states) {
      largest[j] =
          std::max(largest[j], std::abs(sliding_velocity_of(contacts[j], state.q, state.v)));
    }
  }
  return largest;
}

/// Takes the creep velocity of contacts whose bodies forces move.
void let_stick(Mechanism& mechanism, const std::vector<int>& joints,
               const std::vector<int>& moving) {
  const auto is_in = [](const std::vector<int>& all, int one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  for (const FrictionContact& contact : friction_contacts_of(mechanism)) {
    const bool moves = is_in(moving, contact.point.body) || is_in(moving, contact.guide.body);
    if (!moves || !is_in(joints, contact.joint)) continue;
    friction_of(mechanism.joints[static_cast<std::size_t>(contact.joint)])->creep = 0.0;
  }
}

}  // namespace

void fit_creep(Mechanism& mechanism, const std::vector<int>& joints) {
  constexpr int most = 24576;  // instants of a motion
  if (joints.empty()) return;
  // Drivers decide how it moves: no force is asked for.
  Mechanism moved = mechanism;
  for (Joint& joint : moved.joints) {
    if (Friction* const of = friction_of(joint)) of->coulomb = 0.0;
  }
  try {
    const double waves = waves_of(time_span_of(moved), most);
    const StateSolver solver(moved);
    if (solver.integrates()) {
      let_stick(mechanism, joints, solver.freedom().moving);
      return;
    }
    const Motion motion =
        solve_motion(moved, std::clamp(static_cast<int>(std::ceil(8.0 * waves)), 96, most));
    const std::vector<FrictionContact> contacts = friction_contacts_of(mechanism);
    const std::vector<double> velocities = largest_velocities(contacts, motion);
    for (std::size_t j = 0; j < contacts.size(); ++j) {
      if (std::find(joints.begin(), joints.end(), contacts[j].joint) == joints.end()) continue;
      Friction& of = *friction_of(mechanism.joints[static_cast<std::size_t>(contacts[j].joint)]);
      of.creep = fitted_creep(of, velocities[j], waves);
    }
  } catch (const AnalysisError&) {
    // Its verification says why it cannot be solved.
  }
}

}  // namespace boxbeam::planar
