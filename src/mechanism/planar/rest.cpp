#include "boxbeam/mechanism/planar/rest.hpp"

#include <algorithm>

namespace boxbeam::planar {

State held_state(const Mechanism& mechanism, const State& known) {
  Mechanism held = mechanism;
  for (Joint& joint : held.joints) {
    auto* const driven = std::get_if<Driven>(&joint.kind);
    if (driven == nullptr) continue;
    driven->driver = PolynomialDriver{{driver_at(driven->driver, known.time).value}};
  }
  return InstantSolver(held).solve_at(known.time, known.q);
}

bool is_at_rest(const Motion& motion, const State& state) {
  constexpr double rest = 1e-6;
  const auto speed_of = [](const State& of) {
    return of.v.size() == 0 ? 0.0 : of.v.cwiseAbs().maxCoeff();
  };
  double fastest = speed_of(motion.end);
  for (const State& of : motion.states) fastest = std::max(fastest, speed_of(of));
  return speed_of(state) <= rest * fastest;
}

State StatesAround::at(double time) {
  const double end = motion_->begin + motion_->period;
  const bool outside =
      !motion_->closed && motion_->freedom.undriven == 0 && (time < motion_->begin || time > end);
  if (!outside) return finder_.at(time);
  std::optional<State>& held = time < motion_->begin ? before_ : behind_;
  if (!held) {
    held = held_state(*mechanism_, time < motion_->begin ? motion_->states.front() : motion_->end);
  }
  return *held;
}

}  // namespace boxbeam::planar
