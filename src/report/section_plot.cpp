#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "ink.hpp"

namespace boxbeam::plot {
namespace {

/// Checked places that are one place, and their numbers in the list.
struct Spot {
  double y = 0.0, z = 0.0;  ///< [mm]
  std::string numbers;
  bool governs = false;
};

std::vector<Spot> spots_of(const std::vector<SectionFigure::Point>& points, std::size_t most,
                           double near) {
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < std::min(most, points.size()); ++i) {
    const double y = 1e3 * points[i].y;
    const double z = 1e3 * points[i].z;
    const auto known = std::find_if(spots.begin(), spots.end(), [&](const Spot& spot) {
      return std::hypot(spot.y - y, spot.z - z) < near;
    });
    if (known == spots.end()) {
      spots.push_back({y, z, std::to_string(i + 1), points[i].governs});
    } else {
      known->numbers += fmt::format(", {}", i + 1);
      known->governs = known->governs || points[i].governs;
    }
  }
  return spots;
}

constexpr const char* section_ink = "#303030";

/// Material grey, hollows white, in the order of their area.
void draw_material(Drawing& drawing, const SectionFigure& figure, const Panel& panel) {
  for (const auto& loop : figure.outlines) {
    Line line{{}, {section_ink, 1.1, {}, "#ffffff", "outline"}, true};
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [y, z] = loop[i];
      const auto& [y_next, z_next] = loop[(i + 1) % loop.size()];
      line.points.push_back(panel.at(1e3 * y, 1e3 * z));
      twice += y * z_next - y_next * z;
    }
    if (twice > 0.0) line.pen.fill = "#d5dde6";
    drawing.shapes.emplace_back(std::move(line));
  }
  for (const SectionFigure::Hole& hole : figure.holes) {
    Line line{{}, {section_ink, 1.0, {}, "#ffffff", "outline"}, true};
    for (const auto& [across, up] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      line.points.push_back(
          panel.at(1e3 * (hole.y + across * hole.width), 1e3 * (hole.z + up * hole.height)));
    }
    drawing.shapes.emplace_back(std::move(line));
  }
  for (const SectionFigure::Weld& weld : figure.welds) {
    const Pixel at = panel.at(1e3 * weld.y, 1e3 * weld.z);
    drawing.shapes.emplace_back(
        Line{{at + Pixel(0.0, 4.5), at + Pixel(-4.5, -2.5), at + Pixel(4.5, -2.5)},
             {"", 1.0, {}, section_ink, "weld"},
             true});
  }
}

void put_dot(Drawing& drawing, const Pixel& at, bool governs) {
  drawing.shapes.emplace_back(
      Dot{at, governs ? 4.3 : 2.9, {"", 1.0, {}, colour(governs ? 1 : 0), "place"}});
}

struct Range {
  double low = 1e300, high = -1e300;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// With few digits, so that the numbers of a list stand below each other.
std::string in_percent(double share) {
  return fmt::format("{:.{}f} %", 100.0 * share, share < 0.9995 ? 1 : 0);
}

/// In two columns.
std::size_t rows_of_list(std::size_t shown) { return (shown + 1) / 2; }

/// What is checked, in two columns below the drawing.
void draw_list(Drawing& drawing, const SectionFigure& figure, std::size_t shown, double top) {
  const std::size_t rows = std::max<std::size_t>(1, rows_of_list(shown));
  for (std::size_t i = 0; i < shown; ++i) {
    const SectionFigure::Point& point = figure.points[i];
    const double left = i < rows ? 14.0 : 318.0;
    const double y = top - 17.0 * static_cast<double>(i % rows);
    const std::string ink = point.governs ? colour(1) : "#202020";
    const bool stressed = std::abs(point.stress) > 1.0;  // else it is checked for shear alone
    put_text(drawing, fmt::format("{}", i + 1), {left + 16.0, y}, Anchor::right, ink);
    put_text(drawing, fitted(point.name, 136.0), {left + 24.0, y}, Anchor::left, ink);
    put_text(drawing, stressed ? text::MPa(point.stress) : "shear", {left + 236.0, y},
             Anchor::right, ink);
    put_text(drawing, in_percent(point.utilisation), {left + 292.0, y}, Anchor::right, ink);
  }
}

void draw_section(Drawing& drawing, const SectionFigure& figure, const Panel& panel,
                  std::size_t shown) {
  put_axes(drawing, panel);
  put_heading(drawing, panel, "z [mm], seen along the beam");
  // +y is left when looking along +x.
  put_footing(drawing, panel, "y [mm]");
  const double near =
      4.0 * std::abs(panel.x_high - panel.x_low) / (panel.frame.right - panel.frame.left);
  draw_material(drawing, figure, panel);
  Labels labels;
  for (const auto& loop : figure.outlines) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [y_a, z_a] = loop[i];
      const auto& [y_b, z_b] = loop[(i + 1) % loop.size()];
      labels.keep_off(panel.at(1e3 * y_a, 1e3 * z_a), panel.at(1e3 * y_b, 1e3 * z_b));
    }
  }
  const std::vector<Spot> spots = spots_of(figure.points, shown, near);
  for (const Spot& spot : spots) {
    const Pixel at = panel.at(spot.y, spot.z);
    put_dot(drawing, at, spot.governs);
    labels.keep_free({at.x() - 4.0, at.y() - 4.0, at.x() + 4.0, at.y() + 4.0});
  }
  for (const Spot& spot : spots) {
    labels.put(drawing, spot.numbers, panel.at(spot.y, spot.z), panel.frame,
               colour(spot.governs ? 1 : 0), 7.0);
  }
}

