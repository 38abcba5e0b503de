#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "plot_script.hpp"

namespace boxbeam::plot {
namespace {

/// The beam's border in one of its planes: s [m] and the distance from the axis [mm].
struct Outline {
  const char* axis;  ///< "z" or "y"
  std::vector<Row2> upper, lower;
};

Outline outline_in_z(const TaperedBeam& beam) {
  Outline outline{"z", {}, {}};
  const auto add = [&](Length s, const Section& section) {
    const double half = 500.0 * height_of(section.outer).value();
    outline.upper.emplace_back(s.value(), half);
    outline.lower.emplace_back(s.value(), -half);
  };
  for (const Segment& segment : beam.segments) {
    add(segment.start, segment.from);
    add(segment.end(), segment.to);
  }
  return outline;
}

Outline outline_in_y(const TaperedBeam& beam) {
  Outline outline{"y", {}, {}};
  const auto add = [&](Length s, const Section& section) {
    const SectionProperties of = properties_of(section);
    outline.upper.emplace_back(s.value(), 1e3 * of.y_left.value());
    outline.lower.emplace_back(s.value(), 1e3 * of.y_right.value());
  };
  for (const Segment& segment : beam.segments) {
    add(segment.start, segment.from);
    add(segment.end(), segment.to);
  }
  return outline;
}

/// The legend of the whole figure, of curves that are not drawn where it stands.
std::string legend_of(const Verification& verification) {
  std::string legend = ", NaN with filledcurves fc rgb '#e9e9e9' title 'envelope'";
  for (std::size_t k = 0; k < verification.lines.size(); ++k) {
    legend += fmt::format(", NaN with lines lw 1.8 lc rgb '{}' title {}", colour(k),
                          quoted(time_label(verification.lines[k].time)));
  }
  return legend;
}

/// The same below all panels, which says also why an instant is shown.
std::vector<LegendEntry> legend_below(const Verification& verification) {
  std::vector<LegendEntry> legend{{"envelope", "lw 10 lc rgb '#e0e0e0'"}};
  for (std::size_t k = 0; k < verification.lines.size(); ++k) {
    const CutForceLine& line = verification.lines[k];
    legend.push_back({fmt::format("{}, {}", time_label(line.time), line.why),
                      fmt::format("lw 1.8 lc rgb '{}'", colour(k))});
  }
  return legend;
}

void draw_outline(Script& gp, const Project& project, const Outline& border,
                  const std::string& legend) {
  std::vector<Row2> outline = border.upper;
  outline.insert(outline.end(), border.lower.rbegin(), border.lower.rend());
  outline.push_back(outline.front());
  const std::string data = fmt::format("outline_{}", border.axis);
  gp.block(data, outline);
  double tallest = 0.0;
  for (const Row2& row : outline) tallest = std::max(tallest, std::get<1>(row));
  gp << "set ylabel 'beam " << border.axis << " [mm]'\nset yrange [" << -1.6 * tallest << ":"
     << 1.9 * tallest << "]\n"
     << "set ytics " << (tallest > 300 ? "500" : (tallest > 100 ? "100" : "autofreq")) << "\n";
  int label = 0;
  for (const BeamPoint& point : project.beam.points) {
    gp << "set label " << ++label << " " << quoted(point.name) << " at " << point.s.value() << ","
       << 1.25 * tallest << " center noenhanced\n";
    gp << "set arrow " << label << " from " << point.s.value() << "," << 1.15 * tallest << " to "
       << point.s.value() << "," << -1.15 * tallest << " nohead lc rgb '#909090' dt 3\n";
  }
  gp << "plot $" << data << " using 1:2 with filledcurves closed fc rgb '#dde6ef' notitle, $"
     << data << " using 1:2 with lines lc rgb '#505050' lw 1.5 notitle" << legend
     << "\nunset key\nunset label\nunset arrow\nset ytics autofreq\n";
}

void draw_panel(Script& gp, const Verification& verification, cut_force::Index which,
                const std::string& symbol, const std::string& label) {
  const auto rows_of = [&](const CutForceLine& line) {
    std::vector<Row2> rows;
    for (std::size_t i = 0; i < line.stations.size(); ++i) {
      rows.emplace_back(line.stations[i].s.value(), value_of(line.values[i], which) * 1e-3);
    }
    return rows;
  };
  std::vector<Row3> band;
  const std::vector<Row2> low = rows_of(verification.envelope[0]);
  const std::vector<Row2> high = rows_of(verification.envelope[1]);
  double bottom = 0.0;
  double top = 0.0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    band.emplace_back(std::get<0>(low[i]), std::get<1>(low[i]), std::get<1>(high[i]));
    bottom = std::min(bottom, std::get<1>(low[i]));
    top = std::max(top, std::get<1>(high[i]));
  }
  if (top - bottom == 0.0) top = 1.0;  // a cut force that is zero everywhere
  const double room = 0.18 * (top - bottom);
  gp.block("band_" + symbol, band);
  std::string plot = fmt::format(
      "plot $band_{} using 1:2:3 with filledcurves fc rgb '#e9e9e9', "
      "0 with lines lc rgb '#505050' lw 1",
      symbol);
  struct Named {
    Row2 at;
    const char* colour;
  };
  std::vector<Named> extremes;
  int label_number = 0;
  std::vector<Row2> labelled;
  // Whether a value already stands so near that two labels would overlap.
  const auto crowded = [&](const Row2& at) {
    return std::any_of(labelled.begin(), labelled.end(), [&](const Row2& other) {
      return std::abs(std::get<0>(at) - std::get<0>(other)) < 0.08 * std::get<0>(low.back()) &&
             std::abs(std::get<1>(at) - std::get<1>(other)) < 0.12 * (top - bottom);
    });
  };
  for (std::size_t k = 0; k < verification.lines.size(); ++k) {
    const CutForceLine& line = verification.lines[k];
    const std::vector<Row2> rows = rows_of(line);
    gp.block(fmt::format("{}{}", symbol, k), rows);
    plot += fmt::format(", ${}{} using 1:2 with lines lw 1.8 lc rgb '{}'", symbol, k, colour(k));
    extremes.push_back({*std::max_element(rows.begin(), rows.end(),
                                          [](const Row2& one, const Row2& other) {
                                            return std::abs(std::get<1>(one)) <
                                                   std::abs(std::get<1>(other));
                                          }),
                        colour(k)});
  }
  // Where there is no room for all, the largest are named.
  std::stable_sort(extremes.begin(), extremes.end(), [](const Named& one, const Named& other) {
    return std::abs(std::get<1>(one.at)) > std::abs(std::get<1>(other.at));
  });
  for (const Named& extreme : extremes) {
    const auto [x, y] = extreme.at;
    if (crowded(extreme.at) || std::abs(y) < 1e-9 * (top - bottom)) continue;
    labelled.push_back(extreme.at);
    const bool at_end = x > 0.8 * std::get<0>(low.back());
    gp << "set label " << ++label_number << " '" << text::significant(y) << "' at " << x << "," << y
       << " offset " << (at_end ? "-1" : "0.5") << "," << (y > 0 ? 0.6 : -0.6)
       << (at_end ? " right" : " left") << " tc rgb '" << extreme.colour << "' front\n";
  }
  gp << "set ylabel '" << label << "'\nset yrange [" << bottom - room << ":" << top + room << "]\n"
     << plot << "\nunset label\n";
}

}  // namespace

