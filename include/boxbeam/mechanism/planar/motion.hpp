#pragma once

#include <vector>

#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/state_solver.hpp"

namespace boxbeam::planar {

/// States over one period of the drivers, or over the time that is looked at, equally spaced.
struct Motion {
  double begin = 0.0;   ///< time of the first state [s]
  double period = 0.0;  ///< [s]
  bool closed = true;   ///< it repeats after the period; else it ends there
  std::vector<State> states;
  State end;  ///< at begin + period: the first state again, or where an open motion ends
  DegreesOfFreedom freedom;
  std::vector<double> change_points;  ///< times at which two branches cross [s]
  /// When a stop, a cable or a pin in its clearance begins or ends to act, ascending: there loads
  /// bend, however short it acts between two instants [s].
  std::vector<double> changes = {};
  /// Where contacts that can stick begin to do so or to slide, by time.
  std::vector<SlipChange> slip_changes = {};
};

/// Solves `instants` states over the period, each from the one before.
Motion solve_motion(const Mechanism& mechanism, int instants);

/// The motion at enough instants to bracket every peak. The first number follows from the highest
/// harmonic of drivers and forces and from the turns of the bodies (eight instants to each, at
/// least 96); it is doubled until every acceleration and reaction half-way between two instants is
/// what the cubic through their neighbours says, within 1 % of its range (a harmonic of full size
/// then has eight instants to its period). Throws AnalysisError where 24 576 are not enough, and
/// where stops and cables change more than 1000 times.
Motion solve_motion(const Mechanism& mechanism);

/// States at any time of a solved motion (taken modulo the period of a closed one), from the
/// nearest instant.
class StateFinder {
 public:
  StateFinder(const Mechanism& mechanism, const Motion& motion)
      : solver_(mechanism, motion.freedom), motion_(&motion) {}

  /// Throws AnalysisError for a time outside an open motion.
  State at(double time);

 private:
  StateSolver solver_;
  const Motion* motion_;
};

}  // namespace boxbeam::planar
