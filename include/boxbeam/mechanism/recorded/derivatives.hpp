#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace boxbeam::recorded {

/// Rate and second derivative of a series at its instants: of the polynomial of fourth degree
/// through each instant and the two nearest on either side, near the ends through the first or last
/// five, wrong by h^4/90 of the sixth derivative (of waves of n instants, n = 12: 0.1 %). Where
/// steps differ by more than twice, of fewer than five instants and at both ends the parabola
/// through three. Of two instants the rate is their slope. Two at least. Source: Fornberg,
/// Mathematics of Computation 51 (1988), for the weights that this gives.
std::pair<std::vector<double>, std::vector<double>> derivatives_of(
    const std::vector<double>& times, const std::vector<double>& values);

/// The least number of instants that a series has to one of its larger waves: between three turning
/// points, each apart from the next by three tenths of all that the series changes; nothing where
/// there are no such three. Linear between instants, a wave of n keeps cos(pi/n) of its height at
/// the worst.
struct ShortestWave {
  std::size_t instants = 0;
  double time = 0.0;  ///< of its middle turning point [s]
};
ShortestWave shortest_wave_of(const std::vector<double>& times, const std::vector<double>& values);

}  // namespace boxbeam::recorded
