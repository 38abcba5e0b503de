#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/verification/patch_checks.hpp"
#include "pressed_edges.hpp"
#include "pressing_forces.hpp"

namespace boxbeam {

/// Webs of boxes and rectangular tubes that forces press anew at every cycle, in fatigue.
///
///     sigma_z = F/(t (s_s + 2 t_f))   in the web, category 71 (row 8.10/2), rolled 160 (8.10/1)
///     sigma_w = sigma_z t/a           in the throats a of a fillet seam together, 36 (row 8.10/4)
///
/// A seam of which nothing is said is judged as one that penetrates fully, and beside that as
/// fillets. At a place it is that of all forces whose loaded length reaches it: of those that push
/// down at some time, of those that push up, and of all, each with its signs, for they may come by
/// unlike flanges or by the same one; of what turns off from flanges, with what turns off from one.
/// Fillets of diaphragms whose thickness the case says are judged likewise, each by what forces
/// that stand there, or pass, put into it: root, 36 (8.5/3), with the flange across them, or along
/// the web by the same. With it counts the shear stress there (8.3): of the web at its seams, or in
/// the throat; of tubes the one that does most anywhere around the section. Stresses along the beam
/// are judged by details of their own. At an end of the beam it loads the web as far as that goes,
/// but where a diaphragm stands there. Source: EN 1993-1-9:2005+AC:2009, table 8.10, equation 8.3;
/// loaded length EN 1993-1-5:2006, 6.3.
class PressedWebs {
 public:
  PressedWebs(const Project& project, const std::deque<SituationRun>& runs,
              const std::vector<BendingZone>& zones, PatchSearch& search)
      : project_(&project),
        search_(&search),
        forces_(project, search),
        edges_(project, runs, zones) {}

  /// To learn what presses them.
  PressingForces& forces() { return forces_; }
  /// What resists has become another.
  void forget_resistance() { edges_.forget_resistance(); }

  /// Of every web the place that is used most, of each sense, of those where the case says how
  /// forces come in and of the others, which do not hold without that: checks, and gates.
  void add_to(PatchChecks& found) const;

 private:
  /// A check, and whether the case says how forces come in there.
  struct Found {
    CheckResult result;
    bool given = true;
    bool unsaid = false;  ///< taken as fillets where the case does not say what they are
    bool turned = false;  ///< of what turns off from flanges alone
  };
  /// How much of a place is used.
  struct Used {
    PressedPlace place;
    double use = 0.0;
  };
  std::vector<Found> checks(std::vector<Used>& used) const;
  /// The worst of all places like one.
  std::vector<Found> worst_of(PressedPlace place, const std::vector<double>& places,
                              bool any_unsaid, std::vector<Used>& used) const;
  std::optional<CheckResult> check_at(const PressedPlace& place, Turns turns,
                                      bool unsaid_as_fillets) const;
  /// Returns whether a kink turns all that presses there.
  bool name(const PressedPlace& place, CheckResult& result) const;
  Gate gate_of(const Found& of) const;
  /// Where a web and a flange, which meet in a seam, are pressed at one place, the worst of all by
  /// both, as if in phase: above 1 what is not judged.
  std::optional<Gate> square_of(std::vector<Used> used) const;

  const Project* project_;
  PatchSearch* search_;
  PressingForces forces_;
  PressedEdges edges_;
};

}  // namespace boxbeam
