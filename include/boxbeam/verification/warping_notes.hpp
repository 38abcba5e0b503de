#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Largest bimoment of a bar in torsion, a bound from above [N m^2].
///
///     B <= T/k tanh(k L),  k^2 = G I_T/(E I_w)
///
/// T  largest torque in it, about its shear centre [N m]; L its length [m]; its ends warp freely or
/// are held, each by itself (both free, and torques that come in at one place: half of them over k,
/// tanh(k L/2)). Of phi' the equation is phi''' - k^2 phi' = -T/(E I_w), and of no way in which T
/// runs along the bar is B = -E I_w phi'' larger. Valid for prismatic bars.
/// Source: Vlasov, Thin-walled elastic beams (1961).
double largest_bimoment(double torque, double GI_T, double EI_w, double length);

/// Stresses of warping that no check counts.
struct WarpingFound {
  std::vector<Gate> gates;
  std::vector<NotJudged> not_judged;
};

/// Stresses along the beam by torsion of open sections that are held from warping, and by forces
/// along them beside their axis, which make a bimoment where they come in,
///
///     B = sum F omega(y, z),  sigma = B omega/I_w,
///
/// the whole of it on both sides: an end that warps freely has it all, between the ends it halves.
/// On the axis itself a force is taken to come in by the whole section, beside the walls at the
/// nearest one. They are said where both bounds together may be above a tenth of the yield
/// strength; no verdict stands where N, M_y, M_z and B are above it where such a force comes in.
/// Source: Vlasov, Thin-walled elastic beams (1961).
WarpingFound look_at_warping(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
