#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/format.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::plot {

void mechanism_in_space(Script& gp, const Project&, const Verification& verification) {
  // As on a drawing sheet: from the front, from the side, from above.
  struct Sheet {
    View view;
    const char* name;
    const char *across, *up;
  };
  static constexpr Sheet sheets[] = {{{0, 2}, "along y", "x [m]", "z [m]"},
                                     {{1, 2}, "along x", "y [m]", "z [m]"},
                                     {{0, 1}, "along z", "x [m]", "y [m]"}};
  const std::size_t rows = verification.postures.size() - 1;
  const Extent extent = extent_of(verification.postures);
  const double largest_size = (extent.high - extent.low).maxCoeff();
  const double reach = 0.3 * largest_size;  // the longest arrow
  const double half = 0.5 * largest_size + 1.2 * reach;
  const Eigen::Vector3d middle = 0.5 * (extent.low + extent.high);

  const double height = 75.0 + 400.0 * static_cast<double>(rows);
  gp.begin("mechanism", 1120, static_cast<int>(height));
  gp << "set multiplot layout " << rows << ",3 margins 0.068,0.985," << 62.0 / height << ","
     << 1.0 - 85.0 / height << " spacing 0.065," << 88.0 / height << " title "
     << quoted(
            "Bodies from the beam's joint on at the critical instants; forces on the beam, the "
            "longest arrow of each row its largest; grey: " +
            time_label(verification.postures.front().time, verification.postures.front().situation))
     << " noenhanced\n"
     << "set size ratio -1\nunset key\nset xtics autofreq\n";
  for (std::size_t k = 1; k <= rows; ++k) {
    const PostureFigure& posture = verification.postures[k];
    double largest_force = 1e-9;
    std::string sizes;
    for (const BeamLoadRow& row : posture.loads) {
      largest_force = std::max(largest_force, row.world.norm());
      sizes +=
          fmt::format("{}{} {}", sizes.empty() ? "" : ", ", row.name, text::kN(row.world.norm()));
    }
    for (const Sheet& sheet : sheets) {
      const View& view = sheet.view;
      const std::string name = fmt::format("{}_{}{}", k, view.across, view.up);
      const std::string ghost = draw_bodies(gp, verification.postures.front(), view,
                                            {"rest" + name, "#c4c4c4", 0.4 * reach});
      const std::string bodies =
          draw_bodies(gp, posture, view, {"at" + name, colour(k - 1), 0.4 * reach});
      draw_loads(gp, posture, view, reach / largest_force, false);
      const bool first = &sheet == &sheets[0];
      gp << "set xlabel '" << sheet.across << "' offset 0,0.4\nset ylabel '" << sheet.up
         << "' offset 0.8,0\n"
         << "set xrange [" << middle[view.across] - half << ":" << middle[view.across] + half
         << "]\nset yrange [" << middle[view.up] - half << ":" << middle[view.up] + half << "]\n";
      if (first) {
        gp << "set label 1000 "
           << quoted(fmt::format("{}   {}   {}", time_label(posture.time), posture.why, sizes))
           << " at graph 0,1.13 left noenhanced\n";
      }
      gp << "set title 'seen " << sheet.name << "' offset 0,-0.6\n"
         << "plot " << ghost << ", " << bodies << "\nunset label\nunset arrow\n";
    }
  }
  gp << "unset multiplot\n";
}

}  // namespace boxbeam::plot
