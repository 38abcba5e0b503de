#include "table_columns.hpp"

#include <algorithm>

namespace boxbeam::report {

bool holds_numbers(const Table& table, std::size_t column) {
  const auto number = [column](const std::vector<Cell>& row) {
    const std::string& text = row[column].text;
    if (text.empty()) return false;
    const bool sign = text.front() == '-' || text.front() == '+';
    return (text.front() >= '0' && text.front() <= '9') || (sign && text.size() == 1) ||
           (sign && text[1] >= '0' && text[1] <= '9');
  };
  return !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(), number);
}

}  // namespace boxbeam::report
