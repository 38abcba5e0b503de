#pragma once

#include <cstdint>
#include <span>
#include <utility>

namespace oracle {

// A quantity at many instants: what the oracle spends its time on, built for wide registers too.

/// sum += factor values.
void add_times(double factor, std::span<const double> values, std::span<double> sum);

/// Lowest and highest; (infinity, -infinity) of none.
std::pair<double, double> extremes_of(std::span<const double> values);

/// How often it changes between growing and not growing.
std::int64_t changes_of(std::span<const double> values);

}  // namespace oracle
