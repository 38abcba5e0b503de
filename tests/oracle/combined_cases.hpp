#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "beside.hpp"
#include "random_case.hpp"

namespace oracle {

/// Runs of single load cases and their factors.
using Combination = std::vector<std::pair<std::size_t, double>>;

/// What acts together for strength, of load cases that act alone in situations "unit NAME": every
/// variable one leads once, or none does; one that is not there helps; permanent ones count with
/// either factor (EN 1990, 6.4.3.2, equations 6.10, or 6.10a and 6.10b).
std::vector<Combination> combinations_of(const Combining& by, const Project& project,
                                         const std::vector<Run>& sampled);

}  // namespace oracle
