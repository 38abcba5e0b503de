#include "boxbeam/section/point_stress.hpp"

#include "boxbeam/section/equivalent_stress.hpp"

namespace boxbeam {
Stress PointStress::von_mises() const {
  return si<Stress>(equivalent_stress(normal.value(), shear.value()));
}

/// Cut forces of zero add nothing, even where their factor is not known.
double stress_of(const std::array<double, cut_force::count>& per_force, const CutForces& cut) {
  const std::array<double, cut_force::count> forces{cut.N.value(),   cut.V_y.value(),
                                                    cut.V_z.value(), cut.T.value(),
                                                    cut.M_y.value(), cut.M_z.value()};
  double sum = 0.0;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces[k] != 0.0) sum += per_force[k] * forces[k];
  }
  return sum;
}

PointStress stress_at(const StressInfluence& influence, const CutForces& cut) {
  return {si<Stress>(stress_of(influence.normal, cut)),
          si<Stress>(stress_of(influence.shear, cut))};
}

StressInfluence shear_scaled(const StressInfluence& influence, double factor) {
  StressInfluence scaled = influence;
  for (double& shear : scaled.shear) shear *= factor;
  return scaled;
}

}  // namespace boxbeam
