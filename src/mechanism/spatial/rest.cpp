#include "boxbeam/mechanism/spatial/rest.hpp"

#include <algorithm>

namespace boxbeam::spatial {

State held_state(const Chain& chain, double time) {
  State state = chain.at(time);
  for (DriverState& coordinate : state.coordinates) coordinate = {coordinate.value, 0.0, 0.0};
  chain.tree().move(state);
  std::fill(state.friction.begin(), state.friction.end(), 0.0);
  return state;
}

EndsAtRest ends_at_rest_of(const Chain& chain, const Motion& motion) {
  constexpr double rest = 1e-6;
  State state;
  const auto speed_at = [&](std::size_t instant) {
    chain.at(time_of(motion, instant), state);
    double speed = 0.0;
    for (const BodyMotion& body : state.bodies)
      speed =
          std::max({speed, body.velocity.cwiseAbs().maxCoeff(), body.omega.cwiseAbs().maxCoeff()});
    return speed;
  };
  const double at_begin = speed_at(0), at_end = speed_at(motion.instants);
  double fastest = std::max(at_begin, at_end);
  for (std::size_t k = 1; k < motion.instants; ++k) fastest = std::max(fastest, speed_at(k));
  return {at_begin <= rest * fastest, at_end <= rest * fastest};
}

StatesAround::StatesAround(const Chain& chain, const Motion& motion)
    : chain_(&chain), begin_(motion.begin), end_(motion.begin + motion.period) {
  if (motion.closed || chain.forced() != nullptr) return;
  before_ = held_state(chain, begin_);
  behind_ = held_state(chain, end_);
}

State StatesAround::at(double time) const {
  if (before_ && time < begin_) return *before_;
  if (behind_ && time > end_) return *behind_;
  return chain_->at(time);
}

}  // namespace boxbeam::spatial
