#pragma once

#include <vector>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// A section near a station, and its weight in a difference formula.
struct NearbySection {
  Section section;
  double weight = 0.0;  ///< [1/m]
};

/// How a section changes along the beam: the derivative of anything the section has is the sum of
/// weight times its value in the nearby sections. Empty: prismatic. All are of one kind.
using Taper = std::vector<NearbySection>;

}  // namespace boxbeam
