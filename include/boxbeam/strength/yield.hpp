#pragma once

#include "boxbeam/core/derivation.hpp"

namespace boxbeam {

/// The equivalent stress that a plate bears elastically, f_y/gamma_M0.
/// Source: EN 1993-1-1:2005, 6.2.1(5), equation 6.1.
template <class Record, class Value>
Value yield_resistance(Record& record, const Value& yield_strength, double gamma_M0) {
  return yield_strength / record.known("gamma_M0", gamma_M0, {ValueKind::factor});
}

}  // namespace boxbeam
