#pragma once

#include <cmath>

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

}  // namespace boxbeam
