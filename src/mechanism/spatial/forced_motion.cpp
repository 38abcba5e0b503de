#include "boxbeam/mechanism/spatial/forced_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/core/error.hpp"
#include "loop_rows.hpp"

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
         "joint " + spring.name,
         0.0,
         {},
         {},
         {}});
  }
}

/// Pivots of the inertia matrix without units: below it an acceleration is not determined.
constexpr double no_mass = 1e-12;

}  // namespace

ForcedMotion::ForcedMotion(const Tree& tree, const Loops* loops, double tolerance)
    : loops_(loops), tolerance_(tolerance), contacts_(friction_contacts_of(tree.mechanism())) {
  const Mechanism& mechanism = tree.mechanism();
  const double size = size_of(mechanism);
  rest_ = 100.0 * tolerance * size;
  for (const FrictionContact& contact : contacts_) {
    laws_.push_back(contact.law);
    names_.push_back(name_of_contact(mechanism, contact));
  }
  sticking_ = std::any_of(laws_.begin(), laws_.end(), can_stick);
  one_sided_ = std::any_of(mechanism.springs.begin(), mechanism.springs.end(),
                           [](const Spring& of) { return of.acts != Spring::Acts::both; });
  Sample start;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (!is_forced(joint)) continue;
    joints_.push_back(i);
    scales_.push_back(is_angle(joint.kind) ? 1.0 : size);
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
  start.touches.resize(mechanism.springs.size());
  State first;
  if (place(tree, start.y, 0.0, start.loops, first)) require_within_clearance(mechanism, first);
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

bool ForcedMotion::place(const Tree& tree, const std::vector<double>& y, double time,
                         const Loops::Sample& near, State& state) const {
  tree.drive(state, time);
  set(state, y);
  if (loops_ != nullptr) return loops_->close_beside(near, tree, state).has_value();
  tree.move(state);
  return true;
}

void ForcedMotion::know_accelerations(const Tree& tree, Sample& at) const {
  State state;
  state.touches = at.touches;
  static_cast<void>(place(tree, at.y, at.time, at.loops, state));
  const Solution of = solve(tree, state, at.slips);
  if (of.unsolved) say_unsolved(tree, at.time, *of.unsolved);
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
                          Effort& effort, std::vector<Sample>& kept) const {
  constexpr double wider = 100.0;
  if (depth == 0) return;
  const double time = 0.5 * (from.time + to.time);
  // Both sides of a change, as near as times can be told apart.
  if (to.time - from.time <= 4e-13 * std::abs(time)) return;
  const Step half = step_from(tree, from, time - from.time, effort);
  if (!half.followed) return;
  Sample middle = half.end;
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
  refine(tree, from, middle, depth - 1, effort, kept);
  kept.push_back(middle);
  refine(tree, middle, to, depth - 1, effort, kept);
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
  state.touches = before.touches;
  if (before.time == time)
    set(state, before.y);
  else if (later != samples_.begin() && later != samples_.end())
    set(state, between(before, *later, time));
  else {
    Effort effort;
    const Sample there = advanced(tree, before, time, effort);
    state.touches = there.touches;
    set(state, there.y);
  }
}

void ForcedMotion::move(const Tree& tree, State& state) const {
  if (loops_ != nullptr)
    loops_->accelerate(tree, state);
  else
    tree.move(state);
}

ForcedMotion::Response ForcedMotion::response_in(const Tree& tree, State& state) const {
  constexpr double unit = 1e3;  // of acceleration: far above round-off of what acts without it
  const Mechanism& mechanism = tree.mechanism();
  const auto n = static_cast<Eigen::Index>(joints_.size());
  const auto rubbing = static_cast<Eigen::Index>(contacts_.size());
  std::vector<Wrench> wrenches;
  // What joints carry along their axes, then what guides carry, beside friction forces.
  const auto carried = [&](const std::vector<double>& friction) {
    wrenches_beside_friction(tree, loops_, state, contacts_, friction, wrenches);
    Eigen::VectorXd of(n + 6 * rubbing);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = joints_[static_cast<std::size_t>(k)];
      const Joint& joint = mechanism.joints[i];
      const Eigen::Vector3d axis = in_world(state, joint.parent, joint.axis);
      of[k] = scales_[static_cast<std::size_t>(k)] * along_coordinate(joint, axis, wrenches[i]);
    }
    for (Eigen::Index j = 0; j < rubbing; ++j)
      of.segment<6>(n + 6 * j) =
          guide_load_of(mechanism, contacts_[static_cast<std::size_t>(j)], state, wrenches);
    return of;
  };
  for (const std::size_t i : joints_) state.coordinates[i].acceleration = 0.0;
  const auto sliding = [&] {
    Eigen::VectorXd rates(rubbing);
    for (Eigen::Index j = 0; j < rubbing; ++j)
      rates[j] = sliding_acceleration_of(mechanism, contacts_[static_cast<std::size_t>(j)], state);
    return rates;
  };
  move(tree, state);
  const Eigen::VectorXd without = carried({});
  const Eigen::VectorXd sliding_without = sliding();
  // Per unit of each friction force; of the size of what acts without them.
  Eigen::MatrixXd by_friction(without.size(), rubbing);
  double force = 1.0;
  for (const Wrench& joint : wrenches) force = std::max(force, joint.force.norm());
  for (Eigen::Index j = 0; j < rubbing; ++j) {
    std::vector<double> forces(contacts_.size(), 0.0);
    forces[static_cast<std::size_t>(j)] = force;
    by_friction.col(j) = (carried(forces) - without) / force;
  }
  Eigen::MatrixXd by_acceleration(without.size(), n), sliding_by_acceleration(rubbing, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    double& acceleration = state.coordinates[joints_[static_cast<std::size_t>(k)]].acceleration;
    acceleration = unit * scales_[static_cast<std::size_t>(k)];
    move(tree, state);
    by_acceleration.col(k) = (carried({}) - without) / unit;
    sliding_by_acceleration.col(k) = (sliding() - sliding_without) / unit;
    acceleration = 0.0;
  }
  const Eigen::MatrixXd inertia = by_acceleration.topRows(n);
  Response of;
  of.accelerations = Eigen::VectorXd::Zero(n);
  Eigen::Index least = 0;
  if (!inertia.allFinite() || !(inertia.diagonal().minCoeff(&least) > 0.0)) {
    of.unsolved = {joints_[static_cast<std::size_t>(least)], false};
    return of;
  }
  const Eigen::VectorXd root = inertia.diagonal().cwiseSqrt();
  const Eigen::LDLT<Eigen::MatrixXd> pivots(root.cwiseInverse().asDiagonal() * inertia *
                                            root.cwiseInverse().asDiagonal());
  Eigen::VectorXi order =
      Eigen::VectorXi::LinSpaced(static_cast<int>(n), 0, static_cast<int>(n) - 1);
  order = pivots.transpositionsP() * order;
  if (!(pivots.vectorD().minCoeff(&least) > no_mass)) {
    of.unsolved = {joints_[static_cast<std::size_t>(order[least])], false};
    return of;
  }
  // The accelerations that leave these joints nothing to carry, in scales.
  const auto released = [&](const Eigen::VectorXd& along) -> Eigen::VectorXd {
    return -pivots.solve(along.cwiseQuotient(root)).cwiseQuotient(root);
  };
  of.accelerations = released(without.head(n));
  const Eigen::Index rows = 6 * rubbing;
  of.by_friction.resize(n, rubbing);
  of.of = FrictionResponse(contacts_.size());
  for (Eigen::Index j = 0; j < rubbing; ++j) {
    of.by_friction.col(j) = released(by_friction.col(j).head(n));
    of.of.velocity[j] =
        sliding_velocity_of(mechanism, contacts_[static_cast<std::size_t>(j)], state);
  }
  const Eigen::MatrixXd pressing = by_acceleration.bottomRows(rows);
  of.of.load_0 = without.tail(rows) + pressing * of.accelerations;
  of.of.load = by_friction.bottomRows(rows) + pressing * of.by_friction;
  of.of.rate_0 = sliding_without + sliding_by_acceleration * of.accelerations;
  of.of.rate = sliding_by_acceleration * of.by_friction;
  return of;
}

