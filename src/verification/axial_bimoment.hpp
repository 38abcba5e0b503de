#pragma once

#include <deque>
#include <optional>
#include <string>

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Bimoments of forces along the beam that come in beside the axis of open sections.
struct AxialBimoments {
  double largest = 0.0;      ///< the sum of their sizes along the beam, at its largest [N m^2]
  std::string words;         ///< "400 kN along the beam beside its axis, \"p\" at s = 2 m"
  std::optional<Gate> gate;  ///< where N, M_y, M_z and B are more than the section bears
};

/// Precondition: in space.
AxialBimoments axial_bimoments_of(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
