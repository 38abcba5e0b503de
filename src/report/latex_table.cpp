#include "latex_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "latex_text.hpp"
#include "table_columns.hpp"

namespace boxbeam::report {
namespace {

/// Width of the text [pt], set by the preamble.
constexpr double text_width = 468;
constexpr double bold = 1.18;      ///< of the header against the text
constexpr double mark_width = 10;  ///< of the column of marks [pt]
/// No word of a text keeps a column wider than this [em].
constexpr double widest_unbroken = 11;

/// A size of type for tables.
struct Type {
  const char* command;
  double em;      ///< width of 1 em of latex_width [pt]: small type is relatively wider
  double gap;     ///< between columns [pt]
  double height;  ///< of a line [pt]
};

constexpr std::array<Type, 3> types{
    {{"\\small", 9.4, 12, 12.5}, {"\\footnotesize", 8.65, 10, 11}, {"\\scriptsize", 8.15, 6, 9.5}}};

/// Where the unit of a header stays with itself: "M max [kN m]" breaks before the bracket only.
std::string with_whole_unit(std::string header) {
  const std::size_t unit = header.rfind('[');
  if (unit == std::string::npos) return header;
  for (std::size_t at = unit; (at = header.find(' ', at)) != std::string::npos;)
    header.replace(at, 1, "\u00A0");
  return header;
}

/// What a column needs [em].
struct Need {
  double all = 0;    ///< that nothing wraps
  double cells = 0;  ///< that no cell wraps; headers may
  double words = 0;  ///< that no word of normal length breaks
};

Need need_of(const Table& table, std::size_t column, bool numbers) {
  const std::string header = with_whole_unit(table.header[column]);
  Need need;
  need.words = bold * latex_widest_word(header, widest_unbroken);
  for (const std::vector<Cell>& row : table.rows) {
    const double width = latex_width(row[column].text);
    const double word = latex_widest_word(row[column].text, widest_unbroken);
    need.cells = std::max(need.cells, width);
    need.words = std::max(need.words, numbers && width < widest_unbroken ? width : word);
  }
  need.cells = std::max(need.cells, need.words);
  need.all = std::max(need.cells, bold * latex_width(header));
  return need;
}

struct Layout {
  Type type;
  std::vector<double> widths;  ///< of the columns [pt]
  std::vector<bool> numbers;   ///< which columns stand at the right
  bool marked = false;         ///< a column of marks stands before them
  bool wraps = false;          ///< some row takes more than a line