void cut_forces(Script& gp, const Project& project, const Verification& verification) {
  // The legend stands beside the beam, where no curve is; that of several situations is too wide.
  const bool below = project.situations.size() > 1;
  constexpr int width = 860;
  const std::vector<LegendEntry> legend = legend_below(verification);
  const int room = below ? 20 * static_cast<int>(rows_of_legend(legend, width)) + 8 : 0;
  const int height = 980 + room;
  gp.begin("cut-forces", width, height);
  gp << "set multiplot layout 4,1 margins 0.11,0.97," << (58.8 + room) / height
     << ",0.95 spacing 0,0.035 title " << quoted("Cut forces along the beam: " + project.name)
     << " noenhanced\n"
     << "set xrange [" << -0.02 * project.beam.length().value() << ":"
     << 1.02 * project.beam.length().value() << "]\n"
     << "set format x ''\n";
  if (below) {
    draw_legend(gp, legend, width, height, 18);
    gp << "unset key\n";
  } else {
    gp << "set key top right horizontal\n";
  }
  draw_outline(gp, project, outline_in_z(project.beam), below ? "" : legend_of(verification));
  draw_panel(gp, verification, cut_force::N, "N", "N [kN]");
  draw_panel(gp, verification, cut_force::V_z, "V", "V [kN]");
  gp << "set format x '%g'\nset xlabel 's [m], from the start of the beam'\n";
  draw_panel(gp, verification, cut_force::M_y, "M", "M [kN m], on the tension side");
  gp << "unset multiplot\n";
}

void cut_forces_in_space(Script& gp, const Project& project, const Verification& verification) {
  const std::vector<LegendEntry> legend = legend_below(verification);
  constexpr int width = 1240;
  const auto rows = static_cast<int>(rows_of_legend(legend, width));
  const int height = 1010 + 20 * rows;
  gp.begin("cut-forces", width, height);
  gp << "set multiplot layout 4,2 columnsfirst margins 0.07,0.985," << (75.0 + 20.0 * rows) / height
     << ",0.95 spacing 0.08,0.03 title " << quoted("Cut forces along the beam: " + project.name)
     << " noenhanced\n"
     << "set xrange [" << -0.02 * project.beam.length().value() << ":"
     << 1.02 * project.beam.length().value() << "]\nunset key\n";
  draw_legend(gp, legend, width, height, 18);
  const auto names = cut_forces_looked_at(project);
  // A column for each plane of the beam: its border, then what acts in that plane.
  const auto column = [&](const Outline& border, std::initializer_list<cut_force::Index> forces) {
    gp << "set format x ''\nunset xlabel\n";
    draw_outline(gp, project, border, "");
    for (const cut_force::Index which : forces) {
      const auto name = std::find_if(names.begin(), names.end(),
                                     [&](const CutForceName& of) { return of.which == which; });
      std::string title = axis_title(*name);
      if (which == cut_force::M_y) title += ", + tension at +z";
      if (which == cut_force::M_z) title += ", + tension at -y";
      if (which == *(forces.end() - 1))
        gp << "set format x '%g'\nset xlabel 's [m], from the start of the beam'\n";
      draw_panel(gp, verification, which, name->name, title);
    }
  };
  column(outline_in_z(project.beam), {cut_force::N, cut_force::V_z, cut_force::M_y});
  column(outline_in_y(project.beam), {cut_force::T, cut_force::V_y, cut_force::M_z});
  gp << "unset multiplot\n";
}

}  // namespace boxbeam::plot
