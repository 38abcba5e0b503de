#include "boxbeam/section/point_stress.hpp"

#include "boxbeam/section/equivalent_stress.hpp"

namespace boxbeam {
Stress PointStress::von_mises() const {
  return si<Stress>(equivalent_stress(normal.value(), shear.value()));
}

PointStress stress_at(const StressInfluence& influence, const CutForces& cut) {
  return {si<Stress>(stress_of(influence.normal, cut)),
          si<Stress>(stress_of(influence.shear, cut))};
}

}  // namespace boxbeam
