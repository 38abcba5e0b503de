#pragma once

#include "boxbeam/project/table_reader.hpp"
#include "boxbeam/study/study.hpp"

namespace boxbeam {

/// "A,B" = 0.3 for pairs of variables that scatter.
void read_correlation(TableReader& root, Study& study);

}  // namespace boxbeam
