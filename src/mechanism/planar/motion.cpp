#include "boxbeam/mechanism/planar/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"

namespace boxbeam::planar {
namespace {

/// Largest difference of two positions; whole turns of an angle are none.
double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    double difference = a[i] - b[i];
    if (i % 3 == 2) difference = std::remainder(difference, 2.0 * std::numbers::pi);
    largest = std::max(largest, std::abs(difference));
  }
  return largest;
}

/// Largest second difference between neighbouring instants, of each component by its largest
/// value, and where it is.
struct Roughness {
  double value = 0.0;
  std::size_t instant = 0;
};

Roughness roughness_of(const Motion& motion, Eigen::VectorXd State::*values) {
  const std::size_t n = motion.states.size();
  Eigen::VectorXd largest = Eigen::VectorXd::Zero((motion.states.front().*values).size());
  for (const State& state : motion.states) largest = largest.cwiseMax((state.*values).cwiseAbs());
  // A component that is round-off beside the others has no waves of its own to resolve.
  const double floor = 1e-6 * largest.maxCoeff();
  Roughness worst;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::VectorXd bend = motion.states[(i + n - 1) % n].*values -
                                 2.0 * (motion.states[i].*values) +
                                 motion.states[(i + 1) % n].*values;
    for (Eigen::Index k = 0; k < bend.size(); ++k) {
      const double value = largest[k] > floor ? std::abs(bend[k]) / largest[k] : 0.0;
      if (value > worst.value) worst = {value, i};
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

}  // namespace

Motion solve_motion(const Mechanism& mechanism, int instants) {
  InstantSolver solver(mechanism);
  Motion motion;
  motion.period = period_of(mechanism);
  motion.states.reserve(static_cast<std::size_t>(instants));
  motion.states.push_back(solver.solve_from_sketch(0.0, sketch_of(mechanism)));
  for (int i = 1; i < instants; ++i) {
    motion.states.push_back(solver.solve_near(motion.period * i / instants, motion.states.back()));
  }
  // Loops the case does not name are not watched: a motion that comes back elsewhere has jumped.
  const State again = solver.solve_near(motion.period, motion.states.back());
  if (largest_difference(again.q, motion.states.front().q) > 1e-6) {
    throw AnalysisError(
        {"the motion does not close: after one period of the drivers the mechanism is "
         "on another branch; name its loops under [loops]",
         "mechanism",
         motion.period,
         largest_difference(again.q, motion.states.front().q),
         {}});
  }
  return motion;
}

Motion solve_motion(const Mechanism& mechanism) {
  constexpr int fewest = 96;
  constexpr int most = 6144;
  for (int instants = fewest;; instants *= 2) {
    Motion motion = solve_motion(mechanism, instants);
    const Roughness accelerations = roughness_of(motion, &State::a);
    const Roughness reactions = roughness_of(motion, &State::lambda);
    if (accelerations.value < 0.02 && reactions.value < 0.02) return motion;
    if (2 * instants > most) {
      const Roughness& worst = accelerations.value > reactions.value ? accelerations : reactions;
      const State& state = motion.states[worst.instant];
      throw AnalysisError(
          {fmt::format("accelerations or reactions change too fast to be resolved with "
                       "{} instants in a period; the mechanism passes close to a dead "
                       "point",
                       instants),
           nearest_dead_point(mechanism, motion),
           state.time,
           {},
           {}});
    }
  }
}

State state_at(InstantSolver& solver, const Motion& motion, double time) {
  const double within = time - motion.period * std::floor(time / motion.period);
  const auto count = motion.states.size();
  const double position = within / motion.period * static_cast<double>(count);
  const auto nearest = static_cast<std::size_t>(std::lround(position));
  if (nearest < count) return solver.solve_near(within, motion.states[nearest]);
  // Behind the last instant the motion begins again: the first instant is the nearest one.
  State first = motion.states.front();
  first.time = motion.period;
  return solver.solve_near(within, first);
}

}  // namespace boxbeam::planar
