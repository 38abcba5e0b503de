#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "boxbeam/core/error.hpp"

namespace boxbeam {

/// Keys stay in their order.
using Json = nlohmann::ordered_json;

/// The library writes NaN and infinity as null without a word; a result must never be one.
inline double finite(double value) {
  if (!std::isfinite(value))
    throw OutputError("a result is not a finite number and is not written");
  return value == 0.0 ? 0.0 : value;  // no "-0.0"
}

}  // namespace boxbeam
