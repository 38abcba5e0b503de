#pragma once

#include "boxbeam/section/point_stress.hpp"

namespace boxbeam {

/// A stress as a function of the cut forces that is linear in them: where these are polynomials, so
/// is it.
struct LinearStress {
  const std::array<double, cut_force::count>* per_force;
  double factor = 1.0;  ///< of a detail

  double operator()(const CutForces& cut) const { return factor * stress_of(*per_force, cut); }
};

}  // namespace boxbeam
