#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/fatigue/detail.hpp"

namespace boxbeam {

/// Gives a detail what the governing one of its candidates says: row, curve, size effect, and
/// whether compression counts 60 %. Precondition: there are candidates.
void take_governing(Detail& detail, const DetailAssessment& assessment, const Facts& facts,
                    const DetailInPlates& known);

/// A detail by a row, of an attachment by the part of it for so long a one along the stress.
Detail detail_of_row(std::string_view row, std::string name, std::optional<Length> length = {});

/// A detail in the plate in which a point lies, where that plate gives its thickness: the row that
/// governs there, with its size effect; nothing where it is the same as the detail stands. In a
/// plate that no row is for, the weakest of all rows that another plate could have.
/// Source: EN 1993-1-9:2005, 7.2.2, tables 8.1 to 8.5 (t is the thickness of the plate with the
/// stress).
std::optional<Detail> in_plate(const Detail& detail, Length plate);

/// The thicknesses at which what governs a detail may change, none where it depends on no plate.
std::vector<Length> thickness_limits_of(const Detail& detail);

}  // namespace boxbeam
