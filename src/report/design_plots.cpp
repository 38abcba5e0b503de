#include "design_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ink.hpp"
#include "level_lines.hpp"
#include "plot_script.hpp"

namespace boxbeam::plot {
namespace {

constexpr const char* fails_ink = "#b3231b";
constexpr const char* passes_ink = "#1b6e34";
constexpr const char* unclear_ink = "#85560a";
constexpr const char* fails_shade = "#fcefee";

std::string label_of(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

/// What is said of each design: its verdict, or else whether it has results.
const DesignColumn* verdict_of(const DesignRows& rows) {
  const DesignColumn* const verdict = rows.find("verdict");
  return verdict != nullptr ? verdict : rows.find("status");
}

bool passes(const DesignColumn* verdict, std::size_t row) {
  return verdict == nullptr || verdict->words[row] == "pass" || verdict->words[row] == "ok";
}

const char* ink_of(const DesignColumn* verdict, std::size_t row) {
  if (passes(verdict, row)) return verdict == nullptr ? colour(0) : passes_ink;
  return verdict->words[row] == "fail" ? fails_ink : unclear_ink;
}

/// Least and largest number of a column; the same where it has none.
std::pair<double, double> range_of(const std::vector<double>& numbers) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double x : numbers) {
    if (!std::isfinite(x)) continue;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return low <= high ? std::pair(low, high) : std::pair(0.0, 0.0);
}

bool varies(const DesignColumn& column) {
  const auto [low, high] = range_of(column.numbers);
  return high > low;
}

/// The result that figures show: the use, or else the first that varies.
const DesignColumn* shown_result(const DesignRows& rows) {
  const DesignColumn* const use = rows.find("utilisation");
  if (use != nullptr && varies(*use)) return use;
  for (const DesignColumn& column : rows.columns)
    if (!column.is_variable && varies(column)) return &column;
  return nullptr;
}

std::string words_of_failing(const DesignRows& rows, const DesignColumn* verdict) {
  if (verdict == nullptr) return fmt::format("{} designs", rows.size());
  std::size_t failing = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) failing += passes(verdict, row) ? 0 : 1;
  return fmt::format(
      "{} of {} designs do not pass{}", failing, rows.size(),
      rows.scatters ? fmt::format(", p_f about {:.3g} %", 100.0 * static_cast<double>(failing) /
                                                              static_cast<double>(rows.size()))
                    : "");
}

/// Where designs do not pass, in strips.
void shade_failing(const GridOfValues& uses, const Panel& panel, Drawing& drawing) {
  constexpr int fine = 8;
  for (std::size_t j = 0; j + 1 < uses.y.size(); ++j)
    for (int b = 0; b < fine; ++b) {
      const auto row = static_cast<double>(j) + (b + 0.5) / fine;
      // Along a strip, as long pieces as there are.
      double from = -1.0;
      const std::size_t steps = (uses.x.size() - 1) * fine;
      for (std::size_t a = 0; a <= steps; ++a) {
        const double column = static_cast<double>(a) / fine;
        const bool fails = a < steps && uses.at(column + 0.5 / fine, row) > 1.0;
        if (fails && from < 0.0) from = column;
        if (fails || from < 0.0) continue;
        const auto corner = [&](double c, double half) {
          const Pixel at = uses.place(c, row + half / fine);
          return panel.at(at.x(), at.y());
        };
        drawing.shapes.emplace_back(
            Line{{corner(from, -0.5), corner(column, -0.5), corner(column, 0.5), corner(from, 0.5)},
                 {fails_shade, 0.6, {}, fails_shade, ""},
                 true});
        from = -1.0;
      }
    }
}

}  // namespace

