#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "boxbeam/report/format.hpp"
#include "charts/accuracy_plot.hpp"
#include "charts/log_axis.hpp"
#include "report/canvas.hpp"

namespace boxbeam::plot {
namespace {

using charts::Cell;
using charts::Map;
using charts::MapAxis;
using charts::MapPanel;
using charts::Outcome;

constexpr double margin = 12.0;
constexpr const char* quiet = "#5d6b79";
constexpr const char* wrong_colour = "#e8710a";
constexpr const char* refused_colour = "#dedede";
constexpr const char* solved_colour = "#9cc3e6";

/// From light to dark blue, evenly in lightness.
std::string shade(double share) {
  const auto mix = [&](int light, int dark) {
    return static_cast<int>(std::lround(light + share * (dark - light)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0xe3, 0x08), mix(0xee, 0x40), mix(0xf9, 0x81));
}

/// Values of the solved trials of all panels.
struct ValueRange {
  double low = 0.0, high = 0.0;
  bool any = false;
};

ValueRange values_of(const Map& map) {
  ValueRange range;
  if (map.value.empty()) return range;
  for (const MapPanel& panel : map.panels) {
    for (const Cell& cell : panel.cells) {
      if (cell.outcome != Outcome::solved || !cell.value || !std::isfinite(*cell.value)) continue;
      range.low = range.any ? std::min(range.low, *cell.value) : *cell.value;
      range.high = range.any ? std::max(range.high, *cell.value) : *cell.value;
      range.any = true;
    }
  }
  return range;
}

std::string colour_of(const Cell& cell, const ValueRange& range) {
  switch (cell.outcome) {
    case Outcome::wrong: return wrong_colour;
    case Outcome::refused: return refused_colour;
    case Outcome::solved: break;
  }
  if (!cell.value || !std::isfinite(*cell.value) || !range.any) return solved_colour;
  const double span = range.high - range.low;
  // So many shades as an eye tells apart: cells of one are drawn in one go.
  constexpr double shades = 48.0;
  return shade(span > 0.0 ? std::round(shades * (*cell.value - range.low) / span) / shades : 1.0);
}

/// Where the cells of one axis stand, and where one ends and the next begins.
struct Steps {
  bool log = false;
  std::vector<double> at;
  std::vector<double> borders;  ///< one more

  std::size_t place_of(double value) const {
    return static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), value) - at.begin());
  }
};

/// A logarithmic axis holds positive numbers only.
bool is_log(const Map& map, const MapAxis& axis, double Cell::*coordinate) {
  return axis.log && std::all_of(map.panels.begin(), map.panels.end(), [&](const MapPanel& panel) {
           return std::all_of(panel.cells.begin(), panel.cells.end(),
                              [&](const Cell& cell) { return cell.*coordinate > 0.0; });
         });
}

Steps steps_of(const Map& map, const MapAxis& axis, double Cell::*coordinate) {
  const bool log = is_log(map, axis, coordinate);
  std::set<double> sorted;
  for (const MapPanel& panel : map.panels) {
    for (const Cell& cell : panel.cells) sorted.insert(cell.*coordinate);
  }
  Steps steps{log, {sorted.begin(), sorted.end()}, {}};
  if (steps.at.empty()) steps.at.push_back(1.0);
  const auto to = [log](double value) { return log ? std::log(value) : value; };
  const auto from = [log](double value) { return log ? std::exp(value) : value; };
  const std::vector<double>& at = steps.at;
  if (at.size() == 1) {
    steps.borders = {from(to(at[0]) - 0.5), from(to(at[0]) + 0.5)};
    return steps;
  }
  steps.borders.push_back(from(1.5 * to(at[0]) - 0.5 * to(at[1])));
  for (std::size_t i = 1; i < at.size(); ++i)
    steps.borders.push_back(from(0.5 * (to(at[i - 1]) + to(at[i]))));
  const std::size_t last = at.size() - 1;
  steps.borders.push_back(from(1.5 * to(at[last]) - 0.5 * to(at[last - 1])));
  return steps;
}

