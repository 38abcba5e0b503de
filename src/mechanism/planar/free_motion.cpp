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
#include "free_step.hpp"

namespace boxbeam::planar {
namespace {

// Pivot of the equations of motion by that of regular positions, below which nothing is known any
// more.
constexpr double singular = 1e-6;

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

/// Of a step in front of a singular position, by the longest.
constexpr double shortest = 1e-3;

[[noreturn]] void refuse_unseen_change(double time) {
  throw AnalysisError(
      {"a stop, a cable or a pin in its clearance begins or ends to act where the motion cannot be "
       "followed (a singular position)",
       "mechanism", time});
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
         "mechanism", state.time});
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
           off, time});
    }
    assembly = assembler.assemble(time, other_start(*mechanism_, q, attempt));
  }
  Eigen::VectorXd position = assembly.q;
  Eigen::VectorXd velocity = v;
  if (!equations_.project(time, position, velocity)) {
    throw AnalysisError(
        {"the motion starts in a singular position, where velocities cannot be moved "
         "onto the constraints; start beside it",
         "mechanism", time});
  }
  State first;
  first.time = time;
  first.q = position;
  first.v = velocity;
  return state_of(first);
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
  step.length = dt;
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

FreeSolver::Way::Way(const Mechanism& mechanism, const State& from, double time)
    : begin(from),
      end(time),
      direction(time < from.time ? -1.0 : 1.0),
      smallest(1e-13 * std::max(std::abs(time), std::abs(from.time)) + 1e-300),
      stops(stops_between(mechanism, from.time, time)),
      dt(time - from.time) {}

void FreeSolver::choose_step(Way& way, const State& state) {
  const double coordinates = std::max(fewest_coordinates, static_cast<double>(state.q.size()));
  if (static_cast<double>(equations_.evaluations()) * coordinates > most_work) {
    throw AnalysisError(
        {fmt::format("the motion under the applied forces takes too much work: {} steps, those "
                     "between the instants that are judged among them, have not led to its end; "
                     "look for a spring that is far too stiff, a mass that is far too small or a "
                     "[motion] duration that is far too long",
                     steps_),
         "mechanism", state.time});
  }
  while (way.stop < way.stops.size() &&
         way.direction * (way.stops[way.stop] - state.time) <= way.smallest)
    ++way.stop;
  const double until = way.stop < way.stops.size() ? way.stops[way.stop] : way.end;
  way.dt =
      way.direction * std::min({std::abs(way.dt), std::abs(until - state.time),
                                std::max(way.smallest, longest_with_friction(*mechanism_, state))});
}

void FreeSolver::shorten_step(Way& way, State& state, const Step& step, double bound,
                              bool lost) const {
  // The order of the error estimate is eight; Source: Hairer, Norsett, Wanner (1993), II.4.
  const double shrink = step.solved && !lost ? 0.9 * std::pow(bound / step.error, 1.0 / 8.0) : 0.25;
  way.dt *= std::max(0.2, shrink);
  if (std::abs(way.dt) > way.smallest) return;
  // Whether a step passes over a singular position depends on where the last one before it ended:
  // begun otherwise they end elsewhere.
  constexpr int other_ways = 6;
  if (way.attempt == other_ways) {
    throw AnalysisError(
        {"the motion under the applied forces cannot be integrated further: it changes faster than "
         "the arithmetic can follow (a singular position, or far too stiff a spring)",
         "mechanism", state.time});
  }
  ++way.attempt;
  state = way.begin;
  way.stop = 0;
  way.inside = false;
  way.dt = (way.end - way.begin.time) * std::pow(0.6, way.attempt);
}

void FreeSolver::compare_with_halves(const State& known, double bound, Step& step) {
  // Steps much shorter than one that would agree, in the same impacts, do so as well.
  constexpr double of_halves = 0.1, shorter_by_far = 0.25;
  const double dt = std::abs(step.length);
  if (dt <= shorter_by_far * agreed_ && known.touches == agreed_touches_) return;
  if (!in_impact(known)) return;
  step.error = std::max(step.error, of_halves * beside_halves(known, step));
  if (step.error > bound) return;
  agreed_ = dt * std::pow(bound / std::max(step.error, 1e-9 * bound), 1.0 / 8.0);
  agreed_touches_ = known.touches;
}

FreeSolver::Step FreeSolver::before_bend(const State& known, Step step, double smallest) {
  const std::vector<int> sides = pressed_sides_of(*mechanism_, known.lambda);
  const auto keeps_on = [&](const State& end) {
    if (sides.empty()) return true;
    return pressed_sides_of(*mechanism_, end.lambda) == sides &&
           (!sticking_ || contacts_go_on(end));
  };
  if (keeps_on(step.end)) return step;
  const double dt = step.length;
  double low = 0.0;
  double high = dt;
  while (std::abs(high - low) > smallest + 1e-12 * std::abs(dt)) {
    const double half = 0.5 * (low + high);
    Step shorter = step_from(known, half);
    if (!shorter.solved) break;
    if (keeps_on(shorter.end)) {
      low = half;
    } else {
      high = half;
      step = std::move(shorter);
    }
  }
  return step;
}

bool FreeSolver::stop_at_change(Way& way, const State& state, Step& step) {
  // Backwards nobody knows what was lost.
  const auto found = way.direction > 0.0 ? first_change(state, step.end) : std::nullopt;
  if (!found) return true;
  Step until_change = step_to(*found, state);
  if (!until_change.solved) {
    way.dt *= 0.5;
    if (std::abs(way.dt) <= way.smallest) refuse_unseen_change(state.time);
    return false;
  }
  step = std::move(until_change);
  change(step.end);
  return true;
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
  Way way(*mechanism_, state, time);
  double& dt = way.dt;
  const double direction = way.direction, smallest = way.smallest;
  while (direction * (time - state.time) > smallest) {
    if (direction > 0.0 && has_changed(state)) {
      change(state);
      if (sticking_) settle_contacts(state);
    }
    const double wanted = std::abs(dt);
    choose_step(way, state);
    Step step = step_from(state, dt);
    regular_ = std::max(regular_, step.end_pivot);
    const double bound =
        is_near_singular(step.pivot) ? std::max(1.0, error_near_singular / tolerance_) : 1.0;
    const bool lost = way.inside && step.end_pivot < singular * regular_;
    if (step.solved && step.error <= bound && !lost) compare_with_halves(state, bound, step);
    if (!step.solved || step.error > bound || lost) {
      shorten_step(way, state, step, bound, lost);
      continue;
    }
    if (sticking_ && !is_near_singular(step.pivot) && std::abs(dt) > 16.0 * smallest &&
        contacts_go_on(step.end)) {
      const double within = contact_changes_within(state, step);
      if (within != 0.0) {
        dt = within;
        continue;
      }
    }
    if (is_near_singular(step.end_pivot) && !way.inside && std::abs(dt) > shortest * natural_) {
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
    if (!is_near_singular(step.pivot)) step = before_bend(state, std::move(step), smallest);
    if (!stop_at_change(way, state, step)) continue;
    way.inside = is_near_singular(step.end_pivot);
    ++steps_;
    state = std::move(step.end);
    if (sticking_) settle_contacts(state);
    dt = direction * next;
  }
  state.time = time;
  return state;
}

}  // namespace boxbeam::planar
