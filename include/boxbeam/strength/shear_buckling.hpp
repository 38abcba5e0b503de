#pragma once

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Whether a web may buckle in shear before it yields.
struct ShearBucklingNeed {
  double ratio = 0.0;  ///< h_w/t_w
  double limit = 0.0;  ///< 72 eps/eta

  /// The resistance to shear must be taken from EN 1993-1-5, clause 5.
  bool check_needed() const { return ratio > limit; }
};

/// eta: how far strain hardening carries a stout web above its yield strength in shear.
///
///     f_yw <= 460 MPa: 1.2,  above: 1.0
///
/// Recommended values; national annexes may set 1.0 (the limit is then 20 % higher, the resistance
/// of stout webs lower). Source: EN 1993-1-5:2006, 5.1(2), note 2.
double shear_hardening_factor(Stress yield_strength);

/// Clear depth of an unstiffened web over its thickness against 72 eps/eta.
/// Source: EN 1993-1-5:2006, 5.1(2); EN 1993-1-1:2005, 6.2.6(6).
ShearBucklingNeed shear_buckling_need(Length clear_depth, Length thickness, Stress yield_strength,
                                      double eta);

}  // namespace boxbeam
