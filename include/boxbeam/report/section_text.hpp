#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/section_summary.hpp"

namespace boxbeam {

/// Properties of a section as a table in mm.
std::string section_text(const SectionSummary& summary);

/// "boxbeam.section/1", SI; a list of them for several sections. What is not known is left out.
std::string section_json(const std::vector<SectionSummary>& summaries);

}  // namespace boxbeam
