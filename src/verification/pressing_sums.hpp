#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/recorded/channel_loads.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// A sum of the channels of given loads, a factor for each, by whose extremes a web is used most
/// where forces come in.
struct PressingSum {
  Eigen::VectorXd of;
  /// Looked at where this sum, beside what is constant of it, is of the other sense; nothing: at
  /// all instants.
  std::optional<Eigen::VectorXd> against = {};
  double constant = 0.0;  ///< of `against` [N]
  double least = 0.0;     ///< from which size on `against` counts [N]
};

/// Of every set of forces no farther apart than the beam is deep what each web gets of them, by
/// itself and, as eta_2 with 0.8 eta_1, with what the stresses along the beam use of the section
/// there; F_Rd counts once as that of the place and half and twice of it, since other forces change
/// what a web bears. The same of instants at which another force as near is of the other sense, for
/// then they press as type b. Of more than four near each other sets of neighbours. None where
/// nothing is known to bear forces across the beam.
/// Source: EN 1993-1-5:2006, 6.1(2), 6.3(3), 7.2.
std::vector<PressingSum> pressing_sums_of(const Project& project,
                                          const recorded::ChannelLoads& loads,
                                          const std::vector<CutForceDiagram>& units);

}  // namespace boxbeam
