#include "neighbour_loads.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {

bool RodMass::is_even() const {
  constexpr double percent = 0.01;
  const double even = mass * length * length / 12.0;
  return std::abs(centre - 0.5 * length) <= percent * length && beside <= percent * length &&
         std::abs(inertia - even) <= percent * even;
}

double RodMass::lever() const {
  return std::max(0.0, mass * centre * (length - centre) - inertia) / length;
}

double NeighbourLoads::within(double time) const {
  return run_->loads.closed() ? time : std::clamp(time, span_.begin, span_.begin + span_.period);
}

Extreme NeighbourLoads::largest(const Project& project,
                                const std::function<double(double)>& f) const {
  // At the instants of the loads: they know where drivers and forces jump or bend.
  std::vector<double> values;
  for (const SampledInstant& instant : span_.instants) values.push_back(f(instant.at));
  const Extremum peak = peak_over_time(values, span_, f);
  return {si<Time>(peak.at), peak.value, index_of(project, *run_->situation)};
}

NeighbourRuns neighbour_loads_of(const Project& project, const std::deque<SituationRun>& runs) {
  NeighbourRuns all;
  for (const SituationRun& run : runs)
    all.push_back(project.in_space ? spatial_neighbour_loads(project, run)
                                   : planar_neighbour_loads(project, run));
  return all;
}

}  // namespace boxbeam
