// How forces move freedoms from one time to the next.

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/forced_motion.hpp"

namespace boxbeam::spatial {
namespace {

double smallest_step(double from, double to) {
  return 1e-13 * std::max(std::abs(from), std::abs(to)) + 1e-300;
}

/// Adds a step of `freedoms` and contacts that rub; a mechanism costs five bodies besides its own.
/// Throws AnalysisError beyond some ten seconds of them.
void spend(const Tree& tree, std::size_t freedoms, double time, int steps, double& bodies) {
  constexpr double most = 6e7, stages = 15.0, besides = 5.0, of_a_loop = 10.0;
  const Mechanism& mechanism = tree.mechanism();
  bodies += stages * static_cast<double>(freedoms + 1) *
            (besides + static_cast<double>(mechanism.bodies.size()) +
             of_a_loop * static_cast<double>(mechanism.closing.size()));
  if (bodies <= most) return;
  throw AnalysisError(
      {fmt::format(
           "the motion under the applied forces takes too much work: {} steps have not led "
           "to its end; look for a spring that is far too stiff, a mass or a creep velocity of "
           "friction that is far too small, or a [motion] duration that is far too long",
           steps),
       "mechanism", time});
}

}  // namespace

ForcedMotion::Step ForcedMotion::step_from(const Tree& tree, const Sample& from, double dt,
                                           Effort& effort) const {
  using Vector = std::vector<double>;
  const std::size_t n = equations_.freedoms();
  spend(tree, n + equations_.contacts().size(), from.time, effort.steps, effort.bodies);
  Step step;
  State state;
  state.touches = from.touches;
  step.end.touches = from.touches;
  Loops::Sample near = from.loops;
  std::optional<Loops::Sample> closed;
  std::optional<std::vector<char>> acting;  // at the beginning
  const auto rates = [&](const Vector& y, Vector& rate, double time) {
    std::fill(rate.begin(), rate.end(), 0.0);
    if (!step.followed) return;
    closed = equations_.place(tree, y, time, near, state);
    step.followed = closed.has_value();
    if (!step.followed) return;
    const std::vector<char> now = acting_in(tree.mechanism(), state);
    const ForcedEquations::Solution of = equations_.solve(tree, state, *closed, from.slips);
    if (!acting)
      acting = now;
    else if ((now != *acting || !of.go_on) && time != from.time)
      step.change = std::min(step.change, (time - from.time) / dt);
    step.unsolved = of.unsolved;
    step.followed = !of.unsolved;
    if (of.unsolved) return;
    std::copy_n(y.begin() + static_cast<std::ptrdiff_t>(n), n, rate.begin());
    for (std::size_t k = 0; k < n; ++k) rate[n + k] = equations_.acceleration_of(of, k);
  };
  Vector error(2 * n), begin(2 * n);
  rates(from.y, begin, from.time);
  if (loops_ != nullptr && step.followed) {
    // With the accelerations that forces give there, the loops are near it for longer.
    Eigen::VectorXd accelerations(static_cast<Eigen::Index>(n));
    for (std::size_t k = 0; k < n; ++k)
      accelerations[static_cast<Eigen::Index>(k)] = equations_.scale(k) * begin[n + k];
    equations_.move(tree, state, *closed, accelerations);
    near = loops_->sample_of(state);
  }
  step.end.time = from.time + dt;
  step.end.y.resize(2 * n);
  boost::numeric::odeint::runge_kutta_fehlberg78<Vector> stepper;
  stepper.do_step(rates, from.y, begin, from.time, step.end.y, dt, error);
  for (std::size_t k = 0; k < error.size(); ++k) {
    const double bound = tolerance_ * (1.0 + std::abs(step.end.y[k]));
    step.error = std::max(step.error, std::abs(error[k]) / bound);
  }
  if (!step.followed || !std::isfinite(step.error)) {
    step.followed = false;
    return step;
  }
  closed = equations_.place(tree, step.end.y, step.end.time, near, state);
  step.followed = closed.has_value();
  if (!step.followed) return step;
  step.end.loops = *closed;
  step.end.slips = from.slips;
  step.changes =
      *acting != acting_in(tree.mechanism(), state) ||
      (equations_.sticking() && !equations_.solve(tree, state, *closed, from.slips).go_on);
  return step;
}

void ForcedMotion::touch(const Tree& tree, const Sample& from, Sample& end) const {
  State state;
  if (!equations_.place(tree, from.y, from.time, from.loops, state)) return;
  const std::vector<Spring>& springs = tree.mechanism().springs;
  std::vector<char> acted;
  for (const Spring& spring : springs) acted.push_back(acts(spring, state) ? 1 : 0);
  const std::optional<Loops::Sample> closed =
      equations_.place(tree, end.y, end.time, end.loops, state);
  if (!closed) return;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Spring& spring = springs[i];
    if (!spring.impact) continue;
    const bool now = acts(spring, state);
    if (!now) end.touches[i] = {};
    if (!now || acted[i] != 0) continue;
    const Eigen::Vector3d d = position_of(state, spring.b) - position_of(state, spring.a);
    const Eigen::Vector3d v = velocity_of(state, spring.b) - velocity_of(state, spring.a);
    // The mass that a force between its ends meets.
    constexpr double push = 1e3;  // far above round-off of what acts without it
    const auto parting = [&](double force) {
      State pushed = state;
      pushed.touches = end.touches;
      pushed.touches[i] = {true, 0.0, 0.0, force};
      accelerate(tree, pushed, *closed);
      return d.dot(acceleration_of(pushed, spring.b) - acceleration_of(pushed, spring.a)) /
             d.norm();
    };
    const double mass = push / std::abs(parting(push) - parting(0.0));
    const LineLaw law = law_of(spring);
    end.touches[i] = touched(law, inward(law, d.dot(v) / d.norm()), mass);
  }
}

