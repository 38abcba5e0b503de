#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot_script.hpp"

namespace boxbeam::plot {
namespace {

/// Whether all situations take the same time, so that one axis in seconds shows them all.
bool of_one_span(const LoadsOverTime& figure) {
  const LoadsOverTime::Line& first = figure.lines.front();
  return std::all_of(figure.lines.begin(), figure.lines.end(), [&](const auto& line) {
    const double length = (first.times.back() - first.times.front()).value();
    return std::abs((line.times.front() - first.times.front()).value()) < 1e-9 * length &&
           std::abs((line.times.back() - first.times.back()).value()) < 1e-9 * length;
  });
}

}  // namespace

void loads_over_time(Script& gp, const Project& project, const Verification& verification) {
  const LoadsOverTime& figure = *verification.loads_over_time;
  const bool seconds = of_one_span(figure);
  constexpr int width = 1000;
  constexpr int height = 860;
  gp.begin("loads", width, height);
  gp << "set multiplot layout 3,2 columnsfirst margins 0.085,0.98,0.12,0.93 spacing 0.095,0.035 "
        "title "
     << quoted(fmt::format("Cut forces at s = {} m over time: {}", to_text(figure.station),
                           project.name))
     << " noenhanced\n"
     << "set offsets 0,0,graph 0.08,graph 0.08\nunset key\n";
  if (seconds) {
    gp << "set xrange [" << figure.lines.front().times.front().value() << ":"
       << figure.lines.front().times.back().value() << "]\n";
  } else {
    gp << "set xrange [0:1]\n";
  }
  std::vector<LegendEntry> legend;
  for (std::size_t k = 0; k < figure.lines.size(); ++k) {
    const LoadsOverTime::Line& line = figure.lines[k];
    const double length = (line.times.back() - line.times.front()).value();
    const std::string& situation = project.situations[line.situation].name;
    legend.push_back({seconds ? situation : fmt::format("{}, {:.4g} s", situation, length),
                      fmt::format("lw 1.8 lc rgb '{}'", colour(k))});
  }
  // Left what bends in the plane x-z, right what bends in x-y, with the torque.
  static constexpr cut_force::Index order[] = {cut_force::N, cut_force::V_z, cut_force::M_y,
                                               cut_force::T, cut_force::V_y, cut_force::M_z};
  for (std::size_t p = 0; p < std::size(order); ++p) {
    const cut_force::Index which = order[p];
    const auto names = cut_forces_looked_at(project);
    const auto name = std::find_if(names.begin(), names.end(),
                                   [&](const CutForceName& of) { return of.which == which; });
    std::string plot = "plot 0 with lines lc rgb '#505050' lw 1 notitle";
    for (std::size_t k = 0; k < figure.lines.size(); ++k) {
      const LoadsOverTime::Line& line = figure.lines[k];
      const double begin = line.times.front().value();
      const double length = line.times.back().value() - begin;
      std::vector<Row2> rows;
      for (std::size_t i = 0; i < line.times.size(); ++i) {
        const double time = line.times[i].value();
        rows.emplace_back(seconds ? time : (time - begin) / length,
                          value_of(line.values[i], which) * 1e-3);
      }
      const std::string data = fmt::format("{}{}", name->name, k);
      gp.block(data, rows);
      plot += fmt::format(", ${} using 1:2 with lines lw 1.8 lc rgb '{}'", data, colour(k));
    }
    const bool lowest = p % 3 == 2;
    gp << "set format x '" << (lowest ? "%g" : "") << "'\n";
    if (lowest)
      gp << "set xlabel '" << (seconds ? "t [s]" : "time, as part of each situation") << "'\n";
    else
      gp << "unset xlabel\n";
    gp << "set ylabel '" << axis_title(*name) << "'\n";
    // One legend for all panels, below them.
    if (p == 0 && legend.size() > 1) draw_legend(gp, legend, width, height, 18);
    gp << plot << "\nunset label\nunset arrow\n";
  }
  gp << "unset multiplot\n";
}

}  // namespace boxbeam::plot
