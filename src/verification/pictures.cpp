#include "boxbeam/verification/pictures.hpp"

#include <fmt/format.h>

#include "boxbeam/verification/critical_instants.hpp"

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

}  // namespace

std::size_t governing_situation_of(const Verification& verification) {
  for (const CheckResult& result : verification.checks) {
    if (result.basis) return result.basis->running;
  }
  return verification.motions.front().situation;
}

PostureAt postures_of(const Project& project, const SituationRun& run) {
  return [&run, situation = index_of(project, *run.situation),
          bare = run.motion->postures(run.loads)](Time time, const std::string& why) {
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
  result.elastic = front_end_of(project)->elastic_figures(first, result.model.chosen);
  result.postures.push_back(result.elastic
                                ? result.elastic->rest
                                : postures_of(project, first)(first.loads.begin(), "beginning"));
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
  if (project.in_space && governing != nullptr) {
    result.loads_over_time = loads_over_time(project, runs, *governing);
  }
  if (figures == Figures::without) return;
  const std::size_t worst = governing_situation_of(result);
  for (const SituationRun& run : runs) {
    const bool among_first = result.cycles.size() < most_cycles_drawn;
    if (among_first || index_of(project, *run.situation) == worst)
      result.cycles.push_back(cycle_figure_of(project, run));
  }
  result.drivers = first.motion->driver_lines(first.loads);
  result.section = section_figure_of(project, runs, result.checks);
}

}  // namespace boxbeam
