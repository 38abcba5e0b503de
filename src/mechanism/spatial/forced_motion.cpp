#include "boxbeam/mechanism/spatial/forced_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "boxbeam/core/error.hpp"
#include "loop_rows.hpp"

namespace boxbeam::spatial {
namespace {

/// Bodies moved, at most: some ten seconds.
constexpr double most_work = 1e8;
/// Pivots of the inertia matrix without units: below it an acceleration is not determined.
constexpr double no_mass = 1e-12;

double smallest_step(double from, double to) {
  return 1e-13 * std::max(std::abs(from), std::abs(to)) + 1e-300;
}

}  // namespace

ForcedMotion::ForcedMotion(const Tree& tree, const Loops* loops, double tolerance)
    : loops_(loops), tolerance_(tolerance), size_(size_of(tree.mechanism())) {
  const Mechanism& mechanism = tree.mechanism();
  Sample start;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (!is_forced(joint)) continue;
    joints_.push_back(i);
    scales_.push_back(joint.kind == JointKind::revolute ? 1.0 : size_);
    start.y.push_back(joint.start / scales_.back());
  }
  for (std::size_t k = 0; k < joints_.size(); ++k)
    start.y.push_back(mechanism.joints[joints_[k]].start_rate / scales_[k]);
  const TimeSpan span = time_span_of(mechanism);
  const double until = span.begin + span.length;
  const double aside = 1e-12 * until;
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
  std::vector<Sample> steps{start};
  advanced(tree, start, until, &steps, &changes_);
  for (Sample& of : steps) know_accelerations(tree, of);
  samples_.push_back(steps.front());
  constexpr int most_halvings = 12;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    refine(tree, steps[i - 1], steps[i], most_halvings, samples_);
    samples_.push_back(steps[i]);
  }
}

void ForcedMotion::know_accelerations(const Tree& tree, Sample& at) const {
  State state;
  tree.drive(state, at.time);
  set(state, at.y);
  if (loops_ != nullptr)
    static_cast<void>(loops_->close_beside(at.loops, tree, state));
  else
    tree.move(state);
  const Solution of = solve(tree, state);
  if (!of.solved) say_massless(tree, at.time, of.massless);
  at.accelerations.clear();
  for (std::size_t k = 0; k < joints_.size(); ++k)
    at.accelerations.push_back(of.accelerations[static_cast<Eigen::Index>(k)] / scales_[k]);
}

std::vector<double> ForcedMotion::between(const Sample& from, const Sample& to, double time) const {
  const std::size_t n = joints_.size();
  const double h = to.time - from.time, x = (time - from.time) / h;
  std::vector<double> y(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const double q = from.y[k], v = h * from.y[n + k], a = 0.5 * h * h * from.accelerations[k];
    // What is left of value, slope and half the curvature at the end.
    const double d = to.y[k] - q - v - a, e = h * to.y[n + k] - v - 2.0 * a,
                 f = 0.5 * h * h * to.accelerations[k] - a;
    const double c3 = 10.0 * d - 4.0 * e + f, c4 = -15.0 * d + 7.0 * e - 2.0 * f,
                 c5 = 6.0 * d - 3.0 * e + f;
    y[k] = q + x * (v + x * (a + x * (c3 + x * (c4 + x * c5))));
    y[n + k] = (v + x * (2.0 * a + x * (3.0 * c3 + x * (4.0 * c4 + x * 5.0 * c5)))) / h;
  }
  return y;
}

void ForcedMotion::refine(const Tree& tree, const Sample& from, const Sample& to, int depth,
                          std::vector<Sample>& kept) const {
  constexpr double wider = 100.0;
  if (depth == 0) return;
  const double time = 0.5 * (from.time + to.time);
  Sample middle = advanced(tree, from, time, nullptr);
  const std::vector<double> y = between(from, to, time);
  // The error of a position goes by (x (1 - x))^3, largest in the middle; that of its rate is none
  // there and at most 3.5/h times as large.
  const std::size_t n = joints_.size();
  const double to_rate = 3.5 / (to.time - from.time);
  bool near = true;
  for (std::size_t k = 0; k < n; ++k) {
    const double off = std::abs(y[k] - middle.y[k]), bound = wider * tolerance_;
    near = near && off <= bound * (1.0 + std::abs(y[k])) &&
           to_rate * off <= bound * (1.0 + std::abs(y[n + k]));
  }
  if (near) return;
  know_accelerations(tree, middle);
  refine(tree, from, middle, depth - 1, kept);
  kept.push_back(middle);
  refine(tree, middle, to, depth - 1, kept);
}