std::optional<Drawing> parallel_axes(const DesignRows& rows) {
  constexpr std::size_t most_axes = 8, most_lines = 300;
  std::vector<const DesignColumn*> axes;
  for (const DesignColumn& column : rows.columns)
    if (varies(column) && axes.size() < most_axes) axes.push_back(&column);
  if (axes.size() < 2) return std::nullopt;
  constexpr double bottom = 60.0, top = 280.0, left = 50.0;
  Drawing drawing{figure_width, top + 56.0, {}};
  const double apart = (figure_width - 2.0 * left) / static_cast<double>(axes.size() - 1);
  const auto at = [&](std::size_t k, double value) {
    const auto [low, high] = range_of(axes[k]->numbers);
    return Pixel(left + static_cast<double>(k) * apart,
                 bottom + (value - low) / (high - low) * (top - bottom));
  };
  const DesignColumn* const verdict = verdict_of(rows);
  const std::size_t step = (rows.size() + most_lines - 1) / most_lines;
  // Those that fail above the others.
  for (const bool passing : {true, false})
    for (std::size_t row = 0; row < rows.size(); row += step) {
      if (passes(verdict, row) != passing) continue;
      Line line{{}, {ink_of(verdict, row), 0.6}};
      for (std::size_t k = 0; k < axes.size(); ++k)
        if (std::isfinite(axes[k]->numbers[row]))
          line.points.push_back(at(k, axes[k]->numbers[row]));
      if (line.points.size() > 1) drawing.shapes.emplace_back(std::move(line));
    }
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto [low, high] = range_of(axes[k]->numbers);
    put_line(drawing, at(k, low), at(k, high), {"#606060", 1.2});
    put_text(drawing, fmt::format("{:.4g}", high), at(k, high) + Pixel(0.0, 10.0), Anchor::middle,
             quiet_ink);
    put_text(drawing, fmt::format("{:.4g}", low), at(k, low) - Pixel(0.0, 11.0), Anchor::middle,
             quiet_ink);
    // Names by turns on two heights.
    put_text(
        drawing, fitted(label_of(axes[k]->column), 1.8 * apart),
        {std::clamp(at(k, low).x(), left, figure_width - left), top + (k % 2 == 0 ? 44.0 : 28.0)},
        Anchor::middle);
  }
  put_text(drawing, words_of_failing(rows, verdict), {left, 16.0});
  return drawing;
}

std::optional<Drawing> histogram(const DesignRows& rows) {
  const DesignColumn* const column = shown_result(rows);
  if (column == nullptr) return std::nullopt;
  const DesignColumn* const verdict = verdict_of(rows);
  const auto [least, most] = range_of(column->numbers);
  const int wanted =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(rows.size()))), 8, 40);
  const double step = tic_step(most - least, wanted), low = std::floor(least / step) * step;
  std::map<long, std::pair<std::size_t, std::size_t>> bins;  // passing, failing
  std::size_t highest = 1;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (!std::isfinite(column->numbers[row])) continue;
    auto& [good, bad] = bins[static_cast<long>(std::floor((column->numbers[row] - low) / step))];
    ++(passes(verdict, row) ? good : bad);
    highest = std::max(highest, good + bad);
  }
  const double high = low + step * static_cast<double>(bins.rbegin()->first + 1);
  Drawing drawing{figure_width, 300.0, {}};
  const Panel panel{{60.0, 62.0, figure_width - 16.0, 300.0 - heading_room},
                    low,
                    high,
                    0.0,
                    1.05 * static_cast<double>(highest)};
  put_axes(drawing, panel);
  const auto bar = [&](long bin, double from, double to, const char* ink) {
    if (!(to > from)) return;
    const double l = low + step * (static_cast<double>(bin) + 0.05), r = l + 0.9 * step;
    put_bar(drawing, panel, {l, from}, {r, to}, ink);
  };
  for (const auto& [bin, counts] : bins) {
    const auto good = static_cast<double>(counts.first), bad = static_cast<double>(counts.second);
    bar(bin, 0.0, bad, fails_ink);
    bar(bin, bad, bad + good, verdict == nullptr ? colour(0) : passes_ink);
  }
  if (column->column.name == "utilisation" && low < 1.0 && high > 1.0)
    put_line(drawing, panel.at(1.0, 0.0), panel.at(1.0, panel.y_high),
             {"#202020", 1.2, {4.0, 3.0}});
  put_heading(drawing, panel, "designs");
  put_footing(drawing, panel, label_of(column->column));
  put_text(drawing, words_of_failing(rows, verdict), {60.0, 10.0});
  return drawing;
}

