#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace oracle {

// A quantity at many instants: what the oracle spends its time on, built for wide registers too.

/// One quantity and its weight in a sum.
struct Term {
  double factor = 0.0;
  std::span<const double> values;
};

/// The sum of no terms (zeros) or more, each with as many values as the sum.
void add_up(std::span<const Term> terms, std::span<double> sum);

/// Lowest and highest; (infinity, -infinity) of none.
std::pair<double, double> extremes_of(std::span<const double> values);

/// How often it changes between growing and not growing.
std::int64_t changes_of(std::span<const double> values);

/// Moves the first value, those at such changes and the last to the front; how many they are.
std::size_t keep_turns(std::span<double> values);

}  // namespace oracle
