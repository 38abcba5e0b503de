#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace test {

/// How a geometrically nonlinear mechanism is integrated.
struct CorotationalOptions {
  int elements = 32;        ///< of the whole beam, at least
  int steps = 400;          ///< to a period
  double tolerance = 1e-4;  ///< last two periods agree within this, of the largest stress
  int most_periods = 60;
};

/// Nominal stress N/A + M/W and N/A - M/W [Pa] at the two ends of every element of the beam, over
/// the last period.
struct CorotationalStress {
  std::vector<double> places;   ///< s of the elements' ends, two for each [m]
  std::vector<double> largest;  ///< absolute, of both fibres, by place
  double governing = 0.0;       ///< largest of all
  double largest_at(double s) const;
  int periods = 0;
  bool settled = false;
};

/// A planar case whose joints are pins, rigid ones, sliders along fixed lines and one driven angle,
/// its beam divided into corotational elements of Euler and Bernoulli with consistent mass and
/// Kelvin-Voigt damping, its other bodies rigid: absolute coordinates, joints by multipliers,
/// integrated over time from the rigid motion's start until it repeats. Nothing of boxbeam's
/// dynamics is in it but the start. For tests: it knows neither modes nor postures nor linear
/// theory. Sources: Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1
/// (1991), section 7.3, for the element; Arnold, Brüls, Multibody System Dynamics 18 (2007), for
/// the generalised-alpha method with constraints.
CorotationalStress corotational_stress(const boxbeam::Project& project,
                                       const CorotationalOptions& options = {});

}  // namespace test
