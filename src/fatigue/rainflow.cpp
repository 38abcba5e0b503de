#include "boxbeam/fatigue/rainflow.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace boxbeam {
namespace {

/// Points below the bottom of the shrinking ranges, which no comparison reaches.
constexpr std::size_t sentinels = 2;
constexpr double not_reached = std::numeric_limits<double>::quiet_NaN();

}  // namespace

RainflowCounter::RainflowCounter(CountingRule rule, CycleSink sink, const RainflowKernels& kernels)
    : rule_(rule), sink_(std::move(sink)), kernels_(&kernels), shrinking_(sentinels, not_reached) {}

void RainflowCounter::push(std::span<const double> samples) {
  assert(!find_uncountable(samples));
  while (!samples.empty()) {
    const auto piece = samples.first(std::min(samples.size(), block_size - block_filled_));
    find_turns(piece);
    samples = samples.subspan(piece.size());
    block_filled_ += piece.size();
    if (block_filled_ == block_size) close_block(true);
  }
}

void RainflowCounter::find_turns(std::span<const double> samples) {
  double& last = course_.last;
  if (!begun_) {
    last = samples.front();
    begun_ = true;
  }
  if (!moved_) {
    const auto other = [&](double sample) { return sample != last; };
    const auto found = std::find_if(samples.begin(), samples.end(), other);
    if (found == samples.end()) return;
    samples = samples.subspan(static_cast<std::size_t>(found - samples.begin()));
    // The first sample is a turning point.
    moved_ = true;
    turns_[turn_count_++] = last;
    course_ = {*found, *found > last};
    first_turn_is_peak_ = !course_.up;
    samples = samples.subspan(1);
  } else if (turn_count_ == 0) {
    first_turn_is_peak_ = course_.up;
  }
  turn_count_ += kernels_->write_turns(samples, course_, turns_.data() + turn_count_);
}

void RainflowCounter::close_block(bool enclosed_first) {
  if (enclosed_first) close_enclosed();
  shrinking_.resize(sentinels + depth_ + turn_count_);
  bool peak = first_turn_is_peak_;
  for (std::size_t i = 0; i < turn_count_; ++i) {
    take_turn(turns_[i], peak);
    peak = !peak;
  }
  turn_count_ = 0;
  block_filled_ = 0;
}

void RainflowCounter::close_enclosed() {
  constexpr std::size_t fewest_points = 32;
  constexpr std::size_t least_share = 8;  // of points that must go, for another pass to pay
  if (count_ != 1.0 || emitted_ + turn_count_ / 2 > most_emitted) deliver();
  count_ = 1.0;
  CycleArrays cycles{range_.data(), mean_.data(), emitted_};
  std::size_t before = 0;
  do {
    before = turn_count_;
    if (before < fewest_points) break;
    turn_count_ = kernels_->close_enclosed(turns_.data(), turn_count_, first_turn_is_peak_, cycles);
  } while (before - turn_count_ >= before / least_share);
  emitted_ = cycles.count;
}

/// Three points, of which the range X from the last of them to `turn` and the range Y before it are
/// compared; the ranges of shrinking_ always shrink, so that X >= Y closes Y where one stands
/// before it.
void RainflowCounter::take_turn(double turn, bool peak) {
  double* const start = shrinking_.data() + sentinels;
  double* end = start + depth_;
  while (peak ? turn >= end[-2] : turn <= end[-2]) {
    if (end - start == 2) {
      move_start();
      end = start + 1;
      break;
    }
    emit(end[-2], end[-1], 1.0);
    end -= 2;
  }
  *end++ = turn;
  depth_ = static_cast<std::size_t>(end - start);
}

/// The first of the two points left begins no cycle any more.
void RainflowCounter::move_start() {
  double* const start = shrinking_.data() + sentinels;
  if (rule_.counting == Counting::astm) {
    emit(start[0], start[1], 0.5);
  } else if (!growing_.empty() && growing_.back() == start[1]) {
    // The range before is as large as this one: by four points this one closes.
    emit(start[0], start[1], 1.0);
    growing_.pop_back();
  } else {
    growing_.push_back(start[0]);
  }
  start[0] = start[1];
}

