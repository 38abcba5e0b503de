#include "boxbeam/study/design_rows.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "boxbeam/study/design_space.hpp"

namespace boxbeam {
namespace {

constexpr std::uint64_t stream_of_shown_designs = 7;

std::optional<double> number_of_cell(const std::string& cell) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return number;
}

}  // namespace

const DesignColumn* DesignRows::find(const std::string& name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const DesignColumn& of) { return of.column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

DesignSample::DesignSample(std::vector<Column> columns, std::size_t variables, std::size_t designs,
                           std::uint64_t seed)
    : columns_(std::move(columns)),
      variables_(variables),
      designs_(designs),
      part_((designs + most - 1) / most),
      seed_(seed) {}

void DesignSample::take(const std::vector<std::string>& cells, const std::string& status) {
  const std::size_t part = next_ / part_;
  if (next_ % part_ == 0) {
    const std::size_t size = std::min(part_, designs_ - std::min(designs_ - 1, part * part_));
    const double share = uniform_number(seed_, stream_of_shown_designs << 44U | part, 0);
    wanted_ = next_ + static_cast<std::size_t>(share * static_cast<double>(size));
  }
  if (next_++ != wanted_) return;
  numbers_.push_back(next_);
  cells_.push_back(cells);
  cells_.back().push_back(status);
}

DesignRows DesignSample::rows() const {
  DesignRows rows;
  rows.designs = designs_;
  rows.numbers = numbers_;
  for (std::size_t k = 0; k <= columns_.size(); ++k) {
    const bool is_status = k == columns_.size();
    DesignColumn column{is_status ? Column{"status", ""} : columns_[k], k < variables_, {}, {}};
    bool has_words = false, has_numbers = false, has_failed = false;
    for (const std::vector<std::string>& row : cells_) {
      const std::optional<double> number = number_of_cell(row[k]);
      has_numbers = has_numbers || number;
      has_words = has_words || (!number && !row[k].empty());
      has_failed = has_failed || (is_status && row[k] != "ok");
      column.numbers.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
      column.words.push_back(row[k]);
    }
    if (is_status ? !has_failed : !has_words && !has_numbers) continue;
    if (has_words)
      column.numbers.clear();
    else
      column.words.clear();
    rows.columns.push_back(std::move(column));
  }
  return rows;
}

}  // namespace boxbeam
