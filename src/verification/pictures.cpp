#include "boxbeam/verification/pictures.hpp"

#include <fmt/format.h>

#include <memory>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/verification/critical_instants.hpp"
#include "boxbeam/verification/elastic_posture.hpp"

namespace boxbeam {
namespace {

/// The station of the worst check that rests on cut forces.
const Station* governing_station_of(const Verification& verification) {
  for (const CheckResult& result : verification.checks) {
    if (result.basis) return &result.check.station;
  }
  return nullptr;
}

/// A page with more of them would be too large to be opened.
constexpr std::size_t most_cycles_drawn = 24;

PostureAt elastic_postures_of(const Project& project, const SituationRun& run) {
  constexpr double part = 0.06;
  const FlexibleMotion& motion = flexible_motion_of(run);
  const double magnified =
      magnification_of(*motion.structure, largest_displacement(motion.response), part);
  return [&project, &run, &motion, magnified](Time time, const std::string& why) {
    const DeformedPosture deformed{motion.structure.get(),
                                   flexible::at(motion.response, time.value()), magnified};
    PostureFigure posture = posture_figure(project, deformed, why);
    posture.time = time;
    posture.loads = load_rows(project, deformed, run.loads.loads_at(time));
    return posture;
  };
}

PostureAt postures_in_space_of(const Project& project, const SituationRun& run) {
  const spatial::Mechanism& mechanism = spatial_in(project, *run.situation);
  auto chain = std::make_shared<const spatial::Chain>(mechanism);
  return [&project, &run, &mechanism, chain](Time time, const std::string& why) {
    const spatial::State state = chain->at(time.value());
    PostureFigure posture = posture_figure(project, mechanism, state, why);
    posture.loads = load_rows(project, mechanism, run.loads.loads_at(time), state);
    return posture;
  };
}

PostureAt planar_postures_of(const Project& project, const SituationRun& run) {
  const planar::Mechanism& mechanism = planar_in(project, *run.situation);
  auto finder = std::make_shared<planar::StateFinder>(mechanism, planar_motion_of(run));
  return [&project, &run, &mechanism, finder](Time time, const std::string& why) {
    const planar::State state = finder->at(time.value());
    PostureFigure posture = posture_figure(project, mechanism, state, why);
    posture.loads = load_rows(project, mechanism, run.loads.loads_at(time), state);
    return posture;
  };
}

}  // namespace

std::size_t governing_situation_of(const Verification& verification) {
  for (const CheckResult& result : verification.checks) {
    if (result.basis) return result.basis->running;
  }
  return verification.motions.front().situation;
}

PostureAt postures_of(const Project& project, const SituationRun& run) {
  PostureAt bare = is_flexible(project) ? elastic_postures_of(project, run)
                   : in_space(project)  ? postures_in_space_of(project, run)
                                        : planar_postures_of(project, run);
  return [&run, situation = index_of(project, *run.situation), bare = std::move(bare)](
             Time time, const std::string& why) {
    PostureFigure posture = bare(time, why);
    posture.situation = run.situation->name;
    for (BeamLoadRow& row : posture.loads) {
      row.time = time;
      row.situation = situation;
    }
    return posture;
  };
}

void add_pictures(const Project& project, const std::deque<SituationRun>& runs, Figures figures,
                  Verification& result) {
  const SituationRun& first = runs.front();
  result.envelope = envelope_lines(runs);
  if (is_flexible(project)) {
    result.elastic = elastic_figures_of(project, first, result.model.chosen);
    result.postures.push_back(result.elastic->rest);
  } else {
    result.postures.push_back(postures_of(project, first)(first.loads.begin(), "beginning"));
  }
  for (const auto& [index, time, why, weight] : instants_to_show(project, result)) {
    const Situation& situation = project.situations[index];
    const SituationRun& run = run_of(runs, situation);
    const std::string label =
        situation.name.empty() ? why : fmt::format("{} ({})", why, situation.name);
    result.lines.push_back(cut_force_line(run, time, label));
    result.postures.push_back(postures_of(project, run)(time, label));
    result.postures.back().weight = weight;
    const std::vector<BeamLoadRow>& rows = result.postures.back().loads;
    result.loads.insert(result.loads.end(), rows.begin(), rows.end());
  }
  const Station* governing = governing_station_of(result);
  if (in_space(project) && governing != nullptr) {
    result.loads_over_time = loads_over_time(project, runs, *governing);
  }
  if (figures == Figures::without) return;
  const std::size_t worst = governing_situation_of(result);
  for (const SituationRun& run : runs) {
    const bool among_first = result.cycles.size() < most_cycles_drawn;
    if (among_first || index_of(project, *run.situation) == worst)
      result.cycles.push_back(cycle_figure_of(project, run));
  }
  result.drivers = driver_lines_of(project, first);
  result.section = section_figure_of(project, runs, result.checks);
}

}  // namespace boxbeam
