#include "boxbeam/mechanism/planar/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/common/rough_times.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"

namespace boxbeam::planar {
namespace {

/// The same at 16 of the states of a motion.
void judge_uniqueness(const Mechanism& mechanism, Motion& motion) {
  constexpr std::size_t looks = 16;
  const std::size_t count = motion.states.size();
  for (std::size_t i = 0; i < looks; ++i) {
    judge_uniqueness(mechanism, motion.states[i * count / looks].q, motion.freedom);
  }
}

/// A torsion spring that ends a period wound up more than it began, "" where there is none.
std::string wound_up(const Mechanism& mechanism, const Motion& motion) {
  const auto angle = [](const State& state, int body) {
    return body == ground ? 0.0 : state.q[3 * static_cast<Eigen::Index>(body) + 2];
  };
  for (const AppliedForce& force : mechanism.forces) {
    const auto* spring = std::get_if<TorsionSpring>(&force.kind);
    if (spring == nullptr || spring->stiffness == 0.0) continue;
    const auto turned = [&](const State& state) {
      return angle(state, spring->a.body) - angle(state, spring->b.body);
    };
    if (std::abs(turned(motion.end) - turned(motion.states.front())) > 1e-6) return force.name;
  }
  return "";
}

/// How far values half-way between instants are from what the instants say.
struct Misfit {
  double value = 0.0;
  double time = 0.0;
};

/// States of a motion with their end.
std::vector<const State*> all_of(const Motion& motion) {
  std::vector<const State*> all;
  for (const State& state : motion.states) all.push_back(&state);
  all.push_back(&motion.end);
  return all;
}

/// Every second state against the cubic through the four others around it, by component of
/// `values`, relative to the component's range. Where a load has a kink or a jump among the four,
/// against the parabola or the line through those on its own side; between two such places so close
/// that only one state lies there, against nothing.
Misfit misfit_of(const Motion& motion, const RoughTimes& rough, Eigen::VectorXd State::*values,
                 const Eigen::VectorXd& scale, double nothing) {
  const std::vector<const State*> all = all_of(motion);
  const auto count = static_cast<std::ptrdiff_t>(motion.states.size());
  const Eigen::Index size = (all.front()->*values).size();
  if (size == 0) return {};  // nothing holds a mechanism without joints and drivers
  Eigen::VectorXd low = all.front()->*values;
  Eigen::VectorXd high = low;
  for (const State* state : all) {
    low = low.cwiseMin(state->*values);
    high = high.cwiseMax(state->*values);
  }
  const Eigen::VectorXd range = high - low;
  // A component that is round-off beside the others has no waves of its own to resolve.
  const double floor =
      nothing + 1e-6 * scale.cwiseProduct(high.cwiseAbs().cwiseMax(low.cwiseAbs())).maxCoeff();
  const auto at = [&](std::ptrdiff_t i) -> const Eigen::VectorXd& {
    if (motion.closed) i = (i + count) % count;
    return all[static_cast<std::size_t>(i)]->*values;
  };
  const auto smooth = [&](std::ptrdiff_t from, std::ptrdiff_t until) {
    if (!motion.closed && (from < 0 || until > count)) return false;
    const double step = motion.period / static_cast<double>(count);
    return !rough.between(motion.begin + step * static_cast<double>(from),
                          motion.begin + step * static_cast<double>(until));
  };
  Misfit worst;
  Eigen::VectorXd expected(size);
  for (std::ptrdiff_t i = 1; i < count; i += 2) {
    if (smooth(i - 3, i + 3)) {
      expected = (9.0 * (at(i - 1) + at(i + 1)) - (at(i - 3) + at(i + 3))) / 16.0;
    } else if (smooth(i - 1, i + 3)) {
      expected = (3.0 * at(i - 1) + 6.0 * at(i + 1) - at(i + 3)) / 8.0;
    } else if (smooth(i - 3, i + 1)) {
      expected = (3.0 * at(i + 1) + 6.0 * at(i - 1) - at(i - 3)) / 8.0;
    } else if (smooth(i - 1, i + 1)) {
      expected = 0.5 * (at(i - 1) + at(i + 1));
    } else {
      continue;
    }
    for (Eigen::Index k = 0; k < size; ++k) {
      if (!(scale[k] * range[k] > floor)) continue;
      const double value = std::abs(at(i)[k] - expected[k]) / range[k];
      if (value > worst.value) worst = {value, all[static_cast<std::size_t>(i)]->time};
    }
  }
  return worst;
}

/// The loop whose measure comes nearest to zero, by its own largest value.
std::string nearest_dead_point(const Mechanism& mechanism, const Motion& motion) {
  std::string nearest = "mechanism";
  double smallest = 1.0;
  for (const Loop& loop : mechanism.loops) {
    double low = 1e300;
    double high = 0.0;
    for (const State& state : motion.states) {
      const double value = std::abs(measure_of(loop, state.q));
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (low < smallest * high) {
      smallest = low / high;
      nearest = "loop " + loop.name;
    }
  }
  return nearest;
}

/// How fast a body turns at its fastest, and which one that is.
struct Turn {
  double rate = 0.0;  ///< [rad/s]
  std::size_t body = 0;
  double time = 0.0;
};

Turn fastest_turn(const Motion& motion) {
  Turn fastest;
  for (const State& state : motion.states) {
    for (Eigen::Index i = 2; i < state.v.size(); i += 3) {
      const double rate = std::abs(state.v[i]);
      if (rate > fastest.rate) fastest = {rate, static_cast<std::size_t>(i / 3), state.time};
    }
  }
  return fastest;
}

double time_of(const Motion& motion, std::size_t instant, std::size_t count) {
  return motion.begin + motion.period * static_cast<double>(instant) / static_cast<double>(count);
}

/// When what acts one way begins and ends to in the time looked at. Throws AnalysisError where that
/// is too often to be looked at one by one.
std::vector<double> changes_in(const Mechanism& mechanism, const Motion& motion,
                               StateSolver& solver) {
  constexpr std::size_t most_changes = 1000;
  State state = motion.states.front();
  const auto at = [&](double time) -> const State& { return state = solver.near(time, state); };
  std::vector<double> changes =
      solver.integrates() ? solver.changes()
                          : changes_by_drivers(mechanism, motion.begin, motion.period, at);
  std::sort(changes.begin(), changes.end());
  std::erase_if(changes, [&](double time) {
    return time <= motion.begin || time >= motion.begin + motion.period;
  });
  if (changes.size() <= most_changes) return changes;
  throw AnalysisError(
      {fmt::format("stops, cables and pins in their clearance begin and end to act {} times, more "
                   "than can be looked at one by one; give a shorter [motion] duration, or a "
                   "smaller restitution",
                   changes.size()),
       "mechanism", changes[most_changes]});
}

/// Where contacts begin to stick or to slide while a motion is looked at.
std::vector<SlipChange> slip_changes_in(const Motion& motion, const StateSolver& solver) {
  constexpr std::size_t most_changes = 1000;
  std::vector<SlipChange> changes = solver.slip_changes();
  std::erase_if(changes, [&](const SlipChange& of) {
    return of.time <= motion.begin || of.time >= motion.begin + motion.period;
  });
  if (changes.size() <= most_changes) return changes;
  throw AnalysisError(
      {fmt::format(
           "contacts begin to stick or to slide {} times, more than can be looked at one by "
           "one; give a shorter [motion] duration, or a creep velocity, which smooths "
           "friction",
           changes.size()),
       "joint " + changes[most_changes].joint, changes[most_changes].time});
}

Motion motion_with(const Mechanism& mechanism, StateSolver& solver, int instants) {
  const TimeSpan span = time_span_of(mechanism);
  const auto count = static_cast<std::size_t>(instants);
  Motion motion;
  motion.period = span.length;
  motion.closed = span.closed && !solver.integrates();
  motion.begin = motion.closed ? 0.0 : span.begin;
  motion.freedom = solver.freedom();
  motion.states.reserve(count);
  State first = solver.start();
  if (motion.begin > 0.0) first = solver.near(motion.begin, first);
  motion.states.push_back(std::move(first));
  for (std::size_t i = 1; i < count; ++i) {
    motion.states.push_back(solver.near(time_of(motion, i, count), motion.states.back()));
  }
  motion.end = solver.near(time_of(motion, count, count), motion.states.back());
  motion.change_points = solver.change_points();
  motion.changes = changes_in(mechanism, motion, solver);
  motion.slip_changes = slip_changes_in(motion, solver);
  judge_uniqueness(mechanism, motion);
  if (!motion.closed) return motion;
  // An odd number of change points, or a gear that needs more turns, leads elsewhere.
  const double open = distance_between(motion.end.q, motion.states.front().q, size_of(mechanism));
  const std::string spring = wound_up(mechanism, motion);
  if (open < 1e-6 && spring.empty()) return motion;
  if (mechanism.duration.length > 0.0) {
    motion.closed = false;
    return motion;
  }
  if (!spring.empty()) {
    throw AnalysisError(
        {"the torsion spring is wound up further with every period of the drivers; "
         "give [motion] duration",
         "force " + spring, motion.period});
  }
  throw AnalysisError(
      {"the motion does not close: after one period of the drivers the mechanism is elsewhere (on "
       "another branch, or a gear needs more turns); give [motion] duration",
       "mechanism", motion.period, open});
}

/// The motion with a state between every two.
Motion doubled(StateSolver& solver, const Motion& coarse) {
  Motion fine = coarse;
  const std::size_t count = 2 * coarse.states.size();
  fine.states.clear();
  fine.states.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 2 == 0) {
      fine.states.push_back(coarse.states[i / 2]);
    } else {
      fine.states.push_back(solver.near(time_of(coarse, i, count), fine.states.back()));
    }
  }
  return fine;
}

}  // namespace

