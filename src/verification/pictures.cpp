#include "boxbeam/verification/pictures.hpp"

#include <fmt/format.h>

#include "boxbeam/verification/beam_memory.hpp"

namespace boxbeam {
namespace {

/// A page with more of them would be too large to be opened.
constexpr std::size_t most_cycles_drawn = 24;

}  // namespace

std::size_t governing_situation_of(const std::vector<CheckResult>& checks,
                                   const std::vector<MotionSummary>& motions) {
  const CheckResult* governing = first_by_cut_forces(checks);
  return governing != nullptr ? governing->basis->running : motions.front().situation;
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

Pictures pictures_of(const Project& project, const std::deque<SituationRun>& runs,
                     const ElasticModel& model, const std::vector<CheckResult>& checks,
                     const std::vector<CriticalInstant>& instants,
                     const std::vector<MotionSummary>& motions, Figures figures,
                     BeamMemory* memory) {
  const SituationRun& first = runs.front();
  Pictures pictures;
  if (memory == nullptr) {
    pictures.envelope = envelope_lines(runs);
  } else {
    if (!memory->envelope) memory->envelope = envelope_lines(runs);
    pictures.envelope = *memory->envelope;
  }
  pictures.elastic = front_end_of(project)->elastic_figures(first, model);
  pictures.postures.push_back(pictures.elastic
                                  ? pictures.elastic->rest
                                  : postures_of(project, first)(first.loads.begin(), "beginning"));
  for (const auto& [index, time, why, weight] : instants_to_show(project, instants, motions)) {
    const Situation& situation = project.situations[index];
    const SituationRun& run = run_of(runs, situation);
    const std::string label =
        situation.name.empty() ? why : fmt::format("{} ({})", why, situation.name);
    pictures.lines.push_back(cut_force_line(run, time, label));
    pictures.postures.push_back(postures_of(project, run)(time, label));
    pictures.postures.back().weight = weight;
    const std::vector<BeamLoadRow>& rows = pictures.postures.back().loads;
    pictures.loads.insert(pictures.loads.end(), rows.begin(), rows.end());
  }
  const CheckResult* governing = first_by_cut_forces(checks);
  if (project.in_space && governing != nullptr) {
    pictures.loads_over_time = loads_over_time(project, runs, governing->check.station);
  }
  if (const CheckResult* fatigue = governing_of(checks, Criterion::fatigue)) {
    pictures.sn = sn_figure(project, *fatigue, checks);
  }
  if (figures == Figures::without) return pictures;
  const std::size_t worst = governing_situation_of(checks, motions);
  for (const SituationRun& run : runs) {
    const bool among_first = pictures.cycles.size() < most_cycles_drawn;
    if (among_first || index_of(project, *run.situation) == worst)
      pictures.cycles.push_back(cycle_figure_of(project, run, governing, figures));
  }
  pictures.drivers = first.motion->driver_lines(first.loads);
  pictures.section = section_figure_of(project, runs, checks);
  return pictures;
}

}  // namespace boxbeam
