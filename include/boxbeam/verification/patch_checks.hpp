#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"

namespace boxbeam {

/// What the welds of diaphragms need where the case does not say how thick they are.
struct UnsaidWelds {
  Length s;
  std::string under;             ///< the force that asks most
  std::optional<Length> throat;  ///< that suffices everywhere; nothing: none does
};

/// What comes into a part of a diaphragm beside what keeps the box in shape.
struct IntoDiaphragm {
  enum class Part { plate, web_weld, flange_weld };
  Length s;
  Part part = Part::plate;
  std::string under;  ///< the force
  double use = 0.0;   ///< without `required`
  Moment turns = {};  ///< of it about the beam's axis, load factor applied
};

/// What is found where forces come into the webs of the beam.
struct PatchChecks {
  std::vector<CheckResult> checks;
  std::vector<Gate> gates;
  std::vector<NotJudged> not_judged;
  std::optional<UnsaidWelds> unsaid_welds;
  std::vector<IntoDiaphragm> into_diaphragms;
};

/// The webs of boxes and rectangular tubes under the forces across the beam that come into them
/// through a flange: those of joints, supports, wheels and loads; in space the flanges likewise
/// under forces along y.
///
/// Looked at where the case says how a force comes in (`LoadIntroduction`), where a diaphragm takes
/// it, and everywhere else with a stiff length of zero; there what does not hold keeps the verdict
/// back until the case says more. Stout webs are left out while all forces together are hardly felt
/// by them, and what they bear with eta_2 <= 0.3 is not listed, since 7.2 then asks less than the
/// section's own checks. Every force is taken to push but what is known to hang: a load below the
/// middle that pulls down, or the other way, and kinks that pull. What a web bears of it follows
/// from its eccentricity by the lever between the webs. Forces of one sense no farther apart than
/// the web is deep are judged one by one and all together (6.3(3)); with one of the other sense as
/// near, as type b. Near an end of the beam without a diaphragm the lower one of types a or b and c
/// holds. Beside each other in time: eta_1 of the same instant. A joint at an end of the beam whose
/// couples are those of forces more than half its depth away is a clamp, which holds the whole
/// section, and is left out. Looked at are all instants, both sides of every passage of diaphragms
/// and ends of segments, and the maximum near the worst instant.
///
/// With each web, without a diaphragm, its fillet seams with the flange that is pushed and with the
/// one that may be pulled: of every force by itself, over s_s + 2 t_f within the ends of the beam,
/// what other forces of its sense load of the same piece added, with V and T on either side of it.
/// What fully penetrates has no throat. Of a diaphragm that takes a force the welds on both its
/// faces, with the web and with the flange, bear all of it one after the other. What presses a web
/// or its seam anew at every cycle is judged in fatigue (`PressedWebs`).
///
/// Source: EN 1993-1-5:2006, clause 6, 7.2 and 9.4; EN 1993-1-8:2005, 4.5.3.2; EN 1993-1-9:2005,
/// table 8.10.
PatchChecks check_patches(const Project& project, const std::deque<SituationRun>& runs,
                          const std::vector<BendingZone>& zones);

/// The same for designs of a case that differ in what resists alone: where they differ in [fatigue]
/// alone what comes in is looked at once, with a case of its own. Not for several threads at once.
class KeptPatches {
 public:
  KeptPatches();
  ~KeptPatches();
  KeptPatches(const KeptPatches&) = delete;
  KeptPatches& operator=(const KeptPatches&) = delete;

  /// As `check_patches`; the runs are always the same ones, those of the design. What it gives
  /// looks at what is kept, until the next design.
  PatchChecks of(const Project& project, std::deque<SituationRun>& runs);

 private:
  struct Looked;
  std::unique_ptr<Looked> looked_;
};

/// Whether what forces across the beam do where they come in is looked at in all its sections.
bool forces_are_looked_at(const Project& project);

}  // namespace boxbeam
