// Where what acts one way begins and ends to act: stops, cables, pins in their clearances.
#include <algorithm>
#include <cmath>
#include <utility>

#include "free_step.hpp"

namespace boxbeam::planar {
namespace {

/// Into how many parts the way between two states is divided, so that nothing is passed through
/// unseen: each at most a tenth of the length from which it acts.
int looks_between(const std::vector<OneSided>& one_sided, const State& from, const State& end) {
  constexpr double fewest = 32.0, most = 20000.0, parts = 10.0;
  double looks = fewest;
  for (const OneSided& of : one_sided) {
    for (const State* const state : {&from, &end}) {
      const Eigen::Vector2d v =
          velocity_of(of.b, state->q, state->v) - velocity_of(of.a, state->q, state->v);
      const double way = v.norm() * std::abs(end.time - from.time);
      if (of.law.free_length > 0.0) looks = std::max(looks, parts * way / of.law.free_length);
    }
  }
  return static_cast<int>(std::ceil(std::min(looks, most)));
}

}  // namespace

bool FreeSolver::in_impact(const State& state) const {
  return std::any_of(one_sided_.begin(), one_sided_.end(), [&](const OneSided& of) {
    return of.law.impact && state.touches[of.force].on;
  });
}

bool FreeSolver::has_changed(const OneSided& of, const State& state) const {
  const double value = depth_of(of, state.q, state.v).value;
  return state.touches[of.force].on ? value < -touching_ : value > touching_;
}

bool FreeSolver::has_changed(const State& state) const {
  return std::any_of(one_sided_.begin(), one_sided_.end(),
                     [&](const OneSided& of) { return has_changed(of, state); });
}

double FreeSolver::mass_between(const OneSided& of, const State& state) {
  constexpr double push = 1e3;  // far above round-off of what acts without it
  if (!of.law.impact) return 0.0;
  const Eigen::Vector2d line = position_of(of.b, state.q) - position_of(of.a, state.q);
  State pushed = state;
  // Without what it bears itself, which at its beginning is nothing.
  const auto parting = [&](double force) {
    pushed.touches[of.force] = {true, 0.0, 0.0, force};
    if (!equations_.solve_rates(pushed)) return 0.0;
    return line.dot(acceleration_of(of.b, pushed.q, pushed.v, pushed.a) -
                    acceleration_of(of.a, pushed.q, pushed.v, pushed.a)) /
           line.norm();
  };
  return push / std::abs(parting(push) - parting(0.0));
}

void FreeSolver::change(State& state) {
  for (const OneSided& of : one_sided_) {
    if (!has_changed(of, state)) continue;
    Touch& touch = state.touches[of.force];
    if (touch.on)
      touch = {};
    else
      touch = touched(of.law, depth_of(of, state.q, state.v).rate, mass_between(of, state));
  }
  changes_.push_back(state.time);
  state = state_of(state);
}

std::optional<FreeSolver::Change> FreeSolver::first_change(const State& from,
                                                           const State& end) const {
  constexpr int halvings = 40;
  if (one_sided_.empty()) return std::nullopt;
  const double dt = end.time - from.time;
  const int looks = looks_between(one_sided_, from, end);
  const auto at = [&](double time) {
    if (time == end.time) return end;
    State state = interpolate(time, from, end);
    state.touches = from.touches;
    return state;
  };
  State before = from;
  for (int i = 1; i <= looks; ++i) {
    const State behind = at(i == looks ? end.time : from.time + dt * i / looks);
    std::optional<Change> first;
    for (std::size_t k = 0; k < one_sided_.size(); ++k) {
      const OneSided& of = one_sided_[k];
      double low = before.time, high = behind.time;
      if (!has_changed(of, behind)) {
        // Between them it may have gone there and come back.
        const double sense = from.touches[of.force].on ? -1.0 : 1.0;
        const double there = sense * depth_of(of, before.q, before.v).rate;
        const double back = -sense * depth_of(of, behind.q, behind.v).rate;
        if (!(there > 0.0 && back > 0.0)) continue;
        high = low + (high - low) * there / (there + back);
        if (!has_changed(of, at(high))) continue;
      }
      for (int j = 0; j < halvings; ++j) {
        const double middle = 0.5 * (low + high);
        (has_changed(of, at(middle)) ? high : low) = middle;
      }
      if (!first || std::abs(high - from.time) < std::abs(first->until - from.time))
        first = Change{k, low, high};
    }
    if (first) return first;
    before = behind;
  }
  return std::nullopt;
}

FreeSolver::Step FreeSolver::step_to(const Change& change, const State& from) {
  constexpr int most = 60;
  const OneSided& of = one_sided_[change.of];
  const bool on = from.touches[of.force].on;
  const double smallest = 1e-15 * std::abs(change.until) + 1e-300;
  double low = 0.0, high = -1.0;  // not yet known
  double dt = change.until - from.time;
  std::optional<Step> beyond_it;
  for (int i = 0; i < most; ++i) {
    Step step = step_from(from, dt);
    if (!step.solved) return step;
    const ValueAndRate there = depth_of(of, step.end.q, step.end.v);
    // How far it is beyond where it is said to have changed.
    const double past = on ? -touching_ - there.value : there.value - touching_;
    const double rate = on ? -there.rate : there.rate;
    if (past > 0.0) {
      high = dt;
      beyond_it = std::move(step);
      if (past <= touching_) break;
    } else {
      low = dt;
    }
    if (high >= 0.0 && high - low <= smallest) break;
    // Half a way that counts behind it.
    double next = rate > 0.0 ? dt - (past - 0.5 * touching_) / rate : -1.0;
    if (high < 0.0 && !(next > low)) next = dt + 1e-3 * std::max(dt, smallest);
    if (high >= 0.0 && !(next > low && next < high)) next = 0.5 * (low + high);
    dt = next;
  }
  if (beyond_it) return *std::move(beyond_it);
  Step failed;
  failed.solved = false;
  return failed;
}

}  // namespace boxbeam::planar
