#include "boxbeam/fatigue/rainflow.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace boxbeam {
namespace {

/// Points below the bottom of the shrinking ranges, which no comparison reaches.
constexpr std::size_t sentinels = 2;
constexpr double not_reached = std::numeric_limits<double>::quiet_NaN();

/// Writes the turning points of `samples` but its last behind the `count` that are there, without
/// branches that cannot be foretold; returns how many there are. `last`: the sample before; `up`:
/// whether the way to it was up, or the way to the plateau on which it lies.
std::size_t write_turns(std::span<const double> samples, double& last, bool& up, double* turns,
                        std::size_t count) {
  double before = last;
  bool was_up = up;
  for (const double sample : samples) {
    const bool is_up = (sample > before) | ((sample >= before) & was_up);
    turns[count] = before;
    count += is_up != was_up ? 1 : 0;
    was_up = is_up;
    before = sample;
  }
  last = before;
  up = was_up;
  return count;
}

/// Takes out of `turns` every range that both its neighbours enclose, without branches that cannot
/// be foretold. Closing inner cycles first changes no cycle of the count, only their order.
///
///     peaks p, p', valleys v, v' in the order  ... v- p v p' v' ...
///     p-v  closes where  v- < v  and  p <= p';     v-p'  closes where  p > p'  and  v >= v'
///
/// so that one comparison for each point with the next of its kind decides all, no two neighbours
/// close together, and what closes around v has the peak min(p, p').
/// The first and the last points stay. Adds the cycles; returns how many points are left.
std::size_t close_enclosed_once(double* turns, std::size_t count, bool peak_first, double* range,
                                double* mean, std::size_t& emitted) {
  double* const t = peak_first ? turns : turns + 1;
  const std::size_t n = peak_first ? count : count - 1;
  std::size_t out = emitted;
  std::size_t kept = 0;
  std::size_t i = 0;
  bool valley_rose = false;  // the first peak has no neighbour on its left
  bool before_closed = false;
  double peak = t[0];
  double valley = t[1];
  for (; i + 3 < n; i += 2) {
    const double next_peak = t[i + 2];
    const double next_valley = t[i + 3];
    const bool peak_rises = next_peak >= peak;
    const bool valley_rises = next_valley > valley;
    const bool falling_closes = valley_rose & peak_rises;
    const bool rising_closes = !(peak_rises | valley_rises);
    const double top = std::min(peak, next_peak);
    range[out] = top - valley;
    mean[out] = 0.5 * (top + valley);
    out += (falling_closes | rising_closes) ? 1 : 0;
    t[kept] = peak;
    kept += (falling_closes | before_closed) ? 0 : 1;
    t[kept] = valley;
    kept += (falling_closes | rising_closes) ? 0 : 1;
    before_closed = rising_closes;
    valley_rose = valley_rises;
    peak = next_peak;
    valley = next_valley;
  }
  t[kept] = peak;
  kept += before_closed ? 0 : 1;
  for (++i; i < n; ++i) t[kept++] = t[i];
  emitted = out;
  return peak_first ? kept : kept + 1;
}

}  // namespace

RainflowCounter::RainflowCounter(CountingRule rule, CycleSink sink)
    : rule_(rule), sink_(std::move(sink)), shrinking_(sentinels, not_reached) {}

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
  if (!begun_) {
    last_ = samples.front();
    begun_ = true;
  }
  if (!moved_) {
    const auto other = [&](double sample) { return sample != last_; };
    const auto found = std::find_if(samples.begin(), samples.end(), other);
    if (found == samples.end()) return;
    samples = samples.subspan(static_cast<std::size_t>(found - samples.begin()));
    // The first sample is a turning point.
    moved_ = true;
    up_ = *found > last_;
    first_turn_is_peak_ = !up_;
    turns_[turn_count_++] = last_;
    last_ = *found;
    samples = samples.subspan(1);
  } else if (turn_count_ == 0) {
    first_turn_is_peak_ = up_;
  }
  turn_count_ = write_turns(samples, last_, up_, turns_.data(), turn_count_);
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
  if (count_ != 1.0 || emitted_ + turn_count_ / 2 >= range_.size()) deliver();
  count_ = 1.0;
  std::size_t before = 0;
  do {
    if (turn_count_ < fewest_points) return;
    before = turn_count_;
    turn_count_ = close_enclosed_once(turns_.data(), turn_count_, first_turn_is_peak_,
                                      range_.data(), mean_.data(), emitted_);
  } while (before - turn_count_ >= before / least_share);
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
    if (turn_count_ == 0) first_turn_is_peak_ = up_;
    turns_[turn_count_++] = last_;
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
  if (count != count_ || emitted_ == range_.size()) deliver();
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
  constexpr double largest = 0.5 * std::numeric_limits<double>::max();
  constexpr std::size_t stride = 1024;
  const auto countable = [](double sample) { return std::abs(sample) <= largest; };
  for (std::size_t from = 0; from < samples.size(); from += stride) {
    const auto part = samples.subspan(from, std::min(stride, samples.size() - from));
    // Without a way out of the loop, so that it runs in vectors.
    int wrong = 0;
    for (const double sample : part) wrong |= countable(sample) ? 0 : 1;
    if (wrong == 0) continue;
    const auto first = std::find_if_not(part.begin(), part.end(), countable);
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
