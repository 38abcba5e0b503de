#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mechanism_drawing.hpp"

namespace boxbeam::plot {
namespace {

constexpr double arrow = 52.0;  ///< the longest [px]
constexpr double left_of_frame = 44.0, below_frame = footing_room;
constexpr double foot = 22.0;  ///< below all: what grey and thin lines are

/// How the panels stand, and the scale of the drawing.
struct Layout {
  int columns = 1;
  int rows = 1;
  double metres_per_pixel = 1.0;
  double width = 0.0, height = 0.0;                  ///< of a frame
  double above = 0.0;                                ///< room of the longest title
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of every frame, world [m]
};

constexpr double title_row = 16.0;

/// Why a posture is shown, in lines above its frame.
std::vector<std::string> title_of(const PostureFigure& posture, std::size_t number, double width) {
  std::vector<std::string> lines{
      fitted(fmt::format("({}) {}", number, time_label(posture.time)), width + 36.0)};
  for (std::string& line : wrapped(posture.why, width + 36.0)) lines.push_back(std::move(line));
  return lines;
}

/// The corners of the mechanism with its arrows and their names at a scale [px], from the origin of
/// the world.
Frame drawn_extent(const Verification& verification, const Extents& extents, double largest_force,
                   double metres_per_pixel) {
  constexpr double margin = 12.0;
  const Eigen::Vector3d low = extents.low / metres_per_pixel;
  const Eigen::Vector3d high = extents.high / metres_per_pixel;
  Frame frame{low.x() - margin, low.y() - margin, high.x() + margin, high.y() + margin};
  for (const PostureFigure& posture : verification.postures) {
    for (const BeamLoadRow& row : posture.loads) {
      const Eigen::Vector3d tail =
          row.place / metres_per_pixel - row.world * (arrow / largest_force);
      const double name = 0.5 * text_width(row.name + "  00.00 kN");
      frame.left = std::min(frame.left, tail.x() - name);
      frame.right = std::max(frame.right, tail.x() + name);
      frame.bottom = std::min(frame.bottom, tail.y() - 20.0);
      frame.top = std::max(frame.top, tail.y() + 20.0);
    }
  }
  return frame;
}

/// The layout in which the mechanism is largest, in a figure no higher than a page.
Layout layout_of(const Verification& verification, const Extents& extents, double largest_force) {
  constexpr double highest = 650.0;  // on paper a higher one would be shrunk
  const std::vector<PostureFigure>& postures = verification.postures;
  const auto count = static_cast<int>(postures.size()) - 1;
  const auto drawn = [&](double scale) {
    return drawn_extent(verification, extents, largest_force, scale);
  };
  Layout best;
  for (int columns = 1; columns <= std::min(count, 3); ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double width = (figure_width - 8.0) / columns - left_of_frame - 8.0;
    std::size_t lines = 2;
    for (std::size_t k = 1; k < postures.size(); ++k) {
      lines = std::max(lines, title_of(postures[k], k, width).size());
    }
    const double above = title_row * static_cast<double>(lines) + 8.0;
    const double most = std::min(460.0, (highest - foot) / rows - above - below_frame);
    if (most < 120.0) continue;
    // The finest scale that fits, between one far too fine and one at which arrows alone fill it.
    double fine = 1e-3 * extents.size().maxCoeff() / figure_width;
    double coarse = 1e6 * fine;
    for (int i = 0; i < 60; ++i) {
      const double middle = std::sqrt(fine * coarse);
      const Frame at = drawn(middle);
      const bool fits = at.right - at.left <= width && at.top - at.bottom <= most;
      (fits ? coarse : fine) = middle;
    }
    if (best.width > 0.0 && coarse >= best.metres_per_pixel) continue;
    const Frame at = drawn(coarse);
    const Pixel middle(0.5 * (at.left + at.right), 0.5 * (at.bottom + at.top));
    best = {columns, rows,           coarse, width, std::clamp(at.top - at.bottom, 130.0, most),
            above,   middle * coarse};
  }
  return best;
}

/// What the grey posture is, and how large displacements are drawn.
std::string foot_text(const Verification& verification) {
  const PostureFigure& first = verification.postures.front();
  std::string text = first.magnified == 0.0
                         ? "grey: " + time_label(first.time)
                         : fmt::format("displacements {:g} times as large; grey: without load",
                                       verification.postures.back().magnified);
  if (!verification.cycles.empty() && first.magnified == 0.0)
    text += ";  thin lines: paths over the cycle";
  return text + ";  arrows: loads on the beam";
}

}  // namespace

void mechanism(Script& gp, const Project&, const Verification& verification) {
  const auto count = static_cast<int>(verification.postures.size()) - 1;
  double largest_force = 1e-9;
  for (const PostureFigure& posture : verification.postures) {
    for (const BeamLoadRow& row : posture.loads) {
      largest_force = std::max(largest_force, row.world.norm());
    }
  }
  const Layout layout = layout_of(verification, extents_of(verification), largest_force);
  const double step = layout.height + layout.above + below_frame;
  gp.begin("mechanism", foot + layout.rows * step);
  put_text(gp, foot_text(verification), {0.5 * gp.width(), 0.5 * foot}, "center", "#505050");
  const double least_couple = least_couple_of(verification);
  const double guide = 0.5 * arrow * layout.metres_per_pixel;
  for (int k = 0; k < count; ++k) {
    const PostureFigure& posture = verification.postures[static_cast<std::size_t>(k) + 1];
    const double left = left_of_frame + (k % layout.columns) * (layout.width + left_of_frame + 8.0);
    const int row = k / layout.columns;
    const double top = gp.height() - layout.above - row * step;
    const Panel panel =
        panel_to_scale({left, top - layout.height, left + layout.width, top},
                       layout.metres_per_pixel, layout.middle.x(), layout.middle.y());
    place(gp, panel);
    put_footing(gp, panel, "x [m]");
    const std::vector<std::string> title =
        title_of(posture, static_cast<std::size_t>(k) + 1, layout.width);
    for (std::size_t i = 0; i < title.size(); ++i) {
      put_text(gp, title[i],
               {left - 38.0, top + 12.0 + title_row * static_cast<double>(title.size() - 1 - i)},
               "left", i == 0 ? "#202020" : colour(static_cast<std::size_t>(k)));
    }
    put_text(gp, "y [m]", {left + 4.0, top - 8.0}, "left", "#505050");
    Labels labels;
    labels.keep_free({left, top - 16.0, left + 44.0, top});
    keep_off_bodies(labels, panel, posture, View{});
    keep_off_bodies(labels, panel, verification.postures.front(), View{});
    std::vector<std::string> curves =
        draw_traces(gp, verification, View{}, fmt::format("trace{}", k));
    const auto add = [&](const PostureFigure& of, const std::string& prefix, const char* ink) {
      for (std::string& curve : draw_bodies(gp, of, View{}, {prefix, ink, guide})) {
        curves.push_back(std::move(curve));
      }
    };
    add(verification.postures.front(), fmt::format("rest{}", k), "#c4c4c4");
    add(posture, fmt::format("at{}", k), colour(static_cast<std::size_t>(k)));
    draw_loads(gp, labels, panel, posture, View{}, {arrow / largest_force, least_couple, true});
    gp.plot(curves);
  }
}

}  // namespace boxbeam::plot
