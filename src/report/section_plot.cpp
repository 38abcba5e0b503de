#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "canvas.hpp"

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

/// The outlines as one path: material grey, hollows white, in the order of their area.
std::vector<std::string> draw_material(Script& gp, const SectionFigure& figure) {
  std::vector<std::string> curves;
  for (std::size_t k = 0; k < figure.outlines.size(); ++k) {
    const auto& loop = figure.outlines[k];
    std::vector<Row2> rows;
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [y, z] = loop[i];
      const auto& [y_next, z_next] = loop[(i + 1) % loop.size()];
      rows.emplace_back(1e3 * y, 1e3 * z);
      twice += y * z_next - y_next * z;
    }
    rows.push_back(rows.front());
    const std::string data = fmt::format("loop{}", k);
    gp.block(data, rows);
    curves.push_back(fmt::format("${} using 1:2 with filledcurves closed fc rgb '{}'", data,
                                 twice > 0.0 ? "#d5dde6" : "#ffffff"));
    curves.push_back(fmt::format("${} using 1:2 with lines lw 1.1 lc rgb '#303030'", data));
  }
  for (const SectionFigure::Hole& hole : figure.holes) {
    gp << fmt::format(
        "set object rectangle center {},{} size {},{} front fs solid border lc rgb '#303030' "
        "fc rgb '#ffffff'\n",
        1e3 * hole.y, 1e3 * hole.z, 1e3 * hole.width, 1e3 * hole.height);
  }
  return curves;
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
void draw_list(Script& gp, const SectionFigure& figure, std::size_t shown, double top) {
  const std::size_t rows = std::max<std::size_t>(1, rows_of_list(shown));
  for (std::size_t i = 0; i < shown; ++i) {
    const SectionFigure::Point& point = figure.points[i];
    const double left = i < rows ? 14.0 : 318.0;
    const double y = top - 17.0 * static_cast<double>(i % rows);
    const char* ink = point.governs ? colour(1) : "#202020";
    const bool stressed = std::abs(point.stress) > 1.0;  // else it is checked for shear alone
    put_text(gp, fmt::format("{}", i + 1), {left + 16.0, y}, "right", ink);
    put_text(gp, fitted(point.name, 136.0), {left + 24.0, y}, "left", ink);
    put_text(gp, stressed ? text::MPa(point.stress) : "shear", {left + 236.0, y}, "right", ink);
    put_text(gp, in_percent(point.utilisation), {left + 292.0, y}, "right", ink);
  }
}

void draw_section(Script& gp, const SectionFigure& figure, const Panel& panel, std::size_t shown) {
  place(gp, panel);
  put_heading(gp, panel, "z [mm], seen along the beam");
  // +y is left when looking along +x.
  put_footing(gp, panel, "y [mm]");
  const double near =
      4.0 * std::abs(panel.x_high - panel.x_low) / (panel.frame.right - panel.frame.left);
  std::vector<std::string> curves = draw_material(gp, figure);
  Labels labels;
  for (const auto& loop : figure.outlines) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [y_a, z_a] = loop[i];
      const auto& [y_b, z_b] = loop[(i + 1) % loop.size()];
      labels.keep_off(panel.at(1e3 * y_a, 1e3 * z_a), panel.at(1e3 * y_b, 1e3 * z_b));
    }
  }
  std::vector<Row2> welds;
  for (const SectionFigure::Weld& weld : figure.welds) {
    welds.emplace_back(1e3 * weld.y, 1e3 * weld.z);
  }
  if (!welds.empty()) {
    gp.block("welds", welds);
    curves.push_back("$welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030'");
  }
  std::vector<Row2> places;
  std::vector<Row2> governing;
  const std::vector<Spot> spots = spots_of(figure.points, shown, near);
  for (const Spot& spot : spots) (spot.governs ? governing : places).emplace_back(spot.y, spot.z);
  if (!places.empty()) {
    gp.block("places", places);
    curves.push_back(
        fmt::format("$places using 1:2 with points pt 7 ps 0.6 lc rgb '{}'", colour(0)));
  }
  gp.block("governing", governing);
  curves.push_back(
      fmt::format("$governing using 1:2 with points pt 7 ps 0.9 lc rgb '{}'", colour(1)));
  for (const Spot& spot : spots) {
    const Pixel at = panel.at(spot.y, spot.z);
    labels.keep_free({at.x() - 4.0, at.y() - 4.0, at.x() + 4.0, at.y() + 4.0});
  }
  for (const Spot& spot : spots) {
    labels.put(gp, spot.numbers, panel.at(spot.y, spot.z), panel.frame,
               spot.governs ? colour(1) : colour(0), 7.0);
  }
  gp.plot(curves);
}

