#pragma once

#include <vector>

#include "boxbeam/fatigue/detail.hpp"
#include "boxbeam/project/table_reader.hpp"

namespace boxbeam {

/// Reads the detail in a table of a case, given in one of three ways:
///
///     row = "8.2/6"                                a row of the tables, facts may narrow it
///     facts = { part = "seam", sides = "one" }     what is known; the weakest row that fits
///     governs category = 100                               as such
///
/// with `kind` ("direct" or "shear"; direct where not said), `name`, `stress_relieved` (compression
/// then counts 60 %, 7.2.1) and `raise_asterisk` (7.1, note 3). Where the facts do not give a
/// thickness, that of the plate decides in which a point lies, see in_plate; `plates` are those
/// that it can be, the thickest first. Keys beside these are the caller's, who finishes the table.
/// Notes problems: none or several of the ways, an unknown row, category, fact or word, facts that
/// fit no row, a size effect whose size is not known.
Detail read_detail(TableReader& table, const std::vector<Length>& plates = {});

}  // namespace boxbeam
