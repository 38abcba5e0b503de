#include "latex_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "latex_text.hpp"
#include "table_columns.hpp"

namespace boxbeam::report {
namespace {

/// Width of the text [pt], set by the preamble.
constexpr double text_width = 468;
constexpr double bold = 1.16;  ///< of the header against the text
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
    {{"\\small", 9.26, 12, 12.5}, {"\\footnotesize", 8.51, 10, 11}, {"\\scriptsize", 8.0, 6, 9.5}}};

/// What a column needs [em].
struct Need {
  double natural = 0;  ///< that nothing wraps but the header
  double least = 0;    ///< that no word of normal length breaks
};

Need need_of(const Table& table, std::size_t column, bool numbers) {
  Need need;
  const double header = bold * latex_widest_word(table.header[column], widest_unbroken);
  need.natural = need.least = header;
  for (const std::vector<Cell>& row : table.rows) {
    const double width = latex_width(row[column].text);
    need.natural = std::max(need.natural, width);
    const bool whole = numbers && width < widest_unbroken;
    need.least =
        std::max(need.least, whole ? width : latex_widest_word(row[column].text, widest_unbroken));
  }
  return need;
}

struct Layout {
  Type type;
  std::vector<double> widths;  ///< [pt]
};

double sum(const std::vector<Need>& needs, double Need::*of) {
  return std::accumulate(needs.begin(), needs.end(), 0.0,
                         [of](double total, const Need& need) { return total + need.*of; });
}

/// Widths of columns in a type, in an available width [pt]: what wraps least, so that the narrow
/// columns keep what they need and the wide ones share the rest.
std::vector<double> widths_in(const Type& type, const std::vector<Need>& needs, double available) {
  const double natural = sum(needs, &Need::natural) * type.em;
  const double least = sum(needs, &Need::least) * type.em;
  std::vector<double> widths;
  for (const Need& need : needs) {
    double width = need.natural * type.em;
    if (least > available) {
      width = need.least * type.em * available / least;
    } else if (natural > available) {
      const double share = (available - least) / (natural - least);
      width = (need.least + share * (need.natural - need.least)) * type.em;
    }
    widths.push_back(width);
  }
  return widths;
}

/// The largest type in which nothing is broken that should not be; a type smaller than the first
/// only where texts would wrap over more than three lines otherwise.
Layout layout_of(const std::vector<Need>& needs, double mark_width) {
  const auto gaps = static_cast<double>(needs.size() - 1);
  for (const Type& type : types) {
    const double available = text_width - mark_width - gaps * type.gap;
    const bool last = &type == &types.back();
    const double lines = sum(needs, &Need::natural) * type.em / available;
    if (last || (sum(needs, &Need::least) * type.em <= available && lines <= 2.0))
      return {type, widths_in(type, needs, available)};
  }
  return {};
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

/// Height that a table needs at most [pt]; good enough to keep small tables together.
double height_of(const Table& table, const Layout& layout) {
  double lines = 3;
  for (const std::vector<Cell>& row : table.rows) {
    double most = 1;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double width = latex_width(row[k].text) * layout.type.em;
      most = std::max(most, std::ceil(width / layout.widths[k]));
    }
    lines += most;
  }
  return lines * layout.type.height * 1.1 + 20;
}

}  // namespace

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

std::string latex_table(const Table& table) {
  const std::size_t columns = table.header.size();
  if (columns == 0) return "";
  const bool marked = std::any_of(table.marks.begin(), table.marks.end(),
                                  [](Mark mark) { return !mark_of(mark).empty(); });
  std::vector<Need> needs;
  std::vector<bool> numbers;
  for (std::size_t k = 0; k < columns; ++k) {
    numbers.push_back(holds_numbers(table, k));
    needs.push_back(need_of(table, k, numbers[k]));
  }
  const double mark_width = marked ? 10 : 0;
  const Layout layout = layout_of(needs, mark_width);

  std::string columns_spec = "@{}";
  if (marked) columns_spec += fmt::format("p{{{:.1f}pt}}@{{}}", mark_width);
  std::string header = marked ? " & " : "";
  for (std::size_t k = 0; k < columns; ++k) {
    if (k > 0) columns_spec += fmt::format("@{{\\hskip{:.1f}pt}}", layout.type.gap);
    columns_spec +=
        fmt::format(">{{\\{}}}p{{{:.2f}pt}}", numbers[k] ? "Right" : "Left", layout.widths[k]);
    header +=
        fmt::format("{}\\bfseries {}", k > 0 ? " & " : "",
                    latex_breakable(table.header[k], layout.widths[k] / layout.type.em / bold));
  }
  columns_spec += "@{}";
  header += "\\tabularnewline\n\\midrule\n";

  const double height = height_of(table, layout);
  std::string out = fmt::format("\\need{{{:.0f}pt}}\n", height < 200 ? height : 90.0);
  out += fmt::format("{{{}\\begin{{longtable}}[l]{{{}}}\n", layout.type.command, columns_spec);
  if (!table.caption.empty()) {
    out += fmt::format(
        "\\multicolumn{{{}}}{{@{{}}p{{\\linewidth}}@{{}}}}{{\\tablecaption{{{}}}}}"
        "\\tabularnewline\n",
        columns + (marked ? 1 : 0), latex_breakable(table.caption, 20));
  }
  out += fmt::format("\\toprule\n{0}\\endfirsthead\n\\toprule\n{0}\\endhead\n", header);
  out += "\\bottomrule\n\\endfoot\n\\bottomrule\n\\endlastfoot\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (marked) out += mark_of(i < table.marks.size() ? table.marks[i] : Mark::none) + " & ";
    for (std::size_t k = 0; k < columns; ++k) {
      if (k > 0) out += " & ";
      out += latex_breakable(table.rows[i][k].text, layout.widths[k] / layout.type.em);
    }
    out += "\\tabularnewline\n";
  }
  out += "\\end{longtable}}\n";
  return out;
}

}  // namespace boxbeam::report
