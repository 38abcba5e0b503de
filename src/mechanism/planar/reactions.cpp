#include "boxbeam/mechanism/planar/reactions.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

/// Collects the reactions of one joint; `lambda` are its own multipliers.
struct Collector {
  std::vector<Reaction>& reactions;
  int joint;
  const double* lambda;

  void add(const Attachment& at, const Eigen::Vector2d& force, double moment) const {
    if (at.body != ground) reactions.push_back({joint, at.body, force, moment, at.p});
  }

  void operator()(const Pin& pin) const {
    const Eigen::Vector2d force(lambda[0], lambda[1]);
    add(pin.a, -force, 0.0);
    add(pin.b, force, 0.0);
  }

  void operator()(const Slider& slider) const {
    const Eigen::Vector2d normal(-std::sin(slider.direction), std::cos(slider.direction));
    add(slider.point, -lambda[0] * normal, -lambda[1]);
  }

  void operator()(const AngleCoupling& coupling) const {
    add(coupling.a, Eigen::Vector2d::Zero(), -lambda[0]);
    add(coupling.b, Eigen::Vector2d::Zero(), coupling.ratio * lambda[0]);
  }

  void operator()(const Driven& driven) const {
    switch (driven.coordinate) {
      case Coordinate::x: return add(driven.point, {-lambda[0], 0.0}, 0.0);
      case Coordinate::y: return add(driven.point, {0.0, -lambda[0]}, 0.0);
      case Coordinate::angle: return add(driven.point, {0.0, 0.0}, -lambda[0]);
    }
  }
};

}  // namespace

std::vector<Reaction> reactions_of(const Mechanism& mechanism, const State& state) {
  std::vector<Reaction> reactions;
  reactions.reserve(2 * mechanism.joints.size());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    std::visit(Collector{reactions, static_cast<int>(i), state.lambda.data() + row}, joint.kind);
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
