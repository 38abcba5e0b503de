#include "table_columns.hpp"

#include <algorithm>

namespace boxbeam::report {

bool is_number(const std::string& cell) {
  if (cell.empty()) return false;
  const auto digit_at = [&cell](std::size_t i) { return cell[i] >= '0' && cell[i] <= '9'; };
  const bool sign = cell.front() == '-' || cell.front() == '+';
  return sign ? cell.size() == 1 || digit_at(1) : digit_at(0);
}

bool holds_numbers(const Table& table, std::size_t column) {
  return !table.rows.empty() &&
         std::all_of(table.rows.begin(), table.rows.end(),
                     [column](const auto& row) { return is_number(row[column].text); });
}

}  // namespace boxbeam::report
