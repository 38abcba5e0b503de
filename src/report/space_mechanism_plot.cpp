#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::plot {
namespace {

constexpr double arrow = 44.0;  ///< the longest of an instant [px]
constexpr double left_of_frame = 48.0, below_frame = footing_room, foot = 40.0;
constexpr std::size_t most_instants = 3;

/// A view as on a drawing sheet.
struct Sheet {
  View view;
  const char* name;
  const char *across, *up;
};

/// The two of three views that show most: together they have all coordinates.
std::array<Sheet, 2> sheets_of(const Extents& extents) {
  static constexpr Sheet front{{0, 2}, "seen along y", "x [m]", "z [m]"};
  static constexpr Sheet side{{1, 2}, "seen along x", "y [m]", "z [m]"};
  static constexpr Sheet above{{0, 1}, "seen along z", "x [m]", "y [m]"};
  const Eigen::Vector3d size = extents.size();
  const double of_front = size.x() * size.z();
  const double of_side = size.y() * size.z();
  const double of_above = size.x() * size.y();
  if (of_above <= std::min(of_front, of_side)) return {front, side};
  if (of_side <= of_front) return {front, above};
  return {above, side};
}

/// The most telling instants, in order, by their number among all that are critical.
std::vector<std::size_t> instants_of(const Verification& verification) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 1; k < verification.postures.size(); ++k) numbers.push_back(k);
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return verification.postures[a].weight > verification.postures[b].weight;
  });
  numbers.resize(std::min(numbers.size(), most_instants));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

double largest_force_of(const PostureFigure& posture) {
  double largest = 1e-9;
  for (const BeamLoadRow& row : posture.loads) largest = std::max(largest, row.world.norm());
  return largest;
}

/// The corners of a view at a scale [px], with arrows and their names, from the origin.
Frame drawn_extent(const Verification& verification, const std::vector<std::size_t>& shown,
                   const Extents& extents, const View& view, double metres_per_pixel) {
  constexpr double margin = 12.0;
  const Eigen::Vector3d low = extents.low / metres_per_pixel;
  const Eigen::Vector3d high = extents.high / metres_per_pixel;
  Frame frame{low[view.across] - margin, low[view.up] - margin, high[view.across] + margin,
              high[view.up] + margin};
  for (const std::size_t k : shown) {
    const PostureFigure& posture = verification.postures[k];
    const double length = arrow / largest_force_of(posture);
    for (const BeamLoadRow& row : posture.loads) {
      const Eigen::Vector3d tail = row.place / metres_per_pixel - length * row.world;
      const double name = std::min(text_width(row.name), longest_load_name) + 4.0;
      const double side = row.world[view.across] > 0.0 ? -1.0 : 1.0;
      frame.left = std::min(frame.left, tail[view.across] + std::min(0.0, side * name));
      frame.right = std::max(frame.right, tail[view.across] + std::max(0.0, side * name));
      frame.bottom = std::min(frame.bottom, tail[view.up] - text_line);
      frame.top = std::max(frame.top, tail[view.up] + text_line);
    }
  }
  return frame;
}

/// How the frames stand, all on one scale: a row or a column for each instant, the views of it
/// beside or below each other.
struct Layout {
  bool instant_is_column = false;
  double metres_per_pixel = 1.0;
  std::array<double, 2> across{}, up{};     ///< middles of the views [m]
  std::array<double, 2> width{}, height{};  ///< of their frames [px]
};

constexpr double name_row = 18.0;  ///< number and time of an instant above its frames
constexpr double view_row = 22.0;  ///< the name of a view above its frame
constexpr double highest = 650.0;  ///< of the figure: on paper a higher one would be shrunk

/// The layout with the largest scale.
Layout layout_of(const Verification& verification, const std::vector<std::size_t>& shown,
                 const Extents& extents, const std::array<Sheet, 2>& sheets, double below) {
  const auto count = static_cast<double>(std::max<std::size_t>(shown.size(), 1));
  const auto drawn = [&](double scale) {
    return std::array{drawn_extent(verification, shown, extents, sheets[0].view, scale),
                      drawn_extent(verification, shown, extents, sheets[1].view, scale)};
  };
  Layout best;
  for (const bool column : {false, true}) {
    const double columns = column ? count : 2.0;
    const double rows = column ? 2.0 : count;
    const double room_across = figure_width - 12.0 - columns * left_of_frame;
    const double room_up =
        highest - below - rows * (view_row + below_frame) - (column ? 1.0 : count) * name_row;
    const auto sizes_of = [&](double scale) {
      constexpr double least = 70.0, narrowest = 100.0;
      const auto at = drawn(scale);
      Layout layout{column, scale, {}, {}, {}, {}};
      for (std::size_t j = 0; j < 2; ++j) {
        layout.width[j] = std::max(at[j].right - at[j].left, narrowest);
        layout.height[j] = std::max(at[j].top - at[j].bottom, least);
        layout.across[j] = 0.5 * (at[j].left + at[j].right) * scale;
        layout.up[j] = 0.5 * (at[j].bottom + at[j].top) * scale;
      }
      auto& same = column ? layout.width : layout.height;
      same[0] = same[1] = std::max(same[0], same[1]);
      return layout;
    };
    const auto across_of = [&](const Layout& of) {
      return column ? count * of.width[0] : of.width[0] + of.width[1];
    };
    const auto up_of = [&](const Layout& of) {
      return column ? of.height[0] + of.height[1] : count * of.height[0];
    };
    // The finest scale that fits, between one far too fine and one at which arrows alone fill it.
    double fine = 1e-3 * extents.size().maxCoeff() / figure_width;
    double coarse = 1e6 * fine;
    for (int i = 0; i < 60; ++i) {
      const double middle = std::sqrt(fine * coarse);
      const Layout at = sizes_of(middle);
      (across_of(at) <= room_across && up_of(at) <= room_up ? coarse : fine) = middle;
    }
    Layout layout = sizes_of(coarse);
    const double spare = std::max(0.0, room_across - across_of(layout)) / columns;
    for (double& width : layout.width) width += spare;
    if (best.width[0] == 0.0 || coarse < best.metres_per_pixel) best = layout;
  }
  return best;
}

