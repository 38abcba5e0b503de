#include "boxbeam/verification/situation_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/verification/elastic_model.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/plausibility.hpp"
#include "boxbeam/verification/sudden_start.hpp"

namespace boxbeam {
namespace {

/// Stops where a joint has slid off the end of the beam.
void check_on_beam(const Project& project, const BeamLoads& loads, Time time) {
  const double length = project.beam.length().value();
  for (const PointLoad& load : loads.points) {
    const double s = load.s.value();
    if (s >= -1e-9 * length && s <= (1.0 + 1e-9) * length) continue;
    throw AnalysisError({fmt::format("a joint slides off the beam: it stands at s = {:.6g} m, and "
                                     "the beam goes from 0 to {:.6g} m",
                                     s, length),
                         "beam",
                         time.value(),
                         {},
                         {}});
  }
}

/// Where the loads on the beam come from at any time: the mechanism's reactions or the chain.
LoadsAt loads_of(const Project& project, const planar::Mechanism& mechanism,
                 const planar::Motion& motion) {
  auto finder = std::make_shared<planar::StateFinder>(mechanism, motion);
  if (project.dynamics == Dynamics::newton_chain) {
    auto distribution = mass_distribution_of(project.beam);
    return [&project, &mechanism, finder, distribution](Time time) {
      return planar::beam_loads_of(*project.chain, project.beam, distribution, mechanism.gravity,
                                   finder->at(time.value()));
    };
  }
  auto body = planar::beam_body_of(project.beam, project.beam_body);
  return [&project, &mechanism, finder, body](Time time) {
    BeamLoads loads = planar::beam_loads_of(mechanism, finder->at(time.value()), body);
    check_on_beam(project, loads, time);
    return loads;
  };
}

LoadsAt loads_of(const Project& project, const spatial::Mechanism& mechanism) {
  auto chain = std::make_shared<const spatial::Chain>(mechanism);
  auto body = spatial::beam_body_of(project.beam, placement_in(project, mechanism), mechanism);
  return [&project, chain, body](Time time) {
    BeamLoads loads = spatial::beam_loads_of(*chain, chain->at(time.value()), body);
    check_on_beam(project, loads, time);
    return loads;
  };
}

/// Stops where rigid bodies do not determine what acts on the beam.
void check_unique_loads(const planar::Mechanism& mechanism, const planar::Motion& motion,
                        int beam_body) {
  std::string names;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const auto [a, b] = planar::ends_of(mechanism.joints[i]);
    const bool on_beam = a.body == beam_body || b.body == beam_body;
    const bool rubs = planar::rubs(mechanism.joints[i]);
    if (!on_beam && !rubs) continue;
    if (planar::is_unique(mechanism, motion.freedom, static_cast<int>(i))) continue;
    names += (names.empty() ? "joint " : ", ") + mechanism.joints[i].name;
  }
  if (names.empty() || beam_body == planar::ground) return;
  throw AnalysisError(
      {fmt::format("the loads on the beam are not determined by rigid bodies: joints repeat each "
                   "other ({}), and how they share their load depends on their stiffness; release "
                   "one of them (a slot for a pin, a slider without its angle)",
                   fmt::join(planar::names_of_joints(mechanism, motion.freedom.repeating), ", ")),
       names,
       {},
       {},
       {}});
}

using AnyMotion = std::variant<planar::Motion, spatial::Motion, FlexibleMotion>;

AnyMotion motion_in(const Project& project, const Situation& situation, const ElasticModel& model) {
  if (is_flexible(project)) return flexible_motion_of(flexible_in(project, situation), model);
  if (in_space(project)) {
    return spatial::motion_of(spatial::Chain(spatial_in(project, situation)));
  }
  const planar::Mechanism& mechanism = planar_in(project, situation);
  planar::Motion motion = planar::solve_motion(mechanism);
  check_unique_loads(mechanism, motion, project.beam_body);
  return motion;
}

/// When drivers and forces are not smooth, within a time that is looked at.
std::vector<Time> breaks_in(const std::vector<DriverUse>& functions, double begin, double length) {
  std::vector<Time> times;
  for (const Break& at : breaks_of(functions, begin, begin + length)) {
    times.push_back(si<Time>(at.at));
  }
  return times;
}

LoadHistory loads_in(const Project& project, const Situation& situation, const AnyMotion& motion,
                     const ElasticModel& model) {
  if (situation.sudden_start) return loads_after_start(project, situation, model);
  if (const auto* elastic = std::get_if<FlexibleMotion>(&motion)) {
    // Statics alone hold for any time: a second is looked at.
    constexpr std::size_t instants = 96;
    const double frequency = elastic->response.frequency;
    const LoadSpan span{Time{}, si<Time>(frequency > 0.0 ? 1.0 / frequency : 1.0), instants, true};
    auto of = std::make_shared<const flexible::BeamResponse>(
        flexible::beam_response_of(*elastic->structure, project.beam_body, project.beam,
                                   elastic->response, elastic->inertial));
    return {span, [of](Time time) { return flexible::beam_loads_at(*of, time.value()); }};
  }
  if (const auto* space = std::get_if<spatial::Motion>(&motion)) {
    const spatial::Mechanism& mechanism = spatial_in(project, situation);
    const LoadSpan span{si<Time>(space->begin), si<Time>(space->period), space->instants,
                        space->closed,
                        breaks_in(spatial::functions_of(mechanism), space->begin, space->period)};
    return {span, loads_of(project, mechanism)};
  }
  const auto& plane = std::get<planar::Motion>(motion);
  const planar::Mechanism& mechanism = planar_in(project, situation);
  const LoadSpan span{si<Time>(plane.begin), si<Time>(plane.period), plane.states.size(),
                      plane.closed,
                      breaks_in(planar::functions_of(mechanism), plane.begin, plane.period)};
  return {span,
          elastic_loads_of(project, situation, plane, model, loads_of(project, mechanism, plane))};
}

double gravity_of(const Project& project, const Situation& situation) {
  if (is_flexible(project)) return flexible_in(project, situation).gravity.norm();
  return in_space(project) ? spatial_in(project, situation).gravity.norm()
                           : planar_in(project, situation).gravity.norm();
}

/// Largest force and moment left over on the beam, relative to the largest joint force. Anything
/// but round-off means that the loads do not belong to this beam.
double imbalance_over(const Project& project, const Situation& situation,
                      const LoadHistory& loads) {
  const double weight =
      mass_properties_of(project.beam).mass.value() * gravity_of(project, situation);
  // By the largest force of all: a pulsating load leaves nothing but round-off in an instant.
  double largest = weight;
  double worst = 0.0;
  Time when;
  const std::size_t step = std::max<std::size_t>(1, loads.instants() / 16);
  for (std::size_t i = 0; i < loads.instants(); i += step) {
    const Time time = loads.time_of(i);
    const BeamLoads at = loads.loads_at(time);
    for (const PointLoad& load : at.points) largest = std::max(largest, load.force.norm());
    const Imbalance open = imbalance_of(at);
    const double left = open.force.norm() + open.moment.norm() / project.beam.length().value();
    if (!std::isfinite(left)) {
      throw AnalysisError(
          {"the loads on the beam are no numbers: masses, stiffnesses or times of "
           "the case are too far apart for the arithmetic",
           "beam",
           time.value(),
           {},
           {}});
    }
    if (left <= worst) continue;
    worst = left;
    when = time;
  }
  if (largest == 0.0) return 0.0;
  if (worst > 1e-6 * largest) {
    throw AnalysisError(
        {"the loads on the beam are not in balance", "beam", when.value(), worst / largest, {}});
  }
  return worst / largest;
}

/// Static response to loads and to the inertia of a motion, as phasors.
flexible::Deformation<flexible::Complex> static_response_to(
    const flexible::Structure& structure, const flexible::LinkColumns<flexible::Complex>& inertial,
    double frequency) {
  const double square = std::pow(2.0 * std::numbers::pi * frequency, 2);
  flexible::LinkColumns<flexible::Complex> loads = flexible::harmonic_loads(structure);
  const auto inertia = flexible::mass_times(structure, inertial);
  for (std::size_t k = 0; k < loads.size(); ++k) loads[k] += square * inertia[k];
  return flexible::DynamicStiffness<flexible::Complex>(structure, 0.0, 0.0).solve(loads);
}

}  // namespace

