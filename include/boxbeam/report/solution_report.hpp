#pragma once

#include <string>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/study/solution.hpp"

namespace boxbeam {

/// What `boxbeam solve` says to people.
report::MarkedText solution_text(const Solution& solution);

/// "boxbeam.solution/1": values in the unit of the case, results in SI.
std::string solution_json(const Solution& solution);

}  // namespace boxbeam
