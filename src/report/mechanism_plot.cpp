#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ink.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::plot {
namespace {

constexpr double arrow = 52.0;  ///< the longest [px]
constexpr double left_of_frame = 44.0, below_frame = footing_room;
constexpr double foot_row = 22.0;  ///< below all: what grey and thin lines are

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

/// The layout in which the mechanism is largest, in a figure no higher than a page.
Layout layout_of(const Verification& verification, const Room& room) {
  constexpr double highest = 650.0;  // on paper a higher one would be shrunk
  const std::vector<PostureFigure>& postures = verification.pictures.postures;
  const auto count = static_cast<int>(postures.size()) - 1;
  Layout best;
  for (int columns = 1; columns <= std::min(count, 3); ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double width = (figure_width - 8.0) / columns - left_of_frame - 8.0;
    std::size_t lines = 2;
    for (std::size_t k = 1; k < postures.size(); ++k) {
      lines = std::max(lines, title_of(postures[k], k, width).size());
    }
    const double above = title_row * static_cast<double>(lines) + 8.0;
    const double most = std::min(460.0, (highest - foot_row) / rows - above - below_frame);
    if (most < 120.0) continue;
    const double scale = finest_scale(room.size().maxCoeff(), [&](double metres_per_pixel) {
      const Frame at = room.at(metres_per_pixel);
      return at.right - at.left <= width && at.top - at.bottom <= most;
    });
    if (best.width > 0.0 && scale >= best.metres_per_pixel) continue;
    const Frame at = room.at(scale);
    const Pixel middle(0.5 * (at.left + at.right), 0.5 * (at.bottom + at.top));
    best = {columns, rows,          scale, width, std::clamp(at.top - at.bottom, 130.0, most),
            above,   middle * scale};
  }
  return best;
}

/// What the grey posture is, and how large displacements are drawn.
std::string foot_text(const Verification& verification) {
  const PostureFigure& first = verification.pictures.postures.front();
  std::string text = first.magnified == 0.0
                         ? "grey: " + time_label(first.time)
                         : fmt::format("displacements {:g} times as large; grey: without load",
                                       verification.pictures.postures.back().magnified);
  if (!verification.pictures.cycles.empty() && first.magnified == 0.0)
    text += ";  thin lines: paths over the cycle";
  return text + ";  arrows: loads on the beam";
}

}  // namespace

Drawing mechanism(const Project&, const Verification& verification) {
  const auto count = static_cast<int>(verification.pictures.postures.size()) - 1;
  const View view = flat_view(0, 1);
  Room room = room_of(verification, view);
  const LoadSizes sizes = load_sizes_of(verification);
  const LoadInk look{arrow / sizes.force(), sizes.least_couple(room.size().maxCoeff()), true};
  for (const PostureFigure& posture : verification.pictures.postures)
    room.take_loads(posture, look);
  const Layout layout = layout_of(verification, room);
  const double step = layout.height + layout.above + below_frame;
  Drawing drawing{figure_width, foot_row + layout.rows * step, {}};
  put_text(drawing, foot_text(verification), {0.5 * drawing.width, 0.5 * foot_row}, Anchor::middle,
           quiet_ink);
  for (int k = 0; k < count; ++k) {
    const PostureFigure& posture = verification.pictures.postures[static_cast<std::size_t>(k) + 1];
    const double left = left_of_frame + (k % layout.columns) * (layout.width + left_of_frame + 8.0);
    const int row = k / layout.columns;
    const double top = drawing.height - layout.above - row * step;
    const Projection projection{
        view, panel_to_scale({left, top - layout.height, left + layout.width, top},
                             layout.metres_per_pixel, layout.middle)};
    const Panel& panel = projection.panel;
    const std::string ink = colour(static_cast<std::size_t>(k));
    put_axes(drawing, panel);
    put_footing(drawing, panel, "x [m]");
    const std::vector<std::string> title =
        title_of(posture, static_cast<std::size_t>(k) + 1, layout.width);
    for (std::size_t i = 0; i < title.size(); ++i) {
      put_text(drawing, title[i],
               {left - 38.0, top + 12.0 + title_row * static_cast<double>(title.size() - 1 - i)},
               Anchor::left, i == 0 ? "#202020" : ink);
    }
    put_text(drawing, "y [m]", {left + 4.0, top - 8.0}, Anchor::left, quiet_ink);
    Labels labels;
    labels.keep_free({left, top - 16.0, left + 44.0, top});
    keep_off_bodies(labels, posture, projection);
    keep_off_bodies(labels, verification.pictures.postures.front(), projection);
    draw_traces(drawing, verification, projection);
    draw_bodies(drawing, verification.pictures.postures.front(), projection, "#c4c4c4",
                0.5 * arrow);
    draw_bodies(drawing, posture, projection, ink, 0.5 * arrow);
    draw_loads(drawing, labels, posture, projection, look);
  }
  return drawing;
}

}  // namespace boxbeam::plot
