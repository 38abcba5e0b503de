#pragma once

#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/mechanism/flexible/mechanism.hpp"

namespace boxbeam {

/// Stiffness and mass per length of a beam, segment by segment, for the elastic link that it is.
///
///     EA = E A,   GA = G A_s,   EI = E (I_y - I_yz^2/I_z),   mass = rho A,   rotary = rho I_y
///
/// A_s  shear area (`shear_areas_of`); I_y about the centroid; with I_yz the beam bends freely
/// sideways. `youngs_modulus` E and `shear_modulus` G in [Pa]. `rotary` is zero where the beam does
/// not count it. Exact for boxes, plates and tubes whose dimensions change linearly, but for the
/// shear area of a tapered rectangular tube, which is no polynomial and agrees at five places.
/// Valid for axes that go through the centroids: holes and their offset are left out.
/// Source: Timoshenko, On the correction for shear of the differential equation (1921).
std::vector<flexible::LinkStretch> link_stretches_of(const TaperedBeam& beam, double youngs_modulus,
                                                     double shear_modulus);

}  // namespace boxbeam
