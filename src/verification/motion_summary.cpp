#include "boxbeam/verification/motion_summary.hpp"

#include "boxbeam/verification/front_end.hpp"

namespace boxbeam {
namespace {

MotionSummary summary_of(const Project& project, const SituationRun& run) {
  MotionSummary summary;
  summary.situation = index_of(project, *run.situation);
  // Of a history that stays open, its end is an instant of its own.
  summary.recorded = run.loads.is_recorded();
  summary.instants = summary.recorded ? run.loads.recorded_instants()
                                      : run.loads.even_instants() - (run.loads.closed() ? 0 : 1);
  summary.begin = run.loads.begin();
  summary.period = run.loads.period();
  summary.closed = run.loads.closed();
  summary.stands_still = run.motion->stands_still();
  summary.imbalance = run.imbalance;
  summary.closure = run.motion->closure();
  summary.reactions = run.motion->reactions(run.loads);
  return summary;
}

}  // namespace

std::vector<MotionSummary> motion_summaries_of(const Project& project,
                                               const std::deque<SituationRun>& runs) {
  std::vector<MotionSummary> summaries;
  for (const SituationRun& run : runs) summaries.push_back(summary_of(project, run));
  return summaries;
}

}  // namespace boxbeam
