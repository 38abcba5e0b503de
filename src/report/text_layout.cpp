#include "text_layout.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

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

std::string number_beside(double value, double size) {
  return fmt::format("{:.6g}", std::abs(value) <= 1e-12 * size ? 0.0 : value);
}

Table::Table(std::vector<std::string> header) { table_.header = std::move(header); }

void Table::row(const std::vector<std::string>& cells) {
  assert(cells.size() == table_.header.size());
  std::vector<report::Cell>& row = table_.rows.emplace_back();
  for (const std::string& cell : cells) row.push_back({cell, {}});
}

std::string Table::text() const { return report::table_text(table_, width()).text; }

}  // namespace boxbeam::layout
