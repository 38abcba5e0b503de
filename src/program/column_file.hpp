#pragma once

#include <string>
#include <vector>

#include "boxbeam/study/study_summary.hpp"

namespace boxbeam::program {

/// Whether column files can be written here; throws InputError that says what is missing.
void require_column_files();

/// Writes the table of a study once more, column by column with their types, as a NetCDF-4 file
/// (which is an HDF5 file): numbers as doubles, NaN where a cell is empty, the rest as texts, units
/// as the attribute "units". `rows`: the table in CSV, whose columns these are. Throws OutputError.
void write_column_file(const std::string& path, const std::string& rows,
                       const std::vector<Column>& columns, const StudySummary& summary);

}  // namespace boxbeam::program
