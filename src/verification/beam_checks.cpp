#include "boxbeam/verification/beam_checks.hpp"

#include <iterator>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/weld_checks.hpp"

namespace boxbeam {
namespace {

void append(std::vector<CheckResult> more, std::vector<CheckResult>& checks) {
  std::move(more.begin(), more.end(), std::back_inserter(checks));
}

}  // namespace

BeamChecks check_beam(const Project& project, const std::deque<SituationRun>& runs,
                      const std::vector<BendingZone>& zones, const std::vector<Station>& stations,
                      const ModelChoice& model) {
  const bool computed = project.given_stresses.empty();
  BeamChecks beam;
  PlateGates gates(project, zones, model);
  const auto add_outside = [&](const Station& station) {
    beam.stations.push_back(envelope_at(project, station, histories_at(runs, station)));
  };
  add_outside({Length{}, Side::before});
  for (const Station& station : stations) {
    const std::vector<SituationHistory> histories = histories_at(runs, station);
    beam.stations.push_back(envelope_at(project, station, histories));
    if (!computed) continue;
    append(check_station(project, zones, station, histories), beam.checks);
    gates.look_at(station, histories);
  }
  add_outside({project.beam.length(), Side::behind});
  if (!computed) {
    beam.checks = check_given_stresses(project);
    return beam;
  }
  if (beam.checks.empty()) {
    throw AnalysisError(
        {"nothing to verify: no point of the beam is ever stressed", "beam", {}, {}, {}});
  }
  append(check_welds(project, runs), beam.checks);
  gates.look_at(beam.checks);
  beam.gates = gates.gates();
  return beam;
}

}  // namespace boxbeam
