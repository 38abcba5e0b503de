#include "holding_diaphragm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/strength/weld_throat.hpp"

namespace boxbeam {

std::optional<DistortionEstimate::Holding> holding_of(const Project& project, const Diaphragm& of,
                                                      const BoxCell& cell, double d) {
  const std::vector<PlateOf> plates = plates_around(project, of.s, of.thickness);
  const PlateOf plate = first_to_yield(plates), joined = weakest_to_weld(plates);
  const auto yield = yield_strength_of(*plate.material, plate.thickness);
  const auto tensile = tensile_strength_of(*joined.material, joined.thickness);
  const Length least = std::min(cell.width, cell.height) - of.opening;
  if (!yield || !tensile || !(least > Length{})) return std::nullopt;
  DistortionEstimate::Holding holding{of.s, si<Force>(d / cell.width.value())};
  holding.d = si<Moment>(d);
  ShearPanel panel;
  panel.depth = cell.height;
  panel.length = cell.width;
  panel.thickness = of.thickness;
  panel.yield_strength = *yield;
  holding.plate =
      holding.shear / (shear_resistance_of(panel, project.strength.gamma_M1).resistance *
                       (least / (least + of.opening)));
  if (of.opening > Length{}) {
    const Stress bent =
        si<Stress>(6.0 * 0.25 * d / (of.thickness.value() * 0.25 * least.value() * least.value()));
    holding.plate = std::max(holding.plate, (bent * project.strength.gamma_M0 / *yield).value());
  }
  const WeldStrength strength{*tensile, joined.material->beta_w, project.strength.gamma_M2};
  const Length needed =
      std::sqrt(3.0) * holding.shear / (2.0 * cell.height * weld_strength(plainly, strength));
  if (of.throat > Length{})
    holding.welds = needed / of.throat;
  else
    holding.needed = needed;
  return holding;
}

NotJudged unsaid_welds(const Project& project, const DistortionEstimate::Holding& of) {
  return {
      Criterion::weld,
      fmt::format("welds of the diaphragm at s = {} m", to_text(Station{of.s, Side::both})),
      fmt::format("so that the box keeps its shape fillets on its faces need throats of {:.2g} mm "
                  "beside what forces there ask, which the case does not say",
                  1e3 * project.strength.required * of.needed.value())};
}

}  // namespace boxbeam
