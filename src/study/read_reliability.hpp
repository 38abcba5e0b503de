#pragma once

#include "boxbeam/project/table_reader.hpp"
#include "boxbeam/study/study.hpp"

namespace boxbeam {

/// Reads [limit_state] and [reliability] of a study whose variables and columns have been read.
void read_reliability(TableReader& root, Study& study);

}  // namespace boxbeam
