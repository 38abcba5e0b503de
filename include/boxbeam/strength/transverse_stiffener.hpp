#pragma once

#include "boxbeam/core/units.hpp"
#include "boxbeam/strength/patch_loading.hpp"

namespace boxbeam {

/// The least second moment of a stiffener across a web, about the web's middle, that makes it rigid
/// for the shear of the panels beside it.
///
///     I_st = 1.5 h_w^3 t^3/a^2 where a < sqrt(2) h_w,  else 0.75 h_w t^3
///
/// h_w, t  of the web; a  between stiffeners. Source: EN 1993-1-5:2006, 9.3.3(3).
SecondMoment rigid_stiffener_inertia(Length depth, Length thickness, Length length);

/// Of flats on one side of a web, or on both, with 15 eps t of the web on each side of them, about
/// the centroid of all that. Source: EN 1993-1-5:2006, 9.1(2), 9.3.3, figure 9.1.
SecondMoment stiffener_inertia(const BearingStiffener& flats);

}  // namespace boxbeam