std::vector<char> ForcedMotion::acting_in(const Mechanism& mechanism, const State& state) {
  std::vector<char> acting;
  for (const Spring& spring : mechanism.springs) {
    if (spring.acts == Spring::Acts::both) continue;
    acting.push_back(acts(spring, state) ? 1 : 0);
  }
  return acting;
}

double ForcedMotion::until_another_acts(const Tree& tree, const Sample& from) const {
  constexpr double over = 1.05;  // beyond it, so that the step sees it
  double until = std::numeric_limits<double>::infinity();
  State state;
  state.touches = from.touches;
  if (!one_sided_) return until;
  const std::optional<Loops::Sample> closed =
      equations_.place(tree, from.y, from.time, from.loops, state);
  if (!closed) return until;
  equations_.accelerate(tree, state, *closed, from.slips);
  for (const Spring& of : tree.mechanism().springs) {
    for (const Spring& spring : switches_of(of)) {
      const Eigen::Vector3d d = position_of(state, spring.b) - position_of(state, spring.a);
      const Eigen::Vector3d a = acceleration_of(state, spring.b) - acceleration_of(state, spring.a);
      const double length = d.norm();
      if (length == 0.0) continue;
      // tension + rate t + bend t^2/2 = 0.
      const auto [tension, rate] = tension_of(spring, state);
      const double bend = spring.stiffness * d.dot(a) / length;
      const double root = rate * rate - 2.0 * bend * tension;
      if (root < 0.0) continue;
      const double sum = -(rate + std::copysign(std::sqrt(root), rate));
      for (const double t : {sum / bend, 2.0 * tension / sum})
        if (t > 0.0) until = std::min(until, over * t);
    }
  }
  return until;
}

std::optional<ForcedMotion::Step> ForcedMotion::step_to_change(const Tree& tree, const Sample& from,
                                                               Step step, Effort& effort,
                                                               double& dt) const {
  // What only a stage saw is rough, or a contact shorter than the step.
  if (!step.changes) return std::nullopt;
  // As near as arithmetic can: a stage beyond it would count a hard stop over all of the step.
  const double near = smallest_step(from.time, from.time + dt);
  double low = 0.0, high = dt;
  std::optional<Sample> before;
  while (std::abs(high - low) > near) {
    const double middle = 0.5 * (low + high);
    Step half = step_from(tree, from, middle, effort);
    if (!half.followed) return std::nullopt;
    if (half.changes) {
      high = middle;
      step = std::move(half);
    } else {
      low = middle;
      before = std::move(half.end);
    }
  }
  step.before = std::move(before);
  // A stage before it that has them otherwise is no part of this motion.
  if (step.error > 1.0 || step.change < 1.0) return std::nullopt;
  dt = high;
  return step;
}

double ForcedMotion::acts_within(const Tree& tree, Sample& from, Sample& end) const {
  constexpr int looks = 24;
  const bool any_sticks = equations_.sticking() && std::find(from.slips.begin(), from.slips.end(),
                                                             Slip::none) != from.slips.end();
  if (from.accelerations.empty()) know_accelerations(tree, from);
  know_accelerations(tree, end);
  const double dt = end.time - from.time;
  State state;
  state.touches = from.touches;
  std::vector<char> acting;
  for (int i = 0; i < looks; ++i) {
    const double at = from.time + dt * i / looks;
    const std::vector<double> y = i == 0 ? from.y : between(from, end, at);
    const std::optional<Loops::Sample> closed = equations_.place(tree, y, at, from.loops, state);
    if (!closed) return 0.0;
    const std::vector<char> now = acting_in(tree.mechanism(), state);
    if (i == 0)
      acting = now;
    else if (now != acting ||
             (any_sticks && !equations_.solve(tree, state, *closed, from.slips).go_on) ||
             any_turns_back(tree.mechanism(), state, from.slips))
      return at - from.time;
  }
  return 0.0;
}

