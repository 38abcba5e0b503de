#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/report/document.hpp"
#include "boxbeam/report/format.hpp"

/// Short ways to write the blocks of a report.
namespace boxbeam::report {

inline Cell cell(std::string text) { return {std::move(text), {}}; }

/// A quantity by its rule of rounding, without its unit, which stands in the header.
inline Cell cell(text::Quantity quantity, double value) {
  return {text::rounded(quantity, value), value};
}

/// The same where what is below `nothing` is round-off.
inline Cell cell(text::Quantity quantity, double value, double nothing) {
  return cell(quantity, value < nothing && value > -nothing ? 0.0 : value);
}

inline Table table_of(std::string caption, std::vector<std::string> header) {
  return {std::move(caption), std::move(header), {}, {}};
}

inline void add_row(Table& table, std::vector<Cell> cells) {
  assert(cells.size() == table.header.size());
  table.rows.push_back(std::move(cells));
}

inline Cell as_cell(Cell cell) { return cell; }
inline Cell as_cell(std::string text) { return cell(std::move(text)); }
inline Cell as_cell(const char* text) { return cell(std::string(text)); }

/// A row of cells and texts.
template <class... Cells>
std::vector<Cell> row_of(Cells&&... cells) {
  std::vector<Cell> row;
  row.reserve(sizeof...(cells));
  (row.push_back(as_cell(std::forward<Cells>(cells))), ...);
  return row;
}

/// Whether a table fills more than a screen.
inline bool is_long(const Table& table) {
  constexpr std::size_t rows_of_a_screen = 24;
  return table.rows.size() > rows_of_a_screen;
}

/// " (normal running)", "" where the case has only one situation.
inline std::string in_brackets(const std::string& name) {
  return name.empty() ? std::string() : " (" + name + ")";
}

}  // namespace boxbeam::report
