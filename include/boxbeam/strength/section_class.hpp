#pragma once

#include "boxbeam/core/units.hpp"
#include "boxbeam/strength/effective_width.hpp"

namespace boxbeam {

/// Largest slenderness of a plate, c/t or d/t, with which it is still of class 1, 2 and 3.
struct ClassLimits {
  double class_1 = 0.0;
  double class_2 = 0.0;
  double class_3 = 0.0;
};

/// Cross-section class by slenderness: 1 (plastic hinge), 2 (plastic moment), 3 (elastic moment)
/// or 4 (buckles before it yields).
int class_of(double slenderness, const ClassLimits& limits);

/// epsilon = sqrt(235 MPa / f_y). Source: EN 1993-1-1:2005, table 5.2.
double epsilon_of(Stress yield_strength);

/// Limits of c/t of a part supported at both edges (web, flange of a box) under linear stress.
///
///     class 1:  alpha > 0.5: 396 eps/(13 alpha - 1),  else 36 eps/alpha
///     class 2:  alpha > 0.5: 456 eps/(13 alpha - 1),  else 41.5 eps/alpha
///     class 3:  psi > -1:    42 eps/(0.67 + 0.33 psi), else 62 eps (1 - psi) sqrt(-psi)
///
/// alpha  share of the part in compression when the section is fully plastic, 0 to 1
/// psi    smaller over larger edge stress, compression positive, elastic, at most 1; -infinity for
///        a part in tension
///
/// Even compression (1, 1): 33, 38 and 42 eps; bending (0.5, -1): 72, 83 and 124 eps. As printed,
/// the branches of class 2 miss each other by 0.1 % at alpha = 0.5, those of class 3 by 0.4 % at
/// psi = -1; within 1e-9 both are taken to be there. Source: EN 1993-1-1:2005, table 5.2, sheet 1.
ClassLimits internal_part_limits(double alpha, double psi, double epsilon);

/// Limits of c/t of an outstand flange in even compression: 9, 10 and 14 eps.
/// Source: EN 1993-1-1:2005, table 5.2, sheet 2.
ClassLimits outstand_flange_limits(double epsilon);

/// Limits of c/t of an outstand part under linear stress.
///
///     class 1, 2:  largest compression at the tip: 9, 10 eps/alpha, at the support: 9, 10
///                  eps/(alpha sqrt(alpha))
///     class 3:     even compression: 14 eps, else 21 eps sqrt(k_sigma)
///
/// alpha  share of the part in compression when the section is fully plastic, 0 to 1
/// psi    as of the buckling factor: -3 (tip), -1 (support) to 1
///
/// Source: EN 1993-1-1:2005, table 5.2, sheet 2; k_sigma of EN 1993-1-5, table 4.2.
ClassLimits outstand_part_limits(double alpha, double psi, LargestCompression where,
                                 double epsilon);

/// Limits of d/t of a round tube in bending or compression: 50, 70 and 90 eps^2.
/// Source: EN 1993-1-1:2005, table 5.2, sheet 3.
ClassLimits round_tube_limits(double epsilon);

}  // namespace boxbeam
