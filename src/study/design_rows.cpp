#include "boxbeam/study/design_rows.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "boxbeam/study/design_space.hpp"

namespace boxbeam {
namespace {

constexpr std::uint64_t stream_of_shown_designs = 7;

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

bool DesignSample::wants(std::size_t place) const {
  const std::size_t part = place / part_, first = part * part_;
  const double share = uniform_number(seed_, stream_of_shown_designs << 44U | part, 0);
  const std::size_t size = std::min(part_, designs_ - first);
  return place == first + static_cast<std::size_t>(share * static_cast<double>(size));
}

void DesignSample::take(std::size_t number, const std::vector<std::string>& cells,
                        const std::string& status) {
  numbers_.push_back(number);
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
