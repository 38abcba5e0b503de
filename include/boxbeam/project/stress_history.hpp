#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace boxbeam {

/// Where a stress history comes from.
struct StressHistorySource {
  std::string path;  ///< "-": standard input
  /// The unit of a file of raw doubles (little-endian, nothing else in it); none: a table of text.
  std::optional<std::string> binary_unit;
};

/// Some samples of a history [Pa], valid during the call only. All can be counted: finite, and of a
/// magnitude that can be meant.
struct StressSamples {
  std::span<const double> normal;
  std::span<const double> shear;  ///< as many, or none where the history has no shear
};
using StressSink = std::function<void(const StressSamples&)>;

/// What was read.
struct StressHistory {
  std::uint64_t samples = 0;
  bool has_shear = false;
  std::optional<double> first_time;  ///< where the table has the time [s]
  std::optional<double> last_time;
};

/// Reads a history of any length in blocks and hands its samples on; the memory stays the same.
///
/// The first line of a table names its columns with their units, or its second line gives the
/// units: one column of normal stress, or two, the second of shear; before them the time may stand,
/// which ascends and is not handed on. Between columns stand commas, tabs or semicolons, with the
/// latter two the decimal sign may be a comma; names may stand in quotation marks; lines end with
/// LF, CR LF or CR; behind "#" stands a comment.
///
///     time [s], sigma [MPa], tau [MPa]
///
/// Throws InputError at the first thing that is wrong, with its place and what to write.
StressHistory read_stress_history(const StressHistorySource& source, const StressSink& sink);

}  // namespace boxbeam