void RainflowCounter::finish() {
  std::vector<double> residue = take_residue();
  switch (rule_.counting) {
    case Counting::astm: emit_halves(residue); break;
    case Counting::four_point:
      if (rule_.residue == Residue::half_cycles) emit_halves(residue);
      if (rule_.residue == Residue::repeated) {
        push(residue);
        push(residue);
        take_residue();
      }
      break;
    case Counting::periodic:
      if (residue.empty()) break;
      std::rotate(residue.begin(), std::max_element(residue.begin(), residue.end()), residue.end());
      push(residue);
      push({residue.data(), 1});
      residue = take_residue();
      // Highest, lowest, highest: the outermost cycle.
      assert(residue.size() == 3);
      emit(residue[0], residue[1], 1.0);
  }
  deliver();
}

/// Ends the history at its last sample; returns what has not closed and is ready for another one.
std::vector<double> RainflowCounter::take_residue() {
  if (moved_) {
    if (turn_count_ == 0) first_turn_is_peak_ = course_.up;
    turns_[turn_count_++] = course_.last;
  }
  close_block(false);
  std::vector<double> residue = std::move(growing_);
  const auto start = shrinking_.begin() + sentinels;
  residue.insert(residue.end(), start, start + static_cast<std::ptrdiff_t>(depth_));
  growing_.clear();
  depth_ = 0;
  begun_ = moved_ = false;
  return residue;
}

void RainflowCounter::emit_halves(std::span<const double> points) {
  for (std::size_t i = 1; i < points.size(); ++i) emit(points[i - 1], points[i], 0.5);
}

void RainflowCounter::emit(double a, double b, double count) {
  if (count != count_ || emitted_ == most_emitted) deliver();
  count_ = count;
  range_[emitted_] = std::abs(a - b);
  mean_[emitted_] = 0.5 * (a + b);
  ++emitted_;
}

void RainflowCounter::deliver() {
  if (emitted_ > 0) sink_({{range_.data(), emitted_}, {mean_.data(), emitted_}, count_});
  emitted_ = 0;
}

std::optional<std::size_t> find_uncountable(std::span<const double> samples) {
  constexpr std::size_t stride = 1024;
  constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
  // The exponent of 2^1023 is the last but one; two more reach the place of the sign.
  const auto reach = [](double sample) {
    return (std::bit_cast<std::uint64_t>(sample) & ~sign) + (std::uint64_t{2} << 52U);
  };
  for (std::size_t from = 0; from < samples.size(); from += stride) {
    const auto part = samples.subspan(from, std::min(stride, samples.size() - from));
    std::uint64_t reached = 0;
    for (const double sample : part) reached |= reach(sample);
    if ((reached & sign) == 0) continue;
    const auto too_far = [&](double sample) { return (reach(sample) & sign) != 0; };
    const auto first = std::find_if(part.begin(), part.end(), too_far);
    return from + static_cast<std::size_t>(first - part.begin());
  }
  return std::nullopt;
}

std::vector<Cycle> count_cycles(std::span<const double> history, CountingRule rule) {
  std::vector<Cycle> cycles;
  RainflowCounter counter(rule, [&](const CycleBatch& batch) {
    for (std::size_t i = 0; i < batch.range.size(); ++i) {
      cycles.push_back({si<Stress>(batch.range[i]), si<Stress>(batch.mean[i]), batch.count});
    }
  });
  counter.push(history);
  counter.finish();
  return cycles;
}

std::vector<Cycle> count_periodic_cycles(const std::vector<Stress>& turning_points) {
  std::vector<double> points;
  points.reserve(turning_points.size());
  for (const Stress& point : turning_points) points.push_back(point.value());
  return count_cycles(points, {Counting::periodic});
}

}  // namespace boxbeam
