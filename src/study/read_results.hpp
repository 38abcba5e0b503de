#pragma once

#include "boxbeam/project/table_reader.hpp"
#include "boxbeam/study/study.hpp"

namespace boxbeam {

/// Whether a text can be the name of a variable or of a formula's result.
bool is_identifier(const std::string& name);

/// Reads [results] of a study whose variables have been read.
void read_results(TableReader& root, Study& study);

/// Reads [indices] likewise.
void read_indices(TableReader& root, Study& study);

}  // namespace boxbeam
