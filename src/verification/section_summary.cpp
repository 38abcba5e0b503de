#include "boxbeam/verification/section_summary.hpp"

namespace boxbeam {

SectionSummary summary_of(const NamedSection& named, const Material& steel) {
  SectionSummary summary{named,
                         steel.name,
                         properties_of(named.section),
                         torsion_properties_of(named.section),
                         plate_slenderness_of(named.section.outer, steel),
                         {}};
  if (!named.section.inner) return summary;
  for (SlenderPlate plate : plate_slenderness_of(*named.section.inner, steel)) {
    plate.plate = "inner " + plate.plate;
    summary.plates.push_back(plate);
  }
  return summary;
}

}  // namespace boxbeam