void ForcedMotion::set(State& state, const std::vector<double>& y) const {
  for (std::size_t k = 0; k < joints_.size(); ++k)
    state.coordinates[joints_[k]] = {scales_[k] * y[k], scales_[k] * y[joints_.size() + k], 0.0};
}

void ForcedMotion::set(const Tree& tree, State& state) const {
  const double time = state.time;
  const auto later =
      std::upper_bound(samples_.begin(), samples_.end(), time,
                       [](double at, const Sample& sample) { return at < sample.time; });
  const Sample& before = later == samples_.begin() ? *later : *(later - 1);
  if (before.time == time)
    set(state, before.y);
  else if (later != samples_.begin() && later != samples_.end())
    set(state, between(before, *later, time));
  else
    set(state, advanced(tree, before, time, nullptr).y);
}

void ForcedMotion::move(const Tree& tree, State& state) const {
  if (loops_ != nullptr)
    loops_->accelerate(tree, state);
  else
    tree.move(state);
}

ForcedMotion::Solution ForcedMotion::solve(const Tree& tree, State& state) const {
  constexpr double unit = 1e3;  // of acceleration: far above round-off of what acts without it
  const auto n = static_cast<Eigen::Index>(joints_.size());
  std::vector<Wrench> wrenches;
  const auto carried = [&] {
    move(tree, state);
    if (loops_ != nullptr)
      loops_->wrenches(tree, state, wrenches);
    else
      tree.wrenches(state, {}, wrenches);
    Eigen::VectorXd along(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = joints_[static_cast<std::size_t>(k)];
      const Joint& joint = tree.mechanism().joints[i];
      const Eigen::Vector3d axis = in_world(state, joint.parent, joint.axis);
      along[k] =
          scales_[static_cast<std::size_t>(k)] *
          axis.dot(joint.kind == JointKind::revolute ? wrenches[i].moment : wrenches[i].force);
    }
    return along;
  };
  for (const std::size_t i : joints_) state.coordinates[i].acceleration = 0.0;
  const Eigen::VectorXd without = carried();
  Eigen::MatrixXd inertia(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    double& acceleration = state.coordinates[joints_[static_cast<std::size_t>(k)]].acceleration;
    acceleration = unit * scales_[static_cast<std::size_t>(k)];
    inertia.col(k) = (carried() - without) / unit;
    acceleration = 0.0;
  }
  Solution of;
  of.accelerations = Eigen::VectorXd::Zero(n);
  Eigen::Index least = 0;
  of.solved = inertia.allFinite() && inertia.diagonal().minCoeff(&least) > 0.0;
  of.massless = joints_[static_cast<std::size_t>(least)];
  if (!of.solved) return of;
  const Eigen::VectorXd root = inertia.diagonal().cwiseSqrt();
  const Eigen::LDLT<Eigen::MatrixXd> pivots(root.cwiseInverse().asDiagonal() * inertia *
                                            root.cwiseInverse().asDiagonal());
  Eigen::VectorXi order =
      Eigen::VectorXi::LinSpaced(static_cast<int>(n), 0, static_cast<int>(n) - 1);
  order = pivots.transpositionsP() * order;
  of.solved = pivots.vectorD().minCoeff(&least) > no_mass;
  of.massless = joints_[static_cast<std::size_t>(order[least])];
  if (!of.solved) return of;
  of.accelerations = -pivots.solve(without.cwiseQuotient(root)).cwiseQuotient(root);
  for (Eigen::Index k = 0; k < n; ++k) of.accelerations[k] *= scales_[static_cast<std::size_t>(k)];
  return of;
}

void ForcedMotion::accelerate(const Tree& tree, State& state) const {
  const Solution of = solve(tree, state);
  if (!of.solved) say_massless(tree, state.time, of.massless);
  for (std::size_t k = 0; k < joints_.size(); ++k)
    state.coordinates[joints_[k]].acceleration = of.accelerations[static_cast<Eigen::Index>(k)];
  move(tree, state);
}

