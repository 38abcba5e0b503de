#pragma once

#include <string>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/study/study_summary.hpp"

namespace boxbeam {

/// What `boxbeam sweep` says to people.
report::MarkedText study_text(const StudySummary& summary);

/// study.json, "boxbeam.study/1".
std::string study_json(const StudySummary& summary);

}  // namespace boxbeam
