#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/check.hpp"
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

/// Stresses along the beam by torsion of open sections that are held from warping, where they may
/// be above a tenth of the yield strength: no check counts them.
std::vector<NotJudged> warping_not_judged(const Project& project,
                                          const std::deque<SituationRun>& runs);

}  // namespace boxbeam
