#include "boxbeam/mechanism/planar/reactions.hpp"

#include "joint_kinds.hpp"

namespace boxbeam::planar {

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
