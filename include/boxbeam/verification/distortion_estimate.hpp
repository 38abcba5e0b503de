#pragma once

#include <deque>
#include <string>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// How much of a stretch of box segments its torsion distorts at most.
///
/// How a torque comes into a box, nobody knows from its cut forces: wherever T jumps, or a torque
/// passes an end of the stretch, it comes by its webs alone or by its flanges alone, d = +-T/2
/// each, all of them so that their effects add up. What comes along the beam, dT/ds, comes alike
/// everywhere, likewise; the part of a taper and of a jump of b/h is known, d = T/2 d(ln(h/b)).
/// Forces at the beam axis are taken to come evenly by both webs or both flanges and do not
/// distort. Ends and joints of the beam hold nothing in shape; diaphragms do, and what comes where
/// one stands is taken by it. Stiffeners and inner profiles are left out, on the safe side. At the
/// instants of the motion, nothing between them; across, the bending of the plates, in the throat
/// of a seam where that is thinner.
struct DistortionEstimate {
  std::string segments;  ///< their names
  Length from, to;       ///< where the stretch lies
  Stress along, across;  ///< largest, in strength: load factors applied
  Stress bending;        ///< largest normal stress of M_y and M_z there, likewise
  Stress along_range, across_range, bending_range;  ///< of what counts in fatigue
  double used = 0.0;  ///< largest (along + across)/(f_y/gamma_M0) at once, without `required`
  Station station;    ///< where that is
  Time when;          ///< and when
  std::size_t situation = 0;
  Length introduced;  ///< where the torque comes that does most of it
  Moment torque;      ///< that comes there
  /// Where torque comes, ascending: at most 64 of them, for wheels move.
  std::vector<Length> places;
  Length spacing;  ///< of diaphragms: 0.5/lambda, the least of the stretch
};

/// Of every stretch of boxes and rectangular tubes of a beam in space to which torque comes.
std::vector<DistortionEstimate> estimate_distortion(const Project& project,
                                                    const std::deque<SituationRun>& runs);

/// Distortion is in no check. It is left out with a remark where
///
/// - its stresses along and across are at most 10 % of those of bending (EN 1993-2:2006, 6.2.7,
///   recalled, not confirmed), or all of them added to the most that a check of the beam's
///   strength uses is no more than what it has (von Mises' stress of a sum is not above the sum),
///   but not where plates are judged for buckling, or they are 1 % of the strength at most;
/// - and, where fatigue is asked for, its ranges along and across are at most 10 % of that of
///   bending, or the range across is below the cut-off of category 36, the least of all details,
///   and the one along below a tenth of that.
///
/// Else it stops the verdict.
std::vector<Gate> distortion_gates_of(const Project& project,
                                      const std::vector<DistortionEstimate>& estimates,
                                      const std::vector<CheckResult>& checks);

}  // namespace boxbeam