/// The trials of a method as boxes, wrong ones crossed and refused ones dotted.
void draw_cells(Script& gp, const MapPanel& of, const Panel& panel, const Steps& x, const Steps& y,
                const ValueRange& range, std::size_t number) {
  const std::string boxes = fmt::format("cells{}", number);
  gp << "$" << boxes << " << e\n";
  std::vector<Row2> wrong, refused;
  for (const Cell& cell : of.cells) {
    const std::size_t i = x.place_of(cell.x);
    const std::size_t j = y.place_of(cell.y);
    const std::string rgb = "0x" + colour_of(cell, range).substr(1);
    gp << fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {}\n", cell.x, cell.y,
                      x.borders[i], x.borders[i + 1], y.borders[j], y.borders[j + 1], rgb);
    if (cell.outcome == Outcome::wrong) wrong.emplace_back(cell.x, cell.y);
    if (cell.outcome == Outcome::refused) refused.emplace_back(cell.x, cell.y);
  }
  gp << "e\n";
  const double across = (panel.frame.right - panel.frame.left) / static_cast<double>(x.at.size());
  const double down = (panel.frame.top - panel.frame.bottom) / static_cast<double>(y.at.size());
  // A mark of size 1 is about 9 px wide.
  const double size = std::clamp(std::min(across, down) / 9.0 * 0.6, 0.12, 0.7);
  std::vector<std::string> curves;
  if (!of.cells.empty())
    curves.push_back(fmt::format(
        "${} using 1:2:3:4:5:6:7 with boxxyerror fs solid lw 0.4 lc rgb variable", boxes));
  if (!wrong.empty()) {
    gp.block(fmt::format("wrong{}", number), wrong);
    curves.push_back(
        fmt::format("$wrong{} using 1:2 with points pt 2 ps {:.3g} lw 1 lc rgb "
                    "'#202020'",
                    number, size));
  }
  if (!refused.empty()) {
    gp.block(fmt::format("refused{}", number), refused);
    curves.push_back(fmt::format("$refused{} using 1:2 with points pt 7 ps {:.3g} lc rgb '#8a8a8a'",
                                 number, 0.45 * size));
  }
  if (curves.empty()) curves.emplace_back("NaN");
  gp.plot(curves);
}

/// Marks across a logarithmic axis that end left of a place.
std::string tics_across(const Panel& panel, double most) {
  const LogAxis axis{panel.x_low, panel.x_high, panel.x_low, panel.x_high, {}, {}};
  std::vector<Tic> tics =
      tics_of(axis, panel.frame.right - panel.frame.left, TicStyle::number, true);
  std::erase_if(tics, [&](const Tic& tic) {
    return panel.at(tic.at, panel.y_low).x() + 0.5 * tic.width > most;
  });
  return list_of(tics);
}

/// Likewise up; `named`: with their numbers.
std::string tics_up(const Panel& panel, bool named) {
  const LogAxis axis{panel.y_low, panel.y_high, panel.y_low, panel.y_high, {}, {}};
  return list_of(tics_of(axis, panel.frame.top - panel.frame.bottom, TicStyle::number, false),
                 named);
}

/// "210 solved, 3 wrong, 12 refused".
std::string counts_of(const MapPanel& panel) {
  return fmt::format("{} solved, {} wrong, {} refused", panel.count(Outcome::solved),
                     panel.count(Outcome::wrong), panel.count(Outcome::refused));
}

/// The scale of the values, with its numbers at both ends and its name behind.
void draw_scale(Script& gp, const Map& map, const ValueRange& range, double bottom) {
  constexpr int steps = 32;
  constexpr double bar = 140.0;
  const std::string low = text::significant(range.low, 3);
  const double from = margin + text_width(low) + 6.0;
  for (int i = 0; i < steps; ++i) {
    const double x = from + bar * i / steps;
    gp << fmt::format(
        "set object rectangle from screen {:.6g},{:.6g} to screen {:.6g},{:.6g} fs solid noborder "
        "fc rgb '{}'\n",
        x / gp.width(), (bottom + 3.0) / gp.height(), (x + bar / steps + 0.4) / gp.width(),
        (bottom + 15.0) / gp.height(), shade((i + 0.5) / steps));
  }
  put_text(gp, low, {margin, bottom + 9.0});
  const std::string high = text::significant(range.high, 3);
  put_text(gp, fitted(high + "  " + map.value, figure_width - from - bar - margin - 6.0),
           {from + bar + 6.0, bottom + 9.0});
}

std::vector<LegendEntry> legend_of(const ValueRange& range) {
  std::vector<LegendEntry> legend;
  if (!range.any) legend.push_back({"solved", fmt::format("lw 9 lc rgb '{}'", solved_colour)});
  legend.push_back({"silently wrong", fmt::format("lw 9 lc rgb '{}'", wrong_colour),
                    "pt 2 ps 0.6 lw 1 lc rgb '#202020' front"});
  legend.push_back({"refused, with the reason", fmt::format("lw 9 lc rgb '{}'", refused_colour),
                    "pt 7 ps 0.3 lc rgb '#8a8a8a' front"});
  return legend;
}

/// The panels of a map in rows, the first at the top; above each its method and its counts.
struct Grid {
  std::size_t columns = 1, rows = 1;
  double width = 400.0;  ///< of a panel
  double head = 0.0;     ///< above a panel
  double bottom = 0.0;   ///< of all

