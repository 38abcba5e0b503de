#include "table_columns.hpp"

namespace boxbeam::report {

bool is_number(const std::string& cell) {
  if (cell.empty()) return false;
  const auto digit_at = [&cell](std::size_t i) { return cell[i] >= '0' && cell[i] <= '9'; };
  const bool sign = cell.front() == '-' || cell.front() == '+';
  return sign ? cell.size() == 1 || digit_at(1) : digit_at(0);
}

bool holds_numbers(const Table& table, std::size_t column) {
  bool any = false;
  for (const auto& row : table.rows) {
    const std::string& cell = row[column].text;
    // Nothing in the first column is a name that goes on.
    const bool left_out = cell.empty() && column > 0;
    if (!left_out && !is_number(cell)) return false;
    any = any || !cell.empty();
  }
  return any;
}

}  // namespace boxbeam::report