ForcedMotion::Step ForcedMotion::step_from(const Tree& tree, const Sample& from, double dt) const {
  using Vector = std::vector<double>;
  const std::size_t n = joints_.size();
  Step step;
  State state;
  Loops::Sample near = from.loops;
  const auto close = [&](const Vector& y, double time) {
    tree.drive(state, time);
    set(state, y);
    return loops_ == nullptr || loops_->close_beside(near, tree, state).has_value();
  };
  std::optional<std::vector<char>> acting;  // at the beginning
  const auto rates = [&](const Vector& y, Vector& rate, double time) {
    std::fill(rate.begin(), rate.end(), 0.0);
    step.followed = step.followed && close(y, time);
    if (!step.followed) return;
    if (loops_ == nullptr) tree.move(state);
    const std::vector<char> now = acting_in(tree.mechanism(), state);
    if (!acting)
      acting = now;
    else if (now != *acting && time != from.time)
      step.change = std::min(step.change, (time - from.time) / dt);
    const Solution of = solve(tree, state);
    if (!of.solved) step.massless = of.massless;
    step.followed = of.solved;
    std::copy_n(y.begin() + static_cast<std::ptrdiff_t>(n), n, rate.begin());
    for (std::size_t k = 0; k < n; ++k)
      rate[n + k] = of.accelerations[static_cast<Eigen::Index>(k)] / scales_[k];
  };
  Vector error(2 * n), begin(2 * n);
  rates(from.y, begin, from.time);
  if (loops_ != nullptr && step.followed) {
    // With the accelerations that forces give there, the loops are near it for longer.
    for (std::size_t k = 0; k < n; ++k)
      state.coordinates[joints_[k]].acceleration = scales_[k] * begin[n + k];
    move(tree, state);
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
  step.followed = step.followed && std::isfinite(step.error) && close(step.end.y, step.end.time);
  if (!step.followed) return step;
  if (loops_ != nullptr)
    step.end.loops = loops_->sample_of(state);
  else
    tree.move(state);
  step.changes = *acting != acting_in(tree.mechanism(), state);
  return step;
}

std::vector<char> ForcedMotion::acting_in(const Mechanism& mechanism, const State& state) {
  std::vector<char> acting;
  for (const Spring& spring : mechanism.springs) {
    if (spring.acts == Spring::Acts::both) continue;
    const double tension = tension_of(spring, state).value;
    acting.push_back((spring.acts == Spring::Acts::pulling ? tension : -tension) > 0.0 ? 1 : 0);
  }
  return acting;
}

double ForcedMotion::until_another_acts(const Tree& tree, const Sample& from) const {
  constexpr double over = 1.05;  // beyond it, so that the step sees it
  double until = std::numeric_limits<double>::infinity();
  const std::vector<Spring>& springs = tree.mechanism().springs;
  if (std::all_of(springs.begin(), springs.end(),
                  [](const Spring& of) { return of.acts == Spring::Acts::both; }))
    return until;
  State state;
  tree.drive(state, from.time);
  set(state, from.y);
  if (loops_ != nullptr && !loops_->close_beside(from.loops, tree, state)) return until;
  if (loops_ == nullptr) tree.move(state);
  accelerate(tree, state);
  for (const Spring& spring : springs) {
    if (spring.acts == Spring::Acts::both) continue;
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
  return until;
}

std::optional<ForcedMotion::Step> ForcedMotion::step_to_change(const Tree& tree, const Sample& from,
                                                               Step step, double& dt) const {
  // What only a stage saw is rough, or a contact shorter than the step.
  if (!step.changes) return std::nullopt;
  // As near as arithmetic can: a stage beyond it would count a hard stop over all of the step.
  const double near = smallest_step(from.time, from.time + dt);
  double low = 0.0, high = dt;
  while (std::abs(high - low) > near) {
    const double middle = 0.5 * (low + high);
    Step half = step_from(tree, from, middle);
    if (!half.followed) return std::nullopt;
    if (half.changes) {
      high = middle;
      step = std::move(half);
    } else {
      low = middle;
    }
  }
  // A stage before it that has them otherwise is no part of this motion.
  if (step.error > 1.0 || step.change < 1.0) return std::nullopt;
  dt = high;
  return step;
}

void ForcedMotion::say_massless(const Tree& tree, double time, std::size_t joint) {
  const std::string& name = tree.mechanism().joints[joint].name;
  throw AnalysisError(
      {fmt::format(
           "how forces move joint \"{}\" is not determined: nothing that it moves has a mass "
           "or inertia there, or two of its turns lie in line (give its axes another order); a "
           "beam has an "
           "inertia about its own axis with rotary_inertia = true",
           name),
       "joint " + name,
       time,
       {},
       {},
       {}});
}

ForcedMotion::Sample ForcedMotion::advanced(const Tree& tree, Sample from, double until,
                                            std::vector<Sample>* kept,
                                            std::vector<double>* changes) const {
  const double direction = until < from.time ? -1.0 : 1.0;
  const double smallest = smallest_step(from.time, until);
  const double passes =
      static_cast<double>(joints_.size() + 1) *
      static_cast<double>(tree.mechanism().bodies.size() + 10 * tree.mechanism().closing.size());
  constexpr double stages = 13.0;
  const std::vector<Spring>& springs = tree.mechanism().springs;
  const bool sided = std::any_of(springs.begin(), springs.end(),
                                 [](const Spring& of) { return of.acts != Spring::Acts::both; });
  double dt = until - from.time, work = 0.0;
  if (kept != nullptr) dt /= 16.0;
  int steps = 0;
  while (direction * (until - from.time) > smallest) {
    double stop = until;
    for (const double at : stops_) {
      const bool ahead = direction * (at - from.time) > smallest;
      if (ahead && direction * (stop - at) > 0.0) stop = at;
    }
    const double wanted = dt;
    const double change = std::max(smallest, until_another_acts(tree, from));
    if (std::abs(dt) > change) dt = direction * change;
    if (direction * (from.time + dt - stop) > -smallest) dt = stop - from.time;
    work += stages * passes;
    if (work > most_work) {
      throw AnalysisError(
          {fmt::format(
               "the motion under the applied forces takes too much work: {} steps have not "
               "led to its end; look for a spring that is far too stiff, a mass that is far "
               "too small or a [motion] duration that is far too long",
               steps),
           "mechanism",
           from.time,
           {},
           {},
           {}});
    }
    Step step = step_from(tree, from, dt);
    if (!step.followed || step.error > 1.0) {
      // The order of the error estimate is eight; Source: Hairer, Norsett, Wanner (1993), II.4.
      dt *= step.followed ? std::max(0.2, 0.9 * std::pow(step.error, -1.0 / 8.0)) : 0.25;
      if (std::abs(dt) > smallest) continue;
      if (step.massless) say_massless(tree, from.time, *step.massless);
      throw AnalysisError(
          {loops_ != nullptr && !step.followed
               ? "the loops cannot be followed further: what forces move and the drivers no longer "
                 "determine them there (a dead point), or two branches meet"
               : "the motion under the applied forces cannot be integrated further: it changes "
                 "faster than the arithmetic can follow (far too stiff a spring)",
           "mechanism",
           from.time,
           {},
           {},
           {}});
    }
    if (sided && !step.changes && !(step.change < 1.0)) {
      // What begins and ends to act between two stages is seen between the ends of the step.
      constexpr int looks = 24;
      if (from.accelerations.empty()) know_accelerations(tree, from);
      know_accelerations(tree, step.end);
      State state;
      std::optional<std::vector<char>> acting;
      double seen = 0.0;
      for (int i = 0; i < looks && seen == 0.0; ++i) {
        const double at = from.time + dt * i / looks;
        tree.drive(state, at);
        set(state, i == 0 ? from.y : between(from, step.end, at));
        if (loops_ == nullptr)
          tree.move(state);
        else if (!loops_->close_beside(from.loops, tree, state))
          break;
        const std::vector<char> now = acting_in(tree.mechanism(), state);
        if (!acting)
          acting = now;
        else if (now != *acting)
          seen = at - from.time;
      }
      if (seen != 0.0 && std::abs(seen) > smallest) {
        dt = seen;
        continue;
      }
    }
    if (step.change < 1.0 || step.changes) {
      std::optional<Step> until_change = step_to_change(tree, from, step, dt);
      if (!until_change && std::abs(dt) > smallest) {
        dt *= 0.5;
        continue;
      }
      if (until_change) step = *std::move(until_change);
    }
    // Its own error is that of the first and the last stages: two halves see the others, too.
    constexpr double apart = 10.0;
    const Step half = step_from(tree, from, 0.5 * dt);
    double off = std::numeric_limits<double>::infinity();
    if (half.followed) {
      const Step rest = step_from(tree, half.end, 0.5 * dt);
      if (rest.followed) off = 0.0;
      for (std::size_t k = 0; k < step.end.y.size(); ++k) {
        const double bound = tolerance_ * (1.0 + std::abs(step.end.y[k]));
        off = std::max(off, std::abs(rest.end.y[k] - step.end.y[k]) / bound);
      }
    }
    if (!(off <= apart) && std::abs(dt) > smallest) {
      dt *= 0.5;
      continue;
    }
    if (step.changes && changes != nullptr) changes->push_back(step.end.time);
    const double longer = 0.9 * std::pow(std::max(step.error, 1e-9), -1.0 / 8.0);
    const double next = std::abs(dt) * std::min(5.0, longer);
    dt = direction * std::max(next, std::abs(dt) < std::abs(wanted) ? std::abs(wanted) : 0.0);
    from = std::move(step.end);
    ++steps;
    if (kept != nullptr) kept->push_back(from);
  }
  from.time = until;
  return from;
}

}  // namespace boxbeam::spatial
