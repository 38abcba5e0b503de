#pragma once

#include <cstddef>
#include <span>

namespace boxbeam {

/// The stress at instants: factors[0] + sum of factors[k + 1] times channel k, whose values stand
/// `stride` apart from those of the channel before. The same on every machine.
void mix_stress(std::span<const double> factors, const double* values, std::size_t stride,
                std::span<double> stresses);

/// The lowest and the highest of at least one value.
struct Ends {
  double lowest = 0.0, highest = 0.0;
};
Ends ends_of(std::span<const double> values);

}  // namespace boxbeam
