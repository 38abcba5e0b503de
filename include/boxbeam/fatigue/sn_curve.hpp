#pragma once

#include <string>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// How the stress ranges of a life are distributed, EN 1993-1-9 clause 7.1(2) and (3).
enum class Loading {
  spectrum,            ///< ranges of many sizes: slope m = 5 behind the knee down to the cut-off
  constant_amplitude,  ///< one range: none below the knee does damage
};

/// The published S-N step is the sledge-rig thesis' arithmetic, kept for comparison only.
enum class CurveKind { en_1993_1_9, published_step };

/// Fatigue strength line for direct stress of one detail category.
///
///     d_sigma^3 N = d_sigma_C^3 2e6                 for N <= 5e6
///     d_sigma^5 N = d_sigma_D^5 5e6                 for 5e6 <= N <= 1e8 (spectrum)
///     d_sigma_D = (2/5)^(1/3) d_sigma_C,  d_sigma_L = (5/100)^(1/5) d_sigma_D
///
/// Source: EN 1993-1-9:2005, 7.1(2), 7.1(3), figure 7.1.
/// The published step instead puts the category at the knee: d_sigma = d_sigma_C (5e6/N)^(1/5).
struct SnCurve {
  Stress category;  ///< range at 2e6 cycles
  CurveKind kind = CurveKind::en_1993_1_9;
};

Stress knee_of(const SnCurve& curve);     ///< d_sigma_D, constant-amplitude limit, 5e6 cycles
Stress cut_off_of(const SnCurve& curve);  ///< d_sigma_L, 1e8 cycles

/// Largest range that `cycles` cycles of one size may have; never below the knee (constant
/// amplitude) or the cut-off (spectrum).
Stress strength_at(const SnCurve& curve, double cycles, Loading loading);

/// Cycles of one range to failure; infinity at ranges that do no damage.
double cycles_to_failure(const SnCurve& curve, Stress range, Loading loading);

/// Whether a number is a detail category of EN 1993-1-9 figure 7.1 (direct stress), MPa.
bool is_direct_category(int category);
/// The categories as text, for messages.
std::string direct_categories();

}  // namespace boxbeam
