#include "boxbeam/mechanism/spatial/forced_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam::spatial {
namespace {

/// Throws AnalysisError where a ball begins outside of its socket.
void require_within_clearance(const Mechanism& mechanism, const State& state) {
  for (const Spring& spring : mechanism.springs) {
    if (!spring.clearance) continue;
    const double off = (position_of(state, spring.b) - position_of(state, spring.a)).norm();
    if (off <= 1.01 * spring.free_length) continue;
    throw AnalysisError(
        {fmt::format("it begins {:.4g} mm from the middle of its socket, and its clearance is "
                     "{:.4g} mm; write the start of the joints that forces move so that it is "
                     "within",
                     1e3 * off, 1e3 * spring.free_length),
         "joint " + spring.name, 0.0});
  }
}

}  // namespace

ForcedMotion::ForcedMotion(const Tree& tree, const Loops* loops, double tolerance)
    : equations_(tree.mechanism(), loops, tolerance), loops_(loops), tolerance_(tolerance) {
  const Mechanism& mechanism = tree.mechanism();
  one_sided_ = std::any_of(mechanism.springs.begin(), mechanism.springs.end(),
                           [](const Spring& of) { return of.acts != Spring::Acts::both; });
  Sample start;
  start.y = equations_.start_of(mechanism);
  const TimeSpan span = time_span_of(mechanism);
  const double until = span.begin + span.length;
  const double aside = 1e-12 * until;
  gap_ = 4.0 * aside;
  for (const Break& at : breaks_of(functions_of(mechanism), 0.0, until)) {
    stops_.push_back(at.at - aside);
    stops_.push_back(at.at + aside);
  }
  if (loops != nullptr) {
    // With the rates of the start, which the loops have not known yet.
    State state;
    tree.begin(state);
    start.loops = loops->close_beside(loops->first(), tree, state).value_or(loops->first());
  }
  start.touches.resize(mechanism.springs.size());
  State first;
  if (equations_.place(tree, start.y, 0.0, start.loops, first))
    require_within_clearance(mechanism, first);
  settle_contacts(tree, start, nullptr);
  std::vector<Sample> steps{start};
  Effort effort;
  advanced(tree, start, until, effort, &steps, &changes_, &slip_changes_);
  for (Sample& of : steps) know_accelerations(tree, of);
  samples_.push_back(steps.front());
  constexpr int most_halvings = 12;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    refine(tree, steps[i - 1], steps[i], most_halvings, effort, samples_);
    samples_.push_back(steps[i]);
  }
}

void ForcedMotion::know_accelerations(const Tree& tree, Sample& at) const {
  State state;
  state.touches = at.touches;
  const Loops::Sample closed =
      equations_.place(tree, at.y, at.time, at.loops, state).value_or(at.loops);
  const ForcedEquations::Solution of = equations_.solve(tree, state, closed, at.slips);
  if (of.unsolved) equations_.say_unsolved(tree, at.time, *of.unsolved);
  at.accelerations.clear();
  for (std::size_t k = 0; k < equations_.freedoms(); ++k)
    at.accelerations.push_back(equations_.acceleration_of(of, k));
}

