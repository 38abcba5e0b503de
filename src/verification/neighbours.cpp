#include "boxbeam/verification/neighbours.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

/// The modulus of structural steel. Source: EN 1993-1-1:2005, 3.2.6.
constexpr Stress youngs_modulus = 210e9 * pascal;

/// Largest value of a function of the state over the motion, found between the instants.
Extreme largest_over(const Project& project, const SituationRun& run,
                     const std::function<double(const planar::State&)>& f) {
  const planar::Motion& motion = planar_motion_of(run);
  const auto best =
      std::max_element(motion.states.begin(), motion.states.end(),
                       [&](const planar::State& a, const planar::State& b) { return f(a) < f(b); });
  const auto index = static_cast<double>(best - motion.states.begin());
  const double step = motion.period / static_cast<double>(motion.states.size());
  planar::StateFinder finder(planar_in(project, *run.situation), motion);
  double low = motion.begin + (index - 1.0) * step;
  double high = low + 2.0 * step;
  if (!motion.closed) {
    low = std::max(low, motion.begin);
    high = std::min(high, motion.begin + motion.period);
  }
  const Extremum found = find_maximum([&](double time) { return f(finder.at(time)); }, low, high);
  const bool at_end = !motion.closed && f(motion.end) > std::max(found.value, f(*best));
  if (at_end) return {si<Time>(motion.end.time), f(motion.end), index_of(project, *run.situation)};
  // The instant itself may be a corner of the function, which the search only comes near to.
  Extreme extreme{si<Time>(best->time), f(*best), index_of(project, *run.situation)};
  if (found.value > extreme.value) {
    double time = found.at;
    if (motion.closed && time < motion.begin) time += motion.period;
    extreme.time = si<Time>(time);
    extreme.value = found.value;
  }
  return extreme;
}

/// The largest value over all situations, times their load factors.
Extreme worst_of(const Project& project, const std::deque<SituationRun>& runs,
                 const std::function<double(const SituationRun&, const planar::State&)>& f) {
  Extreme worst;
  for (const SituationRun& run : runs) {
    Extreme in =
        largest_over(project, run, [&](const planar::State& state) { return f(run, state); });
    in.value *= run.situation->load_factor;
    if (&run == &runs.front() || in.value > worst.value) worst = in;
  }
  return worst;
}

/// Stops where rigid bodies do not determine the reaction of a joint.
void check_unique(const Project& project, const std::deque<SituationRun>& runs, int joint,
                  const std::string& of) {
  for (const SituationRun& run : runs) {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    if (planar::is_unique(mechanism, planar_motion_of(run).freedom, joint)) continue;
    throw AnalysisError({fmt::format("the load on {} is not determined by rigid bodies: joints "
                                     "repeat each other, and how they share their load depends on "
                                     "their stiffness; release one of them",
                                     of),
                         "joint " + mechanism.joints[static_cast<std::size_t>(joint)].name,
                         {},
                         {},
                         {}});
  }
}

double force_in(const Project& project, const SituationRun& run, const planar::State& state,
                int joint) {
  for (const planar::Reaction& reaction :
       planar::reactions_of(planar_in(project, *run.situation), state)) {
    if (reaction.joint == joint) return reaction.force.norm();
  }
  return 0.0;
}

/// Compression of a rod: what the joints at either end push along it, the larger one.
double compression_in(const Project& project, const SituationRun& run, const planar::State& state,
                      const RodInput& rod) {
  const double angle = state.q[3 * rod.from.body + 2];
  const Eigen::Vector2d along = Eigen::Rotation2Dd(angle) * (rod.to.p - rod.from.p).normalized();
  const double size = (rod.to.p - rod.from.p).norm();
  double at_from = 0.0;
  double at_to = 0.0;
  for (const planar::Reaction& reaction :
       planar::reactions_of(planar_in(project, *run.situation), state)) {
    if (reaction.on != rod.from.body) continue;
    const double push = reaction.force.dot(along);
    if ((reaction.point - rod.from.p).norm() < 1e-9 * size) at_from += push;
    if ((reaction.point - rod.to.p).norm() < 1e-9 * size) at_to -= push;
  }
  return std::max(at_from, at_to);
}

Check frame(Criterion criterion, const std::string& name, const Project& project,
            const Extreme& worst) {
  Check check;
  check.criterion = criterion;
  check.point = name;
  check.on_beam = false;
  check.situation = project.situations[worst.situation].name;
  check.time = worst.time;
  check.acting = si<Force>(worst.value);
  std::string word = name;
  std::replace(word.begin(), word.end(), ' ', '-');
  check.id = fmt::format("{}/{}", to_text(criterion), word);
  return check;
}

}  // namespace

std::vector<NeighbourResult> check_pins(const Project& project,
                                        const std::deque<SituationRun>& runs) {
  std::vector<NeighbourResult> results;
  for (const PinInput& pin : project.pins) {
    check_unique(project, runs, pin.joint, "pin " + pin.name);
    const Extreme worst =
        worst_of(project, runs, [&](const SituationRun& run, const planar::State& state) {
          return force_in(project, run, state, pin.joint);
        });
    if (worst.value == 0.0) continue;
    NeighbourResult result;
    result.pin = pin_utilisation(si<Force>(worst.value), pin.geometry, pin.strength);
    const PinUtilisation& use = result.pin;
    // All grow with the force; the combined one with its square.
    const double largest = std::max(
        {use.shear, use.bearing_inner, use.bearing_outer, use.bending, std::sqrt(use.combined)});
    Check& check = result.check = frame(Criterion::pin, pin.name, project, worst);
    check.safety_factor = 1.0 / largest;
    check.resisting = si<Force>(worst.value / largest);
    check.required = pin.required;
    check.source = "EN 1993-1-8:2005, 3.13.2, table 3.10";
    results.push_back(std::move(result));
  }
  return results;
}

std::vector<NeighbourResult> check_rods(const Project& project,
                                        const std::deque<SituationRun>& runs) {
  std::vector<NeighbourResult> results;
  for (const RodInput& rod : project.rods) {
    for (std::size_t i = 0; i < planar_of(project).joints.size(); ++i) {
      const auto [a, b] = planar::ends_of(planar_of(project).joints[i]);
      if (a.body != rod.from.body && b.body != rod.from.body) continue;
      check_unique(project, runs, static_cast<int>(i), "rod " + rod.name);
    }
    const Extreme worst =
        worst_of(project, runs, [&](const SituationRun& run, const planar::State& state) {
          return compression_in(project, run, state, rod);
        });
    if (worst.value <= 0.0) continue;
    const SectionProperties properties = properties_of(rod.section);
    NeighbourResult result;
    result.weak_axis = properties.I_z < properties.I_y;
    const Force critical = euler_force(youngs_modulus, properties.I_2, rod.buckling_length);
    result.slenderness = column_slenderness(properties.area, rod.yield_strength, critical);
    result.reduction = column_reduction(result.slenderness, rod.curve);
    const Force resistance =
        buckling_resistance(properties.area, rod.yield_strength, critical, rod.curve, rod.gamma_M1);
    Check& check = result.check = frame(Criterion::buckling, rod.name, project, worst);
    check.resisting = resistance;
    check.safety_factor = check.resisting / check.acting;
    check.required = rod.required;
    check.source = "EN 1993-1-1:2005, 6.3.1";
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace boxbeam
