#include "boxbeam/section/point_stress.hpp"

#include "boxbeam/section/equivalent_stress.hpp"

namespace boxbeam {
Stress PointStress::von_mises() const {
  return si<Stress>(equivalent_stress(normal.value(), shear.value()));
}

/// Cut forces of zero add nothing, even where their factor is not known.
double stress_of(const std::array<double, cut_force::count>& per_force, const CutForces& cut) {
  double sum = 0.0;
  const auto add = [&](cut_force::Index which, double force) {
    if (force != 0.0) sum += per_force[which] * force;
  };
  add(cut_force::N, cut.N.value());
  add(cut_force::V_y, cut.V_y.value());
  add(cut_force::V_z, cut.V_z.value());
  add(cut_force::T, cut.T.value());
  add(cut_force::M_y, cut.M_y.value());
  add(cut_force::M_z, cut.M_z.value());
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
