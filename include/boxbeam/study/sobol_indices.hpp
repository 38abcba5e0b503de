#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace boxbeam {

/// An estimate with its bounds of 95 % confidence.
struct BoundedEstimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// Which part of a result's variance a variable makes.
struct SobolIndex {
  BoundedEstimate first;  ///< S1, by itself
  BoundedEstimate total;  ///< ST, with all that it does together with others
};

/// How the indices of a study are found.
struct IndexPlan {
  std::vector<std::string> variables;  ///< that scatter
  std::size_t resamples = 1000;        ///< of the samples, for the bounds
  std::uint64_t seed = 1;
};

/// The indices of one result. Without any where it has no variance or too few samples.
struct SobolIndices {
  std::size_t samples = 0;   ///< of independent pairs of designs that they rest on
  std::size_t left_out = 0;  ///< of the pairs, since a design of them has no result
  double variance = 0.0;
  std::vector<SobolIndex> of;  ///< of each variable
};

/// Indices of a result over designs as `DesignSpace` orders them: of each sample two independent
/// designs A and B, and for each variable the design A with that variable as B has it. With f as
/// the result less its mean,
///
///     S1_i = mean of f_B (f_ABi - f_A) / V,   ST_i = mean of (f_A - f_ABi)^2 / (2 V),
///
/// V the variance of A and B together. Valid for variables that are independent. Estimates may lie
/// below 0 and above 1 by what the bounds say; these are quantiles of the estimates from samples
/// drawn again from themselves (percentile bootstrap), too wide rather than too narrow for Sobol's
/// sequence. `values`: not a number where a design has none.
/// Sources: Saltelli, Annoni, Azzini, Campolongo, Ratto, Tarantola, Computer Physics Communications
/// 181 (2010), estimators (b) and (f) of their table 2, the latter by Jansen (1999); Efron,
/// Tibshirani, An Introduction to the Bootstrap (1993), 13.3.
SobolIndices sobol_indices_of(const std::vector<double>& values, const IndexPlan& plan);

}  // namespace boxbeam
