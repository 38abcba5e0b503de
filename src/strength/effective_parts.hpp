#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/section_use.hpp"

namespace boxbeam {

/// A part of a stress below this part of all of it is round-off.
constexpr double stress_round_off = 1e-6;

/// Whether N compresses a place, by more than round-off.
inline bool is_compressed(const SectionUse& of, Force N) {
  return -(N / of.area).value() > stress_round_off * std::abs(of.stress.value());
}

/// Whether M_z bends it.
inline bool is_bent_about_z(const SectionUse& of) {
  return std::abs((of.M_z / of.W_z).value()) > stress_round_off * std::abs(of.stress.value());
}

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
