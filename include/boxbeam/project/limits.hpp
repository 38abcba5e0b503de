#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "boxbeam/project/quantity_text.hpp"

/// How much a case may count, and how large its values may be. Behind these limits no calculation
/// takes for ever and no formula overflows; far below them every machine has its place.
namespace boxbeam::limits {

/// How many entries a list or a table of a case may have.
struct Count {
  const char* key;  ///< "bodies", "bodies.*.points": "*" is a name or a number
  std::size_t most;
};

/// All of them; what is not named here has the last.
std::span<const Count> counts();

/// The limit of a list or table by its whole key, "bodies.crank.points".
std::size_t most_entries(std::string_view key);

/// Beams of a case.
inline constexpr std::size_t most_beams = 50;

/// Rows of a table of numbers that a driver or a force follows, at most.
inline constexpr std::size_t most_rows = 50'000;
/// Instants of recorded loads, at most; and of those that are looked at one by one, or belong to a
/// beam that moves under them.
inline constexpr std::size_t most_recorded = 20'000'000;
inline constexpr std::size_t most_samples = 300'000;
/// Parts of an elastic link, and of all links of a case, at most.
inline constexpr int most_parts = 2'000;
inline constexpr int most_parts_at_start = 250;  ///< of a link, with a sudden start
inline constexpr int most_parts_of_all = 10'000;
/// Bare numbers, at most, and repetitions in the wanted life.
inline constexpr double largest_number = 1e20;
inline constexpr double most_cycles = 1e15;

/// How large a quantity can be meant to be, SI.
struct Range {
  double smallest;           ///< of one that must be above zero
  double largest;            ///< of either sign
  std::string largest_text;  ///< "1e+12 kg"
};

Range range_of(const WantedDimension& wanted);

}  // namespace boxbeam::limits
