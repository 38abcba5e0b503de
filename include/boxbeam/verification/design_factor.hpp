#pragma once

#include <algorithm>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// The safety factor that is asked of the beam's strength, of which less than one asks nothing less
/// of what does not grow in proportion to the loads.
inline double demanded_of(const Project& project) {
  return std::max(project.strength.required, 1.0);
}

/// How many times its loads a situation has to be borne: its load factor times the safety factor
/// that is asked for; one where it does not count for strength. What does not grow in proportion to
/// the loads, as second order does not, is judged under so many times them.
/// Source: EN 1993-1-1:2005, 5.2.1(3), F_cr/F_Ed by the design loads.
inline double design_factor_of(const Project& project, const Situation& situation) {
  if (situation.load_factor == 0.0) return 1.0;
  return std::max(situation.load_factor, 1.0) * demanded_of(project);
}

}  // namespace boxbeam
