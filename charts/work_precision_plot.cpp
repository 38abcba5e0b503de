#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "charts/accuracy_plot.hpp"
#include "charts/chart_axes.hpp"
#include "charts/chart_text.hpp"
#include "charts/front.hpp"
#include "report/canvas.hpp"

namespace boxbeam::plot {
namespace {

using charts::Chart;
using charts::Point;
using charts::Series;

constexpr double margin = 12.0;
constexpr const char* quiet = "#5d6b79";
constexpr const char* better_style = "pt 6 ps 1.1 lw 1.4 lc rgb '#c8102e'";
constexpr double left = 62.0, right = 600.0;  ///< of the panels
constexpr double gap = 30.0;                  ///< between them
constexpr double height = 290.0;              ///< of a panel

/// Own methods in colour with whole marks, those of others grey with hollow ones.
struct SeriesStyle {
  std::string line, point, colour;
};

SeriesStyle style_of(const Chart& chart, std::size_t i) {
  constexpr const char* greys[] = {"#5a6670", "#857650", "#7a6a8c", "#4a716a"};
  constexpr int whole[] = {7, 5, 9, 13, 11, 15};
  constexpr int hollow[] = {6, 4, 8, 12, 10, 14};
  const bool yardstick = chart.series[i].yardstick;
  const auto before = static_cast<std::size_t>(
      std::count_if(chart.series.begin(), chart.series.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](const Series& other) { return other.yardstick == yardstick; }));
  if (!yardstick) {
    return {line_style(before, 1.7),
            fmt::format("pt {} ps 0.55 lc rgb '{}'", whole[before % 6], colour(before)),
            colour(before)};
  }
  const char* grey = greys[before % std::size(greys)];
  return {fmt::format("lw 1.1 dt {} lc rgb '{}'", dashes(before), grey),
          fmt::format("pt {} ps 0.55 lw 1 lc rgb '{}'", hollow[before % 6], grey), grey};
}

/// The name of a panel's abscissa, which may be a little wider than the panel.
std::vector<std::string> footing_of(const Abscissa& abscissa, double width) {
  return wrapped(abscissa.title, width + gap - 8.0);
}

/// A panel under construction.
struct Drawn {
  Script& gp;
  const Chart& chart;
  const Abscissa& abscissa;
  LogAxis x, y;
  bool shows_floor;
  Panel panel;
  std::string name;  ///< of its data
  Labels labels;
  std::vector<std::string> curves;
};

Row2 row_of(const Drawn& of, const Series& series, std::size_t i) {
  const Point& point = series.points[i];
  const double x = of.x.at(place_of(series, i, of.abscissa).value_or(0.0));
  return {x, has_failed(point) ? of.y.beyond.value_or(of.y.high) : of.y.at(std::abs(point.error))};
}

/// Whether a solved setting is to be seen in a panel: it has a cost there, or none anywhere.
bool is_seen(const Drawn& of, const Point& point) {
  return of.abscissa.of(point).has_value() || (!point.operations && !point.time.has_value());
}

/// A method's line, broken where a setting failed or has no cost here, its marks and spreads.
void draw_series(Drawn& of, std::size_t k) {
  const Series& series = of.chart.series[k];
  const SeriesStyle style = style_of(of.chart, k);
  std::vector<std::vector<Row2>> runs(1);
  std::vector<Row2> solved, failed;
  std::vector<Row4> spreads;
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const Point& point = series.points[i];
    const Row2 row = row_of(of, series, i);
    if (has_failed(point)) failed.push_back(row);
    if (has_failed(point) || !is_seen(of, point)) {
      if (!runs.back().empty()) runs.emplace_back();
      continue;
    }
    runs.back().push_back(row);
    solved.push_back(row);
    if (of.abscissa.time && point.time)
      spreads.emplace_back(std::get<0>(row), std::get<1>(row), of.x.at(point.time->low),
                           of.x.at(point.time->high));
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (runs[r].size() < 2) continue;
    const std::string data = fmt::format("{}line{}_{}", of.name, k, r);
    of.gp.block(data, runs[r]);
    of.curves.push_back(fmt::format("${} using 1:2 with lines {}", data, style.line));
    of.labels.keep_off(of.panel, runs[r]);
  }
  if (!spreads.empty()) {
    const std::string data = fmt::format("{}spread{}", of.name, k);
    of.gp.block(data, spreads);
    of.curves.push_back(fmt::format(
        "${} using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '{}'", data, style.colour));
  }
  if (!solved.empty()) {
    const std::string data = fmt::format("{}points{}", of.name, k);
    of.gp.block(data, solved);
    of.curves.push_back(fmt::format("${} using 1:2 with points {}", data, style.point));
  }
  if (!failed.empty()) {
    const std::string data = fmt::format("{}failed{}", of.name, k);
    of.gp.block(data, failed);
    of.curves.push_back(fmt::format("${} using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '{}'",
                                    data, style.colour));
  }
  for (const std::vector<Row2>* rows : {&solved, &failed}) {
    for (const auto& [x, y] : *rows) {
      constexpr double half = 4.0;
      const Pixel at = of.panel.at(x, y);
      of.labels.keep_free({at.x() - half, at.y() - half, at.x() + half, at.y() + half});
    }
  }
}

