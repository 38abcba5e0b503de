#pragma once

#include <vector>

#include "boxbeam/verification/checks.hpp"

namespace boxbeam {

/// What files of loads and motions leave open, of which nothing else is said:
/// - a beam whose sensor gives accelerations across or along it and not how it turns in their plane
///   (of omega and alpha omega at least), so that what turning adds is missing;
/// - accelerations that come from a path or a rate of turning with fewer than ten instants to a
///   larger wave, between which up to 1 - cos(pi/n) of a peak is lost;
/// - steps a hundred times as long as half of all are, over which the values change: a straight
///   line between two instants far apart is no record.
std::vector<NotJudged> not_judged_of_records(const Project& project);

}  // namespace boxbeam
