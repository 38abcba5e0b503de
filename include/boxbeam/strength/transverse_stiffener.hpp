#pragma once

#include <optional>
#include <string>

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

/// A plate with stiffeners along it that is compressed, between supports across it.
struct HeldPlate {
  Force compression;      ///< N_Ed, the largest of both panels beside the support
  Length width;           ///< b
  Length before, behind;  ///< a_1, a_2: how far to the supports beside it
};

/// The least second moment of a support across such a plate that lets its stiffeners be columns
/// from one support to the next, about its centroid.
///
///     I_st = sigma_m/E (b/pi)^4 (1 + w_0 300/b u),  sigma_m = N_Ed/b (1/a_1 + 1/a_2)
///     u = pi^2 E e_max/(f_y 300 b/gamma_M1) >= 1,   w_0 = min(a_1, a_2, b)/300
///
/// sigma_cr,c/sigma_cr,p taken as one, its largest; e_max from the centroid to its farther edge.
/// Source: EN 1993-1-5:2006, 9.2.1(5), equation 9.1.
SecondMoment holding_stiffener_inertia(const HeldPlate& plate, Length e_max, Stress yield_strength,
                                       double gamma_M1);

/// Of flats on one side of a web, or on both, with 15 eps t of the web on each side of them, about
/// the centroid of all that. Source: EN 1993-1-5:2006, 9.1(2), 9.3.3, figure 9.1.
SecondMoment stiffener_inertia(const BearingStiffener& flats);

/// What of a plate across a box, which reaches so far beside one of the box's plates, works with
/// it: of a whole one half of its effective width between both (psi = 1, k = 4), of one with an
/// opening that of an outstand up to there (k = 0.43), as at yield. Source: EN 1993-1-5:2006, 4.4,
/// tables 4.1 and 4.2.
Length working_width_of(Length beside, Length thickness, Stress yield_strength, bool whole);

/// The least length of panels for which a stiffener is rigid, up to sqrt(2) h_w; nothing where it
/// is so for none. Shorter panels resist no less than those so long.
std::optional<Length> least_panel_length_of(const BearingStiffener& stiffener);

/// "I = 1.2e+06 mm^4 beside the web is below 3.5e+06 mm^4 (9.3.3(3))" of a stiffener between panels
/// so long, "" where it is rigid.
std::string rigidity_obstacle(const BearingStiffener& stiffener, Length panel_length);

}  // namespace boxbeam
