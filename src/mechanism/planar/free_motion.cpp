#include "boxbeam/mechanism/planar/free_motion.hpp"

#include <fmt/format.h>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"

namespace boxbeam::planar {
namespace {

// Pivots of the equations of motion by that of regular positions.
constexpr double near_singular = 2e-2;    ///< no step ends there
constexpr double beside_singular = 4e-3;  ///< where a step over a singular position may end
constexpr double singular = 1e-6;         ///< nothing is known any more

// Errors of a step in scaled coordinates.
constexpr double error_near_singular = 1e-8;
constexpr double error_of_passage = 1e-6;

/// Solutions of the equations of motion times coordinates, at most: some ten seconds. Of few
/// coordinates a solution costs as much as of `fewest_coordinates`.
constexpr double most_work = 1e8;
constexpr double fewest_coordinates = 9.0;

/// Where steps end because drivers or forces bend or jump there: just before and just behind each
/// such time between two, in their direction.
std::vector<double> stops_between(const Mechanism& mechanism, double from, double to) {
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  const double aside = 1e-12 * std::max({std::abs(low), std::abs(high), high - low});
  std::vector<double> stops;
  for (const Break& at : breaks_of(functions_of(mechanism), low, high)) {
    for (const double stop : {at.at - aside, at.at + aside}) {
      if (stop > low && stop < high) stops.push_back(stop);
    }
  }
  if (to < from) std::reverse(stops.begin(), stops.end());
  return stops;
}

/// The longest step in which dry friction cannot turn round unseen: half of the time in which a
/// sliding velocity comes to rest, and within the creep velocity half of the time that this takes.
double longest_with_friction(const Mechanism& mechanism, const State& state) {
  double longest = std::numeric_limits<double>::infinity();
  for (const FrictionContact& contact : friction_contacts_of(mechanism)) {
    if (contact.law.coulomb == 0.0 || can_stick(contact.law)) continue;
    const double speed = std::abs(sliding_velocity_of(contact, state.q, state.v));
    const double change = std::abs(sliding_velocity_of(contact, state.q, state.a));
    if (change > 0.0) longest = std::min(longest, 0.5 * (speed + contact.law.creep) / change);
  }
  return longest;
}

/// On which side of every guide that rubs it is pressed, and whether by a force or a moment:
/// friction bends where one of them changes.
std::vector<int> pressed_sides_of(const Mechanism& mechanism, const Eigen::VectorXd& lambda) {
  std::vector<int> sides;
  for (const FrictionContact& contact : friction_contacts_of(mechanism)) {
    if (contact.law.coulomb == 0.0) continue;
    const double force = lambda[contact.row];
    const double moment = contact.moment && contact.law.guide > 0.0
                              ? 2.0 * lambda[contact.row + 1] / contact.law.guide
                              : 0.0;
    const bool by_moment = std::abs(moment) > std::abs(force);
    const bool positive = (by_moment ? moment : force) > 0.0;
    sides.push_back((by_moment ? 2 : 0) + (positive ? 1 : 0));
  }
  return sides;
}

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

FreeSolver::FreeSolver(const Mechanism& mechanism, double tolerance, bool project)
    : mechanism_(&mechanism),
      tolerance_(tolerance),
      project_(project),
      one_sided_(one_sided_in(mechanism)),
      touching_(1e-13 * size_of(mechanism)),
      equations_(mechanism),
      laws_(laws_of(equations_.contacts())),
      names_(names_of(mechanism, equations_.contacts())),
      rest_(100.0 * tolerance * size_of(mechanism)) {
  sticking_ = std::any_of(laws_.begin(), laws_.end(), can_stick);
}

State FreeSolver::state_of(const State& known) {
  State state;
  state.time = known.time;
  state.q = known.q;
  state.v = known.v;
  state.touches = known.touches;
  state.slips = known.slips;
  if (state.touches.empty() && !one_sided_.empty()) {
    // Of what touches from the beginning no approach is known, and nothing is lost.
    state.touches.resize(mechanism_->forces.size());
    for (const OneSided& of : one_sided_)
      state.touches[of.force].on = depth_of(of, state.q, state.v).value > touching_;
  }
  if (sticking_ && state.slips.empty()) decide_contacts(state);
  if (!equations_.solve_rates(state)) {
    throw AnalysisError(
        {"accelerations are not determined: a freedom that no driver moves has no "
         "mass (give the body a mass and inertia, or drive it), or the mechanism "
         "stands exactly in a singular position",
         "mechanism",
         state.time,
         {},
         {}});
  }
  state.residual = equations_.residual();
  regular_ = std::max(regular_, equations_.smallest_pivot());
  return state;
}

State FreeSolver::start(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  Assembler assembler(*mechanism_);
  Assembly assembly = assembler.assemble(time, q);
  if (!assembly.closed) throw AnalysisError(failure_of_assembly(*mechanism_, time, assembly));
  constexpr int other_starts = 256;
  const std::string off = loops_off_branch(*mechanism_, assembly.q);
  for (int attempt = 1; !(assembly.closed && on_branch(*mechanism_, assembly.q)); ++attempt) {
    if (attempt > other_starts) {
      throw AnalysisError(
          {"no assembly found on the wanted branch; change the sign asked for, or "
           "the sketch",
           off,
           time,
           {},
           {}});
    }
    assembly = assembler.assemble(time, other_start(*mechanism_, q, attempt));
  }
  Eigen::VectorXd position = assembly.q;
  Eigen::VectorXd velocity = v;
  if (!equations_.project(time, position, velocity)) {
    throw AnalysisError(
        {"the motion starts in a singular position, where velocities cannot be moved "
         "onto the constraints; start beside it",
         "mechanism",
         time,
         {},
         {}});
  }
  State first;
  first.time = time;
  first.q = position;
  first.v = velocity;
  return state_of(first);
}

struct FreeSolver::Step {
  State end;
  bool solved = true;
  double error = 0.0;      ///< in tolerances
  double change = 1.0;     ///< of it, where a stage first has a contact that does not go on
  double pivot = 1.0;      ///< the smallest of its stages and its end
  double end_pivot = 1.0;  ///< of its end
};

bool FreeSolver::in_impact(const State& state) const {
  return std::any_of(one_sided_.begin(), one_sided_.end(), [&](const OneSided& of) {
    return of.law.impact && state.touches[of.force].on;
  });
}

double FreeSolver::beside_halves(const State& known, const Step& step) {
  const double half = 0.5 * (step.end.time - known.time);
  const Step first = step_from(known, half);
  if (!first.solved) return std::numeric_limits<double>::infinity();
  const Step second = step_from(first.end, half);
  if (!second.solved) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd& scale = equations_.constraints().col_scale();
  double largest = 0.0;
  for (const auto of : {&State::q, &State::v}) {
    const Eigen::ArrayXd end = (step.end.*of).cwiseQuotient(scale).array();
    const Eigen::ArrayXd halves = (second.end.*of).cwiseQuotient(scale).array();
    largest = std::max(largest, ((end - halves).abs() / (1.0 + end.abs())).maxCoeff());
  }
  return largest / tolerance_;
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

bool FreeSolver::is_near_singular(double pivot) const { return pivot < near_singular * regular_; }

FreeSolver::Step FreeSolver::step_from(const State& known, double dt) {
  using Vector = std::vector<double>;
  const Eigen::Index n = mechanism_->coordinates();
  const Eigen::VectorXd& scale = equations_.constraints().col_scale();
  Step step;
  State& end = step.end;
  end = known;
  const auto rates = [&](const Vector& y, Vector& rate, double t) {
    end.q = Eigen::Map<const Eigen::VectorXd>(y.data(), n).cwiseProduct(scale);
    end.v = Eigen::Map<const Eigen::VectorXd>(y.data() + n, n).cwiseProduct(scale);
    end.time = t;
    step.solved = step.solved && equations_.solve_rates(end);
    if (!step.solved) {
      std::fill(rate.begin(), rate.end(), 0.0);
      return;
    }
    step.pivot = std::min(step.pivot, equations_.smallest_pivot());
    if (sticking_ && t != known.time && !contacts_go_on(end))
      step.change = std::min(step.change, (t - known.time) / dt);
    Eigen::Map<Eigen::VectorXd>(rate.data(), n) = end.v.cwiseQuotient(scale);
    Eigen::Map<Eigen::VectorXd>(rate.data() + n, n) = end.a.cwiseQuotient(scale);
  };
  Vector y(static_cast<std::size_t>(2 * n)), next(y.size()), error(y.size()), rate(y.size());
  Eigen::Map<Eigen::VectorXd>(y.data(), n) = known.q.cwiseQuotient(scale);
  Eigen::Map<Eigen::VectorXd>(y.data() + n, n) = known.v.cwiseQuotient(scale);
  boost::numeric::odeint::runge_kutta_fehlberg78<Vector> stepper;
  // The rates at its beginning are known.
  Eigen::Map<Eigen::VectorXd>(rate.data(), n) = known.v.cwiseQuotient(scale);
  Eigen::Map<Eigen::VectorXd>(rate.data() + n, n) = known.a.cwiseQuotient(scale);
  stepper.do_step(rates, y, rate, known.time, next, dt, error);
  for (std::size_t i = 0; i < y.size(); ++i) {
    step.error = std::max(step.error, std::abs(error[i]) / (tolerance_ * (1.0 + std::abs(y[i]))));
  }
  end.time = known.time + dt;
  end.q = Eigen::Map<const Eigen::VectorXd>(next.data(), n).cwiseProduct(scale);
  end.v = Eigen::Map<const Eigen::VectorXd>(next.data() + n, n).cwiseProduct(scale);
  step.solved = step.solved && end.q.allFinite() && end.v.allFinite();
  if (project_) step.solved = step.solved && equations_.project(end.time, end.q, end.v);
  // Where it ends must be regular as well.
  step.solved = step.solved && std::isfinite(step.error) && equations_.solve_rates(end);
  end.residual = equations_.residual();
  step.end_pivot = step.solved ? equations_.smallest_pivot() : 0.0;
  step.pivot = std::min(step.pivot, step.end_pivot);
  return step;
}

std::optional<FreeSolver::Step> FreeSolver::step_over(const State& known, double dt) {
  constexpr double longer = 1.05;
  const double longest = 4.0 * natural_;
  std::optional<Step> best;
  for (dt *= longer; std::abs(dt) < longest; dt *= longer) {
    Step step = step_from(known, dt);
    if (!step.solved || step.end_pivot < beside_singular * regular_) continue;
    if (step.error * tolerance_ > std::max(tolerance_, error_of_passage)) continue;
    // What begins or ends to act there must be passed apart from it.
    if (first_change(known, step.end)) continue;
    if (!best || step.error < best->error) best = std::move(step);
  }
  return best;
}

const FreeSolver::Passage* FreeSolver::passage_of(const State& known) const {
  constexpr double same_motion = 1e-5;
  const Eigen::VectorXd& scale = equations_.constraints().col_scale();
  for (const Passage& passage : passages_) {
    const double way = passage.behind.time - passage.before.time;
    const double share = (known.time - passage.before.time) / way;
    if (share <= 0.0 || share >= 1.0) continue;
    const Eigen::VectorXd off = known.q - interpolate(known.time, passage.before, passage.behind).q;
    if (off.cwiseQuotient(scale).lpNorm<Eigen::Infinity>() < same_motion) return &passage;
  }
  return nullptr;
}

State FreeSolver::between(const Passage& passage, double time) {
  const auto reached = [&](const State& from, double until) -> std::optional<State> {
    Step step = step_from(from, until - from.time);
    if (!step.solved || step.end_pivot < beside_singular * regular_) return std::nullopt;
    if (step.error * tolerance_ > error_near_singular) return std::nullopt;
    return std::move(step.end);
  };
  State before = passage.before;
  State behind = passage.behind;
  const double way = behind.time - before.time;
  // Where it is regular enough, from the nearer end; else between two such places.
  const bool early = (time - before.time) / way < 0.5;
  if (auto state = reached(early ? before : behind, time)) return *state;
  for (double aside = way / 64.0; std::abs(aside) < std::abs(way); aside *= 2.0) {
    const bool from_before = (time - aside - before.time) / way > 0.0;
    const bool from_behind = (behind.time - time - aside) / way > 0.0;
    const auto left = from_before ? reached(before, time - aside) : before;
    const auto right = from_behind ? reached(behind, time + aside) : behind;
    if (!left || !right) continue;
    before = *left;
    behind = *right;
    break;
  }
  State state = interpolate(time, before, behind);
  const double share = (time - before.time) / (behind.time - before.time);
  state.lambda = (1.0 - share) * before.lambda + share * behind.lambda;
  state.touches = before.touches;
  state.friction = (1.0 - share) * before.friction + share * behind.friction;
  state.slips = before.slips;
  if (project_) {
    // The way back onto the constraints that needs no regular position.
    const Assembly closed = Assembler(*mechanism_).assemble(time, state.q);
    if (closed.closed) state.q = closed.q;
  }
  equations_.evaluate_at(time, state.q);
  state.residual = equations_.residual();
  return state;
}

bool FreeSolver::contacts_go_on(const State& state) const {
  const std::vector<FrictionContact>& contacts = equations_.contacts();
  const auto count = static_cast<Eigen::Index>(contacts.size());
  Eigen::VectorXd velocity(count), pressure(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts[static_cast<std::size_t>(j)];
    velocity[j] = sliding_velocity_of(contact, state.q, state.v);
    pressure[j] = pressure_on(contact, state.lambda);
  }
  return slips_go_on(laws_, state.slips, velocity, state.friction, pressure, turning_back * rest_);
}

double FreeSolver::contact_changes_within(const State& known, const Step& step) {
  // A step sees its stages only, and these roughly.
  constexpr int looks = 16;
  const double dt = step.end.time - known.time;
  if (step.change < 1.0) return step.change * dt;
  const bool any_sticks =
      std::find(known.slips.begin(), known.slips.end(), Slip::none) != known.slips.end();
  for (int i = 1; i < looks; ++i) {
    State at = interpolate(known.time + dt * i / looks, known, step.end);
    at.lambda = known.lambda;
    at.friction = known.friction;
    at.slips = known.slips;
    if (any_sticks && !equations_.solve_rates(at)) return 0.0;
    if (!contacts_go_on(at)) return at.time - known.time;
  }
  return 0.0;
}

void FreeSolver::decide_contacts(State& state) {
  FrictionResponse response;
  if (!equations_.friction_response(state, response)) return;
  const std::vector<char> stands = standing_contacts(laws_, state.slips, response.velocity, rest_);
  state.v += equations_.velocities_by(holding_impulses(response, stands));
  for (std::size_t j = 0; j < laws_.size(); ++j)
    if (stands[j] != 0) response.velocity[static_cast<Eigen::Index>(j)] = 0.0;
  state.slips = decide_sticking(laws_, response, stands, names_, state.time).slips;
}

void FreeSolver::settle_contacts(State& state) {
  const std::vector<Slip> before = state.slips;
  const auto velocity = [&](std::size_t j) {
    return sliding_velocity_of(equations_.contacts()[j], state.q, state.v);
  };
  if (contacts_go_on(state)) {
    bool slides = false;
    for (std::size_t j = 0; j < laws_.size(); ++j) {
      slides = slides || (can_stick(laws_[j]) && before[j] == Slip::none &&
                          std::abs(velocity(j)) > turning_back * rest_);
    }
    if (!slides) return;
  }
  for (std::size_t j = 0; j < laws_.size(); ++j) {
    if (!can_stick(laws_[j]) || static_cast<double>(before[j]) * velocity(j) >= -rest_) continue;
    throw AnalysisError(
        {"a contact with dry friction comes to rest where the mechanism passes a "
         "singular position; give it a creep velocity, which smooths its friction",
         "joint " + names_[j],
         state.time,
         {},
         {}});
  }
  decide_contacts(state);
  static_cast<void>(equations_.solve_rates(state));
  // Ways begun at other instants lead to the same changes.
  note_changes(slip_changes_, changes_between(names_, before, state.slips, state.time),
               1e-9 * time_span_of(*mechanism_).length);
}

State FreeSolver::advance(double time, const State& known) {
  State state = known;
  if (const Passage* passage = passage_of(known)) {
    // Within a passage over a singular position only its ends are where to go on from.
    const double way = passage->behind.time - passage->before.time;
    const double share = (time - passage->before.time) / way;
    if (share > 0.0 && share < 1.0) return between(*passage, time);
    state = share >= 1.0 ? passage->behind : passage->before;
  }
  // What was set by hand has no accelerations yet.
  const bool touches_known = state.touches.size() == mechanism_->forces.size();
  if (state.a.size() != state.q.size() || !(one_sided_.empty() || touches_known) ||
      (sticking_ && state.slips.empty()))
    state = state_of(state);
  constexpr double shortest = 1e-3;  // of a step in front of a singular position
  const double direction = time < state.time ? -1.0 : 1.0;
  const double smallest = 1e-13 * std::max(std::abs(time), std::abs(state.time)) + 1e-300;
  double dt = time - state.time;
  bool inside = false;  // close to a singular position already
  const State begin = state;
  int attempt = 0;
  const std::vector<double> stops = stops_between(*mechanism_, state.time, time);
  auto stop = stops.begin();
  while (direction * (time - state.time) > smallest) {
    const double coordinates = std::max(fewest_coordinates, static_cast<double>(state.q.size()));
    if (static_cast<double>(equations_.evaluations()) * coordinates > most_work) {
      throw AnalysisError(
          {fmt::format(
               "the motion under the applied forces takes too much work: {} steps, those "
               "between the instants that are judged among them, have not led to its end; look "
               "for a spring that is far too stiff, a mass that is far too small or a [motion] "
               "duration that is far too long",
               steps_),
           "mechanism",
           state.time,
           {},
           {}});
    }
    while (stop != stops.end() && direction * (*stop - state.time) <= smallest) ++stop;
    if (direction > 0.0 && has_changed(state)) {
      change(state);
      if (sticking_) settle_contacts(state);
    }
    const double until = stop != stops.end() ? *stop : time;
    const double wanted = std::abs(dt);
    dt = direction * std::min({std::abs(dt), std::abs(until - state.time),
                               std::max(smallest, longest_with_friction(*mechanism_, state))});
    Step step = step_from(state, dt);
    regular_ = std::max(regular_, step.end_pivot);
    const double bound =
        is_near_singular(step.pivot) ? std::max(1.0, error_near_singular / tolerance_) : 1.0;
    const bool lost = inside && step.end_pivot < singular * regular_;
    // Steps much shorter than one that would agree, in the same impacts, do so as well.
    constexpr double of_halves = 0.1, shorter_by_far = 0.25;
    const bool known_good =
        std::abs(dt) <= shorter_by_far * agreed_ && state.touches == agreed_touches_;
    if (step.solved && step.error <= bound && !lost && !known_good && in_impact(state)) {
      step.error = std::max(step.error, of_halves * beside_halves(state, step));
      if (step.error <= bound) {
        agreed_ = std::abs(dt) * std::pow(bound / std::max(step.error, 1e-9 * bound), 1.0 / 8.0);
        agreed_touches_ = state.touches;
      }
    }
    if (!step.solved || step.error > bound || lost) {
      // The order of the error estimate is eight; Source: Hairer, Norsett, Wanner (1993), II.4.
      const double shrink =
          step.solved && !lost ? 0.9 * std::pow(bound / step.error, 1.0 / 8.0) : 0.25;
      dt *= std::max(0.2, shrink);
      if (std::abs(dt) > smallest) continue;
      // Whether a step passes over a singular position depends on where the last one before it
      // ended: begun otherwise they end elsewhere.
      constexpr int other_ways = 6;
      if (attempt < other_ways) {
        ++attempt;
        state = begin;
        stop = stops.begin();
        inside = false;
        dt = (time - begin.time) * std::pow(0.6, attempt);
        continue;
      }
      throw AnalysisError(
          {"the motion under the applied forces cannot be integrated further: it "
           "changes faster than the arithmetic can follow (a singular position, or "
           "far too stiff a spring)",
           "mechanism",
           state.time,
           {},
           {}});
    }
    if (sticking_ && !is_near_singular(step.pivot) && std::abs(dt) > 16.0 * smallest &&
        contacts_go_on(step.end)) {
      const double within = contact_changes_within(state, step);
      if (within != 0.0) {
        dt = within;
        continue;
      }
    }
    if (is_near_singular(step.end_pivot) && !inside && std::abs(dt) > shortest * natural_) {
      std::optional<Step> over = step_over(state, dt);
      if (!over) {
        dt *= 0.5;
        continue;
      }
      ++steps_;
      if (direction * (over->end.time - time) > 0.0) {
        passages_.push_back({state, over->end});
        return between(passages_.back(), time);
      }
      step = std::move(*over);
    }
    const double longer = 0.9 * std::pow(bound / std::max(step.error, 1e-9 * bound), 1.0 / 8.0);
    natural_ = std::max(natural_, std::abs(dt) * longer);
    const double next =
        std::max(std::abs(dt) * std::min(5.0, longer), std::abs(dt) < wanted ? wanted : 0.0);
    // No step goes on beyond a bend of friction, which its error does not show, nor beyond where a
    // contact begins to stick or to slide.
    const std::vector<int> sides = pressed_sides_of(*mechanism_, state.lambda);
    const auto keeps_on = [&](const State& end) {
      if (sides.empty()) return true;
      return pressed_sides_of(*mechanism_, end.lambda) == sides &&
             (!sticking_ || contacts_go_on(end));
    };
    if (!is_near_singular(step.pivot) && !keeps_on(step.end)) {
      double low = 0.0;
      double high = dt;
      while (std::abs(high - low) > smallest + 1e-12 * std::abs(dt)) {
        const double half = 0.5 * (low + high);
        Step shorter = step_from(state, half);
        if (!shorter.solved) break;
        if (keeps_on(shorter.end)) {
          low = half;
        } else {
          high = half;
          step = std::move(shorter);
        }
      }
    }
    // Backwards nobody knows what was lost.
    const auto found = direction > 0.0 ? first_change(state, step.end) : std::nullopt;
    if (found) {
      Step until_change = step_to(*found, state);
      if (!until_change.solved) {
        dt *= 0.5;
        if (std::abs(dt) > smallest) continue;
        throw AnalysisError(
            {"a stop, a cable or a pin in its clearance begins or ends to act where "
             "the motion cannot be followed (a singular position)",
             "mechanism",
             state.time,
             {},
             {}});
      }
      step = std::move(until_change);
      change(step.end);
    }
    inside = is_near_singular(step.end_pivot);
    ++steps_;
    state = std::move(step.end);
    if (sticking_) settle_contacts(state);
    dt = direction * next;
  }
  state.time = time;
  return state;
}

}  // namespace boxbeam::planar