DriverState ForcedMotion::course(const Sample& from, const Sample& to, std::size_t k,
                                 double time) const {
  const std::size_t n = equations_.freedoms();
  const double h = to.time - from.time, x = (time - from.time) / h;
  // Across a break round-off would be all there is.
  if (h <= gap_) return {from.y[k] + x * h * from.y[n + k], from.y[n + k], from.accelerations[k]};
  const double q = from.y[k], v = h * from.y[n + k], a = 0.5 * h * h * from.accelerations[k];
  // What is left of value, slope and half the curvature at the end.
  const double d = to.y[k] - q - v - a, e = h * to.y[n + k] - v - 2.0 * a,
               f = 0.5 * h * h * to.accelerations[k] - a;
  const double c3 = 10.0 * d - 4.0 * e + f, c4 = -15.0 * d + 7.0 * e - 2.0 * f,
               c5 = 6.0 * d - 3.0 * e + f;
  double value = q + x * (v + x * (a + x * (c3 + x * (c4 + x * c5))));
  double slope = v + x * (2.0 * a + x * (3.0 * c3 + x * (4.0 * c4 + x * 5.0 * c5)));
  double bend = 2.0 * a + x * (6.0 * c3 + x * (12.0 * c4 + x * 20.0 * c5));
  if (!to.added.empty()) {
    // (x (1 - x))^3, which the ends do not feel, times a parabola about the middle.
    const double t = x * (1.0 - x), dt = 1.0 - 2.0 * x, u = x - 0.5;
    const double* const c = &to.added[3 * k];
    const double p = c[0] + u * (c[1] + u * c[2]), dp = c[1] + 2.0 * u * c[2], ddp = 2.0 * c[2];
    value += t * t * t * p;
    slope += t * t * (3.0 * dt * p + t * dp);
    bend += t * (6.0 * (dt * dt - t) * p + 6.0 * t * dt * dp + t * t * ddp);
  }
  return {value, slope / h, bend / (h * h)};
}

std::vector<double> ForcedMotion::between(const Sample& from, const Sample& to, double time) const {
  const std::size_t n = equations_.freedoms();
  std::vector<double> y(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const DriverState at = course(from, to, k, time);
    y[k] = at.value;
    y[n + k] = at.rate;
  }
  return y;
}

std::vector<double> ForcedMotion::added_to_meet(const Sample& middle, const Sample& from,
                                                const Sample& to) const {
  const std::size_t n = equations_.freedoms();
  const double h = to.time - from.time;
  std::vector<double> added;
  for (std::size_t k = 0; k < n; ++k) {
    const DriverState at = course(from, to, k, middle.time);
    const double d = middle.y[k] - at.value, e = h * (middle.y[n + k] - at.rate),
                 f = h * h * (middle.accelerations[k] - at.acceleration);
    added.insert(added.end(), {64.0 * d, 64.0 * e, 768.0 * d + 32.0 * f});
  }
  return added;
}

bool ForcedMotion::follows(const Tree& tree, const Sample& from, const Sample& to) const {
  const std::size_t n = equations_.freedoms();
  const double h = to.time - from.time;
  State state;
  state.touches = from.touches;
  // The error goes by (x (x - 1/2) (1 - x))^3, largest at these x; there it has none in the rate,
  // which has at most 8.1/h times as much elsewhere, and 108/h^2 times as much in the acceleration.
  const double aside = std::sqrt(1.0 / 12.0);
  for (const double x : {0.5 - aside, 0.5 + aside}) {
    const double time = from.time + x * h;
    const std::vector<double> y = between(from, to, time);
    const std::optional<Loops::Sample> closed = equations_.place(tree, y, time, from.loops, state);
    if (!closed) return false;
    const ForcedEquations::Solution of = equations_.solve(tree, state, *closed, from.slips);
    if (of.unsolved) return false;
    for (std::size_t k = 0; k < n; ++k) {
      const double acceleration = equations_.acceleration_of(of, k);
      const double off =
          h * h / 108.0 * std::abs(acceleration - course(from, to, k, time).acceleration);
      if (!is_near(off, 8.1 / h, y[k], y[n + k])) return false;
    }
  }
  return true;
}

bool ForcedMotion::is_near(double off, double to_rate, double value, double rate) const {
  const double bound = 100.0 * tolerance_;
  return off <= bound * (1.0 + std::abs(value)) && to_rate * off <= bound * (1.0 + std::abs(rate));
}

