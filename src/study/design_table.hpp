#pragma once

#include <string>
#include <vector>

namespace boxbeam {

/// A table of designs as its file has it: a row for each, a column for each variable.
struct TableOfDesigns {
  struct Cells {
    std::string name, unit;  ///< of "t [mm]"; "" where it has none
    std::vector<std::string> cells;
  };

  std::string path;
  std::string text;
  std::vector<Cells> columns;
  std::vector<int> lines;  ///< of the rows, in the file

  /// Nullptr where there is none.
  const Cells* find(const std::string& name) const;
};

/// Reads comma-separated values (RFC 4180) whose first line names the columns, "t [mm], steel";
/// empty lines and those that begin with # are passed over. Throws InputError with the first thing
/// that is wrong.
TableOfDesigns read_design_table(const std::string& path);

}  // namespace boxbeam
