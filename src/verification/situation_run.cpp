#include "boxbeam/verification/situation_run.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/plausibility.hpp"
#include "boxbeam/verification/whole_life.hpp"

namespace boxbeam {
namespace {

/// Largest force and moment left over on the beam, relative to the largest joint force. Anything
/// but round-off means that the loads do not belong to this beam.
double imbalance_over(const Project& project, double gravity, const LoadHistory& loads) {
  const double weight = mass_properties_of(project.beam).mass.value() * gravity;
  // By the largest force of all: a pulsating load leaves nothing but round-off in an instant.
  double largest = weight;
  const double length = project.beam.length().value();
  double worst = 0.0;
  Time when;
  const std::size_t step = std::max<std::size_t>(1, loads.instants() / 16);
  for (std::size_t i = 0; i < loads.instants(); i += step) {
    const Time time = loads.time_of(i);
    const BeamLoads at = loads.loads_at(time);
    for (const PointLoad& load : at.points)
      largest = std::max({largest, load.force.norm(), load.moment.norm() / length});
    const Imbalance open = imbalance_of(at);
    const double left = open.force.norm() + open.moment.norm() / length;
    if (!std::isfinite(left)) {
      throw AnalysisError(
          {"the loads on the beam are no numbers: masses, stiffnesses or times of "
           "the case are too far apart for the arithmetic",
           "beam", time.value()});
    }
    if (left <= worst) continue;
    worst = left;
    when = time;
  }
  if (largest == 0.0) return 0.0;
  if (worst > 1e-6 * largest) {
    throw AnalysisError(
        {"the loads on the beam are not in balance", "beam", when.value(), worst / largest});
  }
  return worst / largest;
}

}  // namespace

SituationRun::SituationRun(const Project& project, const Situation& of, const ElasticModel& model,
                           const SharedMotions& shared)
    : situation(&of),
      motion(front_end_of(project)->solve(of, model, shared)),
      loads(motion->loads()),
      imbalance(imbalance_over(project, motion->gravity(), loads)) {}

SituationRun::~SituationRun() = default;

std::deque<SituationRun> run_situations(const Project& project, const ElasticModel& model,
                                        const SharedMotions& shared) {
  std::deque<SituationRun> runs;
  const std::size_t places = places_of(project.beam).size();
  std::size_t instants = 0;
  for (const Situation& situation : project.situations) {
    if (!situation.runs()) continue;
    try {
      runs.emplace_back(project, situation, model, shared);
      // What is given need not be solved.
      constexpr std::size_t given_for_solved = 20;
      const LoadHistory& loads = runs.back().loads;
      instants += loads.instants() / (loads.is_recorded() ? given_for_solved : 1);
      require_moderate_work(instants, places);
    } catch (const AnalysisError& error) {
      if (situation.name.empty()) throw;
      AnalysisFailure failure = error.failure();
      failure.details.push_back("situation  " + situation.name);
      throw AnalysisError(std::move(failure));
    }
  }
  const bool is_long = std::any_of(runs.begin(), runs.end(), [](const SituationRun& run) {
    return run.loads.is_recorded() && run.loads.recorded_channels()->record != nullptr;
  });
  if (is_long) {
    const auto whole = std::make_shared<WholeLife>(project, runs);
    for (SituationRun& run : runs) run.loads.count_by(whole);
  }
  return runs;
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
