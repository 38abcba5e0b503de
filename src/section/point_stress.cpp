#include "boxbeam/section/point_stress.hpp"

#include "boxbeam/section/equivalent_stress.hpp"

namespace boxbeam {
namespace {

/// Cut forces of zero add nothing, even where their factor is not known.
double sum_of(const std::array<double, 6>& factors, const CutForces& cut) {
  const std::array<double, 6> forces{cut.N.value(), cut.V_y.value(), cut.V_z.value(),
                                     cut.T.value(), cut.M_y.value(), cut.M_z.value()};
  double sum = 0.0;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces[k] != 0.0) sum += factors[k] * forces[k];
  }
  return sum;
}

}  // namespace

Stress PointStress::von_mises() const {
  return si<Stress>(equivalent_stress(normal.value(), shear.value()));
}

PointStress stress_at(const StressInfluence& influence, const CutForces& cut) {
  return {si<Stress>(sum_of(influence.normal, cut)), si<Stress>(sum_of(influence.shear, cut))};
}

StressInfluence shear_scaled(const StressInfluence& influence, double factor) {
  StressInfluence scaled = influence;
  for (double& shear : scaled.shear) shear *= factor;
  return scaled;
}

}  // namespace boxbeam
