#pragma once

#include <vector>

#include "boxbeam/fatigue/cycle.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"

namespace boxbeam {

/// What a history is verified against.
struct FatigueDemand {
  double periods = 0.0;  ///< repetitions of the history in the wanted life
  Loading loading = Loading::spectrum;
  double gamma_Ff = 1.0;
  double gamma_Mf = 1.0;
};

/// Damage sum with all ranges multiplied by `factor`:
///
///     D = sum n_i / N_R(gamma_Ff factor d_sigma_i; curve divided by gamma_Mf)
///
/// Under constant-amplitude loading no range damages while all stay below the knee; once one
/// exceeds it, the line of a spectrum holds for all. Source: Palmgren-Miner; EN
/// 1993-1-9:2005, 7.1(2), 7.1(3), annex A.5.
double damage_of(const std::vector<Cycle>& cycles, const SnCurve& curve,
                 const FatigueDemand& demand, double factor = 1.0);

/// Cycles to failure of one cycle of a history, all ranges multiplied by `factor`.
double cycles_to_failure_in(const std::vector<Cycle>& cycles, const Cycle& cycle,
                            const SnCurve& curve, const FatigueDemand& demand, double factor);

/// The largest factor on the history for which the damage is at most 1. It exists and is finite
/// even where the history does no damage. Infinity only for a history without cycles.
double largest_factor(const std::vector<Cycle>& cycles, const SnCurve& curve,
                      const FatigueDemand& demand);

}  // namespace boxbeam
