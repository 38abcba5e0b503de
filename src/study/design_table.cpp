#include "design_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/study_summary.hpp"
#include "boxbeam/study/written_quantity.hpp"

namespace boxbeam {
namespace {

std::string trimmed_cell(std::string text) {
  constexpr const char* blanks = " \t\r";
  const auto end = text.find_last_not_of(blanks);
  text.resize(end == std::string::npos ? 0 : end + 1);
  return text.substr(std::min(text.find_first_not_of(blanks), text.size()));
}

[[noreturn]] void refuse_table(const TableOfDesigns& table, int line, const std::string& written,
                               const std::string& message, const std::string& hint) {
  throw InputError({Problem{table.path, line, 1, written, message, hint}});
}

/// "t [mm]" in its parts.
TableOfDesigns::Cells column_named(const TableOfDesigns& table, int line,
                                   const std::string& written, const std::string& head) {
  TableOfDesigns::Cells column;
  const std::size_t open = head.find('[');
  column.name = trimmed_cell(head.substr(0, open));
  if (open != std::string::npos && head.back() == ']')
    column.unit = trimmed_cell(head.substr(open + 1, head.size() - open - 2));
  if (column.name.empty() || (open != std::string::npos && head.back() != ']') ||
      !ratio_of_units(column.unit, column.unit))
    refuse_table(table, line, written,
                 fmt::format("\"{}\" is no name of a column with its unit", head), "write t [mm]");
  if (table.find(column.name) != nullptr)
    refuse_table(table, line, written, fmt::format("two columns are named \"{}\"", column.name),
                 "give each a name of its own");
  return column;
}

}  // namespace

const TableOfDesigns::Cells* TableOfDesigns::find(const std::string& name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Cells& of) { return of.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

TableOfDesigns read_design_table(const std::string& path) {
  TableOfDesigns table;
  table.path = path;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{} cannot be read", path), "write the file's place");
  table.text.assign(std::istreambuf_iterator<char>(file), {});
  std::string_view rest = table.text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // a byte order mark
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string written = trimmed_cell(std::string(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (written.empty() || written.front() == '#') continue;
    std::vector<std::string> cells = cells_in(written);
    for (std::string& cell : cells) cell = trimmed_cell(std::move(cell));
    if (table.columns.empty()) {
      for (const std::string& head : cells)
        table.columns.push_back(column_named(table, line, written, head));
      continue;
    }
    if (cells.size() != table.columns.size())
      refuse_table(table, line, written,
                   fmt::format("the row has {} cells, its table {} columns", cells.size(),
                               table.columns.size()),
                   "write a cell for each column");
    table.lines.push_back(line);
    for (std::size_t k = 0; k < cells.size(); ++k)
      table.columns[k].cells.push_back(std::move(cells[k]));
  }
  if (table.lines.empty())
    throw InputError(fmt::format("{} has no row below the names of its columns", path),
                     "write a row for each design");
  return table;
}

}  // namespace boxbeam
