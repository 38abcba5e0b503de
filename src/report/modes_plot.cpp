#include <fmt/format.h>

#include <algorithm>

#include "mechanism_drawing.hpp"

namespace boxbeam::plot {

void modes(Script& gp, const Project&, const Verification& verification) {
  constexpr double left_of_frame = 44.0, above_frame = 26.0, below_frame = footing_room,
                   foot = 22.0;
  const ElasticFigures& figures = *verification.elastic;
  const auto count = static_cast<int>(figures.modes.size());
  Extents extents;
  for (const PostureFigure& mode : figures.modes) extents.take(mode);
  extents.take(figures.rest);
  const int columns = std::clamp(count, 1, 2);
  const int rows = (count + columns - 1) / columns;
  const double width = (figure_width - 8.0) / columns - left_of_frame - 8.0;
  const double most = std::min(360.0, 730.0 / rows - above_frame - below_frame);
  constexpr double margin = 14.0;
  const double metres_per_pixel = std::max(extents.size().x() / (width - 2.0 * margin),
                                           extents.size().y() / (most - 2.0 * margin));
  const double height =
      std::clamp(extents.size().y() / metres_per_pixel + 2.0 * margin, 60.0, most);
  const double step = height + above_frame + below_frame;
  gp.begin("modes", foot + rows * step);
  put_text(gp, "grey: without load;  how far a mode moves has no scale",
           {0.5 * gp.width(), 0.5 * foot}, "center", "#505050");
  for (int k = 0; k < count; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const double left = left_of_frame + (k % columns) * (width + left_of_frame + 8.0);
    const int row = k / columns;
    const double top = gp.height() - above_frame - row * step;
    const Panel panel = panel_to_scale({left, top - height, left + width, top}, metres_per_pixel,
                                       extents.middle().x(), extents.middle().y());
    place(gp, panel);
    put_footing(gp, panel, "x [m]");
    put_text(gp, fmt::format("y [m]   mode {}: {}", k + 1, figures.modes[index].why),
             {left - 30.0, top + 13.0});
    std::vector<std::string> curves = draw_bodies(
        gp, figures.rest, View{}, {fmt::format("rest{}", k), "#c4c4c4", margin * metres_per_pixel});
    for (std::string& curve :
         draw_bodies(gp, figures.modes[index], View{},
                     {fmt::format("mode{}", k), colour(index), margin * metres_per_pixel})) {
      curves.push_back(std::move(curve));
    }
    gp.plot(curves);
  }
}

}  // namespace boxbeam::plot
