#pragma once

#include <vector>

#include "boxbeam/project/named_section.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"

namespace boxbeam {

/// What there is to say about a section without loads.
struct SectionSummary {
  NamedSection section;
  std::string steel;
  SectionProperties properties;
  TorsionProperties torsion;
  std::vector<SlenderPlate> plates;  ///< of both profiles
};

SectionSummary summary_of(const NamedSection& section, const Material& steel);

}  // namespace boxbeam
