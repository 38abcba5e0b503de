#include <fmt/format.h>

#include <algorithm>

#include "mechanism_drawing.hpp"

namespace boxbeam::plot {

void modes(Script& gp, const Project&, const Verification& verification) {
  const ElasticFigures& figures = *verification.elastic;
  const auto count = static_cast<int>(figures.modes.size());
  std::vector<PostureFigure> drawn = figures.modes;
  drawn.push_back(figures.rest);
  const Extent extent = extent_of(drawn);
  const Eigen::Vector3d size = extent.high - extent.low;
  const double margin = 0.08 * size.maxCoeff();
  const int columns = std::min(2, count);
  const int rows = (count + columns - 1) / columns;
  const double aspect = (size.y() + 2.0 * margin) / (size.x() + 2.0 * margin);
  constexpr int width = 500;
  const int height = std::clamp(static_cast<int>(430.0 * aspect), 140, 600) + 70;
  gp.begin("modes", width * columns, 50 + height * rows);
  gp << "set multiplot layout " << rows << "," << columns
     << " title 'Natural modes of the mechanism; grey: without load'\n"
     << "set size ratio -1\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nunset key\n"
     << "set xrange [" << extent.low.x() - margin << ":" << extent.high.x() + margin << "]\n"
     << "set yrange [" << extent.low.y() - margin << ":" << extent.high.y() + margin << "]\n";
  for (int k = 0; k < count; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const std::string rest =
        draw_bodies(gp, figures.rest, View{}, {fmt::format("rest{}", k), "#c4c4c4", margin});
    const std::string mode = draw_bodies(gp, figures.modes[index], View{},
                                         {fmt::format("mode{}", k), colour(index), margin});
    gp << "set title " << quoted(fmt::format("{}: {}", k + 1, figures.modes[index].why))
       << "\nplot " << rest << ", " << mode << "\n";
  }
  gp << "unset multiplot\n";
}

}  // namespace boxbeam::plot
