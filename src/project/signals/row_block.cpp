#include "row_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "../csv_text.hpp"

namespace boxbeam {
namespace {

bool can_be_meant(double value) { return std::abs(value) <= largest_table_number; }

RowTrouble value_trouble(std::size_t row, std::size_t channel, double value) {
  return {row, channel, fmt::format("{:g} is not finite, or too large to be meant", value),
          "write a finite number of the channel's unit"};
}

RowTrouble time_trouble(std::size_t row, double time, std::optional<double> before) {
  if (!can_be_meant(time)) return value_trouble(row, RowTrouble::time, time);
  return {row, RowTrouble::time,
          fmt::format("the time {} s does not come after {} s of the row before", time,
                      before.value_or(0.0)),
          "write the rows in the order of time, each instant once; of a run that was repeated into "
          "the same file keep one"};
}

}  // namespace

RowBlock::RowBlock(std::vector<double> factors, const SignalSink& sink)
    : factors_(std::move(factors)), sink_(&sink), time_(most_rows) {
  columns_.assign(factors_.size(), std::vector<double>(most_rows));
  spans_.resize(factors_.size());
}

std::optional<RowTrouble> RowBlock::trouble_of_time(double time) const {
  if (can_be_meant(time) && (!last_time_ || time > *last_time_)) return std::nullopt;
  return time_trouble(0, time, last_time_);
}

std::optional<RowTrouble> RowBlock::trouble_of_value(double value) {
  if (can_be_meant(value)) return std::nullopt;
  return value_trouble(0, 0, value);
}

std::optional<RowTrouble> RowBlock::take(double time, const double* values) {
  if (auto trouble = trouble_of_time(time)) return trouble;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (!can_be_meant(values[k])) return value_trouble(0, k, values[k]);
    columns_[k][filled_] = values[k];
  }
  last_time_ = time_[filled_] = time;
  if (++filled_ == most_rows) finish();
  return std::nullopt;
}

std::optional<RowTrouble> RowBlock::take_filled(std::size_t rows) {
  std::optional<double> before = last_time_;
  std::optional<RowTrouble> first;
  for (std::size_t row = 0; row < rows; ++row) {
    if (!can_be_meant(time_[row]) || (before && !(time_[row] > *before))) {
      first = time_trouble(row, time_[row], before);
      break;
    }
    before = time_[row];
  }
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const std::vector<double>& column = columns_[k];
    // All at once first: nearly always nothing is wrong.
    bool all = true;
    for (std::size_t row = 0; row < rows; ++row) all &= can_be_meant(column[row]);
    if (all) continue;
    const auto found = std::find_if_not(column.begin(), column.end(), can_be_meant);
    const auto row = static_cast<std::size_t>(found - column.begin());
    if (!first || row < first->row) first = value_trouble(row, k, *found);
  }
  if (first) return first;
  last_time_ = before;
  deliver(rows);
  return std::nullopt;
}

void RowBlock::finish() { deliver(std::exchange(filled_, 0)); }

void RowBlock::deliver(std::size_t rows) {
  if (rows == 0) return;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    double* const column = columns_[k].data();
    if (const double factor = factors_[k]; factor != 1.0) {
      for (std::size_t row = 0; row < rows; ++row) column[row] *= factor;
    }
    spans_[k] = {column, rows};
  }
  if (summary_.rows == 0) summary_.first_time = time_.front();
  summary_.last_time = time_[rows - 1];
  summary_.rows += rows;
  (*sink_)({{time_.data(), rows}, spans_});
}

}  // namespace boxbeam