  static constexpr double left = 62.0, right = 600.0, gap = 30.0;
  static constexpr double panel_height = 190.0;
  static constexpr double foot = 28.0;  ///< numbers below a panel

  double row_height() const { return panel_height + head + foot; }
  double height() const { return static_cast<double>(rows) * row_height(); }
  Frame frame(std::size_t i) const {
    const std::size_t column = i % columns;
    const std::size_t row_from_below = rows - 1 - i / columns;
    const double x = left + static_cast<double>(column) * (width + gap);
    const double y = bottom + static_cast<double>(row_from_below) * row_height() + foot;
    return {x, y, x + width, y + panel_height};
  }
};

/// Two abreast, three where that fills the row.
Grid grid_of(const Map& map) {
  Grid grid;
  const std::size_t panels = map.panels.size();
  grid.columns = panels == 3 ? 3 : std::clamp<std::size_t>(panels, 1, 2);
  grid.rows = std::max<std::size_t>(1, (panels + grid.columns - 1) / grid.columns);
  const auto across = static_cast<double>(grid.columns);
  if (grid.columns > 1)
    grid.width = (Grid::right - Grid::left - Grid::gap * (across - 1.0)) / across;
  std::size_t lines = 0;
  for (const MapPanel& panel : map.panels)
    lines = std::max(lines, wrapped({panel.method, counts_of(panel)}, grid.width).size());
  grid.head = text_line * static_cast<double>(lines) + 8.0;
  return grid;
}

void draw_panel(Script& gp, const Map& map, std::size_t i, const Grid& grid, const Steps& x,
                const Steps& y) {
  const MapPanel& of = map.panels[i];
  const bool first = i % grid.columns == 0;
  const bool last = (i + 1) % grid.columns == 0;
  const Panel panel{grid.frame(i),
                    x.borders.front(),
                    x.borders.back(),
                    y.borders.front(),
                    y.borders.back(),
                    x.log,
                    y.log};
  place(gp, panel);
  const double most = last ? gp.width() - 2.0 : panel.frame.right + 4.0;
  if (x.log) gp << "set xtics " << tics_across(panel, most) << "\n";
  if (y.log) gp << "set ytics " << tics_up(panel, first) << "\n";
  gp << "set format y " << (first ? "'%g'" : "''") << "\n";
  // A little above the panel, where the longest ends.
  const std::vector<std::string> method = wrapped(of.method, grid.width);
  const std::vector<std::string> counts = wrapped(counts_of(of), grid.width);
  const double top =
      panel.frame.top + 4.0 + text_line * static_cast<double>(method.size() + counts.size());
  put_lines(gp, counts, {panel.frame.left, put_lines(gp, method, {panel.frame.left, top})}, "left",
            quiet);
  draw_cells(gp, of, panel, x, y, values_of(map), i);
}

}  // namespace

void stability_map(Script& gp, const Map& map) {
  const Steps x = steps_of(map, map.x, &Cell::x);
  const Steps y = steps_of(map, map.y, &Cell::y);
  const ValueRange range = values_of(map);
  constexpr double whole = figure_width - 2.0 * margin;
  const std::vector<std::string> title = wrapped(map.title, whole);
  std::vector<std::string> about;
  if (!map.scene.empty()) about.push_back("on " + map.scene);
  if (!map.reference.empty()) about.push_back("what is right: " + map.reference);
  about = wrapped(about, whole);
  const std::vector<std::string> ordinate = wrapped("up: " + map.y.title, whole);
  const std::vector<std::string> abscissa = wrapped("across: " + map.x.title, whole);
  const std::vector<LegendEntry> legend = legend_of(range);

  const double legend_bottom = range.any ? 26.0 : 4.0;
  const double abscissa_top =
      legend_bottom + height_of_legend(legend) + text_line * static_cast<double>(abscissa.size());
  Grid grid = grid_of(map);
  grid.bottom = abscissa_top + 4.0;
  const auto above = static_cast<double>(title.size() + about.size() + ordinate.size());
  gp.begin(map.name, grid.bottom + grid.height() + text_line * above + 20.0);
  double top = put_lines(gp, title, {margin, gp.height() - 8.0}) - 2.0;
  top = put_lines(gp, about, {margin, top}, "left", quiet) - 4.0;
  put_lines(gp, ordinate, {margin, top});
  put_lines(gp, abscissa, {0.5 * (Grid::left + Grid::right), abscissa_top}, "center");
  if (range.any) draw_scale(gp, map, range, 4.0);
  draw_legend(gp, legend, legend_bottom);
  gp << "unset grid\n";
  if (x.log) gp << "set logscale x\n";
  if (y.log) gp << "set logscale y\n";
  for (std::size_t i = 0; i < map.panels.size(); ++i) draw_panel(gp, map, i, grid, x, y);
}

}  // namespace boxbeam::plot