/// Slope that a series has between two settings, by the work they take; nothing where there is
/// none.
std::optional<double> order_between(const Point& a, const Point& b) {
  if (has_failed(a) || has_failed(b) || !a.operations || !b.operations) return std::nullopt;
  if (a.error <= 0.0 || b.error <= 0.0) return std::nullopt;
  if (*a.operations <= 0.0 || *b.operations <= 0.0 || *a.operations == *b.operations)
    return std::nullopt;
  return -std::log(b.error / a.error) / std::log(*b.operations / *a.operations);
}

/// A short line of a known order beside a stretch of a series that runs so, where it has room:
/// rather in the middle of the series than at its ends.
void draw_guide(Drawn& of, const charts::SlopeGuide& guide) {
  if (guide.series >= of.chart.series.size() || guide.order <= 0.0) return;
  const Series& series = of.chart.series[guide.series];
  const Frame inside = {of.panel.frame.left + 2.0, of.panel.at(of.x.low, of.y.low).y() + 2.0,
                        of.panel.frame.right - 2.0, of.panel.at(of.x.low, of.y.high).y() - 2.0};
  const Frame& f = of.panel.frame;
  const double per_x = (f.right - f.left) / std::log(of.panel.x_high / of.panel.x_low);
  const double per_y = (f.top - f.bottom) / std::log(of.panel.y_high / of.panel.y_low);
  const Eigen::Vector2d along = Eigen::Vector2d(per_x, -guide.order * per_y).normalized();
  const Eigen::Vector2d below(along.y(), -along.x());
  const Eigen::Vector2d above = -below;
  constexpr double half = 24.0;
  constexpr double beside = 11.0;
  const auto within = [&](const Pixel& at) {
    return at.x() >= inside.left && at.x() <= inside.right && at.y() >= inside.bottom &&
           at.y() <= inside.top;
  };
  double least = 1e300;
  Pixel best;
  for (std::size_t i = 1; i < series.points.size(); ++i) {
    const Point& a = series.points[i - 1];
    const Point& b = series.points[i];
    const std::optional<double> order = order_between(a, b);
    if (!order) continue;
    const Pixel middle = 0.5 * (of.panel.at(of.x.at(*a.operations), of.y.at(a.error)) +
                                of.panel.at(of.x.at(*b.operations), of.y.at(b.error)));
    for (const Eigen::Vector2d& side : {below, above}) {
      const Pixel at = middle + beside * side;
      if (!within(at - half * along) || !within(at + half * along)) continue;
      const double off_centre =
          std::abs(2.0 * static_cast<double>(i) / static_cast<double>(series.points.size()) - 1.0);
      const double cost = 5.0 * std::abs(*order - guide.order) + 0.5 * off_centre +
                          0.02 * of.labels.disturbance(at - half * along, at + half * along);
      if (cost >= least) continue;
      least = cost;
      best = at;
    }
  }
  if (least == 1e300) return;
  const Pixel from = best - half * along;
  const Pixel to = best + half * along;
  put_line(of.gp, from, to, "lw 1 lc rgb '#404040'");
  of.labels.keep_off(from, to);
  of.labels.put(of.gp, fmt::format("order {:g}", guide.order), best, inside, "#404040", 5.0);
}

