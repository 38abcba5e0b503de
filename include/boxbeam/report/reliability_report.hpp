#pragma once

#include <string>
#include <vector>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/study/study_reliability.hpp"

namespace boxbeam {

/// What `boxbeam reliability` says to people.
report::MarkedText reliability_text(const StudyReliability& of);

/// reliability.json, "boxbeam.reliability/1".
std::string reliability_json(const StudyReliability& of);

/// Draws importance.svg, whose bars are the shares alpha^2 of the variables, and convergence.svg,
/// p_f of the simulations over their samples; each where there is something to draw. Returns the
/// names of the files.
std::vector<std::string> draw_reliability(const StudyReliability& of, const std::string& folder);

/// All that the command may write into a folder.
std::vector<std::string> files_of_reliability();

}  // namespace boxbeam