void draw_stress(Drawing& drawing, const SectionFigure& figure, const Panel& panel) {
  put_axes(drawing, panel, false);
  put_heading(drawing, panel, "highest and lowest over the height");
  put_footing(drawing, panel, "nominal stress [MPa]");
  Line high{{}, {colour(0), 1.6}};
  Line low{{}, {colour(2), 1.6, {4.8, 4.8}}};
  for (const SectionFigure::Level& level : figure.across) {
    high.points.push_back(panel.at(1e-6 * level.highest, 1e3 * level.z));
    low.points.push_back(panel.at(1e-6 * level.lowest, 1e3 * level.z));
  }
  Line band{high.points, {"", 1.0, {}, "#e2e2e2", "band"}, true};
  band.points.insert(band.points.end(), low.points.rbegin(), low.points.rend());
  drawing.shapes.emplace_back(std::move(band));
  Labels labels;
  labels.keep_off(high.points);
  labels.keep_off(low.points);
  const Pixel zero_low = panel.at(0.0, panel.y_low);
  const Pixel zero_high = panel.at(0.0, panel.y_high);
  put_line(drawing, zero_low, zero_high, {quiet_ink, 0.9});
  labels.keep_off(zero_low, zero_high);
  drawing.shapes.emplace_back(std::move(high));
  drawing.shapes.emplace_back(std::move(low));
  const auto governing = std::find_if(figure.points.begin(), figure.points.end(),
                                      [](const auto& point) { return point.governs; });
  put_dot(drawing, panel.at(1e-6 * governing->stress, 1e3 * governing->z), true);
  const auto put = [&](double stress, double z, const std::string& ink, const std::string& suffix) {
    labels.put(drawing, text::significant(1e-6 * stress) + suffix, panel.at(1e-6 * stress, 1e3 * z),
               panel.frame, ink, 6.0);
  };
  put(governing->stress, governing->z, colour(1), " (1)");
  const auto end = [&](const SectionFigure::Level& level) {
    const double near = 1e-3 * std::abs(governing->stress);
    const bool at_governing = std::abs(level.z - governing->z) < 1e-9;
    if (!at_governing || std::abs(level.highest - governing->stress) > near)
      put(level.highest, level.z, colour(0), "");
    if (!at_governing || std::abs(level.lowest - governing->stress) > near)
      put(level.lowest, level.z, colour(2), "");
  };
  end(figure.across.front());
  end(figure.across.back());
}

}  // namespace

Drawing section(const Project& project, const Verification& verification) {
  const SectionFigure& figure = *verification.pictures.section;
  Range y, z, stress;
  for (const auto& loop : figure.outlines) {
    for (const auto& [y_at, z_at] : loop) {
      y.take(1e3 * y_at);
      z.take(1e3 * z_at);
    }
  }
  stress.take(0.0);
  for (const SectionFigure::Level& level : figure.across) {
    stress.take(1e-6 * level.highest);
    stress.take(1e-6 * level.lowest);
  }
  for (const SectionFigure::Point& point : figure.points) {
    if (point.governs) stress.take(1e-6 * point.stress);
  }
  constexpr std::size_t most = 20;
  const std::size_t shown = std::min(most, figure.points.size());
  const double list = 17.0 * static_cast<double>(rows_of_list(shown)) + 24.0;
  // To scale, with room for numbers around it.
  constexpr double width = 296.0, room = 30.0, highest = 380.0;
  const double scale =
      std::max((y.high - y.low) / (width - 2.0 * room), (z.high - z.low) / (highest - 2.0 * room));
  const double height = std::max(150.0, (z.high - z.low) / scale + 2.0 * room);
  const double below = list + footing_room + 4.0;
  Drawing drawing{figure_width, below + height + 50.0, {}};
  const double y_middle = 0.5 * (y.low + y.high);
  const double z_middle = 0.5 * (z.low + z.high);
  const double half_y = 0.5 * scale * width;
  const double half_z = 0.5 * scale * height;
  const std::string situation = figure.situation.empty() ? "" : ", " + figure.situation;
  put_text(drawing,
           fitted(fmt::format("s = {} m at {}{}", to_text(figure.station), time_label(figure.time),
                              situation),
                  drawing.width - 24.0),
           {12.0, below + height + 34.0});
  put_text(drawing, "utilisation", {14.0 + 292.0, list - 6.0}, Anchor::right, quiet_ink);
  put_text(drawing, "stress then", {14.0 + 224.0, list - 6.0}, Anchor::right, quiet_ink);
  put_text(drawing, project.fatigue.published_step ? "" : "checked place", {38.0, list - 6.0},
           Anchor::left, quiet_ink);
  draw_list(drawing, figure, shown, list - 24.0);
  const Frame left{56.0, below, 56.0 + width, below + height};
  draw_section(drawing, figure,
               {left, y_middle + half_y, y_middle - half_y, z_middle - half_z, z_middle + half_z},
               shown);
  const double margin = 0.28 * (stress.high - stress.low);
  draw_stress(drawing, figure,
              {{412.0, below, 600.0, below + height},
               stress.low - margin,
               stress.high + margin,
               z_middle - half_z,
               z_middle + half_z});
  return drawing;
}

}  // namespace boxbeam::plot
