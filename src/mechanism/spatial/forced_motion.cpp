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

std::optional<Loops::Sample> ForcedMotion::place(const Tree& tree, const std::vector<double>& y,
                                                 double time, const Loops::Sample& near,
                                                 State& state) const {
  tree.drive(state, time);
  set(state, y);
  if (loops_ != nullptr) return loops_->close_beside(near, tree, state);
  tree.move(state);
  return Loops::Sample{};
}

void ForcedMotion::know_accelerations(const Tree& tree, Sample& at) const {
  State state;
  state.touches = at.touches;
  const Loops::Sample closed = place(tree, at.y, at.time, at.loops, state).value_or(at.loops);
  const Solution of = solve(tree, state, closed, at.slips);
  if (of.unsolved) say_unsolved(tree, at.time, *of.unsolved);
  at.accelerations.clear();
  for (std::size_t k = 0; k < joints_.size(); ++k)
    at.accelerations.push_back(of.accelerations[static_cast<Eigen::Index>(k)] / scales_[k]);
}

DriverState ForcedMotion::course(const Sample& from, const Sample& to, std::size_t k,
                                 double time) const {
  const std::size_t n = joints_.size();
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
  const std::size_t n = joints_.size();
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
  const std::size_t n = joints_.size();
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
  const std::size_t n = joints_.size();
  const double h = to.time - from.time;
  State state;
  state.touches = from.touches;
  // The error goes by (x (x - 1/2) (1 - x))^3, largest at these x; there it has none in the rate,
  // which has at most 8.1/h times as much elsewhere, and 108/h^2 times as much in the acceleration.
  const double aside = std::sqrt(1.0 / 12.0);
  for (const double x : {0.5 - aside, 0.5 + aside}) {
    const double time = from.time + x * h;
    const std::vector<double> y = between(from, to, time);
    const std::optional<Loops::Sample> closed = place(tree, y, time, from.loops, state);
    if (!closed) return false;
    const Solution of = solve(tree, state, *closed, from.slips);
    if (of.unsolved) return false;
    for (std::size_t k = 0; k < n; ++k) {
      const double acceleration = of.accelerations[static_cast<Eigen::Index>(k)] / scales_[k];
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
  const std::size_t n = joints_.size();
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

void ForcedMotion::move(const Tree& tree, State& state, const Loops::Sample& closed,
                        const Eigen::VectorXd& accelerations) const {
  for (std::size_t k = 0; k < joints_.size(); ++k)
    state.coordinates[joints_[k]].acceleration = accelerations[static_cast<Eigen::Index>(k)];
  if (loops_ != nullptr && loops_->freedoms() > 0) {
    const Eigen::VectorXd led = closed.following * accelerations;
    for (std::size_t f = 0; f < loops_->joints().size(); ++f)
      state.coordinates[loops_->joints()[f]].acceleration += led[static_cast<Eigen::Index>(f)];
  }
  tree.accelerate(state);
}

ForcedMotion::Response ForcedMotion::response_in(const Tree& tree, const State& state,
                                                 const Loops::Sample& closed) const {
  const Mechanism& mechanism = tree.mechanism();
  const auto n = static_cast<Eigen::Index>(joints_.size());
  const auto rubbing = static_cast<Eigen::Index>(contacts_.size());
  const auto bodies = static_cast<Eigen::Index>(mechanism.bodies.size());
  // What moves with each coordinate, and what is asked of the joints without its acceleration.
  std::vector<Wrench> wrenches;
  tree.wrenches(state, {}, wrenches);
  Eigen::MatrixXd velocity(6 * bodies, n), momentum(6 * bodies, n), sliding(rubbing, n);
  Eigen::VectorXd asked = Eigen::VectorXd::Zero(n);
  State moving = state;
  for (DriverState& of : moving.coordinates) of.rate = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t own = joints_[static_cast<std::size_t>(k)];
    const double scale = scales_[static_cast<std::size_t>(k)];
    const auto turn = [&](std::size_t i, double rate) {
      moving.coordinates[i].rate = rate;
      const Joint& joint = mechanism.joints[i];
      const Eigen::Vector3d axis = in_world(state, joint.parent, joint.axis);
      asked[k] += rate * along_coordinate(joint, axis, wrenches[i]);
    };
    turn(own, scale);
    if (loops_ != nullptr) {
      for (std::size_t f = 0; f < loops_->joints().size(); ++f)
        turn(loops_->joints()[f], scale * closed.following(static_cast<Eigen::Index>(f), k));
    }
    tree.move_at_rates(moving);
    for (Eigen::Index b = 0; b < bodies; ++b) {
      const Body& body = mechanism.bodies[static_cast<std::size_t>(b)];
      const BodyMotion& of = moving.bodies[static_cast<std::size_t>(b)];
      const Eigen::Vector3d centre = velocity_of(moving, {static_cast<int>(b), body.centre});
      const Eigen::Vector3d omega = of.R_WB.transpose() * of.omega;
      velocity.col(k).segment<6>(6 * b) << centre, omega;
      momentum.col(k).segment<6>(6 * b) << body.mass * centre, body.inertia * omega;
    }
    for (Eigen::Index j = 0; j < rubbing; ++j)
      sliding(j, k) =
          sliding_velocity_of(mechanism, contacts_[static_cast<std::size_t>(j)], moving);
    moving.coordinates[own].rate = 0.0;
  }
  const Eigen::MatrixXd inertia = velocity.transpose() * momentum;
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
  const auto moved_by = [&](const Eigen::VectorXd& power) -> Eigen::VectorXd {
    return pivots.solve(power.cwiseQuotient(root)).cwiseQuotient(root);
  };
  of.accelerations = moved_by(-asked);
  of.by_friction.resize(n, rubbing);
  of.of = FrictionResponse(contacts_.size());
  if (rubbing == 0) return of;
  const Eigen::Map<const Eigen::VectorXd> scales(scales_.data(), n);
  std::vector<double> forces(contacts_.size(), 0.0);
  // What guides carry where it is accelerated so.
  const auto loaded = [&](const Eigen::VectorXd& accelerations) {
    moving = state;
    move(tree, moving, closed, scales.cwiseProduct(accelerations));
    wrenches_beside_friction(tree, loops_, moving, contacts_, forces, wrenches);
    Eigen::VectorXd loads(6 * rubbing);
    for (Eigen::Index j = 0; j < rubbing; ++j)
      loads.segment<6>(6 * j) =
          guide_load_of(mechanism, contacts_[static_cast<std::size_t>(j)], moving, wrenches);
    return loads;
  };
  of.of.load_0 = loaded(of.accelerations);
  for (Eigen::Index j = 0; j < rubbing; ++j) {
    const FrictionContact& contact = contacts_[static_cast<std::size_t>(j)];
    of.of.velocity[j] = sliding_velocity_of(mechanism, contact, state);
    of.of.rate_0[j] = sliding_acceleration_of(mechanism, contact, moving);
    of.by_friction.col(j) = moved_by(sliding.row(j).transpose());
  }
  of.of.rate = sliding * of.by_friction;
  // Per unit of each friction force; of the size of what acts without them.
  double unit = 1.0;
  for (const Wrench& joint : wrenches) unit = std::max(unit, joint.force.norm());
  for (Eigen::Index j = 0; j < rubbing; ++j) {
    forces[static_cast<std::size_t>(j)] = unit;
    of.of.load.col(j) =
        (loaded(of.accelerations + unit * of.by_friction.col(j)) - of.of.load_0) / unit;
    forces[static_cast<std::size_t>(j)] = 0.0;
  }
  return of;
}

ForcedMotion::Solution ForcedMotion::solve(const Tree& tree, const State& state,
                                           const Loops::Sample& closed,
                                           const std::vector<Slip>& slips) const {
  const Response response = response_in(tree, state, closed);
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
  const std::optional<Loops::Sample> closed = place(tree, at.y, at.time, at.loops, state);
  if (!closed) return;
  const std::vector<Slip> before = at.slips;
  if (!before.empty()) {
    const Solution of = solve(tree, state, *closed, before);
    if (of.unsolved) say_unsolved(tree, at.time, *of.unsolved);
    bool settled = of.go_on;
    for (std::size_t j = 0; j < laws_.size(); ++j) {
      const bool sticks = can_stick(laws_[j]) && before[j] == Slip::none;
      const double v = sliding_velocity_of(tree.mechanism(), contacts_[j], state);
      settled = settled && !(sticks && std::abs(v) > turning_back * rest_);
    }
    if (settled) return;
  }
  Response response = response_in(tree, state, *closed);
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

void ForcedMotion::accelerate(const Tree& tree, State& state, const Loops::Sample& closed) const {
  accelerate(tree, state, closed, slips_at(state.time));
}

void ForcedMotion::accelerate(const Tree& tree, State& state, const Loops::Sample& closed,
                              const std::vector<Slip>& slips) const {
  Solution of = solve(tree, state, closed, slips);
  if (of.unsolved) say_unsolved(tree, state.time, *of.unsolved);
  state.friction = std::move(of.friction);
  move(tree, state, closed, of.accelerations);
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
