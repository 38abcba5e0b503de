#pragma once

#include <numbers>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"

namespace boxbeam {

/// The largest stress range, partial factor on the loads applied, for which a detail's curve holds.
///
///     direct: 1.5 f_y,  shear: 1.5 f_y/sqrt(3)
///
/// Source: EN 1993-1-9:2005+AC:2009, 8(1), equation 8.1.
template <class Record, class Value>
Value range_limit(Record& record, const Value& yield_strength, StressKind kind) {
  constexpr double most = 1.5;
  if (kind == StressKind::direct) return most * yield_strength;
  return most / record.constant("sqrt(3)", std::numbers::sqrt3) * yield_strength;
}

}  // namespace boxbeam
