#include "text_table.hpp"

#include <algorithm>
#include <numeric>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "plain_text.hpp"
#include "table_columns.hpp"

namespace boxbeam::report {
namespace {

using plain_text::columns_of;

constexpr std::size_t usual_gap = 2;   // before every column
constexpr std::size_t narrow_gap = 1;  // where all cells stay whole by it

/// A table whose cells are safe for a terminal.
using Grid = std::vector<std::vector<std::string>>;

Grid grid_of(const Table& table) {
  Grid grid;
  grid.reserve(table.rows.size() + 1);
  std::vector<std::string>& header = grid.emplace_back();
  for (const std::string& title : table.header) header.push_back(visible(title));
  for (const auto& row : table.rows) {
    std::vector<std::string>& line = grid.emplace_back();
    line.reserve(row.size());
    for (const Cell& cell : row) line.push_back(visible(cell.text));
  }
  return grid;
}

struct Column {
  std::size_t width = 0;      ///< of its widest cell, then what it gets
  std::size_t narrowest = 0;  ///< that wrapping can make it
  bool right = false;         ///< as numbers do
};

/// Where there is no room for whole words, longer ones are broken.
constexpr std::size_t longest_word = 24;

std::size_t longest_word_in(const std::string& cell, std::size_t most) {
  std::size_t longest = 1;
  for (std::size_t at = 0; at < cell.size();) {
    const std::size_t end = std::min(cell.find(' ', at), cell.size());
    longest = std::max(longest, columns_of(std::string_view(cell).substr(at, end - at)));
    at = end + 1;
  }
  return std::min(longest, most);
}

std::vector<Column> columns_in(const Table& table, const Grid& grid) {
  std::vector<Column> columns(grid.front().size());
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k].right = holds_numbers(table, k);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Column& column = columns[k];
      column.width = std::max(column.width, columns_of(grid[i][k]));
    }
  }
  return columns;
}

std::size_t width_of(const std::vector<Column>& columns, std::size_t gap = usual_gap) {
  return std::accumulate(columns.begin(), columns.end(), std::size_t{0},
                         [&](std::size_t sum, const Column& of) { return sum + gap + of.width; });
}

/// Takes width from the widest column that can give some, until the table fits or none can. Words
/// longer than `most` may be broken.
void narrow(const Grid& grid, std::size_t width, std::size_t most, std::vector<Column>& columns) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (std::size_t i = 0; i < grid.size(); ++i) {
      // A number is never broken, but the words above it may stand one below the other.
      const bool whole = columns[k].right && i > 0;
      columns[k].narrowest = std::max(
          columns[k].narrowest, whole ? columns_of(grid[i][k]) : longest_word_in(grid[i][k], most));
    }
  }
  for (std::size_t total = width_of(columns); total > width; --total) {
    Column* widest = nullptr;
    for (Column& column : columns) {
      if (column.width <= column.narrowest) continue;
      if (widest == nullptr || column.width > widest->width) widest = &column;
    }
    if (widest == nullptr) return;
    --widest->width;
  }
}

void add_cell(const std::string& cell, const Column& column, std::string& line) {
  const std::size_t used = columns_of(cell);
  const std::size_t space = column.width - std::min(column.width, used);
  if (column.right) line.append(space, ' ');
  line += cell;
  if (!column.right) line.append(space, ' ');
}

void end_line(MarkedText& line, MarkedText& out) {
  line.text.erase(line.text.find_last_not_of(' ') + 1);
  line.text += '\n';
  out += line;
}

/// The cells of one line of a row.
MarkedText line_of(const std::vector<std::string>& cells, const std::vector<Mark>& marks,
                   const std::vector<Column>& columns, std::size_t gap, char mark) {
  MarkedText line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    line.text.append(gap, ' ');
    const std::size_t begin = line.text.size();
    add_cell(cells[k], columns[k], line.text);
    if (k < marks.size() && marks[k] != Mark::none && !cells[k].empty())
      line.words.push_back({begin, begin + cells[k].size(), marks[k]});
  }
  line.text.front() = mark;
  return line;
}

