#pragma once

#include <array>
#include <span>
#include <vector>

namespace boxbeam {

/// A beam that may bend sideways and turn about its axis at once, in elements from end to end.
/// Values of elements stand at their two Gauss points.
struct TurningBeam {
  std::vector<double> nodes;  ///< ascending [m]
  std::vector<bool> held;     ///< of each node, against turning about the axis
  std::vector<std::array<double, 2>> turning_stiffness;  ///< G I_T of each element [N m^2]
  /// E I_w of each element, even along it [N m^4]; none: of no element. Where it changes at a node,
  /// warping is free there, on the safe side.
  std::vector<double> warping_stiffness = {};
  /// Of each node, whether the section behind it warps otherwise though its E I_w be the same, so
  /// that warping is free there; none: nowhere.
  std::vector<bool> parted = {};
};

/// Where the Gauss points of an element stand [m].
std::array<double, 2> gauss_places(const TurningBeam& beam, std::size_t element);

/// How much of the load at which a beam buckles by lateral torsion acts: 1/alpha_cr, the smallest
/// alpha > 0 at which
///
///     (G I_T phi')' - (E I_w phi'')'' + (alpha^2 M^2/(E I) + alpha H) phi = 0,
///     phi = 0 where the beam is held
///
/// has a solution; where it is nowhere held, every load buckles it. Nothing holds it against
/// warping (E I_w phi'' = 0 at its ends). Bending sideways is determinate: the beam is held
/// sideways at two places, or clamped at one. `twisting`: M^2/(E I) of each element [N], I that of
/// bending sideways; with M^2 (1/(E I) - 1/(E I_M)) the bow of the bent beam counts, too.
/// `tipping`: forces times their height above the axis at each node, H [N m], above zero where they
/// turn the beam over. `known`: nothing less than this is looked for; it is returned then; nor more
/// than 1e30. To 1e-5 of the result of the elements, which is 1e-3 of the beam's with 64 of them
/// where it tapers by four, 1e-4 with 256. G I_T below zero, of what longitudinal stresses take
/// from it, only with E I_w. Source: Timoshenko, Gere, Theory of Elastic Stability (1961),
/// sections 6.2 to 6.5.
double lateral_buckling_part(const TurningBeam& beam,
                             std::span<const std::array<double, 2>> twisting,
                             std::span<const double> tipping, double known = 0.0);

}  // namespace boxbeam
