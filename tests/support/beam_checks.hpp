#pragma once

#include "boxbeam/verification/beam_checks.hpp"
#include "boxbeam/verification/verified_stations.hpp"

namespace test {

/// What is found in the beam of rigid bodies, at given stations.
inline boxbeam::BeamChecks beam_checks_at(const boxbeam::Project& project,
                                          const std::vector<boxbeam::Station>& stations) {
  const std::deque<boxbeam::SituationRun> runs = boxbeam::run_situations(project);
  const auto zones = boxbeam::bending_zones_of(project, runs);
  return boxbeam::check_beam(project, runs, zones, {stations}, {});
}

/// The same at the stations that the search gives.
inline boxbeam::BeamChecks beam_checks_of(const boxbeam::Project& project,
                                          const boxbeam::ModelChoice& model = {}) {
  const std::deque<boxbeam::SituationRun> runs = boxbeam::run_situations(project);
  const auto zones = boxbeam::bending_zones_of(project, runs);
  const auto found = boxbeam::search_stations(project, runs, zones);
  return boxbeam::check_beam(project, runs, zones, found, model);
}

}  // namespace test
