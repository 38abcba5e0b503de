#pragma once

#include <cstddef>
#include <span>

namespace boxbeam {

/// Room behind the last element that the kernels may write to.
inline constexpr std::size_t kernel_slack = 8;

/// The way of a history to its last sample.
struct Course {
  double last = 0.0;  ///< the last sample
  bool up = false;    ///< whether the way to it, or to the plateau on which it lies, was up
};

/// Cycles that closed; room for as many as turning points come in, and the slack.
struct CycleArrays {
  double* range;
  double* mean;
  std::size_t count;
};

/// The two inner loops of cycle counting, without branches that depend on the samples: in random
/// histories each wrong guess costs more than ten comparisons. Kernels differ in speed only.
struct RainflowKernels {
  /// Writes the turning points from the last sample of `course` up to the last but one of
  /// `samples`; returns how many. Samples are finite.
  std::size_t (*write_turns)(std::span<const double> samples, Course& course, double* turns);

  /// Takes out of at least five turning points, by turns peaks and valleys, the ranges that both
  /// neighbours enclose, and adds them to the cycles. The first and the last points stay. Returns
  /// how many points stay.
  std::size_t (*close_enclosed)(double* turns, std::size_t count, bool peak_first,
                                CycleArrays& cycles);
};

/// For every machine.
extern const RainflowKernels plain_kernels;

/// The fastest that this machine can run.
const RainflowKernels& fastest_kernels();

}  // namespace boxbeam
