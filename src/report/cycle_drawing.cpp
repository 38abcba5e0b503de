#include "cycle_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "ink.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::plot {
namespace {

/// As wide as half a page on a screen: letters there are about as large as those around them.
constexpr double pane = 460.0;

struct NamedView {
  const char* name;
  View view;
};

std::vector<NamedView> views_of(bool in_space) {
  if (!in_space) return {{"", flat_view(0, 1)}};
  View oblique;  // seen from the front (-y), 30 deg to the right and 25 deg above
  oblique << 0.8660, 0.5000, 0.0000,  //
      -0.2113, 0.3660, 0.9063;
  return {{"oblique", oblique},
          {"from the front, x-z", flat_view(0, 2)},
          {"from the side, y-z", flat_view(1, 2)},
          {"from above, x-y", flat_view(0, 1)}};
}

/// 1, 2 or 5 times a power of ten, not above a size.
double round_size(double size) {
  const double power = std::pow(10.0, std::floor(std::log10(size)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= size * (1.0 + 1e-9)) return step * power;
  }
  return power;
}

/// A length to measure by, how displacements are drawn, and in space the axes.
void draw_rule(Drawing& back, const View& view, bool in_space, double metres_per_pixel,
               double magnified) {
  const double size = round_size(0.2 * pane * metres_per_pixel);
  const double end = 8.0 + size / metres_per_pixel;
  const Pen pen{quiet_ink, 1.2, {}, "", "rule"};
  back.shapes.emplace_back(Line{{{8.0, 10.0}, {8.0, 6.0}, {end, 6.0}, {end, 10.0}}, pen});
  put_text(back, fmt::format("{:.1g} m", size), {12.0, 16.0}, Anchor::left, quiet_ink, "small");
  if (magnified > 0.0) {
    put_text(back, fmt::format("displacements {:g} times as large", magnified), {pane - 6.0, 10.0},
             Anchor::right, quiet_ink, "small");
  }
  static constexpr const char* names[] = {"x", "y", "z"};
  for (int i = 0; in_space && i < 3; ++i) {
    const Pixel axis = 26.0 * view.col(i);
    if (axis.norm() < 2.6) continue;
    const Pixel origin(34.0, back.height - 46.0);
    put_line(back, origin, origin + axis, pen);
    put_text(back, names[i], origin + 1.3 * axis, Anchor::middle, quiet_ink, "small");
  }
}

MovingView moving_view(const CycleFigure& cycle, const NamedView& seen, bool in_space) {
  constexpr double arrow = 70.0, highest = 380.0, least = 190.0, below = 28.0, margin = 4.0;
  Room room(seen.view);
  LoadSizes sizes;
  for (const CycleFrame& frame : cycle.frames) {
    room.take(frame.posture);
    sizes.take(frame.posture);
  }
  const double size = std::max(room.size().maxCoeff(), 1e-9);
  const LoadInk look{arrow / sizes.force(), sizes.least_couple(size), true};
  for (const CycleFrame& frame : cycle.frames) room.take_loads(frame.posture, look);
  const double scale = finest_scale(size, [&](double metres_per_pixel) {
    const Frame at = room.at(metres_per_pixel);
    return at.right - at.left <= pane - 2.0 * margin && at.top - at.bottom <= highest;
  });
  const Frame at = room.at(scale);
  const double height = std::max(at.top - at.bottom, least);
  const Projection projection{
      seen.view, panel_to_scale({margin, below, pane - margin, below + height}, scale,
                                0.5 * scale * Pixel(at.left + at.right, at.bottom + at.top))};
  MovingView moving{seen.name, {pane, below + height + margin, {}}, {}};
  draw_rule(moving.back, seen.view, in_space, scale, cycle.frames.front().posture.magnified);
  for (const CycleFrame& frame : cycle.frames) {
    Drawing drawing{pane, moving.back.height, {}};
    Labels labels;
    if (in_space) labels.keep_free({0.0, drawing.height - 84.0, 72.0, drawing.height});
    keep_off_bodies(labels, frame.posture, projection);
    draw_bodies(drawing, frame.posture, projection, "#202020", 0.12 * size / scale);
    draw_loads(drawing, labels, frame.posture, projection, look);
    moving.frames.push_back(std::move(drawing));
  }
  return moving;
}

}  // namespace

