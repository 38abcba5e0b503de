#pragma once

#include <vector>

#include "boxbeam/fatigue/cycle.hpp"

namespace boxbeam {

/// Cycles that do at least the damage of the sum of two stresses over a history that repeats: of
/// the first its counted cycles, of the other no more than its range R and its rise, the sum of all
/// by which it goes up.
///
///     r_k + R each,  and max(0, rise/R - count) more of R
///
/// Where both are one cycle, that is the sum of their ranges. Counted cycles join each peak to the
/// trough at which its part of the history ends. Nothing that stays within +-R/2 moves one of these
/// by more than that, so that every cycle of the sum is one of the first, changed by R at most, or
/// a new one of R at most; and all together are no longer than the sum of the r_k and the rise.
/// With damage that grows faster than the range the most is done by what stands above.
/// Source: stability of persistence pairs, Cohen-Steiner, Edelsbrunner, Harer, Discrete Comput.
/// Geom. 37 (2007), recalled; here the rest.
std::vector<Cycle> joined_cycles(std::vector<Cycle> cycles, Stress range, Stress rise);

}  // namespace boxbeam