std::optional<Drawing> histogram(const StudySummary& summary) {
  const auto shown =
      std::find_if(summary.statistics.begin(), summary.statistics.end(),
                   [](const ColumnStatistics& of) { return of.column.name == "utilisation"; });
  if (shown == summary.statistics.end() || !(shown->quantiles.back() > shown->quantiles.front()))
    return std::nullopt;
  const double low = shown->quantiles.front(), high = shown->quantiles.back();
  const double step = (high - low) / static_cast<double>(shown->histogram.size());
  const auto highest =
      static_cast<double>(*std::max_element(shown->histogram.begin(), shown->histogram.end()));
  Drawing drawing{figure_width, 300.0, {}};
  const Panel panel{
      {60.0, 62.0, figure_width - 16.0, 300.0 - heading_room}, low, high, 0.0, 1.05 * highest};
  put_axes(drawing, panel);
  for (std::size_t k = 0; k < shown->histogram.size(); ++k) {
    const double l = low + step * (static_cast<double>(k) + 0.05), r = l + 0.9 * step;
    const auto count = static_cast<double>(shown->histogram[k]);
    if (count > 0.0) put_bar(drawing, panel, {l, 0.0}, {r, count}, colour(0));
  }
  if (low < 1.0 && high > 1.0)
    put_line(drawing, panel.at(1.0, 0.0), panel.at(1.0, panel.y_high),
             {"#202020", 1.2, {4.0, 3.0}});
  put_heading(drawing, panel, "designs");
  put_footing(drawing, panel, label_of(shown->column));
  put_text(drawing,
           summary.p_f ? fmt::format("All {} designs, p_f about {:.3g} %", summary.designs,
                                     100.0 * summary.p_f->value)
                       : fmt::format("All {} designs", summary.designs),
           {60.0, 10.0});
  return drawing;
}

std::optional<Drawing> contour(const DesignRows& rows) {
  std::vector<const DesignColumn*> variables;
  for (const DesignColumn& column : rows.columns)
    if (column.is_variable && varies(column)) variables.push_back(&column);
  const DesignColumn* shown = rows.find("utilisation");
  for (const DesignColumn& column : rows.columns)
    if (!column.is_variable && varies(column) &&
        column.column.name.find("safety_factor") != std::string::npos) {
      shown = &column;
      break;
    }
  if (shown == nullptr || !varies(*shown)) shown = shown_result(rows);
  if (variables.size() != 2 || shown == nullptr) return std::nullopt;
  const std::optional<GridOfValues> values =
      grid_of(variables[0]->numbers, variables[1]->numbers, shown->numbers);
  if (!values) return std::nullopt;
  // Where all corners of a field pass so does it as far as a figure can tell.
  const DesignColumn* const verdict = verdict_of(rows);
  const DesignColumn* const use_column = rows.find("utilisation");
  std::vector<double> use;
  for (std::size_t row = 0; row < rows.size(); ++row)
    use.push_back(use_column != nullptr && std::isfinite(use_column->numbers[row])
                      ? use_column->numbers[row]
                  : passes(verdict, row) ? 0.0
                                         : 2.0);
  const GridOfValues uses = *grid_of(variables[0]->numbers, variables[1]->numbers, use);
  Drawing drawing{figure_width, 400.0, {}};
  const Panel panel{{60.0, 62.0, figure_width - 16.0, 400.0 - heading_room},
                    values->x.front(),
                    values->x.back(),
                    values->y.front(),
                    values->y.back()};
  shade_failing(uses, panel, drawing);
  put_axes(drawing, panel);
  const auto draw = [&](const GridOfValues& of, double level, const Pen& pen) {
    std::vector<std::pair<Pixel, Pixel>> lines = level_lines(of, level);
    for (auto& [a, b] : lines) {
      a = panel.at(a.x(), a.y());
      b = panel.at(b.x(), b.y());
      drawing.shapes.emplace_back(Line{{a, b}, pen});
    }
    return lines;
  };
  const auto [low, high] = range_of(shown->numbers);
  const double step = tic_step(high - low, 8);
  Labels labels;
  for (double k = std::ceil(low / step); k * step <= high; ++k) {
    const auto lines = draw(*values, k * step, {"#606060", 0.9});
    if (lines.size() < 2) continue;
    labels.put(drawing, fmt::format("{:.4g}", k * step), lines[lines.size() * 3 / 5].first,
               panel.frame, "#202020", 4.0);
  }
  draw(uses, 1.0, {fails_ink, 2.0});
  put_heading(
      drawing, panel,
      fmt::format("{}, lines: {}", label_of(variables[1]->column), label_of(shown->column)));
  put_footing(drawing, panel, label_of(variables[0]->column));
  put_text(drawing, "Shaded: does not pass", {60.0, 10.0});
  return drawing;
}

