#pragma once

#include <vector>

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// Gives contacts with dry friction a creep velocity that suits how fast they slide
/// (`fitted_creep`); where forces decide the motion none, but for contacts between bodies that
/// drivers alone move, which stay as they are. So do all of a motion that cannot be solved, of
/// which its verification says why.
void fit_creep(Mechanism& mechanism, const std::vector<int>& joints);

}  // namespace boxbeam::planar
