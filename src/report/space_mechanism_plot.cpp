#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "ink.hpp"
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
std::array<Sheet, 2> sheets_of(const Verification& verification) {
  const Sheet front{flat_view(0, 2), "seen along y", "x [m]", "z [m]"};
  const Sheet side{flat_view(1, 2), "seen along x", "y [m]", "z [m]"};
  const Sheet above{flat_view(0, 1), "seen along z", "x [m]", "y [m]"};
  const auto area = [&](const Sheet& sheet) {
    return room_of(verification, sheet.view).size().prod();
  };
  const double of_front = area(front);
  const double of_side = area(side);
  if (area(above) <= std::min(of_front, of_side)) return {front, side};
  if (of_side <= of_front) return {front, above};
  return {above, side};
}

/// The most telling instants, at most so many, in order, by their number among all that are
/// critical.
std::vector<std::size_t> instants_of(const Verification& verification, std::size_t most) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 1; k < verification.pictures.postures.size(); ++k) numbers.push_back(k);
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return verification.pictures.postures[a].weight > verification.pictures.postures[b].weight;
  });
  numbers.resize(std::min(numbers.size(), most));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// The longest arrow of each instant is its largest force.
LoadInk look_of(const PostureFigure& posture, double least_couple) {
  LoadSizes sizes;
  sizes.take(posture);
  return {arrow / sizes.force(), least_couple, false};
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

/// The layout with the largest scale for what two views must show of so many instants.
Layout layout_of(const std::array<Room, 2>& rooms, std::size_t instants, double below) {
  const auto count = static_cast<double>(std::max<std::size_t>(instants, 1));
  Layout best;
  for (const bool column : {false, true}) {
    const double columns = column ? count : 2.0;
    const double rows = column ? 2.0 : count;
    const double room_across = figure_width - 12.0 - columns * left_of_frame;
    const double room_up =
        highest - below - rows * (view_row + below_frame) - (column ? 1.0 : count) * name_row;
    const auto sizes_of = [&](double scale) {
      constexpr double least = 70.0, narrowest = 100.0;
      const std::array at{rooms[0].at(scale), rooms[1].at(scale)};
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
    const double size = std::max(rooms[0].size().maxCoeff(), rooms[1].size().maxCoeff());
    const double scale = finest_scale(size, [&](double metres_per_pixel) {
      const Layout at = sizes_of(metres_per_pixel);
      return across_of(at) <= room_across && up_of(at) <= room_up;
    });
    Layout layout = sizes_of(scale);
    const double spare = std::max(0.0, room_across - across_of(layout)) / columns;
    for (double& width : layout.width) width += spare;
    if (best.width[0] == 0.0 || scale < best.metres_per_pixel) best = layout;
  }
  return best;
}

/// Below the frames: of each instant when and why it is shown, and its loads.
std::vector<LegendEntry> legend_of(const Verification& verification,
                                   const std::vector<std::size_t>& shown, double least_couple) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PostureFigure& posture = verification.pictures.postures[shown[i]];
    std::string text = fmt::format("({}) {}", shown[i], posture.why);
    for (const BeamLoadRow& row : posture.loads) {
      text += fmt::format("{} {} {}", &row == &posture.loads.front() ? ":" : ",", row.name,
                          text::kN(row.world.norm()));
      if (row.couple.norm() > least_couple) text += " and " + text::kNm(row.couple.norm());
    }
    entries.push_back({text, "", "", {colour(i), 4.0}});
  }
  return entries;
}

/// What is shown, and how it stands.
struct Picture {
  std::vector<std::size_t> shown;
  std::vector<LegendEntry> legend;
  double below = 0.0;  ///< the frames [px]
  Layout layout;
};

