#pragma once

#include <optional>
#include <vector>

#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/stress_points.hpp"

namespace boxbeam {

/// What a computed check rests on, for the calculation sheet and the plots.
struct CheckBasis {
  StressPoint point;
  /// Extremes of the normal stress [Pa]; for yield both are the instant of the check.
  TurningPoint highest, lowest;
  CutForces cut_at_highest, cut_at_lowest;
  CutForces cut_at_time;  ///< at the check's own instant
  PointStress stress_at_time;
  std::vector<double> history;  ///< normal stress at the instants of the motion [Pa]
  std::vector<Cycle> cycles;    ///< of the wanted life
  std::vector<double>
      endured;  ///< cycles to failure of each, the history taken safety_factor times
  // Fatigue only:
  double constant_amplitude_factor = 0.0;  ///< EN 1993-1-9 7.1(2)
  Stress knee, cut_off;                    ///< d_sigma_D and d_sigma_L of the category
};

/// A check and what it rests on; nothing for a stress that was given.
struct CheckResult {
  Check check;
  std::optional<CheckBasis> basis;
};

/// Elastic verification of a point: the largest equivalent stress over the period against the
/// yield strength of its plate. Nothing where the point is never stressed.
/// Source: EN 1993-1-1:2005, 6.2.1(5).
std::optional<CheckResult> check_yield(const Project& project, const StationHistory& history,
                                       const StressPoint& point);

/// Direct-stress fatigue of a point: the cycles of one period, as often as the life asks.
/// Nothing where the stress does not change.
/// Source: EN 1993-1-9:2005, clauses 7 and 8, annex A.
std::optional<CheckResult> check_fatigue(const Project& project, const StationHistory& history,
                                         const StressPoint& point);

/// Every criterion at every point of the stations.
std::vector<CheckResult> check_beam(const Project& project, const LoadHistory& loads,
                                    const std::vector<Station>& stations);

/// Yield and fatigue of stresses taken from a published calculation.
std::vector<CheckResult> check_given_stresses(const Project& project);

}  // namespace boxbeam
