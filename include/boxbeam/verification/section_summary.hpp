#pragma once

#include <memory>
#include <vector>

#include "boxbeam/project/named_section.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "boxbeam/verification/section_under_forces.hpp"

namespace boxbeam {

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
