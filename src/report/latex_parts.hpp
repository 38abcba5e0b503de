#pragma once

#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// A table over as many pages as it needs, as wide as the text at most: the type becomes smaller
/// and long texts wrap until it fits. Rows that fail have a red "!" before them.
std::string latex_table(const Table& table);

/// Heights of a table, about [pt].
struct TableHeight {
  double all = 0;
  double together =
      0;  ///< of what should stand on one page: all of a short one, else its beginning
};

TableHeight latex_table_height(const Table& table);

/// The house style of the PDF: page, type, colours, and the commands that the writer uses.
extern const char* const latex_preamble;

}  // namespace boxbeam::report
