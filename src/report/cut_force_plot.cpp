#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam_outline.hpp"
#include "boxbeam/report/format.hpp"

namespace boxbeam::plot {
namespace {

constexpr double panel_height = 116.0;

/// What the lines are, which their values name by number.
std::vector<LegendEntry> legend_of(const Verification& verification) {
  std::vector<LegendEntry> legend{{"envelope of all instants", "lw 9 lc rgb '#dcdcdc'"}};
  for (std::size_t k = 0; k < verification.pictures.lines.size(); ++k) {
    const CutForceLine& line = verification.pictures.lines[k];
    legend.push_back(
        {fmt::format("({}) {}, {}", k + 1, time_label(line.time), line.why), line_style(k, 1.8)});
  }
  return legend;
}

std::vector<Row2> rows_of(const CutForceLine& line, cut_force::Index which) {
  std::vector<Row2> rows;
  for (std::size_t i = 0; i < line.stations.size(); ++i) {
    rows.emplace_back(line.stations[i].s.value(), 1e-3 * value_of(line.values[i], which));
  }
  return rows;
}

bool lower(const Row2& one, const Row2& other) { return std::get<1>(one) < std::get<1>(other); }

/// A value to be written.
struct Named {
  Row2 at;
  std::string text;
  const char* colour;
};

/// The highest and the lowest value of every line and of the envelope, the largest first.
std::vector<Named> extremes_of(const Verification& verification, cut_force::Index which,
                               double span) {
  std::vector<Named> extremes;
  const auto add = [&](const Row2& at, const std::string& suffix, const char* ink) {
    const double value = std::get<1>(at);
    if (std::abs(value) < 0.03 * span || std::abs(value) < 1e-9) return;
    extremes.push_back({at, text::significant(value) + suffix, ink});
  };
  for (std::size_t k = 0; k < verification.pictures.lines.size(); ++k) {
    const std::vector<Row2> rows = rows_of(verification.pictures.lines[k], which);
    const std::string suffix = fmt::format(" ({})", k + 1);
    add(*std::max_element(rows.begin(), rows.end(), lower), suffix, colour(k));
    add(*std::min_element(rows.begin(), rows.end(), lower), suffix, colour(k));
  }
  std::stable_sort(extremes.begin(), extremes.end(), [](const Named& one, const Named& other) {
    return std::abs(std::get<1>(one.at)) > std::abs(std::get<1>(other.at));
  });
  const auto reached = [&](const Row2& at) {
    return std::any_of(extremes.begin(), extremes.end(), [&](const Named& other) {
      return std::abs(std::get<1>(at) - std::get<1>(other.at)) < 0.02 * span;
    });
  };
  const std::vector<Row2> high = rows_of(verification.pictures.envelope[1], which);
  const std::vector<Row2> low = rows_of(verification.pictures.envelope[0], which);
  const Row2 highest = *std::max_element(high.begin(), high.end(), lower);
  const Row2 lowest = *std::min_element(low.begin(), low.end(), lower);
  for (const Row2& at : {highest, lowest}) {
    if (!reached(at)) add(at, "", "#606060");
  }
  return extremes;
}

/// What the ordinate of a diagram is, and where it pulls.
std::string heading_of(const CutForceName& name) {
  std::string title = axis_title(name);
  if (std::string(name.name) == "M") return title + ", drawn on the side in tension";
  if (name.which == cut_force::M_y) return title + ", positive: tension at +z";
  if (name.which == cut_force::M_z) return title + ", positive: tension at -y";
  return title;
}

void draw_panel(Script& gp, const Project& project, const Verification& verification,
                const CutForceName& name, const Frame& frame, bool lowest) {
  const cut_force::Index which = name.which;
  const std::string symbol = name.name;
  const std::vector<Row2> low = rows_of(verification.pictures.envelope[0], which);
  const std::vector<Row2> high = rows_of(verification.pictures.envelope[1], which);
  std::vector<Row3> band;
  for (std::size_t i = 0; i < low.size(); ++i) {
    band.emplace_back(std::get<0>(low[i]), std::get<1>(low[i]), std::get<1>(high[i]));
  }
  gp.block("band_" + symbol, band);
  const double bottom = std::get<1>(*std::min_element(low.begin(), low.end(), lower));
  const double top = std::get<1>(*std::max_element(high.begin(), high.end(), lower));
  const auto [s_low, s_high] = range_of_s(project.beam);
  const auto [y_low, y_high] = range_with_zero(bottom, top, 0.2);
  const Panel panel{frame, s_low, s_high, y_low, y_high};
  place(gp, panel);
  put_heading(gp, panel, heading_of(name));
  if (lowest) put_footing(gp, panel, "s [m], from the start of the beam");
  std::vector<std::string> curves{
      fmt::format("$band_{} using 1:2:3 with filledcurves fc rgb '#e2e2e2'", symbol),
      "0 with lines lc rgb '#505050' lw 0.9"};
  Labels labels;
  for (std::size_t k = 0; k < verification.pictures.lines.size(); ++k) {
    const std::vector<Row2> rows = rows_of(verification.pictures.lines[k], which);
    gp.block(fmt::format("{}_{}", symbol, k), rows);
    curves.push_back(fmt::format("${}_{} using 1:2 with lines {}", symbol, k, line_style(k, 1.8)));
    labels.keep_off(panel, rows);
  }
  labels.keep_off(panel.at(s_low, 0.0), panel.at(s_high, 0.0));
  for (const Named& extreme : extremes_of(verification, which, top - bottom)) {
    const auto [x, y] = extreme.at;
    labels.put(gp, extreme.text, panel.at(x, y), frame, extreme.colour, 4.0);
  }
  gp.plot(curves);
}

/// The axis of s below the lowest panel only.
void show_s(Script& gp, bool shown) { gp << (shown ? "set format x '%g'\n" : "set format x ''\n"); }

const CutForceName& name_of(const Project& project, cut_force::Index which) {
  const auto names = cut_forces_looked_at(project);
  return *std::find_if(names.begin(), names.end(),
                       [&](const CutForceName& of) { return of.which == which; });
}

/// Diagrams below each other, the beam above them.
struct Column {
  Plane plane;
  std::vector<cut_force::Index> forces;
  double left, right;
};

void draw_columns(Script& gp, const Project& project, const Verification& verification,
                  const std::vector<Column>& columns) {
  const std::vector<LegendEntry> legend = legend_of(verification);
  const double below = footing_room + height_of_legend(legend);
  gp.begin("cut-forces", below + 3.0 * (panel_height + heading_room) + outline_height + 40.0);
  for (const Column& column : columns) {
    double top = gp.height() - 40.0;
    show_s(gp, false);
    draw_outline(gp, project, verification, column.plane,
                 {column.left, top - outline_height, column.right, top});
    top -= outline_height;
    for (const cut_force::Index which : column.forces) {
      top -= heading_room;
      show_s(gp, which == column.forces.back());
      if (which == column.forces.back() && &column == &columns.back()) draw_legend(gp, legend, 2.0);
      const CutForceName& name = name_of(project, which);
      draw_panel(gp, project, verification, name,
                 {column.left, top - panel_height, column.right, top},
                 which == column.forces.back());
      top -= panel_height;
    }
  }
}

}  // namespace

void cut_forces(Script& gp, const Project& project, const Verification& verification) {
  draw_columns(gp, project, verification,
               {{Plane::xz, {cut_force::N, cut_force::V_z, cut_force::M_y}, 56.0, 600.0}});
}

void cut_forces_in_space(Script& gp, const Project& project, const Verification& verification) {
  // A column for each plane of the beam: its border, then what acts in that plane.
  draw_columns(gp, project, verification,
               {{Plane::xz, {cut_force::N, cut_force::V_z, cut_force::M_y}, 56.0, 300.0},
                {Plane::xy, {cut_force::T, cut_force::V_y, cut_force::M_z}, 356.0, 600.0}});
}

}  // namespace boxbeam::plot