/// Below the frames: of each instant when and why it is shown, and its loads.
std::vector<LegendEntry> legend_of(const Verification& verification,
                                   const std::vector<std::size_t>& shown, double least_couple) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PostureFigure& posture = verification.postures[shown[i]];
    std::string text = fmt::format("({}) {}", shown[i], posture.why);
    for (const BeamLoadRow& row : posture.loads) {
      text += fmt::format("{} {} {}", &row == &posture.loads.front() ? ":" : ",", row.name,
                          text::kN(row.world.norm()));
      if (row.couple.norm() > least_couple) text += " and " + text::kNm(row.couple.norm());
    }
    entries.push_back({text, fmt::format("lw 4 lc rgb '{}'", colour(i))});
  }
  return entries;
}

}  // namespace

void mechanism_in_space(Script& gp, const Project&, const Verification& verification) {
  const std::vector<std::size_t> shown = instants_of(verification);
  const Extents extents = extents_of(verification);
  const std::array<Sheet, 2> sheets = sheets_of(extents);
  const double least_couple = least_couple_of(verification);
  const std::vector<LegendEntry> legend = legend_of(verification, shown, least_couple);
  const double below = foot + height_of_legend(legend);
  const Layout layout = layout_of(verification, shown, extents, sheets, below);
  const auto count = static_cast<double>(shown.size());
  const bool column = layout.instant_is_column;
  const double row_height = name_row + view_row + layout.height[0] + below_frame;
  const double height =
      column ? row_height + view_row + layout.height[1] + below_frame : count * row_height;
  gp.begin("mechanism", below + height);
  const PostureFigure& first = verification.postures.front();
  const std::size_t all = verification.postures.size() - 1;
  const std::string some =
      all > shown.size() ? fmt::format(";  {} of {} instants", shown.size(), all) : "";
  put_text(gp,
           fitted(fmt::format("origin: the beam's joint;  grey: {}{}",
                              time_label(first.time, first.situation), some),
                  gp.width() - 20.0),
           {0.5 * gp.width(), foot - 12.0}, "center", "#505050");
  put_text(gp, "arrows: loads on the beam, the longest of each instant its largest",
           {0.5 * gp.width(), foot - 29.0}, "center", "#505050");
  draw_legend(gp, legend, foot);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PostureFigure& posture = verification.postures[shown[i]];
    const auto step = static_cast<double>(i);
    for (std::size_t j = 0; j < sheets.size(); ++j) {
      const Sheet& sheet = sheets[j];
      double left = left_of_frame;
      double top = gp.height() - name_row - view_row;
      if (column) {
        left += step * (layout.width[0] + left_of_frame);
        if (j == 1) top -= layout.height[0] + below_frame + view_row;
      } else {
        if (j == 1) left += layout.width[0] + left_of_frame;
        top -= step * row_height;
      }
      if (j == 0) {
        put_text(gp,
                 fitted(fmt::format("({}) {}", shown[i], time_label(posture.time)),
                        layout.width[0] + 36.0),
                 {left - 40.0, top + view_row + 8.0}, "left", colour(i));
      }
      const Panel panel =
          panel_to_scale({left, top - layout.height[j], left + layout.width[j], top},
                         layout.metres_per_pixel, layout.across[j], layout.up[j]);
      place(gp, panel);
      put_footing(gp, panel, sheet.across);
      put_text(gp, fmt::format("{}, {}", sheet.up, sheet.name), {left - 40.0, top + 10.0}, "left",
               "#505050");
      Labels labels;
      keep_off_bodies(labels, panel, posture, sheet.view);
      keep_off_bodies(labels, panel, first, sheet.view);
      const std::string name = fmt::format("{}_{}", i, j);
      std::vector<std::string> curves = draw_traces(gp, verification, sheet.view, "trace" + name);
      const auto add = [&](const PostureFigure& of, const std::string& prefix, const char* rgb) {
        const Ink look{prefix + name, rgb, 0.4 * arrow * layout.metres_per_pixel};
        for (std::string& curve : draw_bodies(gp, of, sheet.view, look)) {
          curves.push_back(std::move(curve));
        }
      };
      add(first, "rest", "#c4c4c4");
      add(posture, "at", colour(i));
      draw_loads(gp, labels, panel, posture, sheet.view,
                 {arrow / largest_force_of(posture), least_couple, false});
      gp.plot(curves);
    }
  }
}

}  // namespace boxbeam::plot
