#include "ink.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace boxbeam::plot {

void put_text(Drawing& drawing, const std::string& text, const Pixel& at, Anchor anchor,
              const std::string& colour, const std::string& kind) {
  constexpr double half_a_letter = 3.9;
  drawing.shapes.emplace_back(
      Words{{{text}}, at - Pixel(0.0, half_a_letter), anchor, colour, kind});
}

void put_line(Drawing& drawing, const Pixel& from, const Pixel& to, const Pen& pen) {
  drawing.shapes.emplace_back(Line{{from, to}, pen});
}

void put_bar(Drawing& drawing, const Panel& panel, const Eigen::Vector2d& from,
             const Eigen::Vector2d& to, const std::string& ink, double border) {
  drawing.shapes.emplace_back(Line{{panel.at(from.x(), from.y()), panel.at(to.x(), from.y()),
                                    panel.at(to.x(), to.y()), panel.at(from.x(), to.y())},
                                   {ink, border, {}, ink, ""},
                                   true});
}

void put_named_bar(Drawing& drawing, const Panel& panel, double middle, double value,
                   const std::string& ink, const std::string& name, double width) {
  constexpr double half = 0.32, beside = 8.0;
  put_bar(drawing, panel, {0.0, middle - half}, {value, middle + half}, ink, 0.8);
  put_text(drawing, fitted(name, width - 2.0 * beside), {width - beside, panel.at(0.0, middle).y()},
           Anchor::right);
}

void put_head(Drawing& drawing, const Pixel& tip, const Eigen::Vector2d& along, double length,
              const std::string& colour) {
  constexpr double slenderness = 0.35;
  const Eigen::Vector2d side = slenderness * length * Eigen::Vector2d(-along.y(), along.x());
  const Pixel neck = tip - length * along;
  drawing.shapes.emplace_back(
      Line{{tip, neck + side, neck - side}, {"", 1.0, {}, colour, "head"}, true});
}

void put_arrow(Drawing& drawing, const Pixel& from, const Pixel& to, const Pen& pen) {
  constexpr double longest = 8.0;
  const double length = (to - from).norm();
  if (length == 0.0) return;
  const Eigen::Vector2d along = (to - from) / length;
  const double head = std::min(longest, length);
  put_line(drawing, from, to - 0.8 * head * along, pen);
  put_head(drawing, to, along, head, pen.stroke);
}

void put_axes(Drawing& drawing, const Panel& panel, bool numbers_up) {
  const Frame& frame = panel.frame;
  const Pen grid{"#e4e4e4", 0.7, {}, "", "grid"};
  const Pen border{"#606060", 1.0, {}, "", "axis"};
  constexpr double tic = 4.5;
  const auto places = [](double from, double to, double room, double apart) {
    const auto [low, high] = std::minmax(from, to);
    const int most = std::max(2, static_cast<int>(room / apart));
    const double step = tic_step(high - low, most);
    std::vector<double> values;
    for (double k = std::ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; ++k)
      values.push_back(k == 0.0 ? 0.0 : k * step);
    return values;
  };
  const auto words = [&](double value, const Pixel& at, Anchor anchor) {
    put_text(drawing, fmt::format("{:.6g}", value), at, anchor, border.stroke, "small");
  };
  for (const double x : places(panel.x_low, panel.x_high, frame.right - frame.left, 55.0)) {
    const Pixel foot = panel.at(x, panel.y_low);
    put_line(drawing, foot, {foot.x(), frame.top}, grid);
    put_line(drawing, foot, foot - Pixel(0.0, tic), border);
    words(x, foot - Pixel(0.0, 15.0), Anchor::middle);
  }
  for (const double y : places(panel.y_low, panel.y_high, frame.top - frame.bottom, 21.0)) {
    const Pixel foot = panel.at(panel.x_low, y);
    put_line(drawing, foot, {frame.right, foot.y()}, grid);
    put_line(drawing, foot, foot - Pixel(tic, 0.0), border);
    if (numbers_up) words(y, foot - Pixel(8.0, 0.0), Anchor::right);
  }
  drawing.shapes.emplace_back(Line{
      {{frame.left, frame.top}, {frame.left, frame.bottom}, {frame.right, frame.bottom}}, border});
}

void put_heading(Drawing& drawing, const Panel& panel, const std::string& text) {
  put_text(drawing, text, {panel.frame.left - 44.0, panel.frame.top + 15.0});
}

void put_footing(Drawing& drawing, const Panel& panel, const std::string& text) {
  put_text(drawing, text, {0.5 * (panel.frame.left + panel.frame.right), panel.frame.bottom - 34.0},
           Anchor::middle);
}

void draw_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, double bottom) {
  for (const auto& [entry, at] : rows_of_legend(entries, bottom)) {
    if (!entry.pen.stroke.empty()) put_line(drawing, at, at + Pixel(legend_stroke, 0.0), entry.pen);
    put_text(drawing, entry.title, at + Pixel(legend_words, 0.0));
  }
}

}  // namespace boxbeam::plot
