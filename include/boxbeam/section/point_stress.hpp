#pragma once

#include <array>

#include "boxbeam/section/cut_forces.hpp"

namespace boxbeam {

/// Nominal stress at one point of a section.
struct PointStress {
  Stress normal;  ///< tension positive
  Stress shear;   ///< along the wall; signed like the cut force that causes it

  /// Equivalent stress of plane stress with one normal component, after von Mises:
  ///
  ///     sigma_v = sqrt(sigma^2 + 3 tau^2)
  Stress von_mises() const;
};

/// Stress per cut force at one point; depends on the section (and its taper) only, SI: 1/m^2 for
/// forces, 1/m^3 for moments.
///
///     sigma = sum normal_k c_k,  tau = sum shear_k c_k,  c = (N, V_y, V_z, T, M_y, M_z)
///
/// N and the moments are about the beam axis. A factor that is not known (the torsion of a general
/// polygon) is NaN: it makes the stress NaN where that cut force is not zero.
struct StressInfluence {
  std::array<double, cut_force::count> normal{};
  std::array<double, cut_force::count> shear{};
};

PointStress stress_at(const StressInfluence& influence, const CutForces& cut);

/// One of the two [Pa]. Cut forces of zero add nothing, even where their factor is not known.
inline double stress_of(const std::array<double, cut_force::count>& per_force,
                        const CutForces& cut) {
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

}  // namespace boxbeam
