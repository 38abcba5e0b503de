#pragma once

#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/spatial/tree.hpp"

namespace boxbeam::spatial {

/// The measure whose sign tells assemblies of a loop apart [m or m^2].
double measure_of(const Branch& branch, const State& state);

/// Its sign for every loop that the mechanism names: +1, -1, or 0 where it is nothing.
std::vector<std::pair<std::string, int>> branch_signs_of(const Mechanism& mechanism,
                                                         const State& state);

/// "loop crank, loop rod": those that are not on the branch that is wanted; "" where all are.
std::string loops_off_branch(const Mechanism& mechanism, const State& state);

}  // namespace boxbeam::spatial
