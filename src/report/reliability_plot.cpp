#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/reliability_report.hpp"
#include "drawn_files.hpp"
#include "ink.hpp"

namespace boxbeam {
namespace {

constexpr const char* importance_figure = "importance";
constexpr const char* convergence_figure = "convergence";

plot::Drawing importance_bars(const std::vector<VariableAtPoint>& variables, double beta) {
  constexpr double row = 19.0, names = 250.0, below = plot::footing_room;
  constexpr std::size_t most_bars = 16;
  std::vector<VariableAtPoint> shown = variables;
  std::stable_sort(shown.begin(), shown.end(),
                   [](const VariableAtPoint& a, const VariableAtPoint& b) {
                     return std::abs(a.alpha) > std::abs(b.alpha);
                   });
  if (shown.size() > most_bars) shown.resize(most_bars);
  const auto count = static_cast<double>(shown.size());
  plot::Drawing drawing{plot::figure_width, below + row * count + plot::heading_room, {}};
  const plot::Panel panel{
      {names, below, plot::figure_width - 16.0, below + row * count}, 0.0, 100.0, 0.0, count};
  plot::put_axes(drawing, panel, false);
  plot::put_heading(drawing, panel, fmt::format("what decides at beta = {:.3f}", beta));
  plot::put_footing(drawing, panel, "alpha^2 [%]; red: more of it leads to failure");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double middle = count - static_cast<double>(i) - 0.5;
    const double share = 100.0 * shown[i].alpha * shown[i].alpha;
    plot::put_named_bar(drawing, panel, middle, share, plot::colour(shown[i].alpha > 0.0 ? 1 : 0),
                        fmt::format("{}  {:.4g} {}", shown[i].name, shown[i].value, shown[i].unit),
                        names);
  }
  return drawing;
}

std::vector<const MethodResult*> drawn_methods(const StudyReliability& of) {
  std::vector<const MethodResult*> drawn;
  for (const MethodResult& by : of.result.methods)
    if (by.p_f && by.history.size() > 1) drawn.push_back(&by);
  return drawn;
}

/// log10 of p_f over log10 of the samples, with the borders of 95 %.
plot::Drawing convergence_lines(const std::vector<const MethodResult*>& methods) {
  double left = 1e300, right = 0.0, low = 1.0, high = 0.0;
  for (const MethodResult* by : methods)
    for (const Estimate& at : by->history) {
      if (at.p_f <= 0.0) continue;
      left = std::min(left, static_cast<double>(at.samples));
      right = std::max(right, static_cast<double>(at.samples));
      low = std::min(low, 0.5 * at.p_f);
      high = std::max(high, std::min(1.0, 2.0 * at.p_f));
    }
  std::vector<plot::LegendEntry> legend;
  for (std::size_t k = 0; k < methods.size(); ++k)
    legend.push_back({to_text(methods[k]->method), "", "", {plot::colour(k), 1.8}});
  const double below = plot::height_of_legend(legend) + plot::footing_room + 4.0;
  constexpr double panel_height = 230.0;
  plot::Drawing drawing{plot::figure_width, below + panel_height + plot::heading_room, {}};
  const plot::Panel panel{{60.0, below, plot::figure_width - 16.0, below + panel_height},
                          std::log10(left),
                          std::log10(1.05 * right),
                          std::log10(low),
                          std::log10(high)};
  plot::put_axes(drawing, panel);
  plot::put_heading(drawing, panel, "log10 of p_f, with bounds of 95 %");
  plot::put_footing(drawing, panel, "log10 of the samples");
  for (std::size_t k = 0; k < methods.size(); ++k) {
    plot::Line middle{{}, {plot::colour(k), 1.8}}, under{{}, {plot::colour(k), 0.8, {4.0, 3.0}}},
        over = under;
    const auto put = [&](plot::Line& line, const Estimate& at, double value) {
      const double inside = std::clamp(value, low, high);
      line.points.push_back(
          panel.at(std::log10(static_cast<double>(at.samples)), std::log10(inside)));
    };
    for (const Estimate& at : methods[k]->history) {
      if (at.p_f <= 0.0) continue;
      put(middle, at, at.p_f);
      put(under, at, at.low);
      put(over, at, at.high);
    }
    for (const plot::Line& line : {middle, under, over}) drawing.shapes.emplace_back(line);
  }
  plot::draw_legend(drawing, legend, 4.0);
  return drawing;
}

}  // namespace

std::vector<std::string> draw_reliability(const StudyReliability& of, const std::string& folder) {
  std::vector<DrawnFigure> figures;
  if (!of.points.empty())
    figures.push_back({importance_figure, [&]() -> plot::Drawing {
                         return importance_bars(of.points.front(), of.result.points.front().beta);
                       }});
  const std::vector<const MethodResult*> methods = drawn_methods(of);
  if (!methods.empty())
    figures.push_back(
        {convergence_figure, [&]() -> plot::Drawing { return convergence_lines(methods); }});
  if (figures.empty()) return {};
  return draw_into(folder, "", figures);
}

std::vector<std::string> files_of_reliability() {
  return {"reliability.json", "reliability.html", fmt::format("{}.svg", importance_figure),
          fmt::format("{}.svg", convergence_figure)};
}

}  // namespace boxbeam
