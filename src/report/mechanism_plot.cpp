#include <fmt/format.h>

#include <algorithm>

#include "mechanism_drawing.hpp"

namespace boxbeam::plot {
namespace {

/// What the grey posture is, and how large displacements are drawn.
std::string grey_text(const Verification& verification) {
  const PostureFigure& first = verification.postures.front();
  if (first.magnified == 0.0) return "grey: " + time_label(first.time);
  return fmt::format("displacements {:g} times as large; grey: without load",
                     verification.postures.back().magnified);
}

}  // namespace

void mechanism(Script& gp, const Project&, const Verification& verification) {
  const std::size_t panels = verification.postures.size() - 1;
  const Extent extent = extent_of(verification.postures);
  const Eigen::Vector3d size = extent.high - extent.low;
  double largest_force = 0.0;
  for (std::size_t k = 1; k <= panels; ++k) {
    for (const BeamLoadRow& row : verification.postures[k].loads) {
      largest_force = std::max(largest_force, row.world.norm());
    }
  }
  const double reach = 0.16 * size.maxCoeff();  // the longest arrow
  // Tall mechanisms stand side by side, wide ones below each other.
  const bool tall = size.y() > size.x();
  const auto count = static_cast<int>(panels);
  // As large as the mechanism's shape asks for, with room for axes and arrows.
  const double aspect = (size.y() + 1.6 * reach) / (size.x() + 3.4 * reach);
  const int width = tall ? std::clamp(static_cast<int>(720.0 / aspect), 260, 640) + 90 : 900;
  const int height = tall ? 720 : std::clamp(static_cast<int>(820.0 * aspect), 160, 720) + 110;
  gp.begin("mechanism", tall ? width * count : width, tall ? 860 : 60 + height * count);
  gp << "set multiplot layout " << (tall ? 1 : count) << "," << (tall ? count : 1) << " title "
     << quoted("Mechanism at its critical instants, forces on the beam; " + grey_text(verification))
     << " noenhanced\n"
     << "set size ratio -1\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nunset key\n"
     << "set xrange [" << extent.low.x() - 1.7 * reach << ":" << extent.high.x() + 1.7 * reach
     << "]\n"
     << "set yrange [" << extent.low.y() - 0.8 * reach << ":" << extent.high.y() + 0.8 * reach
     << "]\n";
  for (std::size_t k = 1; k <= panels; ++k) {
    const PostureFigure& posture = verification.postures[k];
    const std::string ghost = draw_bodies(gp, verification.postures.front(), View{},
                                          {fmt::format("rest{}", k), "#c4c4c4", 0.5 * reach});
    const std::string bodies =
        draw_bodies(gp, posture, View{}, {fmt::format("at{}", k), colour(k - 1), 0.5 * reach});
    draw_loads(gp, posture, View{}, reach / std::max(largest_force, 1e-9), true);
    gp << "set title \"" << time_label(posture.time) << "\\n"
       << posture.why << "\"\n"
       << "plot " << ghost << ", " << bodies << "\nunset label\nunset arrow\n";
  }
  gp << "unset multiplot\n";
}

}  // namespace boxbeam::plot
