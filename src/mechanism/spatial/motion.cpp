#include "boxbeam/mechanism/spatial/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/common/rough_times.hpp"
#include "boxbeam/mechanism/common/sign_changes.hpp"

namespace boxbeam::spatial {
namespace {

constexpr std::size_t fewest = 96;
constexpr std::size_t most = 24576;

/// The forces and moments of all joints at every instant and at the end, a column each; in the axes
/// of the bodies that carry, in which a wheel's spin is not seen.
struct Samples {
  Eigen::MatrixXd values;
  double fastest = 0.0;  ///< rate of turn of any body [rad/s]
};

int axes_of(const ClosingJoint& joint) {
  return has_teeth(joint.kind) ? joint.mesh.at.body : joint.a.body;
}

Samples samples_of(const Chain& chain, const Motion& motion) {
  const Mechanism& mechanism = chain.mechanism();
  const std::size_t joints = mechanism.joints.size() + mechanism.closing.size();
  Samples samples;
  samples.values.resize(static_cast<Eigen::Index>(6 * joints),
                        static_cast<Eigen::Index>(motion.instants + 1));
  State state;
  std::vector<Wrench> wrenches;
  for (std::size_t k = 0; k <= motion.instants; ++k) {
    chain.at(time_of(motion, k), state);
    chain.joint_wrenches(state, wrenches);
    const auto column = static_cast<Eigen::Index>(k);
    for (std::size_t i = 0; i < joints; ++i) {
      const bool carries = i < mechanism.joints.size();
      const int parent = carries ? mechanism.joints[i].parent
                                 : axes_of(mechanism.closing[i - mechanism.joints.size()]);
      const auto row = static_cast<Eigen::Index>(6 * i);
      samples.values.col(column).segment<3>(row) = in_axes(state, parent, wrenches[i].force);
      samples.values.col(column).segment<3>(row + 3) = in_axes(state, parent, wrenches[i].moment);
      if (carries) samples.fastest = std::max(samples.fastest, state.bodies[i].omega.norm());
    }
  }
  return samples;
}

/// The largest distance of a value at an odd instant from the cubic through its even neighbours, or
/// from the line where a load has a kink or jump among them, relative to the value's range; and
/// when.
struct Misfit {
  double value = 0.0;
  double time = 0.0;
};

Misfit misfit_of(const Motion& motion, const RoughTimes& rough, const Eigen::MatrixXd& values) {
  Misfit misfit;
  const auto count = static_cast<Eigen::Index>(motion.instants);
  const Eigen::VectorXd range = values.rowwise().maxCoeff() - values.rowwise().minCoeff();
  const Eigen::VectorXd size = values.rowwise().lpNorm<Eigen::Infinity>();
  const double largest = size.maxCoeff();
  // An open motion has no neighbours beyond its ends.
  const auto column = [&](Eigen::Index k) {
    return values.col(motion.closed ? (k + count) % count : k);
  };
  const auto smooth = [&](Eigen::Index from, Eigen::Index until) {
    if (!motion.closed && (from < 0 || until > count)) return false;
    const double step = motion.period / static_cast<double>(count);
    return !rough.between(motion.begin + step * static_cast<double>(from),
                          motion.begin + step * static_cast<double>(until));
  };
  Eigen::VectorXd expected(values.rows());
  const Eigen::Index first = motion.closed ? 1 : 3;
  const Eigen::Index last = motion.closed ? count - 1 : count - 3;
  for (Eigen::Index k = first; k <= last; k += 2) {
    if (smooth(k - 3, k + 3)) {
      expected = (9.0 * (column(k - 1) + column(k + 1)) - (column(k - 3) + column(k + 3))) / 16.0;
    } else if (smooth(k - 1, k + 1)) {
      expected = 0.5 * (column(k - 1) + column(k + 1));
    } else {
      continue;
    }
    const Eigen::VectorXd open = (column(k) - expected).cwiseAbs();
    for (Eigen::Index i = 0; i < open.size(); ++i) {
      // What hardly changes beside its own size, or beside all others, is round-off.
      if (range[i] <= 1e-9 * std::max(size[i], 1e-3 * largest)) continue;
      if (open[i] / range[i] <= misfit.value) continue;
      misfit = {open[i] / range[i], time_of(motion, static_cast<std::size_t>(k))};
    }
  }
  return misfit;
}

/// What says where springs that only pull or only push begin and end to act.
std::vector<Spring> switches_of(const Mechanism& mechanism) {
  std::vector<Spring> switches;
  for (const Spring& of : mechanism.springs)
    for (Spring& by : spatial::switches_of(of)) switches.push_back(std::move(by));
  return switches;
}

std::vector<double> changes_by_drivers(const Chain& chain, const TimeSpan& span) {
  std::vector<double> changes;
  State state;
  for (const Spring& spring : switches_of(chain.mechanism())) {
    const auto tension_at = [&](double time) {
      chain.at(time, state);
      const Tension tension = tension_of(spring, state);
      return ValueAndRate{tension.value, tension.rate};
    };
    add_sign_changes(span.begin, span.length, tension_at, changes);
  }
  std::sort(changes.begin(), changes.end());
  return changes;
}

std::vector<double> changes_of(const Chain& chain, const TimeSpan& span) {
  constexpr std::size_t most_changes = 1000;
  std::vector<double> changes;
  if (chain.forced() != nullptr)
    changes = chain.forced()->changes();
  else if (!switches_of(chain.mechanism()).empty())
    changes = changes_by_drivers(chain, span);
  std::erase_if(changes,
                [&](double at) { return at <= span.begin || at >= span.begin + span.length; });
  if (changes.size() <= most_changes) return changes;
  throw AnalysisError(
      {fmt::format("stops and cables begin and end to act, and contacts to stick, {} times, more "
                   "than can be looked at one by one; give a shorter [motion] duration, their "
                   "springs more damping, or contacts a creep velocity",
                   changes.size()),
       "mechanism", changes[most_changes]});
}

}  // namespace

double time_of(const Motion& motion, std::size_t instant) {
  return motion.begin +
         motion.period * static_cast<double>(instant) / static_cast<double>(motion.instants);
}

Motion motion_of(const Chain& chain) {
  constexpr double enough = 0.01;
  const TimeSpan span = time_span_of(chain.mechanism());
  Motion motion{span.begin, span.length, span.closed, fewest, changes_of(chain, span)};
  const RoughTimes rough(functions_of(chain.mechanism()), span.begin, span.length, span.closed,
                         motion.changes);
  const double waves = waves_of(span, most);
  while (static_cast<double>(motion.instants) < 8.0 * waves) motion.instants *= 2;
  while (true) {
    const Samples samples = samples_of(chain, motion);
    const Misfit misfit = misfit_of(motion, rough, samples.values);
    const bool turns_seen =
        static_cast<double>(motion.instants) >= 8.0 * motion.period * samples.fastest / full_turn;
    if (misfit.value < enough && turns_seen) return motion;
    if (2 * motion.instants > most) {
      throw AnalysisError(
          {fmt::format(
               "joint forces change too fast to be resolved with {} instants in the time "
               "looked at; give a shorter [motion] duration, smoother drivers and loads, or a "
               "larger creep velocity of what rubs",
               motion.instants),
           "mechanism", misfit.time});
    }
    motion.instants *= 2;
  }
}

}  // namespace boxbeam::spatial