void ForcedMotion::refine(const Tree& tree, const Sample& from, Sample& to, int depth,
                          Effort& effort, std::vector<Sample>& kept) const {
  if (depth == 0) return;
  const double time = 0.5 * (from.time + to.time);
  if (to.time - from.time <= gap_) return;
  const Step half = step_from(tree, from, time - from.time, effort);
  if (!half.followed) return;
  Sample middle = half.end;
  const std::vector<double> y = between(from, to, time);
  // The error of degree 5 goes by (x (1 - x))^3, largest in the middle; that of its rate is none
  // there and at most 3.5/h times as large.
  const std::size_t n = equations_.freedoms();
  bool near = true;
  for (std::size_t k = 0; k < n; ++k)
    near =
        near && is_near(std::abs(y[k] - middle.y[k]), 3.5 / (to.time - from.time), y[k], y[n + k]);
  if (near) return;
  know_accelerations(tree, middle);
  to.added = added_to_meet(middle, from, to);
  if (follows(tree, from, to)) return;
  to.added.clear();
  refine(tree, from, middle, depth - 1, effort, kept);
  kept.push_back(middle);
  refine(tree, middle, to, depth - 1, effort, kept);
}

void ForcedMotion::set(const Tree& tree, State& state) const {
  const double time = state.time;
  const auto later =
      std::upper_bound(samples_.begin(), samples_.end(), time,
                       [](double at, const Sample& sample) { return at < sample.time; });
  const Sample& before = later == samples_.begin() ? *later : *(later - 1);
  state.touches = before.touches;
  if (before.time == time)
    equations_.set(state, before.y);
  else if (later != samples_.begin() && later != samples_.end())
    equations_.set(state, between(before, *later, time));
  else {
    Effort effort;
    const Sample there = advanced(tree, before, time, effort);
    state.touches = there.touches;
    equations_.set(state, there.y);
  }
}

void ForcedMotion::settle_contacts(const Tree& tree, Sample& at,
                                   std::vector<SlipChange>* found) const {
  if (!equations_.sticking()) return;
  State state;
  state.touches = at.touches;
  const std::optional<Loops::Sample> closed =
      equations_.place(tree, at.y, at.time, at.loops, state);
  if (!closed) return;
  const std::vector<Slip> before = at.slips;
  if (!before.empty()) {
    const ForcedEquations::Solution of = equations_.solve(tree, state, *closed, before);
    if (of.unsolved) equations_.say_unsolved(tree, at.time, *of.unsolved);
    bool settled = of.go_on;
    for (std::size_t j = 0; j < equations_.laws().size(); ++j) {
      const bool sticks = can_stick(equations_.laws()[j]) && before[j] == Slip::none;
      const double v = sliding_velocity_of(tree.mechanism(), equations_.contacts()[j], state);
      settled = settled && !(sticks && std::abs(v) > turning_back * equations_.rest());
    }
    if (settled) return;
  }
  ForcedEquations::Response response = equations_.response_in(tree, state, *closed);
  if (response.unsolved) equations_.say_unsolved(tree, at.time, *response.unsolved);
  const std::vector<char> stands =
      standing_contacts(equations_.laws(), before, response.of.velocity, equations_.rest());
  const Eigen::VectorXd held = response.by_friction * holding_impulses(response.of, stands);
  for (std::size_t k = 0; k < equations_.freedoms(); ++k)
    at.y[equations_.freedoms() + k] += held[static_cast<Eigen::Index>(k)];
  for (std::size_t j = 0; j < equations_.laws().size(); ++j)
    if (stands[j] != 0) response.of.velocity[static_cast<Eigen::Index>(j)] = 0.0;
  at.slips =
      decide_sticking(equations_.laws(), response.of, stands, equations_.names(), at.time).slips;
  at.accelerations.clear();
  if (found == nullptr || before.empty()) return;
  for (const SlipChange& change : changes_between(equations_.names(), before, at.slips, at.time))
    found->push_back(change);
}

const std::vector<Slip>& ForcedMotion::slips_at(double time) const {
  const auto later =
      std::upper_bound(samples_.begin(), samples_.end(), time,
                       [](double at, const Sample& sample) { return at < sample.time; });
  return (later == samples_.begin() ? later : later - 1)->slips;
}

void ForcedMotion::accelerate(const Tree& tree, State& state, const Loops::Sample& closed) const {
  equations_.accelerate(tree, state, closed, slips_at(state.time));
}

}  // namespace boxbeam::spatial
