#include "boxbeam/verification/chain_comparison.hpp"

#include <algorithm>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "planar_pictures.hpp"

namespace boxbeam {
namespace {

ChainComparison compare_chain(const Project& project, const planar::State& state) {
  const planar::NewtonChain& chain = *project.chain;
  ChainComparison comparison;
  comparison.time = si<Time>(state.time);
  const planar::ChainForces forces = planar::chain_at(chain, state);
  comparison.chain_first = forces.g[chain.first_end];
  comparison.chain_second = forces.g[chain.second_end];
  comparison.chain_mass = si<Mass>(forces.sought_mass);
  const BeamLoads loads = planar::beam_loads_of(
      chain, project.beam, mass_distribution_of(project.beam), planar_of(project).gravity, state);
  comparison.moment_gap = si<Moment>(loads.points.back().moment.y());
  comparison.rigorous_first.setZero();
  comparison.rigorous_second.setZero();
  if (project.beam_body == planar::ground) return comparison;
  const auto body = planar::beam_body_of(project.beam, project.beam_body);
  const BeamLoads rigorous = planar::beam_loads_of(planar_of(project), state, body);
  for (const BeamLoadRow& row : load_rows(project, rigorous, state)) {
    if (row.s == chain.first_station) comparison.rigorous_first += row.world.head<2>();
    if (row.s == chain.second_station) comparison.rigorous_second += row.world.head<2>();
  }
  return comparison;
}

}  // namespace

std::optional<ChainComparison> chain_comparison_of(const Project& project,
                                                   const std::deque<SituationRun>& runs,
                                                   const std::vector<CriticalInstant>& instants) {
  if (!project.chain) return std::nullopt;
  const auto largest_M = std::find_if(
      instants.begin(), instants.end(),
      [](const CriticalInstant& instant) { return instant.force && instant.force->bends(); });
  const SituationRun& run = run_of(runs, project.situations[largest_M->situation]);
  planar::StateFinder finder(planar_in(project, *run.situation), planar_motion_of(run));
  return compare_chain(project, finder.at(largest_M->time.value()));
}

}  // namespace boxbeam
