#pragma once

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Which size lowers the fatigue strength of a detail. Only where its row of the tables says so.
enum class SizeEffect { none, butt, eccentric_butt, bolt };

/// Factor on the strength of a transverse butt weld in a thick plate, 1 up to 25 mm.
///
///     k_s = (25 mm/t)^0.2
///
/// Source: EN 1993-1-9:2005, 7.2.2, equation 7.1, table 8.3.
double size_factor_of_butt_weld(Length thickness);

/// Factor on the strength of a transverse butt weld between plates of two thicknesses whose middle
/// planes are offset, without a transition.
///
///     k_s = (25 mm/t1)^0.2 / (1 + (6 e/t1) t1^1.5/(t1^1.5 + t2^1.5))
///
/// The first part is 1 up to 25 mm. Valid for t2 >= t1, e >= 0.
/// Source: EN 1993-1-9:2005, table 8.3, detail 17.
double size_factor_of_eccentric_butt_weld(Length thinner, Length thicker, Length eccentricity);

/// Factor on the strength of a thick bolt or rod in tension, 1 up to 30 mm.
///
///     k_s = (30 mm/d)^0.25
///
/// Source: EN 1993-1-9:2005, table 8.1, detail 14: recalled, not confirmed.
double size_factor_of_bolt(Length diameter);

}  // namespace boxbeam