void mark_default(Drawn& of) {
  std::vector<Row2> rings;
  for (const Series& series : of.chart.series) {
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      if (!series.points[i].is_default || !is_seen(of, series.points[i])) continue;
      const auto [x, y] = row_of(of, series, i);
      rings.emplace_back(x, y);
      of.labels.put(of.gp, "default", of.panel.at(x, y), of.panel.frame, "#202020", 8.0);
    }
  }
  if (rings.empty()) return;
  const std::string data = of.name + "default";
  of.gp.block(data, rings);
  of.curves.push_back(
      fmt::format("${} using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020'", data));
}

void mark_better(Drawn& of) {
  std::vector<Row2> rings;
  const charts::CostBy by = of.abscissa.time ? charts::CostBy::time : charts::CostBy::operations;
  for (const charts::Better& better : charts::better_than_default(of.chart, by))
    rings.push_back(row_of(of, *better.series,
                           static_cast<std::size_t>(better.point - better.series->points.data())));
  if (rings.empty()) return;
  const std::string data = of.name + "better";
  of.gp.block(data, rings);
  of.curves.push_back(fmt::format("${} using 1:2 with points {}", data, better_style));
}

/// The band of what is needed and the floor, behind; lines that set zero and failures apart.
void draw_levels(Drawn& of) {
  const double low = of.y.at(of.chart.needed_low);
  const double high = of.y.at(of.chart.needed_high);
  of.gp << fmt::format(
      "set object rectangle from graph 0, first {:.9g} to graph 1, first {:.9g} behind fs solid "
      "noborder fc rgb '#dcebd3'\n",
      low, high);
  const auto level = [&](double y, const char* style) {
    const Pixel from = of.panel.at(of.panel.x_low, y);
    const Pixel to = of.panel.at(of.panel.x_high, y);
    put_line(of.gp, from, to, style);
    of.labels.keep_off(from, to);
  };
  if (of.shows_floor) level(of.y.at(of.chart.floor->error), "lw 1.2 dt (6,4) lc rgb '#606060'");
  if (of.y.beyond) level(of.y.high, "lw 0.8 lc rgb '#606060'");
  if (of.y.zero) level(of.y.low, "lw 0.8 lc rgb '#606060'");
}

std::string error_tics(const LogAxis& axis) {
  std::vector<Tic> tics = tics_of(axis, height, TicStyle::number, false);
  if (axis.beyond) tics.push_back({*axis.beyond, "failed", 0.0, false});
  if (axis.zero) tics.push_back({*axis.zero, "0", 0.0, false});
  return list_of(tics);
}

void draw_panel(Script& gp, const Chart& chart, const Abscissa& abscissa, const ErrorAxis& errors,
                const Frame& frame, std::size_t number) {
  const double length = frame.right - frame.left;
  const LogAxis x = cost_axis(chart, abscissa, length);
  const LogAxis& y = errors.axis;
  Drawn of{gp,
           chart,
           abscissa,
           x,
           y,
           errors.shows_floor,
           Panel{frame, x.first, x.last, y.first, y.last, true, true},
           fmt::format("p{}", number),
           {},
           {}};
  place(gp, of.panel);
  std::vector<Tic> tics = tics_of(x, length, abscissa.tics, true);
  std::erase_if(tics, [&](const Tic& tic) {
    return of.panel.at(tic.at, y.first).x() + 0.5 * tic.width > gp.width() - 2.0;
  });
  if (x.zero) tics.insert(tics.begin(), {*x.zero, "0", 0.0, false});
  gp << "set xtics " << list_of(tics) << "\n";
  gp << "set ytics "
     << (number == 0 ? error_tics(y) : list_of(tics_of(y, height, TicStyle::number, false), false))
     << "\n";
  put_lines(gp, footing_of(abscissa, length),
            {0.5 * (frame.left + frame.right), frame.bottom - 34.0 + 0.5 * text_line}, "center");
  draw_levels(of);
  for (std::size_t k = 0; k < chart.series.size(); ++k) draw_series(of, k);
  mark_default(of);
  mark_better(of);
  if (abscissa.operations) {
    for (const charts::SlopeGuide& guide : chart.guides) draw_guide(of, guide);
  }
  if (of.curves.empty()) of.curves.emplace_back("NaN");
  gp.plot(of.curves);
}

