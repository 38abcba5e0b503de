#pragma once

#include "boxbeam/project/table_reader.hpp"
#include "boxbeam/study/study.hpp"

namespace boxbeam {

/// Reads [optimise] of a study whose variables have been read.
void read_optimise(TableReader& root, Study& study);

}  // namespace boxbeam