void add_row(const std::vector<std::string>& row, const std::vector<Mark>& marks,
             const std::vector<Column>& columns, std::size_t gap, char mark, MarkedText& out) {
  const auto fits = [&](std::size_t k) { return columns_of(row[k]) <= columns[k].width; };
  bool one_line = true;
  for (std::size_t k = 0; k < row.size(); ++k) one_line = one_line && fits(k);
  if (one_line) {
    MarkedText line = line_of(row, marks, columns, gap, mark);
    end_line(line, out);
    return;
  }
  std::vector<std::vector<std::string>> cells;
  std::size_t lines = 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    cells.push_back(plain_text::wrapped(row[k], columns[k].width, columns[k].width));
    lines = std::max(lines, cells.back().size());
  }
  for (std::size_t i = 0; i < lines; ++i) {
    std::vector<std::string> parts;
    for (const std::vector<std::string>& cell : cells)
      parts.push_back(i < cell.size() ? cell[i] : "");
    MarkedText line = line_of(parts, marks, columns, gap, i == 0 ? mark : ' ');
    end_line(line, out);
  }
}

char sign_of(Mark mark) {
  return mark == Mark::fails ? '!' : mark == Mark::not_applicable ? '?' : ' ';
}

/// The first column and those from one to another.
Table part_of(const Table& table, std::size_t from, std::size_t to) {
  const auto taken = [&](const auto& cells) {
    auto some = cells;
    some.erase(some.begin() + static_cast<std::ptrdiff_t>(to), some.end());
    some.erase(some.begin() + 1, some.begin() + static_cast<std::ptrdiff_t>(from));
    return some;
  };
  Table part;
  part.header = taken(table.header);
  for (const auto& row : table.rows) part.rows.push_back(taken(row));
  part.marks = table.marks;
  return part;
}

/// A table that no wrapping makes narrow enough, as tables one below the other: as many columns as
/// there is room for, each time behind the first.
MarkedText in_parts(const Table& table, std::size_t width, const std::vector<Column>& columns) {
  MarkedText out;
  for (std::size_t from = 1; from < columns.size();) {
    std::size_t to = from + 1;
    std::size_t used = 2 * usual_gap + columns.front().width + columns[from].width;
    while (to < columns.size() && used + usual_gap + columns[to].width <= width) {
      used += usual_gap + columns[to].width;
      ++to;
    }
    if (from == 1 && to == columns.size()) return {};  // nothing to part
    if (!out.text.empty()) out += "\n";
    out += table_text(part_of(table, from, to), width);
    from = to;
  }
  return out;
}

}  // namespace

MarkedText table_text(const Table& table, std::size_t width) {
  if (table.header.empty()) return {};
  const Grid grid = grid_of(table);
  std::vector<Column> columns = columns_in(table, grid);
  const bool wide = width_of(columns) > width;
  // On a screen; a report in a file keeps its columns apart for those who read it by a program.
  const bool closes = width < report_columns && wide && width_of(columns, narrow_gap) <= width;
  const std::size_t gap = closes ? narrow_gap : usual_gap;
  for (const std::size_t most : {width, longest_word}) {
    if (width_of(columns, gap) <= width) break;
    columns = columns_in(table, grid);
    narrow(grid, width, most, columns);
  }
  if (width_of(columns, gap) > width && columns.size() > 2) {
    if (MarkedText parts = in_parts(table, width, columns); !parts.text.empty()) return parts;
  }
  MarkedText out;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    std::vector<Mark> marks;
    if (i > 0) {
      for (const Cell& cell : table.rows[i - 1]) marks.push_back(cell.mark);
    }
    const bool signs = i > 0 && !table.marks.empty();
    add_row(grid[i], marks, columns, gap, signs ? sign_of(table.marks[i - 1]) : ' ', out);
  }
  return out;
}

Table with_results(Table table) {
  if (table.marks.empty()) return table;
  table.header.insert(table.header.begin(), "result");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Mark mark = table.marks[i];
    table.rows[i].insert(table.rows[i].begin(), {to_text(mark), {}, mark});
  }
  table.marks.clear();
  return table;
}

}  // namespace boxbeam::report