  /// Of a column, in em, and a little more: what just fits need not break.
  double room(std::size_t column) const { return 1.001 * widths[column] / type.em; }
};

double total(const std::vector<Need>& needs, double Need::*part) {
  return std::accumulate(needs.begin(), needs.end(), 0.0,
                         [part](double sum, const Need& need) { return sum + need.*part; });
}

/// Widths [em] that fill what is available, each between two needs: the widest columns give way.
std::vector<double> between(const std::vector<Need>& needs, double available, double Need::*least,
                            double Need::*most) {
  const auto capped = [&](double cap) {
    std::vector<double> widths;
    widths.reserve(needs.size());
    for (const Need& need : needs) {
      const double lower = least == nullptr ? 0.0 : need.*least;
      widths.push_back(std::max(lower, std::min(need.*most, cap)));
    }
    return widths;
  };
  double low = 0;
  double high = available;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    const std::vector<double> widths = capped(middle);
    const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
    (sum <= available ? low : high) = middle;
  }
  return capped(low);
}

std::vector<double> fitting(const std::vector<Need>& needs, double available) {
  if (total(needs, &Need::all) <= available)
    return between(needs, available, &Need::all, &Need::all);
  if (total(needs, &Need::cells) <= available)
    return between(needs, available, &Need::cells, &Need::all);
  if (total(needs, &Need::words) <= available)
    return between(needs, available, &Need::words, &Need::cells);
  return between(needs, available, nullptr, &Need::words);
}

std::string mark_of(Mark mark) {
  switch (mark) {
    case Mark::fails: return "\\textcolor{fails}{\\textbf{!}}";
    case Mark::not_applicable: return "\\textcolor{unknown}{\\textbf{?}}";
    case Mark::passes:
    case Mark::none: break;
  }
  return "";
}

/// Lines that the rows of a table take, about.
double lines_of(const Table& table, const Layout& layout) {
  double lines = 0;
  for (const std::vector<Cell>& row : table.rows) {
    double most = 1;
    for (std::size_t k = 0; k < row.size(); ++k)
      most = std::max(most, std::ceil(latex_width(row[k].text) / layout.room(k)));
    lines += most;
  }
  return lines;
}

/// In the largest type in which no cell wraps, so that a row is a line (a table over pages in the
/// smallest); where none is small enough,
/// in the largest in which no word breaks and few texts wrap.
Layout layout_of(const Table& table) {
  Layout layout;
  layout.marked = std::any_of(table.marks.begin(), table.marks.end(),
                              [](Mark mark) { return !mark_of(mark).empty(); });
  std::vector<Need> needs;
  for (std::size_t k = 0; k < table.header.size(); ++k) {
    layout.numbers.push_back(holds_numbers(table, k));
    needs.push_back(need_of(table, k, layout.numbers[k]));
  }
  const double cells = total(needs, &Need::cells);
  const double words = total(needs, &Need::words);
  const auto gaps = static_cast<double>(needs.size()) - 1;
  const auto available = [&](const Type& type) {
    return (text_width - (layout.marked ? mark_width : 0) - gaps * type.gap) / type.em;
  };
  const auto holds_well = [&](const Type& type) {
    return words <= available(type) && cells <= 1.8 * available(type);
  };
  constexpr std::size_t a_page = 60;  // of rows: what is longer is looked up, not read
  const auto largest = table.rows.size() > a_page ? types.end() - 1 : types.begin();
  auto type = std::find_if(largest, types.end(),
                           [&](const Type& each) { return cells <= available(each); });
  if (type == types.end()) type = std::find_if(types.begin(), types.end() - 1, holds_well);
  layout.type = *type;
  layout.widths = fitting(needs, available(*type));
  for (double& width : layout.widths) width *= layout.type.em;
  layout.wraps = lines_of(table, layout) > static_cast<double>(table.rows.size());
  return layout;
}

TableHeight height_of(const Table& table, const Layout& layout) {
  constexpr double most = 150;
  constexpr double of_a_long_one = 90;
  const auto rows = static_cast<double>(table.rows.size());
  const double lines = lines_of(table, layout) + 2;
  const double height = lines * layout.type.height * 1.02 + (layout.wraps ? 2.5 * rows : 0) + 14;
  return {height, height < most ? height : of_a_long_one};
}

}  // namespace

TableHeight latex_table_height(const Table& table) { return height_of(table, layout_of(table)); }

std::string latex_table(const Table& table) {
  const std::size_t columns = table.header.size();
  if (columns == 0) return "";
  const Layout layout = layout_of(table);

  std::string columns_spec = "@{}";
  if (layout.marked) columns_spec += fmt::format("p{{{:.1f}pt}}@{{}}", mark_width);
  std::string header = layout.marked ? " & " : "";
  for (std::size_t k = 0; k < columns; ++k) {
    if (k > 0) columns_spec += fmt::format("@{{\\hskip{:.1f}pt}}", layout.type.gap);
    columns_spec += fmt::format(">{{\\{}}}p{{{:.2f}pt}}", layout.numbers[k] ? "Right" : "Left",
                                layout.widths[k]);
    header += fmt::format("{}\\bfseries {}", k > 0 ? " & " : "",
                          latex_breakable(with_whole_unit(table.header[k]), layout.room(k) / bold));
  }
  columns_spec += "@{}";
  header += "\\tabularnewline\n\\midrule\n";

  std::string out;
  if (!table.caption.empty())
    out += fmt::format("\\tablecaption{{{}}}\n", latex_breakable(table.caption, 12));
  out += fmt::format("{{{}\\begin{{longtable}}[l]{{{}}}\n", layout.type.command, columns_spec);
  out += fmt::format("\\toprule\n{0}\\endfirsthead\n\\toprule\n{0}\\endhead\n", header);
  out += "\\bottomrule\n\\endfoot\n\\bottomrule\n\\endlastfoot\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (layout.marked) out += mark_of(i < table.marks.size() ? table.marks[i] : Mark::none) + " & ";
    for (std::size_t k = 0; k < columns; ++k) {
      if (k > 0) out += " & ";
      out += latex_breakable(table.rows[i][k].text, layout.room(k));
    }
    out += "\\tabularnewline\n";
    if (layout.wraps && i + 1 < table.rows.size()) out += "\\addlinespace[2.5pt]\n";
  }
  out += "\\end{longtable}}\n";
  return out;
}

}  // namespace boxbeam::report