Motion solve_motion(const Mechanism& mechanism, int instants) {
  StateSolver solver(mechanism);
  return motion_with(mechanism, solver, instants);
}

Motion solve_motion(const Mechanism& mechanism) {
  constexpr int fewest = 48;
  constexpr int most = 24576;
  constexpr double enough = 0.01;
  StateSolver solver(mechanism);
  const ConstraintEquations equations(mechanism);
  const TimeSpan span = time_span_of(mechanism);
  // What does not even move by a millionth of its size in a period, or of a fall, is at rest.
  const double rest =
      1e-6 * (std::pow(full_turn / span.length, 2) + mechanism.gravity.norm() / size_of(mechanism));
  const double waves = waves_of(span, most);
  // Whole waves stay whole: the points of an even table are instants then.
  constexpr double rounding = 1e-9;
  const int instants = std::max(fewest, static_cast<int>(std::ceil((4.0 - rounding) * waves)));
  Motion motion = motion_with(mechanism, solver, instants);
  while (true) {
    motion = doubled(solver, motion);
    motion.slip_changes = slip_changes_in(motion, solver);
    std::vector<double> changes = times_of(motion.slip_changes);
    changes.insert(changes.end(), motion.changes.begin(), motion.changes.end());
    const RoughTimes rough(functions_of(mechanism), motion.begin, motion.period, motion.closed,
                           changes);
    const Misfit accelerations =
        misfit_of(motion, rough, &State::a, equations.col_scale().cwiseInverse(), rest);
    const Misfit reactions =
        misfit_of(motion, rough, &State::lambda, equations.row_scale().cwiseInverse(), 0.0);
    const auto count = static_cast<double>(motion.states.size());
    // More instants can only show faster turns, so that some motions are too fast already here.
    const Turn fastest = fastest_turn(motion);
    const double wanted = 8.0 * motion.period * fastest.rate / full_turn;
    const bool turns_seen = count >= wanted;
    if (accelerations.value < enough && reactions.value < enough && turns_seen) return motion;
    if (wanted > most) {
      throw AnalysisError(
          {fmt::format("it turns with up to {:.3g} rad/s, which {} instants in the {:.3g} s looked "
                       "at do not resolve; look for a rate in a wrong unit, or look at a shorter "
                       "time",
                       fastest.rate, most, motion.period),
           "body " + mechanism.bodies[fastest.body].name, fastest.time});
    }
    if (2.0 * count > most) {
      const Misfit& worst = accelerations.value > reactions.value ? accelerations : reactions;
      throw AnalysisError(
          {fmt::format("accelerations or reactions change too fast to be resolved with {} instants "
                       "in the time looked at; the mechanism passes close to a dead point, slides "
                       "back and forth against much friction with a small creep velocity, or the "
                       "time is too long",
                       most),
           nearest_dead_point(mechanism, motion), worst.time});
    }
  }
}

State StateFinder::at(double time) {
  const Motion& motion = *motion_;
  double within = time;
  if (motion.closed) {
    within -= motion.period * std::floor((time - motion.begin) / motion.period);
  } else if (time < motion.begin || time > motion.begin + motion.period * (1.0 + 1e-12)) {
    throw AnalysisError({fmt::format("the motion lasts from {:.6g} s to {:.6g} s", motion.begin,
                                     motion.begin + motion.period),
                         "mechanism", time});
  }
  const auto count = motion.states.size();
  const double position = (within - motion.begin) / motion.period * static_cast<double>(count);
  // Integration goes forward only: backwards, what damping has taken away grows again.
  const double chosen = solver_.integrates() ? std::floor(position) : std::round(position);
  const auto nearest = static_cast<std::size_t>(std::max(0.0, chosen));
  const State& known = nearest < count ? motion.states[nearest] : motion.end;
  // An instant of the motion itself is known, also where it lies in a change point.
  return within == known.time ? known : solver_.near(within, known);
}

}  // namespace boxbeam::planar
