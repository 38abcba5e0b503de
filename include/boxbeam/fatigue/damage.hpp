#pragma once

#include <span>
#include <vector>

#include "boxbeam/fatigue/cycle.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"

namespace boxbeam {

/// How a spectrum is verified.
struct FatigueDemand {
  Loading loading = Loading::spectrum;
  double gamma_Ff = 1.0;
  double gamma_Mf = 1.0;
};

/// The cycles of one stress in the whole life, and what resists them.
struct FatigueChannel {
  std::vector<Cycle> cycles;
  SnCurve curve;
};

/// The same where the curve is prepared already.
struct FatigueLoad {
  std::span<const Cycle> cycles;
  const SnLine* line = nullptr;
};

/// Damage sum with all ranges multiplied by `factor`:
///
///     D = sum n_i / N_R(gamma_Ff factor range_i; curve divided by gamma_Mf)
///
/// Under constant-amplitude loading no range damages while all stay below the limit; once one
/// exceeds it, the line of a spectrum holds for all. Source: Palmgren-Miner; EN
/// 1993-1-9:2005, 7.1(2), 7.1(3), annex A.5.
double damage_of(const std::vector<Cycle>& cycles, const SnCurve& curve,
                 const FatigueDemand& demand, double factor = 1.0);
double damage_of(const FatigueLoad& load, const FatigueDemand& demand, double factor = 1.0);

/// Cycles to failure of each cycle of a spectrum, all ranges multiplied by `factor`.
std::vector<double> cycles_to_failure_in(const FatigueLoad& load, const FatigueDemand& demand,
                                         double factor);

/// The largest factor on the loads for which the damage of all channels together is at most 1. It
/// exists and is finite even where the spectrum does no damage. Infinity only without any cycles.
///
/// One channel is EN 1993-1-9 8(2). Direct stress and shear together are 8(3), equation 8.3: with
/// the equivalent ranges at 2e6 cycles (d_E,2/d_C)^m is the damage sum of each.
double largest_factor(std::span<const FatigueChannel> channels, const FatigueDemand& demand);

double largest_factor(std::span<const FatigueLoad> channels, const FatigueDemand& demand);

/// Of one channel.
double largest_factor(const std::vector<Cycle>& cycles, const SnCurve& curve,
                      const FatigueDemand& demand);

/// The range of which `cycles` cycles do the same damage on the curve's first branch:
///
///     d_E = d_C (D N_ref/cycles)^(1/m) / (gamma_Ff gamma_Mf)
///
/// Zero where the spectrum does no damage. Source: EN 1993-1-9:2005, 1.3 (1.3.2.11), 8(2).
Stress equivalent_range(double damage, const SnCurve& curve, const FatigueDemand& demand,
                        double cycles = 2e6);

/// Ranges of a detail without weld, or with its residual stresses relieved, of which compression
/// counts 60 %, see reduced_range. Source: EN 1993-1-9:2005, 7.2.1, figure 7.4.
std::vector<Cycle> compression_reduced(std::vector<Cycle> cycles);

}  // namespace boxbeam