void draw_stress(Script& gp, const SectionFigure& figure, const Panel& panel) {
  place(gp, panel);
  put_heading(gp, panel, "highest and lowest over the height");
  put_footing(gp, panel, "nominal stress [MPa]");
  gp << "set format y ''\n";
  std::vector<Row2> high;
  std::vector<Row2> low;
  for (const SectionFigure::Level& level : figure.across) {
    high.emplace_back(1e-6 * level.highest, 1e3 * level.z);
    low.emplace_back(1e-6 * level.lowest, 1e3 * level.z);
  }
  std::vector<Row2> band = high;
  band.insert(band.end(), low.rbegin(), low.rend());
  band.push_back(band.front());
  gp.block("band", band);
  gp.block("high", high);
  gp.block("low", low);
  Labels labels;
  labels.keep_off(panel, high);
  labels.keep_off(panel, low);
  const Pixel zero_low = panel.at(0.0, panel.y_low);
  const Pixel zero_high = panel.at(0.0, panel.y_high);
  put_line(gp, zero_low, zero_high, "lw 0.9 lc rgb '#505050'");
  labels.keep_off(zero_low, zero_high);
  std::vector<std::string> curves{"$band using 1:2 with filledcurves closed fc rgb '#e2e2e2'",
                                  fmt::format("$high using 1:2 with lines {}", line_style(0, 1.6)),
                                  fmt::format("$low using 1:2 with lines {}", line_style(2, 1.6))};
  const auto governing = std::find_if(figure.points.begin(), figure.points.end(),
                                      [](const auto& point) { return point.governs; });
  gp.block("point", std::vector<Row2>{{1e-6 * governing->stress, 1e3 * governing->z}});
  curves.push_back(fmt::format("$point using 1:2 with points pt 7 ps 0.9 lc rgb '{}'", colour(1)));
  const auto put = [&](double stress, double z, const char* ink, const std::string& suffix) {
    labels.put(gp, text::significant(1e-6 * stress) + suffix, panel.at(1e-6 * stress, 1e3 * z),
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
  gp.plot(curves);
  gp << "set format y '%g'\n";
}

}  // namespace

void section(Script& gp, const Project& project, const Verification& verification) {
  const SectionFigure& figure = *verification.section;
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
  gp.begin("section", below + height + 50.0);
  const double y_middle = 0.5 * (y.low + y.high);
  const double z_middle = 0.5 * (z.low + z.high);
  const double half_y = 0.5 * scale * width;
  const double half_z = 0.5 * scale * height;
  const std::string situation = figure.situation.empty() ? "" : ", " + figure.situation;
  put_text(gp,
           fitted(fmt::format("s = {} m at {}{}", to_text(figure.station), time_label(figure.time),
                              situation),
                  gp.width() - 24.0),
           {12.0, below + height + 34.0});
  put_text(gp, "utilisation", {14.0 + 292.0, list - 6.0}, "right", "#505050");
  put_text(gp, "stress then", {14.0 + 224.0, list - 6.0}, "right", "#505050");
  put_text(gp, project.fatigue.published_step ? "" : "checked place", {38.0, list - 6.0}, "left",
           "#505050");
  draw_list(gp, figure, shown, list - 24.0);
  const Frame left{56.0, below, 56.0 + width, below + height};
  draw_section(gp, figure,
               {left, y_middle + half_y, y_middle - half_y, z_middle - half_z, z_middle + half_z},
               shown);
  const double margin = 0.28 * (stress.high - stress.low);
  draw_stress(gp, figure,
              {{412.0, below, 600.0, below + height},
               stress.low - margin,
               stress.high + margin,
               z_middle - half_z,
               z_middle + half_z});
}

}  // namespace boxbeam::plot
