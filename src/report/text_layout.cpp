#include "text_layout.hpp"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <numeric>

#include "boxbeam/core/code_points.hpp"
#include "plain_text.hpp"
#include "text_table.hpp"

namespace boxbeam::layout {
namespace {

using plain_text::columns_of;

constexpr std::size_t usual_width = 110;

std::size_t& columns_there() {
  static std::size_t columns = usual_width;
  return columns;
}

std::string wrapped(const std::string& text, const std::string& first, const std::string& rest) {
  std::string out;
  for (const std::string& line :
       plain_text::wrapped(text, width() - columns_of(rest), width() - columns_of(first))) {
    out += out.empty() ? first : rest;
    out += line;
    out += '\n';
  }
  return out;
}

bool numeric(const std::string& cell) {
  if (cell.empty()) return true;
  const char c = cell.front();
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+';
}

}  // namespace

std::size_t width() { return columns_there(); }

void set_width(std::size_t columns) { columns_there() = columns; }

std::string line(const std::string& text) { return wrapped(text, "", "  "); }

std::string heading(const std::string& text) {
  return text + "\n" + std::string(columns_of(text), '-') + "\n";
}

std::string paragraph(const std::string& text) { return wrapped(text, "  ", "  "); }

std::string item(const std::string& text) { return wrapped(text, "  - ", "    "); }

std::string entry(const std::string& name, const std::string& text) {
  const std::size_t used = columns_of(name);
  const std::string gap(used < 10 ? 10 - used : 1, ' ');
  return wrapped(text, "  " + visible(name) + gap, std::string(12, ' '));
}

Table::Table(std::vector<std::string> header) : rows_{std::move(header)} {}

void Table::row(std::vector<std::string> cells) {
  assert(cells.size() == rows_.front().size());
  for (std::string& cell : cells) cell = visible(cell);
  rows_.push_back(std::move(cells));
}

report::Table Table::as_report_table() const {
  report::Table table;
  table.header = rows_.front();
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    std::vector<report::Cell>& row = table.rows.emplace_back();
    for (const std::string& cell : rows_[i]) row.push_back({cell, {}});
  }
  return table;
}

std::string Table::text() const {
  const std::size_t columns = rows_.front().size();
  std::vector<std::size_t> widths(columns, 0);
  std::vector<bool> right(columns, true);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (std::size_t k = 0; k < columns; ++k) {
      widths[k] = std::max(widths[k], columns_of(rows_[i][k]));
      if (i > 0) right[k] = right[k] && numeric(rows_[i][k]);
    }
  }
  const std::size_t all = std::accumulate(widths.begin(), widths.end(), 2 * columns);
  if (all > width()) return report::table_text(as_report_table(), width());
  std::string out;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    std::string line = " ";
    for (std::size_t k = 0; k < columns; ++k) {
      const std::string gap(widths[k] - columns_of(rows_[i][k]), ' ');
      line += ' ';
      if (right[k]) line += gap;
      line += rows_[i][k];
      if (!right[k]) line += gap;
      line += ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

}  // namespace boxbeam::layout
