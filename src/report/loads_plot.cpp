#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "canvas.hpp"

namespace boxbeam::plot {
namespace {

/// Whether all situations take the same time, so that one axis in seconds shows them all.
bool of_one_span(const LoadsOverTime& figure) {
  const LoadsOverTime::Line& first = figure.lines.front();
  return std::all_of(figure.lines.begin(), figure.lines.end(), [&](const auto& line) {
    const double length = (first.times.back() - first.times.front()).value();
    return std::abs((line.times.front() - first.times.front()).value()) < 1e-9 * length &&
           std::abs((line.times.back() - first.times.back()).value()) < 1e-9 * length;
  });
}

/// What is round-off beside the largest force, of moments at the length of the beam.
double round_off_of(const LoadsOverTime& figure, cut_force::Index which, Length beam) {
  double largest = 0.0;
  for (const LoadsOverTime::Line& line : figure.lines) {
    for (const CutForces& forces : line.values)
      for (const cut_force::Index force : {cut_force::N, cut_force::V_y, cut_force::V_z})
        largest = std::max(largest, std::abs(value_of(forces, force)));
  }
  const bool is_force = which == cut_force::N || which == cut_force::V_y || which == cut_force::V_z;
  return 1e-10 * largest * (is_force ? 1.0 : beam.value());
}

/// The lines of one cut force, a row for each instant.
std::vector<std::vector<Row2>> lines_of(const LoadsOverTime& figure, cut_force::Index which,
                                        bool seconds, Length beam) {
  const double none = round_off_of(figure, which, beam);
  std::vector<std::vector<Row2>> lines;
  for (const LoadsOverTime::Line& line : figure.lines) {
    const double begin = line.times.front().value();
    const double length = line.times.back().value() - begin;
    std::vector<Row2>& rows = lines.emplace_back();
    for (std::size_t i = 0; i < line.times.size(); ++i) {
      const double time = line.times[i].value();
      const double value = value_of(line.values[i], which);
      rows.emplace_back(seconds ? time : (time - begin) / length,
                        std::abs(value) <= none ? 0.0 : 1e-3 * value);
    }
  }
  return lines;
}

void draw_panel(Script& gp, const CutForceName& name, const std::vector<std::vector<Row2>>& lines,
                const std::string& footing, const Frame& frame) {
  const auto lower = [](const Row2& a, const Row2& b) { return std::get<1>(a) < std::get<1>(b); };
  struct Extreme {
    Row2 at;
    std::size_t line;
  };
  Extreme lowest{lines.front().front(), 0};
  Extreme highest = lowest;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto [low, high] = std::minmax_element(lines[k].begin(), lines[k].end(), lower);
    if (lower(*low, lowest.at)) lowest = {*low, k};
    if (lower(highest.at, *high)) highest = {*high, k};
  }
  const double bottom = std::get<1>(lowest.at);
  const double top = std::get<1>(highest.at);
  const auto [y_low, y_high] = range_with_zero(bottom, top, 0.2);
  const Panel panel{frame, std::get<0>(lines.front().front()), std::get<0>(lines.front().back()),
                    y_low, y_high};
  place(gp, panel);
  put_heading(gp, panel, axis_title(name));
  if (!footing.empty()) put_footing(gp, panel, footing);
  Labels labels;
  labels.keep_off(panel.at(panel.x_low, 0.0), panel.at(panel.x_high, 0.0));
  std::vector<std::string> curves{"0 with lines lc rgb '#505050' lw 0.9"};
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string data = fmt::format("{}{}", name.name, k);
    gp.block(data, lines[k]);
    curves.push_back(fmt::format("${} using 1:2 with lines {}", data, line_style(k)));
    labels.keep_off(panel, lines[k]);
  }
  for (const Extreme& extreme : {highest, lowest}) {
    const auto [time, value] = extreme.at;
    if (std::abs(value) < 0.03 * (top - bottom)) continue;
    labels.put(gp, text::significant(value), panel.at(time, value), frame, colour(extreme.line),
               3.0);
  }
  gp.plot(curves);
}

}  // namespace

void loads_over_time(Script& gp, const Project& project, const Verification& verification) {
  const LoadsOverTime& figure = *verification.pictures.loads_over_time;
  const bool seconds = of_one_span(figure);
  std::vector<LegendEntry> legend;
  for (std::size_t k = 0; k < figure.lines.size(); ++k) {
    const LoadsOverTime::Line& line = figure.lines[k];
    const double length = (line.times.back() - line.times.front()).value();
    const std::string& situation = project.situations[line.situation].name;
    legend.push_back(
        {seconds ? situation : fmt::format("{}, {:.4g} s", situation, length), line_style(k)});
  }
  constexpr double height = 130.0, between = heading_room;
  const bool several = legend.size() > 1;
  const double below = footing_room + (several ? height_of_legend(legend) : 0.0);
  gp.begin("loads", below + 3.0 * height + 2.0 * between + 44.0);
  const double highest = gp.height() - 44.0;
  put_text(gp, fmt::format("cut forces at s = {} m", to_text(figure.station)),
           {12.0, highest + 32.0});
  if (several) draw_legend(gp, legend, 2.0);
  // Left what bends in the plane x-z, right what bends in x-y, with the torque.
  static constexpr cut_force::Index order[] = {cut_force::N, cut_force::V_z, cut_force::M_y,
                                               cut_force::T, cut_force::V_y, cut_force::M_z};
  const std::string footing = seconds ? "t [s]" : "time, as part of each situation";
  const auto names = cut_forces_looked_at(project);
  for (std::size_t p = 0; p < std::size(order); ++p) {
    const auto name = std::find_if(names.begin(), names.end(),
                                   [&](const CutForceName& of) { return of.which == order[p]; });
    const bool lowest = p % 3 == 2;
    gp << (lowest ? "set format x '%g'\n" : "set format x ''\n");
    const double left = p < 3 ? 56.0 : 358.0;
    const double top = highest - static_cast<double>(p % 3) * (height + between);
    draw_panel(gp, *name, lines_of(figure, order[p], seconds, project.beam.length()),
               lowest ? footing : "", {left, top - height, left + 242.0, top});
  }
}

}  // namespace boxbeam::plot
