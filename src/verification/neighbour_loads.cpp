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

std::optional<Polynomial<2>> RodMass::along() const {
  const double L = length, off = centre - 0.5 * L;
  const double J = inertia + mass * off * off;
  double b = 12.0 * mass * off / (L * L);
  double c = 180.0 * (J / (L * L * L) - mass / (12.0 * L));
  // What round-off leaves of an even rod.
  constexpr double nothing = 1e-9;
  const double even = mass / L;
  if (std::abs(b) <= nothing * even) b = 0.0;
  if (std::abs(c) <= nothing * even) c = 0.0;
  const double a = even - c / 12.0;
  const auto at = [&](double xi) { return a + b * xi + c * xi * xi; };
  const double lowest = c > 0.0 ? std::clamp(-0.5 * b / c, -0.5, 0.5) : 0.5;
  if (std::min({at(-0.5), at(lowest), at(0.5)}) < -nothing * even) return std::nullopt;
  return Polynomial<2>{{at(-0.5), (b - c) / L, c / (L * L)}};
}

RodMass mass_of(const Body& body, const PlanarRod& rod) {
  const Eigen::Vector2d line = rod.to.p - rod.from.p, centre = -rod.from.p;
  const double length = line.norm();
  const Eigen::Vector2d own = line / length;
  return {body.mass, length, own.dot(centre), std::abs(own.x() * centre.y() - own.y() * centre.x()),
          body.inertia};
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
    all.push_back(project.in_space ? spatial_neighbour_loads(run)
                                   : planar_neighbour_loads(project, run));
  return all;
}

}  // namespace boxbeam