bool ForcedMotion::any_turns_back(const Mechanism& mechanism, const State& state,
                                  const std::vector<Slip>& slips) const {
  for (std::size_t j = 0; equations_.sticking() && j < equations_.contacts().size(); ++j) {
    if (!can_stick(equations_.laws()[j]) || slips[j] == Slip::none) continue;
    const double v = sliding_velocity_of(mechanism, equations_.contacts()[j], state);
    if (static_cast<double>(slips[j]) * v < -equations_.rest()) return true;
  }
  return false;
}

bool ForcedMotion::agrees_with_halves(const Tree& tree, const Sample& from, const Step& step,
                                      double dt, Effort& effort) const {
  constexpr double apart = 10.0;
  const Step half = step_from(tree, from, 0.5 * dt, effort);
  if (!half.followed) return false;
  const Step rest = step_from(tree, half.end, 0.5 * dt, effort);
  if (!rest.followed) return false;
  for (std::size_t k = 0; k < step.end.y.size(); ++k) {
    const double bound = apart * tolerance_ * (1.0 + std::abs(step.end.y[k]));
    if (!(std::abs(rest.end.y[k] - step.end.y[k]) <= bound)) return false;
  }
  return true;
}

std::optional<ForcedMotion::Step> ForcedMotion::good_step(const Tree& tree, Sample& from,
                                                          double smallest, Effort& effort,
                                                          double& dt) const {
  Step step = step_from(tree, from, dt, effort);
  const bool too_short = std::abs(dt) <= smallest;
  if (!step.followed || step.error > 1.0) {
    if (too_short && step.unsolved) equations_.say_unsolved(tree, from.time, *step.unsolved);
    if (too_short) {
      throw AnalysisError(
          {loops_ != nullptr && !step.followed
               ? "the loops cannot be followed further: what forces move and the drivers no longer "
                 "determine them there (a dead point), or two branches meet"
               : "the motion under the applied forces cannot be integrated further: it changes "
                 "faster than the arithmetic can follow (far too stiff a spring, or friction with "
                 "far "
                 "too small a creep velocity)",
           "mechanism", from.time});
    }
    // The order of the error estimate is eight; Source: Hairer, Norsett, Wanner (1993), II.4.
    dt *= step.followed ? std::max(0.2, 0.9 * std::pow(step.error, -1.0 / 8.0)) : 0.25;
    return std::nullopt;
  }
  if (too_short) return step;
  if (step.changes || step.change < 1.0) {
    std::optional<Step> until_change = step_to_change(tree, from, step, effort, dt);
    if (!until_change) {
      dt *= 0.5;
      return std::nullopt;
    }
    step = *std::move(until_change);
  } else if (one_sided_ || equations_.sticking()) {
    // What begins and ends to act between two stages is seen between the ends of the step.
    const double within = acts_within(tree, from, step.end);
    if (within != 0.0) {
      dt = within;
      return std::nullopt;
    }
  }
  if (agrees_with_halves(tree, from, step, dt, effort)) return step;
  dt *= 0.5;
  return std::nullopt;
}

ForcedMotion::Sample ForcedMotion::advanced(const Tree& tree, Sample from, double until,
                                            Effort& effort, std::vector<Sample>* kept,
                                            std::vector<double>* changes,
                                            std::vector<SlipChange>* slip_changes) const {
  const double direction = until < from.time ? -1.0 : 1.0;
  const double smallest = smallest_step(from.time, until);
  double dt = until - from.time;
  if (kept != nullptr) dt /= 16.0;
  while (direction * (until - from.time) > smallest) {
    double stop = until;
    for (const double at : stops_) {
      const bool ahead = direction * (at - from.time) > smallest;
      if (ahead && direction * (stop - at) > 0.0) stop = at;
    }
    const double wanted = std::abs(dt);
    const double longest = std::max(smallest, until_another_acts(tree, from));
    dt = direction * std::min({wanted, longest, std::abs(stop - from.time)});
    std::optional<Step> step = good_step(tree, from, smallest, effort, dt);
    while (!step) step = good_step(tree, from, smallest, effort, dt);
    if (step->changes) touch(tree, from, step->end);
    if (step->changes && changes != nullptr) changes->push_back(step->end.time);
    const double longer = 0.9 * std::pow(std::max(step->error, 1e-9), -1.0 / 8.0);
    const double next = std::abs(dt) * std::min(5.0, longer);
    dt = std::abs(dt) < wanted ? std::max(next, wanted) : next;
    std::optional<Sample> before = std::move(step->before);
    from = std::move(step->end);
    settle_contacts(tree, from, slip_changes);
    ++effort.steps;
    if (kept != nullptr && before) kept->push_back(std::move(*before));
    if (kept != nullptr) kept->push_back(from);
  }
  from.time = until;
  return from;
}

}  // namespace boxbeam::spatial
