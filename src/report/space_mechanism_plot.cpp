#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/format.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::plot {
namespace {

constexpr double title_row = 16.0;

/// When and why a posture is shown, in lines of the whole width.
std::vector<std::string> title_of(const PostureFigure& posture, std::size_t number) {
  return wrapped(fmt::format("({}) {}:  {}", number, time_label(posture.time), posture.why),
                 figure_width - 20.0);
}

}  // namespace

void mechanism_in_space(Script& gp, const Project&, const Verification& verification) {
  // As on a drawing sheet: from the front, from the side, from above.
  struct Sheet {
    View view;
    const char* name;
    const char *across, *up;
  };
  static constexpr Sheet sheets[] = {{{0, 2}, "seen along y", "x [m]", "z [m]"},
                                     {{1, 2}, "seen along x", "y [m]", "z [m]"},
                                     {{0, 1}, "seen along z", "x [m]", "y [m]"}};
  constexpr double arrow = 44.0;
  constexpr double side = 152.0;  // of a frame
  constexpr double left_of_frame = 48.0, below_frame = footing_room, foot = 40.0;
  const std::size_t rows = verification.postures.size() - 1;
  std::size_t lines = 1;
  for (std::size_t k = 1; k <= rows; ++k) {
    lines = std::max(lines, title_of(verification.postures[k], k).size());
  }
  const double above_frame = 44.0 + title_row * static_cast<double>(lines);
  Extents extents = extents_of(verification);
  const double metres_per_pixel = extents.size().maxCoeff() / (side - 2.0 * 34.0);
  const double step = side + above_frame + below_frame;
  gp.begin("mechanism", foot + step * static_cast<double>(rows));
  const PostureFigure& first = verification.postures.front();
  put_text(gp,
           fitted("origin: the beam's joint;  grey: " + time_label(first.time, first.situation),
                  gp.width() - 20.0),
           {0.5 * gp.width(), foot - 12.0}, "center", "#505050");
  put_text(gp, "arrows: forces on the beam, the longest of each row its largest",
           {0.5 * gp.width(), foot - 29.0}, "center", "#505050");
  for (std::size_t k = 1; k <= rows; ++k) {
    const PostureFigure& posture = verification.postures[k];
    double largest_force = 1e-9;
    std::string sizes;
    for (const BeamLoadRow& row : posture.loads) {
      largest_force = std::max(largest_force, row.world.norm());
      sizes +=
          fmt::format("{}{} {}", sizes.empty() ? "" : ", ", row.name, text::kN(row.world.norm()));
    }
    const double top = gp.height() - above_frame - step * static_cast<double>(k - 1);
    const std::vector<std::string> title = title_of(posture, k);
    for (std::size_t i = 0; i < title.size(); ++i) {
      put_text(gp, title[i], {10.0, top + 32.0 + title_row * static_cast<double>(title.size() - i)},
               "left", colour(k - 1));
    }
    put_text(gp, fitted(sizes, gp.width() - 40.0), {30.0, top + 32.0});
    for (std::size_t j = 0; j < std::size(sheets); ++j) {
      const Sheet& sheet = sheets[j];
      const View& view = sheet.view;
      const double left = left_of_frame + (side + left_of_frame) * static_cast<double>(j);
      const Panel panel = panel_to_scale({left, top - side, left + side, top}, metres_per_pixel,
                                         extents.middle()[view.across], extents.middle()[view.up]);
      place(gp, panel);
      put_footing(gp, panel, sheet.across);
      put_text(gp, fmt::format("{}, {}", sheet.up, sheet.name), {left - 30.0, top + 14.0}, "left",
               "#505050");
      Labels labels;
      keep_off_bodies(labels, panel, posture, view);
      keep_off_bodies(labels, panel, first, view);
      const std::string name = fmt::format("{}_{}", k, j);
      std::vector<std::string> curves = draw_traces(gp, verification, view, "trace" + name);
      const auto add = [&](const PostureFigure& of, const std::string& prefix, const char* ink) {
        const Ink look{prefix + name, ink, 0.4 * arrow * metres_per_pixel};
        for (std::string& curve : draw_bodies(gp, of, view, look)) {
          curves.push_back(std::move(curve));
        }
      };
      add(first, "rest", "#c4c4c4");
      add(posture, "at", colour(k - 1));
      draw_loads(gp, labels, panel, posture, view, arrow / largest_force, false);
      gp.plot(curves);
    }
  }
}

}  // namespace boxbeam::plot
