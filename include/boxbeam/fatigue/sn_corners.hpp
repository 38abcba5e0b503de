#pragma once

#include <string>
#include <vector>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"

namespace boxbeam {

/// A point of an S-N curve that has a name.
struct SnCorner {
  enum class Kind { reference, branch_end, constant_amplitude_limit, cut_off };
  Kind kind = Kind::reference;
  std::string symbol;  ///< "d_sigma_C", "d_sigma_D", "d_sigma_L", "d_sigma_K1" of a branch's end
  double cycles = 0.0;
  Stress strength;
};

/// "constant-amplitude limit".
const char* to_text(SnCorner::Kind kind);

/// "d_sigma" or "d_tau".
std::string symbol_of(const SnCurve& curve);

/// The corners from the reference to the cut-off, in order.
std::vector<SnCorner> corners_of(const SnCurve& curve);

/// The strengths at the corners behind the reference, each from the corner before, step by step.
///
///     R = R_0 (N_0/N)^(1/m)
void derive_corners(Derivation& steps, const SnCurve& curve);

/// The strength at a number of cycles, "d_sigma_R", by the branch of the curve that it lies on.
Traced derive_strength(Derivation& steps, const SnCurve& curve, double cycles, Loading loading);

/// Cycles to failure of a range, partial factors applied, by the branch on which they are.
///
///     N = N_0 (R_0/range)^m
Traced derive_endurance(Derivation& steps, const SnCurve& curve, Symbol symbol, const Traced& range,
                        double cycles);

/// The range of 2e6 cycles that does as much damage, see equivalent_range.
void derive_equivalent_range(Derivation& steps, const SnCurve& curve, double damage,
                             const Traced& gammas);

}  // namespace boxbeam
