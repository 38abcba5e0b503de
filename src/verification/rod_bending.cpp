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

Stress own_bending_of(const Project& project, const std::deque<SituationRun>& runs,
                      const RodInput& rod) {
  double most = 0.0;
  for (const SituationRun& run : runs) {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    for (const planar::State& state : planar_motion_of(run).states)
      most = std::max(most, run.situation->load_factor * own_moment_of(mechanism, state, rod));
  }
  const SectionProperties of = properties_of(rod.section);
  return si<Stress>(most / std::min(of.W_y, of.W_z).value());
}

double use_with_bending(const RodInput& rod, const NeighbourResult& result, Stress bending) {
  const double use = result.check.utilisation();
  const auto* const pressed = std::get_if<PressedRod>(&result.basis);
  const double part = rod.required * (bending / rod.yield_strength).value();
  if (pressed == nullptr) return use + rod.gamma_M0 * part;
  const double whole = (pressed->section.area / pressed->section.effective).value();
  return use + (1.0 + 0.6 * std::min(use, 1.0)) * whole * rod.gamma_M1 * part;
}

}  // namespace boxbeam