std::vector<LegendEntry> legend_of(const Chart& chart, bool shows_floor) {
  std::vector<LegendEntry> legend;
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    const SeriesStyle style = style_of(chart, k);
    legend.push_back({chart.series[k].method, style.line, style.point});
  }
  legend.push_back({"good enough for a strength check", "lw 9 lc rgb '#dcebd3'"});
  if (chart.floor)
    legend.push_back({fmt::format("{}: {:.1e}{}", chart.floor->name, chart.floor->error,
                                  shows_floor ? "" : ", below all that is shown"),
                      shows_floor ? "lw 1.2 dt (6,4) lc rgb '#606060'" : ""});
  if (any_point(chart, [](const Point& point) { return point.is_default; }))
    legend.push_back({"default of the program", "", "pt 6 ps 1.5 lw 1.6 lc rgb '#202020'"});
  const auto any_better = [&](charts::CostBy by) {
    return !charts::better_than_default(chart, by).empty();
  };
  if (any_better(charts::CostBy::operations) || any_better(charts::CostBy::time))
    legend.push_back(
        {"better: 2/3 of its cost or error at no more of the other", "", better_style});
  return legend;
}

/// What the drawing needs to be read rightly, and what failed.
std::vector<std::string> notes_of(const Chart& chart) {
  const auto any_error = [&](const std::function<bool(double)>& holds) {
    return any_point(chart, [&](const Point& point) {
      return !has_failed(point) && holds(std::abs(point.error));
    });
  };
  std::vector<std::string> notes;
  if (any_error([](double error) { return error == 0.0; }))
    notes.emplace_back("at 0: the same number as the reference, to the last digit");
  if (any_error([](double error) { return error > most_error; }))
    notes.push_back(fmt::format("at {0:g}: errors of {0:g} and more", most_error));
  constexpr std::size_t most = 6;
  const std::vector<FailedSettings> failures = failures_of(chart);
  for (std::size_t i = 0; i < std::min(most, failures.size()); ++i) {
    const FailedSettings& failed = failures[i];
    notes.push_back(fmt::format("failed: {}, {}: {}", failed.method, settings_text(failed.settings),
                                failed.reason));
  }
  if (failures.size() > most)
    notes.push_back(fmt::format("and {} more, which the data tell", failures.size() - most));
  return notes;
}

}  // namespace

void work_precision(Script& gp, const Chart& chart) {
  const std::vector<Abscissa> abscissas = abscissas_of(chart);
  const auto number = static_cast<double>(abscissas.size());
  const double width = (right - left - gap * (number - 1.0)) / number;
  std::size_t footings = 1;
  for (const Abscissa& abscissa : abscissas)
    footings = std::max(footings, footing_of(abscissa, width).size());
  const ErrorAxis errors = error_axis(chart, height);
  const std::vector<LegendEntry> legend = legend_of(chart, errors.shows_floor);
  constexpr double whole = figure_width - 2.0 * margin;
  const std::vector<std::string> notes = wrapped(notes_of(chart), whole);
  const std::vector<std::string> title = wrapped(chart.title, whole);
  std::vector<std::string> about;
  if (!chart.scene.empty()) about.push_back("on " + chart.scene);
  if (!chart.reference.empty()) about.push_back("reference: " + chart.reference);
  about = wrapped(about, whole);
  const std::vector<std::string> ordinate = wrapped(chart.error, whole);

  const double legend_bottom = 6.0 + text_line * static_cast<double>(notes.size());
  const double below = legend_bottom + height_of_legend(legend) + footing_room +
                       text_line * static_cast<double>(footings - 1) + 2.0;
  const auto above = static_cast<double>(title.size() + about.size() + ordinate.size());
  gp.begin(chart.name, below + height + text_line * above + 26.0);
  double top = put_lines(gp, title, {margin, gp.height() - 8.0}) - 2.0;
  top = put_lines(gp, about, {margin, top}, "left", quiet) - 6.0;
  put_lines(gp, ordinate, {margin, top});
  put_lines(gp, notes, {margin, legend_bottom - 2.0}, "left", quiet);
  draw_legend(gp, legend, legend_bottom);
  gp << "set logscale xy\nset errorbars 0.35\n";
  for (std::size_t i = 0; i < abscissas.size(); ++i) {
    const double from = left + (width + gap) * static_cast<double>(i);
    draw_panel(gp, chart, abscissas[i], errors, {from, below, from + width, below + height}, i);
  }
}

}  // namespace boxbeam::plot
