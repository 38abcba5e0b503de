#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "neighbour_parts.hpp"

namespace boxbeam {
namespace {

/// The largest moment of an even rod between pins under its weight and inertia, mass m: the load
/// across it per length is linear, by its mean and by how far its ends are above and below that.
///
///     M <= m L (|mean|/8 + 0.01604 |ends|)
///
/// mean, ends  of g - a across the rod. Source: equilibrium.
double own_moment_of(const planar::Mechanism& mechanism, const planar::State& state,
                     const RodInput& rod) {
  const Eigen::Vector2d line =
      planar::position_of(rod.to, state.q) - planar::position_of(rod.from, state.q);
  const double length = line.norm();
  const Eigen::Vector2d across(-line.y() / length, line.x() / length);
  const auto load_at = [&](const planar::Attachment& end) {
    return across.dot(mechanism.gravity - planar::acceleration_of(end, state.q, state.v, state.a));
  };
  const double from = load_at(rod.from), to = load_at(rod.to);
  const double mass = mechanism.bodies[static_cast<std::size_t>(rod.from.body)].mass;
  constexpr double of_ends = 0.01604;
  return mass * length * (std::abs(from + to) / 16.0 + of_ends * std::abs(from - to) / 2.0);
}

}  // namespace

std::optional<NotJudged> own_bending_of(const Project& project,
                                        const std::deque<SituationRun>& runs, const RodInput& rod) {
  double most = 0.0;
  for (const SituationRun& run : runs) {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    for (const planar::State& state : planar_motion_of(run).states)
      most = std::max(most, run.situation->load_factor * own_moment_of(mechanism, state, rod));
  }
  const SectionProperties of = properties_of(rod.section);
  const double stress = most / std::min(of.W_y, of.W_z).value();
  // As much as a second order that does not count (EN 1993-1-1, 6.3.1.2(4)).
  constexpr double hardly = 0.04;
  if (!(stress > hardly * rod.yield_strength.value())) return std::nullopt;
  return NotJudged{
      Criterion::rod, "rod " + rod.name,
      fmt::format("its own weight and inertia bend it, by {:.3g} MPa at most about its "
                  "weaker axis, which is not counted",
                  1e-6 * stress)};
}

}  // namespace boxbeam