Picture picture_of(const Verification& verification, std::array<Room, 2> rooms, double least_couple,
                   std::size_t most) {
  Picture of{instants_of(verification, most), {}, 0.0, {}};
  for (Room& room : rooms) {
    for (const std::size_t k : of.shown)
      room.take_loads(verification.pictures.postures[k],
                      look_of(verification.pictures.postures[k], least_couple));
  }
  of.legend = legend_of(verification, of.shown, least_couple);
  of.below = foot + height_of_legend(of.legend);
  of.layout = layout_of(rooms, of.shown.size(), of.below);
  return of;
}

}  // namespace

Drawing mechanism_in_space(const Project&, const Verification& verification) {
  const std::array<Sheet, 2> sheets = sheets_of(verification);
  const std::array rooms{room_of(verification, sheets[0].view),
                         room_of(verification, sheets[1].view)};
  const double size = std::max(rooms[0].size().maxCoeff(), rooms[1].size().maxCoeff());
  const double least_couple = load_sizes_of(verification).least_couple(size);
  // Fewer instants where so many leave no room for the mechanism.
  constexpr double readable = 40.0;  // [px]
  Picture picture;
  for (std::size_t most = most_instants; most > 0; --most) {
    picture = picture_of(verification, rooms, least_couple, most);
    if (size >= readable * picture.layout.metres_per_pixel) break;
  }
  const auto& [shown, legend, below, layout] = picture;
  const auto count = static_cast<double>(shown.size());
  const bool column = layout.instant_is_column;
  const double row_height = name_row + view_row + layout.height[0] + below_frame;
  const double height =
      column ? row_height + view_row + layout.height[1] + below_frame : count * row_height;
  Drawing drawing{figure_width, below + height, {}};
  const PostureFigure& first = verification.pictures.postures.front();
  const std::size_t all = verification.pictures.postures.size() - 1;
  const std::string some =
      all > shown.size() ? fmt::format(";  {} of {} instants", shown.size(), all) : "";
  const double middle = 0.5 * drawing.width;
  put_text(drawing,
           fitted(fmt::format("origin: the beam's joint;  grey: {}{}",
                              time_label(first.time, first.situation), some),
                  drawing.width - 20.0),
           {middle, foot - 12.0}, Anchor::middle, quiet_ink);
  put_text(drawing, "arrows: loads on the beam, the longest of each instant its largest",
           {middle, foot - 29.0}, Anchor::middle, quiet_ink);
  draw_legend(drawing, legend, foot);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PostureFigure& posture = verification.pictures.postures[shown[i]];
    const auto step = static_cast<double>(i);
    for (std::size_t j = 0; j < sheets.size(); ++j) {
      const Sheet& sheet = sheets[j];
      double left = left_of_frame;
      double top = drawing.height - name_row - view_row;
      if (column) {
        left += step * (layout.width[0] + left_of_frame);
        if (j == 1) top -= layout.height[0] + below_frame + view_row;
      } else {
        if (j == 1) left += layout.width[0] + left_of_frame;
        top -= step * row_height;
      }
      if (j == 0) {
        put_text(drawing,
                 fitted(fmt::format("({}) {}", shown[i], time_label(posture.time)),
                        layout.width[0] + 36.0),
                 {left - 40.0, top + view_row + 8.0}, Anchor::left, colour(i));
      }
      const Projection projection{
          sheet.view, panel_to_scale({left, top - layout.height[j], left + layout.width[j], top},
                                     layout.metres_per_pixel, {layout.across[j], layout.up[j]})};
      put_axes(drawing, projection.panel);
      put_footing(drawing, projection.panel, sheet.across);
      put_text(drawing, fmt::format("{}, {}", sheet.up, sheet.name), {left - 40.0, top + 10.0},
               Anchor::left, quiet_ink);
      Labels labels;
      keep_off_bodies(labels, posture, projection);
      keep_off_bodies(labels, first, projection);
      draw_traces(drawing, verification, projection);
      draw_bodies(drawing, first, projection, "#c4c4c4", 0.4 * arrow);
      draw_bodies(drawing, posture, projection, colour(i), 0.4 * arrow);
      draw_loads(drawing, labels, posture, projection, look_of(posture, least_couple));
    }
  }
  return drawing;
}

}  // namespace boxbeam::plot
