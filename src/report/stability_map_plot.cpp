#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "accuracy_plot.hpp"
#include "boxbeam/report/format.hpp"
#include "canvas.hpp"
#include "log_axis.hpp"

namespace boxbeam::plot {
namespace {

using study::Cell;
using study::Map;
using study::MapAxis;
using study::MapPanel;
using study::Outcome;

constexpr double margin = 12.0;
constexpr double line = 15.0;
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
  return shade(span > 0.0 ? (*cell.value - range.low) / span : 1.0);
}

/// Where the cells of one axis stand, and where one ends and the next begins.
struct Steps {
  std::vector<double> at;
  std::vector<double> borders;  ///< one more

  std::size_t place_of(double value) const {
    return static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), value) - at.begin());
  }
};

Steps steps_of(const Map& map, bool log, double Cell::*coordinate) {
  std::set<double> sorted;
  for (const MapPanel& panel : map.panels) {
    for (const Cell& cell : panel.cells) sorted.insert(cell.*coordinate);
  }
  Steps steps{{sorted.begin(), sorted.end()}, {}};
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

/// A logarithmic axis holds positive numbers only.
bool is_log(const Map& map, const MapAxis& axis, double Cell::*coordinate) {
  return axis.log && std::all_of(map.panels.begin(), map.panels.end(), [&](const MapPanel& panel) {
           return std::all_of(panel.cells.begin(), panel.cells.end(),
                              [&](const Cell& cell) { return cell.*coordinate > 0.0; });
         });
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

}  // namespace

void stability_map(Script& gp, const Map& map) {
  const bool log_x = is_log(map, map.x, &Cell::x);
  const bool log_y = is_log(map, map.y, &Cell::y);
  const Steps x = steps_of(map, log_x, &Cell::x);
  const Steps y = steps_of(map, log_y, &Cell::y);
  const ValueRange range = values_of(map);
  const std::size_t columns = map.panels.size() > 1 ? 2 : 1;
  const std::size_t rows = std::max<std::size_t>(1, (map.panels.size() + columns - 1) / columns);
  constexpr double left = 62.0, right = 600.0, gap = 34.0, height = 190.0;
  const double width = columns == 1 ? 400.0 : 0.5 * (right - left - gap);
  const auto all_wrapped = [](const std::vector<std::string>& texts, double room) {
    std::vector<std::string> lines;
    for (const std::string& text : texts) {
      const std::vector<std::string> of = wrapped(text, room);
      lines.insert(lines.end(), of.begin(), of.end());
    }
    return lines;
  };
  const double whole = figure_width - 2.0 * margin;
  const std::vector<std::string> title = all_wrapped({map.title}, whole);
  std::vector<std::string> about;
  if (!map.scene.empty()) about.push_back("on " + map.scene);
  if (!map.reference.empty()) about.push_back("what is right: " + map.reference);
  about = all_wrapped(about, whole);
  const std::vector<std::string> ordinate = all_wrapped({"up: " + map.y.title}, whole);
  const std::vector<std::string> footing = wrapped("across: " + map.x.title, whole);
  std::size_t heads = 1;
  for (const MapPanel& panel : map.panels)
    heads = std::max(heads, wrapped(panel.method, width).size());

  const auto lines = [](std::size_t of) { return line * static_cast<double>(of); };
  std::vector<LegendEntry> legend;
  if (!range.any) legend.push_back({"solved", fmt::format("lw 9 lc rgb '{}'", solved_colour)});
  legend.push_back({"silently wrong", fmt::format("lw 9 lc rgb '{}'", wrong_colour),
                    "pt 2 ps 0.6 lw 1 lc rgb '#202020' front"});
  legend.push_back({"refused, with the reason", fmt::format("lw 9 lc rgb '{}'", refused_colour),
                    "pt 7 ps 0.3 lc rgb '#8a8a8a' front"});
  const double head = lines(heads) + line + 8.0;
  const double foot = 28.0;  // numbers
  const double scale = range.any ? 22.0 : 0.0;
  const double legend_top = 4.0 + scale + height_of_legend(legend);
  const double panels_bottom = legend_top + lines(footing.size()) + 4.0;
  const double panels = static_cast<double>(rows) * (height + head + foot);
  gp.begin(map.name,
           panels_bottom + panels + lines(about.size() + title.size() + ordinate.size()) + 20.0);
  const auto put_lines = [&](const std::vector<std::string>& texts, const Pixel& at,
                             const char* side, const char* colour) {
    double top = at.y();
    for (const std::string& text : texts) {
      top -= line;
      put_text(gp, text, {at.x(), top + 0.5 * line}, side, colour);
    }
    return top;
  };
  double top = put_lines(title, {margin, gp.height() - 8.0}, "left", "#202020") - 2.0;
  top = put_lines(about, {margin, top}, "left", "#5d6b79") - 4.0;
  put_lines(ordinate, {margin, top}, "left", "#202020");
  put_lines(footing, {0.5 * (left + right), legend_top + lines(footing.size())}, "center",
            "#202020");
  if (range.any) draw_scale(gp, map, range, 4.0);
  draw_legend(gp, legend, 4.0 + scale);
  gp << "unset grid\n";
  if (log_x) gp << "set logscale x\n";
  if (log_y) gp << "set logscale y\n";
  for (std::size_t i = 0; i < map.panels.size(); ++i) {
    const std::size_t row = i / columns;
    const std::size_t column = i % columns;
    const double bottom =
        panels_bottom + static_cast<double>(rows - 1 - row) * (height + head + foot) + foot;
    const double from = left + static_cast<double>(column) * (width + gap);
    const Panel panel{{from, bottom, from + width, bottom + height},
                      x.borders.front(),
                      x.borders.back(),
                      y.borders.front(),
                      y.borders.back(),
                      log_x,
                      log_y};
    place(gp, panel);
    const double most = column + 1 == columns ? gp.width() - 2.0 : panel.frame.right + 4.0;
    if (log_x) gp << "set xtics " << tics_across(panel, most) << "\n";
    if (log_y) gp << "set ytics " << tics_up(panel, column == 0) << "\n";
    gp << "set format y " << (column == 0 ? "'%g'" : "''") << "\n";
    const MapPanel& of = map.panels[i];
    const double below = put_lines(wrapped(of.method, width), {from, panel.frame.top + head - 2.0},
                                   "left", "#202020");
    put_text(gp, fitted(counts_of(of), width), {from, below - 0.5 * line + 1.0}, "left", "#5d6b79");
    draw_cells(gp, of, panel, x, y, range, i);
  }
}

}  // namespace boxbeam::plot
