#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "boxbeam/strength/effective_width.hpp"

namespace boxbeam {

/// After so many steps levels that have not settled do not.
constexpr int most_level_steps = 60;

/// Gives each plate the level of its own compression; whether that leaves all as they were.
template <class Plates, class Shares>
bool settled_at(const Shares& shares, bool annex_E, Plates& plates) {
  constexpr double close = 1e-9;
  bool settled = true;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    settled = settled && std::abs(shares[k] - plates[k].level.share) < close;
    plates[k].level = {shares[k], annex_E};
  }
  return settled;
}

/// Shares of a section's use as those where it yields.
template <class Shares>
Shares where_it_yields(Shares shares, double use) {
  for (double& share : shares) share = use > 0.0 ? std::min(1.0, share / use) : 1.0;
  return shares;
}

}  // namespace boxbeam
