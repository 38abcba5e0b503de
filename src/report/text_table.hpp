#pragma once

#include "boxbeam/report/document.hpp"
#include "boxbeam/report/marked_text.hpp"

namespace boxbeam::report {

/// A table as plain text, indented by two columns, its columns as wide as their content. Where it
/// is wider than `width` the texts in its cells are wrapped; where that is not enough, columns that
/// have no room stand below, behind the first column once more. "!" stands before a row that fails,
/// "?" before one that does not apply.
MarkedText table_text(const Table& table, std::size_t width);

/// The table with its marks, where it has some, as words in a column before the others: "passes",
/// "FAILS".
Table with_results(Table table);

}  // namespace boxbeam::report