bool is_in_space(const CycleFigure& cycle) {
  double flat = 0.0;
  double deep = 0.0;
  for (const CycleFrame& frame : cycle.frames) {
    each_place(frame.posture, [&](const Eigen::Vector3d& place) {
      flat = std::max(flat, place.head<2>().cwiseAbs().maxCoeff());
      deep = std::max(deep, std::abs(place.z()));
    });
  }
  return deep > 1e-9 * flat;
}

std::vector<MovingView> moving_views_of(const CycleFigure& cycle) {
  const bool in_space = is_in_space(cycle);
  std::vector<MovingView> views;
  for (const NamedView& seen : views_of(in_space))
    views.push_back(moving_view(cycle, seen, in_space));
  return views;
}

DiagramPaper diagram_paper(const std::vector<double>& stations,
                           const std::vector<AlongBeam>& quantities) {
  constexpr double left = 58.0, right = pane - 16.0, title = 26.0, bottom = 36.0;
  const double high = quantities.size() > 3 ? 70.0 : 92.0;
  const auto count = static_cast<double>(quantities.size());
  DiagramPaper paper{{pane, count * (high + title) + bottom, {}}, {}, {}};
  Drawing& back = paper.back;
  const double length = stations.back();
  for (const double s : stations) paper.x.push_back(left + s / length * (right - left));
  const Pen axis{quiet_ink, 1.0, {}, "", "axis"};
  double top = back.height - title;
  for (const AlongBeam& of : quantities) {
    const double low = std::min(0.0, *std::min_element(of.low.begin(), of.low.end()));
    const double up = std::max(0.0, *std::max_element(of.high.begin(), of.high.end()));
    const double per_unit = high / (up > low ? up - low : 1.0);
    const double zero = top - per_unit * up;
    put_text(back, of.name, {left, top + 11.0}, Anchor::left, "#202020", "name");
    Line band{{}, {"", 1.0, {}, "#e2e2e2", "band"}, true};
    for (std::size_t i = 0; i < stations.size(); ++i)
      band.points.emplace_back(paper.x[i], zero + per_unit * of.high[i]);
    for (std::size_t i = stations.size(); i-- > 0;)
      band.points.emplace_back(paper.x[i], zero + per_unit * of.low[i]);
    back.shapes.emplace_back(std::move(band));
    put_line(back, {left, zero}, {right, zero}, axis);
    for (const double value : {low, 0.0, up}) {
      const double y = zero + per_unit * value;
      if (value != 0.0 && std::abs(y - zero) < 13.0) continue;
      put_text(back, value == 0.0 ? "0" : text::significant(value), {left - 6.0, y}, Anchor::right,
               quiet_ink, "small");
    }
    paper.scales.push_back({zero, per_unit});
    top -= high + title;
  }
  const double foot = bottom - 8.0;
  put_line(back, {left, foot}, {right, foot}, axis);
  const double step = round_size(length / 4.0);
  for (int k = 0; k * step <= length * (1.0 + 1e-6); ++k) {
    const double x = left + k * step / length * (right - left);
    put_line(back, {x, foot}, {x, foot - 4.0}, axis);
    put_text(back, fmt::format("{:.6g}", k * step), {x, foot - 14.0}, Anchor::middle, quiet_ink,
             "small");
  }
  put_text(back, "s [m]", {left - 12.0, foot - 14.0}, Anchor::right, "#202020", "name");
  return paper;
}

}  // namespace boxbeam::plot
