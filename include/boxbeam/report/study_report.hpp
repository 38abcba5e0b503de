#pragma once

#include <string>
#include <vector>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/study/study_summary.hpp"

namespace boxbeam {

/// What `boxbeam sweep` says to people.
report::MarkedText study_text(const StudySummary& summary);

/// study.json, "boxbeam.study/1".
std::string study_json(const StudySummary& summary);

/// Draws indices.svg, a bar of S1 and ST for each variable, where indices were asked for. Returns
/// the names of the files.
std::vector<std::string> draw_study(const StudySummary& summary, const std::string& folder);

/// All that the command may write into a folder.
std::vector<std::string> files_of_study();

}  // namespace boxbeam