std::optional<Drawing> front(const OptimumReport& of) {
  if (of.goals.size() != 2 || of.front.empty()) return std::nullopt;
  const DesignColumn* const first = of.judged.find(of.goals[0].name);
  const DesignColumn* const second = of.judged.find(of.goals[1].name);
  std::vector<double> x, y;
  for (const FrontPoint& point : of.front) {
    x.push_back(point.goals[0]);
    y.push_back(point.goals[1]);
  }
  const auto padded = [](const std::vector<double>& values) {
    const auto [low, high] = range_of(values);
    const double room = high > low ? 0.35 * (high - low) : 0.1 * std::abs(high) + 1e-300;
    return std::pair(low - 0.3 * room, high + room);
  };
  const auto along_x = padded(x);
  const auto along_y = padded(y);
  Drawing drawing{figure_width, 340.0, {}};
  const Panel panel{{70.0, 62.0, figure_width - 16.0, 340.0 - heading_room},
                    along_x.first,
                    along_x.second,
                    along_y.first,
                    along_y.second};
  put_axes(drawing, panel);
  const auto inside = [&](double a, double b) {
    return a >= along_x.first && a <= along_x.second && b >= along_y.first && b <= along_y.second;
  };
  const DesignColumn* const verdict = verdict_of(of.judged);
  if (first != nullptr && second != nullptr)
    for (std::size_t row = 0; row < of.judged.size(); ++row)
      if (inside(first->numbers[row], second->numbers[row]) && passes(verdict, row))
        drawing.shapes.emplace_back(Dot{panel.at(first->numbers[row], second->numbers[row]),
                                        1.6,
                                        {"", 1.0, {}, "#9aa5b1", ""}});
  Line line{{}, {colour(0), 1.4}};
  for (std::size_t k = 0; k < x.size(); ++k) line.points.push_back(panel.at(x[k], y[k]));
  drawing.shapes.emplace_back(line);
  for (const Pixel& at : line.points)
    drawing.shapes.emplace_back(Dot{at, 3.2, {colour(0), 1.0, {}, colour(0), ""}});
  const auto name = [](const OptimumReport::Named& goal) {
    return label_of({goal.name, goal.unit});
  };
  put_heading(drawing, panel, name(of.goals[1]));
  put_footing(drawing, panel, name(of.goals[0]));
  put_text(drawing,
           "Blue: neither goal can be less but for more of the other; grey: others that keep "
           "all limits",
           {20.0, 10.0});
  return drawing;
}

}  // namespace boxbeam::plot
