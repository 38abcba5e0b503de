#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// How much of a stretch of box segments its torsion distorts at most, see DistortedStretch.
struct DistortionEstimate {
  std::string segments;  ///< their names
  Length from, to;       ///< where the stretch lies
  Stress along, across;  ///< largest, in strength: load factors applied
  Stress bending;        ///< largest normal stress of M_y and M_z there, likewise
  Stress along_range, across_range, bending_range;  ///< of what counts in fatigue
  double used = 0.0;  ///< largest (along + across)/(f_y/gamma_M0) at once, without `required`
  /// The same where plates may buckle.
  double used_where_slender = 0.0;
  Station station;  ///< where that is
  Time when;        ///< and when
  std::size_t situation = 0;
  Length introduced;  ///< where the torque comes that does most of it
  Moment torque;      ///< that comes there
  /// Where torque comes, ascending: at most 64 of them, for wheels move.
  std::vector<Length> places;
  Length spacing;              ///< of diaphragms: 0.5/lambda, the least of the stretch
  bool ranges_judged = false;  ///< in a check; not of long records, whose cycles are counted else
  /// A diaphragm, by what it takes so that the box keeps its shape.
  struct Holding {
    Length s;
    Force shear;  ///< along an edge at a web
    /// Of its plate in shear, beside an opening or of a strip there that bends; of its fillets,
    /// where the case says how thick they are. Without `required`.
    double plate = 0.0, welds = 0.0;
    /// Where the case does not say how thick these are: the throat that they need, without
    /// `required`.
    Length needed = {};
    Moment d = {};  ///< that it takes, see DistortedBeam
    /// In fatigue, of the fillets (half as thick as the diaphragm where the case does not say) and
    /// of the plate, with `required`; the range of shear stress of the fillets.
    double life = 0.0;
    Stress range = {};

    double used() const { return std::max(plate, welds); }
  };
  std::optional<Holding> holding;  ///< the one used most
  std::vector<Holding> held;       ///< all of them
};

struct DistortionChecks {
  std::vector<CheckResult> checks;
  std::vector<NotJudged> not_judged;
  std::vector<DistortionEstimate> estimates;
  std::vector<Gate> gates;  ///< of cells whose distortion is not computed
};

/// Distortion of every stretch of boxes, rectangular tubes and thin-walled paths around a rectangle
/// of a beam in space to which torque comes: of each the places that are used most, in strength by
///
///     sigma_x = |sigma| + sigma_D,  sigma_t = 6 m/t^2,  tau = |tau| + tau_D
///
/// in the plates (bent_across_stress) and in the throats of seams that have one, and in fatigue by
/// the details of the point, the ranges of direct and shear stress of both joined (joined_cycles)
/// and both in one damage sum, and by `corner` for what bends a corner across, in the throat of its
/// seam where that is thinnest. Signs are taken so that all adds up; signed by the load alone where
/// the case says how torque comes. Looked at are the named points of a section and the ends and
/// middles of its walls, but no edges of holes, at both sides of every place where anything jumps,
/// at `stations` and between them every sixteenth of 1/lambda, at the instants of the motion and,
/// for strength, at the maximum beside the worst of them. Ranges are those between instants.
DistortionChecks check_distortion(const Project& project, const std::deque<SituationRun>& runs,
                                  const std::vector<BendingZone>& zones,
                                  const std::vector<Station>& stations);

/// Takes out those that are used as the worst check without distortion is, within a millionth: at
/// their place distortion does nothing, and they say no more.
void leave_out_without_effect(std::vector<CheckResult>& checks);

/// What stays beside these checks: where plates may buckle and in the fatigue of long records,
/// distortion is in no check; at edges of holes, at welds around profiles, in forces that come into
/// webs and in the buckling of the beam as a member nothing of it is. There it is left out where
///
/// - its stresses along and across are at most 10 % of those of bending (EN 1993-2:2006, 6.2.7,
///   recalled, not confirmed), or 1 % of the strength at most, or, but where plates may buckle, all
///   of it added to the most that such a check uses is no more than what it has, at edges of holes
///   three times;
/// - and its ranges along and across are at most 10 % of that of bending, or the range across is
///   below the cut-off of category 36, the least of all details, and the one along below a tenth of
///   that.
///
/// Else it stops the verdict.
std::vector<Gate> distortion_gates_of(const Project& project,
                                      const std::vector<DistortionEstimate>& estimates,
                                      const std::vector<CheckResult>& checks);

/// Where a diaphragm bears what keeps the box in shape and what forces put into the same parts of
/// it: of the plate and the welds with the webs both as a sum, of those with the flange, across
/// which the force comes, as a vector. What turns the beam there is a lever of the force itself,
/// whose part of d, T/2, lies in what these bear of it. In fatigue the sum of both uses.
std::vector<Gate> shared_diaphragm_gates_of(const Project& project,
                                            const std::vector<DistortionEstimate>& estimates,
                                            const std::vector<IntoDiaphragm>& into,
                                            const std::vector<CheckResult>& checks);

}  // namespace boxbeam
