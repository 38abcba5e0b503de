#pragma once

#include <string>
#include <vector>

#include "boxbeam/strength/reduced_stress.hpp"
#include "boxbeam/verification/plate_checks.hpp"

namespace boxbeam {

/// A plate of a section under forces.
struct PlateUnderForces {
  ShearedPlate sheared;
  bool web = true;
  double shear_use = 0.0;
  ReducedStress reduced;
};

/// A box or rectangular tube under cut forces, partial factors one, by both routes of EN 1993-1-5.
struct SectionUnderForces {
  CutForces forces;
  /// 1 to 4 by the gross stress that is there: of each plate that is compressed c/t against its
  /// limits, alpha as of the elastic stress; the largest.
  int section_class = 1;
  EffectiveBox box;
  CornerUse corner;  ///< of the effective section, used most
  std::vector<PlateUnderForces> plates;
  double interaction_use = 0.0;  ///< 7.1, of the plate that is used most
  /// Of `plates`, by reduced stresses used most; nothing where stiffeners divide one of them, whose
  /// critical stress under all that acts is not computed.
  const PlateUnderForces* reduced = nullptr;
};

/// Throws InputError where the section has not four plates, stiffeners do not divide theirs, or the
/// steel has no strength for one of them.
SectionUnderForces section_under(const Section& section, const Material& steel,
                                 const CutForces& forces);

}  // namespace boxbeam
