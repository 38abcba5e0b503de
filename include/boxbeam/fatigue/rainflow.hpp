#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "boxbeam/fatigue/cycle.hpp"
#include "boxbeam/fatigue/rainflow_kernels.hpp"

namespace boxbeam {

/// How the cycles of a history are found; exact, without classes. The first and the last sample
/// count as turning points.
enum class Counting {
  /// By three points: a range that holds the start of what is left is half a cycle, and so is what
  /// is left at the end. Source: ASTM E1049-85, 5.4.4.
  astm,
  /// By four points: a range that both its neighbours enclose is a full cycle; the rest by Residue.
  /// Source: Amzallag et al., Int. J. Fatigue 16 (1994) 287-293.
  four_point,
  /// Of one period of a history that repeats for ever: rotated to its highest point it closes, so
  /// that every cycle is full and nothing is left. Source: ASTM E1049-85, 5.4.5.
  periodic,
};

/// What becomes of the ranges that never closed; for counting by four points only.
enum class Residue {
  half_cycles,  ///< each range half a cycle: with it as many of each as by ASTM; IEC 61400-1
  repeated,     ///< put once more behind itself; the cycles that close then, as full ones
  discard,      ///< nothing: loses the largest range
};

struct CountingRule {
  Counting counting = Counting::astm;
  Residue residue = Residue::half_cycles;
};

/// Some cycles of one count. Valid during the call only.
struct CycleBatch {
  std::span<const double> range;  ///< above zero [Pa]
  std::span<const double> mean;   ///< of the same cycles [Pa]
  double count = 1.0;             ///< of each: 1 or 0.5
};
using CycleSink = std::function<void(const CycleBatch&)>;

/// Counts a history that comes in chunks of any size; keeps only its residue.
///
/// The cycles are those of the whole history, in the same order however it is cut. A history of at
/// most `block_size` samples gives them in the order in which they close; in a longer one, cycles
/// that their neighbours enclose come first in each block of samples.
class RainflowCounter {
 public:
  static constexpr std::size_t block_size = 4096;

  RainflowCounter(CountingRule rule, CycleSink sink,
                  const RainflowKernels& kernels = fastest_kernels());

  /// The next samples [Pa]; all must be countable (find_uncountable).
  void push(std::span<const double> samples);

  /// The history is complete: counts what the residue gives. Afterwards another one may begin.
  void finish();

 private:
  void find_turns(std::span<const double> samples);
  void close_block(bool enclosed_first);
  void close_enclosed();
  void take_turn(double turn, bool peak);
  void move_start();
  std::vector<double> take_residue();
  void emit_halves(std::span<const double> points);
  void emit(double a, double b, double count);
  void deliver();

  CountingRule rule_;
  CycleSink sink_;
  const RainflowKernels* kernels_;

  Course course_;
  bool begun_ = false;  ///< whether there is a sample
  bool moved_ = false;  ///< whether there are two that differ

  // The turning points of the block of samples at hand, peaks and valleys by turns.
  std::array<double, block_size + 1 + kernel_slack> turns_;
  std::size_t turn_count_ = 0;
  std::size_t block_filled_ = 0;
  bool first_turn_is_peak_ = false;

  // What has not closed: ranges that grow up to the largest, then ranges that shrink.
  std::vector<double> growing_;
  std::vector<double> shrinking_;
  std::size_t depth_ = 0;

  // Cycles on their way to the sink.
  static constexpr std::size_t most_emitted = block_size;
  std::array<double, most_emitted + kernel_slack> range_;
  std::array<double, most_emitted + kernel_slack> mean_;
  std::size_t emitted_ = 0;
  double count_ = 1.0;
};

/// The index of the first sample that cannot be counted: NaN, infinite, or 2^1023 and more, where a
/// range could overflow.
std::optional<std::size_t> find_uncountable(std::span<const double> samples);

/// All cycles of a history in memory, its samples in Pa.
std::vector<Cycle> count_cycles(std::span<const double> history, CountingRule rule = {});

/// The full cycles of one period of a periodic history, from its turning points in order of time.
std::vector<Cycle> count_periodic_cycles(const std::vector<Stress>& turning_points);

}  // namespace boxbeam
