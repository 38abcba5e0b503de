#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// Where and when the cut forces and the stress of the governing check have their extremes, from
/// the stations and the checks of a verification.
std::vector<CriticalInstant> critical_instants_of(const Project& project,
                                                  const Verification& verification);

/// An instant worth drawing.
struct ShownInstant {
  std::size_t situation = 0;  ///< index in the case
  Time time;
  std::string why;  ///< "largest M, highest stress at the governing place"
  /// How telling: the largest bending moment there over the largest of all, and one more at an
  /// extreme of stress at the governing place.
  double weight = 0.0;
};

/// The distinct times of the extremes of bending and stress, in order.
std::vector<ShownInstant> instants_to_show(const Project& project,
                                           const Verification& verification);

}  // namespace boxbeam
