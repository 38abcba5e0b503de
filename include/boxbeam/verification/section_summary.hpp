#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/named_section.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/strength/plate_materials.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "boxbeam/strength/reduced_stress.hpp"
#include "boxbeam/strength/section_use.hpp"
#include "boxbeam/verification/sheared_plates.hpp"

namespace boxbeam {

/// A plate of a section under forces.
struct PlateUnderForces {
  ShearedWall sheared;
  bool web = true;  ///< rather along z than along y
  double shear_use = 0.0;
  ReducedStress reduced = {};  ///< of boxes
};

/// A box, a rectangular tube or a thin-walled path under cut forces, partial factors one: by
/// effective widths, and where it has four plates by reduced stresses as well (EN 1993-1-5).
struct SectionUnderForces {
  CutForces forces;
  /// 1 to 4 by the gross stress that is there: of each plate that is compressed c/t against its
  /// limits, alpha as of the elastic stress; the largest.
  int section_class = 1;
  Area area;                ///< effective, under N alone
  Length shift_y, shift_z;  ///< of the centroid, likewise
  SectionUse use;           ///< of the place of the effective section that is used most
  std::string place;
  std::vector<PlateUnderForces> plates;  ///< held at both ends
  double interaction_use = 0.0;          ///< 7.1, of the plate that is used most
  /// Of `plates`, by reduced stresses used most; nothing of a path, and where stiffeners divide one
  /// of them, whose critical stress under all that acts is not computed.
  std::optional<std::size_t> reduced = {};
};

/// Throws InputError where the section is no such profile alone, stiffeners do not divide their
/// plates, a plate has no effective width, an outstand bears shear that nothing judges, or the
/// steel has no strength for one of them.
SectionUnderForces section_under(const Section& section, const Material& steel,
                                 const CutForces& forces);

/// What there is to say about a section, and, under forces, its plates.
struct SectionSummary {
  NamedSection section;
  std::string steel;
  SectionProperties properties;
  TorsionProperties torsion;
  std::vector<SlenderPlate> plates;                 ///< of both profiles
  std::shared_ptr<const SectionUnderForces> under;  ///< where forces are given
};

SectionSummary summary_of(const NamedSection& section, const Material& steel);

}  // namespace boxbeam
