#pragma once

#include <vector>

#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"

namespace boxbeam::planar {

/// States over one period of the drivers, equally spaced, the first at t = 0.
struct Motion {
  double period = 0.0;  ///< [s]
  std::vector<State> states;
};

/// Solves `instants` states over the period, each from the one before.
Motion solve_motion(const Mechanism& mechanism, int instants);

/// The motion at enough instants to bracket every peak: the number is doubled until neither an
/// acceleration nor a reaction bends by more than 2 % of its largest value between neighbours (44
/// instants per period of the highest harmonic that matters, at least 96). Throws AnalysisError
/// where 6144 are not enough.
Motion solve_motion(const Mechanism& mechanism);

/// The state at any time of a solved motion (taken modulo the period), from the nearest instant.
State state_at(InstantSolver& solver, const Motion& motion, double time);

}  // namespace boxbeam::planar
