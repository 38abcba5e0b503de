#pragma once

#include <vector>

#include "beside.hpp"
#include "rules.hpp"

namespace oracle {

/// A beam of one doubly symmetric box under given loads, held by `[[beam.restraints]]` as one on
/// two pins or as a cantilever, that bends and buckles: equations 6.61 and 6.62 of EN 1993-1-1 with
/// k of table B.1 (class 3), at any instant, under the loads times their load factor and the wanted
/// factor. On the milder side: its least compression all along, curve b of a welded box and a of a
/// tube (table 6.2), and nothing where compression is below 0.05 of the critical one.
void look_at_member(const Project& project, const std::vector<Run>& sampled, const Rules& rules,
                    Findings& found);

}  // namespace oracle
