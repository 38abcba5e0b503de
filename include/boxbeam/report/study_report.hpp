#pragma once

#include <string>
#include <vector>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/study/design_rows.hpp"
#include "boxbeam/study/study_summary.hpp"

namespace boxbeam {

/// What `boxbeam sweep` says to people.
report::MarkedText study_text(const StudySummary& summary);

/// study.json, "boxbeam.study/1".
std::string study_json(const StudySummary& summary);

/// "0.013, from 0.008 to 0.02 with 95 % confidence".
std::string p_f_text(const BoundedEstimate& p_f);

/// Draws what there is to draw: indices.svg, a bar of S1 and ST for each variable; contour.svg over
/// the two variables of a grid; parallel.svg, histogram.svg. Returns the names of the files.
std::vector<std::string> draw_study(const StudySummary& summary, const DesignRows& rows,
                                    const std::string& folder);

/// All that the command may write into a folder.
std::vector<std::string> files_of_study();

}  // namespace boxbeam
