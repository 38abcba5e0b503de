#pragma once

#include "design_points.hpp"

namespace boxbeam {

/// Designs as they scatter: the share that fails. Ends where the coefficient of variation,
///
///     sqrt((1 - p)/(n p)),
///
/// is the wanted one, or at the most samples. Bounds of Clopper and Pearson (1934).
MethodResult monte_carlo(LimitState& limit_state, const ReliabilityDemand& demand,
                         std::uint64_t seed);

/// Designs about the design points, each counted by how much rarer it is by itself:
///
///     q(u) = sum w_i phi(u - u_i),   p = mean of phi(u)/q(u) over those that fail,
///
/// w_i in proportion to Phi(-beta_i). Failure that no design point leads to is not seen.
/// Source: Melchers, Structural Safety 6 (1989).
MethodResult importance_sampling(LimitState& limit_state, const ReliabilityDemand& demand,
                                 const DesignPoints& about, std::uint64_t seed);

/// Failure as the last of a row of events of which each is a tenth as likely as the one before it,
/// sampled by Markov chains whose next place is correlated with the one before it,
///
///     u' = sqrt(1 - s^2) u + s xi,
///
/// s such that 44 % are accepted. Repeated until the coefficient of variation is the wanted one.
/// Sources: Au, Beck, Probabilistic Engineering Mechanics 16 (2001), also for the coefficient of
/// variation; Papaioannou, Betz, Zwirglmaier, Straub, ibid. 41 (2015), for the chains.
MethodResult subset_simulation(LimitState& limit_state, const ReliabilityDemand& demand,
                               std::uint64_t seed);

/// A result by its last estimate.
void conclude(MethodResult& result, const ReliabilityDemand& demand);

/// A share of so many, with bounds of 95 % by Clopper and Pearson (1934).
Estimate share_estimate(std::size_t samples, std::size_t failing);

/// Bounds of 95 % of an estimate whose logarithm is normal.
Estimate lognormal_estimate(std::size_t samples, double p_f, double variation);

}  // namespace boxbeam
