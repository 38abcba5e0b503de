#include <fmt/format.h>

#include <algorithm>

#include "ink.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::plot {

Drawing modes(const Project&, const Verification& verification) {
  constexpr double left_of_frame = 44.0, above_frame = 26.0, below_frame = footing_room,
                   foot = 22.0;
  const ElasticFigures& figures = *verification.pictures.elastic;
  const auto count = static_cast<int>(figures.modes.size());
  const View view = flat_view(0, 1);
  Room room(view);
  for (const PostureFigure& mode : figures.modes) room.take(mode);
  room.take(figures.rest);
  const Eigen::Vector2d size = room.size();
  const int columns = std::clamp(count, 1, 2);
  const int rows = (count + columns - 1) / columns;
  const double width = (figure_width - 8.0) / columns - left_of_frame - 8.0;
  const double most = std::min(360.0, 730.0 / rows - above_frame - below_frame);
  constexpr double margin = 14.0;
  const double metres_per_pixel =
      std::max(size.x() / (width - 2.0 * margin), size.y() / (most - 2.0 * margin));
  const double height = std::clamp(size.y() / metres_per_pixel + 2.0 * margin, 60.0, most);
  const Frame at = room.at(metres_per_pixel);
  const Eigen::Vector2d middle =
      0.5 * metres_per_pixel * Eigen::Vector2d(at.left + at.right, at.bottom + at.top);
  const double step = height + above_frame + below_frame;
  Drawing drawing{figure_width, foot + rows * step, {}};
  put_text(drawing, "grey: without load;  how far a mode moves has no scale",
           {0.5 * drawing.width, 0.5 * foot}, Anchor::middle, quiet_ink);
  for (int k = 0; k < count; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const double left = left_of_frame + (k % columns) * (width + left_of_frame + 8.0);
    const int row = k / columns;
    const double top = drawing.height - above_frame - row * step;
    const Projection projection{
        view, panel_to_scale({left, top - height, left + width, top}, metres_per_pixel, middle)};
    put_axes(drawing, projection.panel);
    put_footing(drawing, projection.panel, "x [m]");
    put_text(drawing, fmt::format("y [m]   mode {}: {}", k + 1, figures.modes[index].why),
             {left - 30.0, top + 13.0});
    draw_bodies(drawing, figures.rest, projection, "#c4c4c4", margin);
    draw_bodies(drawing, figures.modes[index], projection, colour(index), margin);
  }
  return drawing;
}

}  // namespace boxbeam::plot