ForcedMotion::Solution ForcedMotion::solve(const Tree& tree, State& state,
                                           const std::vector<Slip>& slips) const {
  const Response response = response_in(tree, state);
  Solution of{response.accelerations, {}, true, response.unsolved};
  if (of.unsolved) return of;
  const auto n = static_cast<Eigen::Index>(joints_.size());
  if (!contacts_.empty()) {
    const auto friction = solve_friction(laws_, slips, response.of);
    if (!friction) {
      of.unsolved = {0, true};
      return of;
    }
    of.friction.assign(friction->begin(), friction->end());
    of.accelerations += response.by_friction * *friction;
    if (sticking_) {
      const Eigen::VectorXd load = response.of.load_0 + response.of.load * *friction;
      Eigen::VectorXd pressure(friction->size());
      for (Eigen::Index j = 0; j < pressure.size(); ++j)
        pressure[j] = pressure_of(laws_[static_cast<std::size_t>(j)], load.segment<6>(6 * j));
      of.go_on = slips_go_on(laws_, slips, response.of.velocity, *friction, pressure,
                             turning_back * rest_);
    }
  }
  for (Eigen::Index k = 0; k < n; ++k) of.accelerations[k] *= scales_[static_cast<std::size_t>(k)];
  return of;
}

void ForcedMotion::settle_contacts(const Tree& tree, Sample& at,
                                   std::vector<SlipChange>* found) const {
  if (!sticking_) return;
  State state;
  state.touches = at.touches;
  if (!place(tree, at.y, at.time, at.loops, state)) return;
  const std::vector<Slip> before = at.slips;
  if (!before.empty()) {
    const Solution of = solve(tree, state, before);
    if (of.unsolved) say_unsolved(tree, at.time, *of.unsolved);
    bool settled = of.go_on;
    for (std::size_t j = 0; j < laws_.size(); ++j) {
      const bool sticks = can_stick(laws_[j]) && before[j] == Slip::none;
      const double v = sliding_velocity_of(tree.mechanism(), contacts_[j], state);
      settled = settled && !(sticks && std::abs(v) > turning_back * rest_);
    }
    if (settled) return;
  }
  Response response = response_in(tree, state);
  if (response.unsolved) say_unsolved(tree, at.time, *response.unsolved);
  const std::vector<char> stands = standing_contacts(laws_, before, response.of.velocity, rest_);
  const Eigen::VectorXd held = response.by_friction * holding_impulses(response.of, stands);
  for (std::size_t k = 0; k < joints_.size(); ++k)
    at.y[joints_.size() + k] += held[static_cast<Eigen::Index>(k)];
  for (std::size_t j = 0; j < laws_.size(); ++j)
    if (stands[j] != 0) response.of.velocity[static_cast<Eigen::Index>(j)] = 0.0;
  at.slips = decide_sticking(laws_, response.of, stands, names_, at.time).slips;
  at.accelerations.clear();
  if (found == nullptr || before.empty()) return;
  for (const SlipChange& change : changes_between(names_, before, at.slips, at.time))
    found->push_back(change);
}

const std::vector<Slip>& ForcedMotion::slips_at(double time) const {
  const auto later =
      std::upper_bound(samples_.begin(), samples_.end(), time,
                       [](double at, const Sample& sample) { return at < sample.time; });
  return (later == samples_.begin() ? later : later - 1)->slips;
}

void ForcedMotion::accelerate(const Tree& tree, State& state) const {
  accelerate(tree, state, slips_at(state.time));
}

void ForcedMotion::accelerate(const Tree& tree, State& state,
                              const std::vector<Slip>& slips) const {
  Solution of = solve(tree, state, slips);
  if (of.unsolved) say_unsolved(tree, state.time, *of.unsolved);
  for (std::size_t k = 0; k < joints_.size(); ++k)
    state.coordinates[joints_[k]].acceleration = of.accelerations[static_cast<Eigen::Index>(k)];
  state.friction = std::move(of.friction);
  move(tree, state);
}

void ForcedMotion::say_unsolved(const Tree& tree, double time, const Unsolved& why) const {
  if (why.locked) say_locked_contacts(tree.mechanism(), contacts_, time);
  const std::string& name = tree.mechanism().joints[why.massless].name;
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

}  // namespace boxbeam::spatial