FlexibleMotion flexible_motion_of(const flexible::Mechanism& of, const ElasticModel& model) {
  FlexibleMotion motion;
  motion.mechanism = std::make_shared<const flexible::Mechanism>(modelled(of, model));
  motion.structure =
      std::make_shared<const flexible::Structure>(flexible::structure_of(*motion.mechanism));
  const flexible::Structure& structure = *motion.structure;
  const bool reduced = model.level == ModelLevel::quasi_static || model.level == ModelLevel::modal;
  if (!reduced || of.frequency == 0.0) {
    motion.response = flexible::response_of(structure);
    motion.inertial = motion.response.harmonic.motion;
    return motion;
  }
  motion.response.frequency = of.frequency;
  motion.response.constant = flexible::static_response(structure);
  motion.inertial = flexible::no_loads<flexible::Complex>(structure);
  if (model.level == ModelLevel::modal) {
    const flexible::ModalModel modes =
        flexible::modal_model_of(structure, static_cast<std::size_t>(model.modes));
    motion.inertial = flexible::harmonic_response(modes, of.frequency, false).motion;
  }
  motion.response.harmonic = static_response_to(structure, motion.inertial, of.frequency);
  return motion;
}

SituationRun::SituationRun(const Project& project, const Situation& of, const ElasticModel& model)
    : situation(&of),
      motion(motion_in(project, of, model)),
      loads(loads_in(project, of, motion, model)),
      imbalance(imbalance_over(project, of, loads)) {}

std::deque<SituationRun> run_situations(const Project& project, const ElasticModel& model) {
  std::deque<SituationRun> runs;
  const std::size_t places = places_of(project.beam).size();
  std::size_t instants = 0;
  for (const Situation& situation : project.situations) {
    if (!situation.between.empty()) continue;
    try {
      runs.emplace_back(project, situation, model);
      instants += runs.back().loads.instants();
      require_moderate_work(instants, places);
    } catch (const AnalysisError& error) {
      if (situation.name.empty()) throw;
      AnalysisFailure failure = error.failure();
      failure.details.push_back("situation  " + situation.name);
      throw AnalysisError(std::move(failure));
    }
  }
  return runs;
}

const planar::Motion& planar_motion_of(const SituationRun& run) {
  return std::get<planar::Motion>(run.motion);
}

const FlexibleMotion& flexible_motion_of(const SituationRun& run) {
  return std::get<FlexibleMotion>(run.motion);
}

std::size_t index_of(const Project& project, const Situation& situation) {
  return static_cast<std::size_t>(&situation - project.situations.data());
}

const SituationRun& run_of(const std::deque<SituationRun>& runs, const Situation& situation) {
  return *std::find_if(runs.begin(), runs.end(),
                       [&](const SituationRun& run) { return run.situation == &situation; });
}

std::vector<SituationHistory> histories_at(const std::deque<SituationRun>& runs,
                                           const Station& station) {
  std::vector<SituationHistory> histories;
  for (const SituationRun& run : runs) {
    histories.push_back({run.situation, StationHistory(run.loads, station)});
  }
  return histories;
}

}  // namespace boxbeam
