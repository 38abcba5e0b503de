#include <algorithm>
#include <functional>

#include "boxbeam/section/section_properties.hpp"
#include "neighbour_parts.hpp"

namespace boxbeam {

Stress rod_modulus_of(const Project& project) {
  return std::min(steel_modulus, si<Stress>(project.model.youngs_modulus), std::less<>());
}

Stress rod_shear_modulus_of(const Project& project) {
  return std::min(steel_shear_modulus, si<Stress>(project.model.shear_modulus), std::less<>());
}

Stress own_bending_of(const NeighbourRuns& runs, const RodInput& rod) {
  double most = 0.0;
  for (const auto& run : runs) {
    for (const SampledInstant& instant : run->span().instants)
      most = std::max(most, run->run().situation->load_factor * run->moment_in(rod, instant.at));
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
