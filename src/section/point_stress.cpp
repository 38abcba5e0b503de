#include "boxbeam/section/point_stress.hpp"

#include <cmath>

namespace boxbeam {

Stress PointStress::von_mises() const {
  return si<Stress>(
      std::sqrt(normal.value() * normal.value() + 3.0 * shear.value() * shear.value()));
}

StressLevel stress_level_of(const Section& section, const std::vector<Hole>& holes,
                            const SectionProperties& net, Length z) {
  const double arm = (z - net.centroid_z).value();
  const double width = width_at(section, holes, z).value();
  const double first_moment = first_moment_beyond(section, holes, z, net.centroid_z).value();
  StressLevel level;
  level.per_M = arm / net.I_y.value();
  level.per_N = 1.0 / net.area.value() - net.centroid_z.value() * level.per_M;
  // At the crown of a round tube both the first moment and the width vanish, and the shear with
  // them.
  level.per_shear = width > 0.0 ? first_moment / (net.I_y.value() * width) : 0.0;
  return level;
}

PointStress stress_at(const StressLevel& level, const CutForces& cut) {
  return {si<Stress>(level.per_N * cut.N.value() + level.per_M * cut.M_y.value() +
                     level.per_V * cut.V_z.value()),
          si<Stress>(level.per_shear * cut.V_z.value())};
}

}  // namespace boxbeam
