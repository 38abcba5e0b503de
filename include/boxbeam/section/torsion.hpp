#pragma once

#include <optional>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// Torsion constant I_T of a solid rectangle.
///
///     I_T = b^3 h/3 (1 - 192 b/(pi^5 h) sum_{n odd} tanh(n pi h/(2 b))/n^5),  b <= h
///
/// Source: Timoshenko and Goodier, Theory of Elasticity, article 109.
SecondMoment torsion_constant_of_rectangle(Length a, Length b);

/// Largest shear stress of a solid rectangle per torque, in the middle of a side [1/m^3]: `side` is
/// the length of that side, `other` of the other. Source: the same article.
double torsion_shear_of_rectangle(Length side, Length other);

/// Torsion constant of a thick-walled rectangular box with sharp corners, its four plates
/// thicknesses of their own:
///
///     I_T = J_0 + 4 (A_h + W)^2/C
///
/// exact for Prandtl's stress function phi = phi_0 + k psi: psi is harmonic, 0 on the outer and 1
/// on the inner border; C the integral of its slope along the inner border, W of psi dA; phi_0
/// vanishes on both, J_0 = 2 int phi_0 dA; A_h the area of the hollow. Straight walls of length s
/// give s/t, s t/2 and s t^3/3; a corner adds C exactly (conformal map), W and J_0 from a table of
/// a finite- element solution of the corner. Valid for clear sides longer than 1.5 times the plates
/// they lie between, where one corner does not feel the next. With C on mid-lines and no J_0 this
/// is Bredt's formula, 4 % low for a box of height 1000, width 400, plates 50. Source: Prandtl
/// (1903); Timoshenko and Goodier, article 115; corner capacitance: Cohn (1954).
SecondMoment torsion_constant_of_box(const Box& box);

/// Torsion constant of a profile for free warping; nothing where it is not known (polygons).
/// Stiffeners add d t^3/3. Rolled tubes:
///
///     I_T = t^3 h/3 + 4 A_h^2 t/h,  h = 2 ((B - t) + (H - t)) - 2 R_c (4 - pi),
///     A_h = (B - t)(H - t) - R_c^2 (4 - pi),  R_c mean corner radius
///
/// Round tubes: polar second moment. Thin-walled paths: cells after Bredt, and s t^3/3 of all
/// walls. Source: EN 10210-2:2006, annex B (recalled, not confirmed).
std::optional<SecondMoment> torsion_constant_of(const Profile& profile);

/// Of an outer and an inner profile that twist alike.
std::optional<SecondMoment> torsion_constant_of(const Section& section);

/// Area inside the mid-lines of all cells of a profile; zero where there is none.
Area enclosed_area_of(const Profile& profile);

/// What an outer and an inner profile offer together, twisting alike; warping resistance (I_w) is
/// not included.
struct TorsionProperties {
  std::optional<SecondMoment> I_T;
  Area enclosed;  ///< A_m, of all cells of the outer profile
  /// Where transverse forces cause no twist; nothing for polygons.
  std::optional<SectionPlace> shear_centre;
};

TorsionProperties torsion_properties_of(const Section& section);

}  // namespace boxbeam
