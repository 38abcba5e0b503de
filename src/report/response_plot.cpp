#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "canvas.hpp"

namespace boxbeam::plot {
namespace {

std::vector<Row2> rows_of(const JointLines& lines, std::size_t joint, double scale) {
  std::vector<Row2> rows;
  for (std::size_t i = 0; i < lines.at.size(); ++i) {
    rows.emplace_back(scale * lines.at[i], 1e-3 * lines.force[joint][i]);
  }
  return rows;
}

/// One panel for every joint, two beside each other.
void panels(Script& gp, const std::string& name, const JointLines& lines,
            const std::string& abscissa, double scale) {
  constexpr double height = 84.0, above = 24.0, foot = footing_room;
  const std::size_t count = lines.names.size();
  const std::size_t rows = (count + 1) / 2;
  const double step = height + above;
  gp.begin(name, foot + step * static_cast<double>(rows) + 6.0);
  for (std::size_t j = 0; j < count; ++j) {
    const std::vector<Row2> line = rows_of(lines, j, scale);
    const auto lower = [](const Row2& a, const Row2& b) { return std::get<1>(a) < std::get<1>(b); };
    const auto [low, high] = std::minmax_element(line.begin(), line.end(), lower);
    const double span =
        std::max(std::get<1>(*high) - std::get<1>(*low), std::max(1e-3 * std::get<1>(*high), 1e-9));
    const double left = j % 2 == 0 ? 56.0 : 358.0;
    const std::size_t row = j / 2;
    const double top = gp.height() - above - step * static_cast<double>(row) - 2.0;
    const Panel panel{{left, top - height, left + 242.0, top},
                      std::get<0>(line.front()),
                      std::get<0>(line.back()),
                      std::get<1>(*low) - 0.1 * span,
                      std::get<1>(*high) + 0.3 * span};
    const bool lowest = j + 2 >= count;
    gp << (lowest ? std::string("set format x '%g'\n") : std::string("set format x ''\n"));
    const std::string data = fmt::format("joint{}", j);
    gp.block(data, line);
    place(gp, panel);
    if (lowest) put_footing(gp, panel, abscissa);
    put_text(gp, fitted(lines.names[j], 130.0) + "  [kN]" + note_of_beginning(panel),
             {left - 44.0, top + 12.0});
    Labels labels;
    labels.keep_off(panel, line);
    labels.put(gp, text::significant(std::get<1>(*high)),
               panel.at(std::get<0>(*high), std::get<1>(*high)), panel.frame, colour(0), 3.0);
    gp.plot({fmt::format("${} using 1:2 with lines lw 1.3 lc rgb '{}'", data, colour(0))});
  }
}

}  // namespace

void frequency_response(Script& gp, const Project&, const Verification& verification) {
  const ElasticFigures& figures = *verification.pictures.elastic;
  const JointLines& lines = figures.over_frequency;
  // Peaks without damping are as high as the grid happens to meet them: what is drawn ends above
  // what the drive gives.
  double drive = 0.0;
  for (const JointVibration& joint : figures.motion.joints) {
    drive = std::max(drive, joint.force.largest);
  }
  const double top = std::pow(10.0, std::ceil(std::log10(std::max(30e-3 * drive, 1e-9))));
  std::vector<LegendEntry> legend;
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    legend.push_back({lines.names[j], line_style(j, 1.4)});
  }
  constexpr double height = 330.0;
  const double below = footing_room + height_of_legend(legend);
  gp.begin("frequency-response", below + height + 52.0);
  const Panel panel{
      {60.0, below, 600.0, below + height}, 0.0, lines.at.back(), 1e-5 * top, top, false, true};
  gp << "set logscale y\nset format y '10^{%T}'\nset ytics 10\nset mytics 1\n";
  place(gp, panel);
  put_footing(gp, panel, "frequency of the harmonic loads [Hz]");
  // Above the name of the drive, which may stand anywhere along the axis.
  put_text(gp, "largest force of the joints [kN]",
           {panel.frame.left - 44.0, panel.frame.top + 32.0});
  draw_legend(gp, legend, 2.0);
  std::vector<std::string> curves;
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    const std::string data = fmt::format("joint{}", j);
    gp.block(data, rows_of(lines, j, 1.0));
    curves.push_back(fmt::format("${} using 1:2 with lines {}", data, legend[j].style));
  }
  const Pixel foot = panel.at(figures.motion.frequency, panel.y_low);
  const Pixel head = panel.at(figures.motion.frequency, panel.y_high);
  put_line(gp, foot, head, "lw 1 dt (4,3) lc rgb '#202020' front");
  put_text(gp, fmt::format("drive {:.4g} Hz", figures.motion.frequency), {head.x(), head.y() + 8.0},
           "center");
  // The natural frequencies that are printed, above the diagram.
  for (const NaturalFrequency& natural : figures.motion.frequencies) {
    if (natural.frequency > panel.x_high) continue;
    const Pixel at = panel.at(natural.frequency, panel.y_high);
    put_line(gp, at, at - Pixel(0.0, 8.0), "lw 1.4 lc rgb '#202020' front");
  }
  gp.plot(curves);
}

void joint_forces(Script& gp, const Project&, const Verification& verification) {
  panels(gp, "joint-forces", verification.pictures.elastic->over_period, "t [ms]", 1e3);
}

void sudden_start(Script& gp, const Project&, const Verification& verification) {
  panels(gp, "sudden-start", verification.pictures.elastic->after_start, "t [s]", 1.0);
}

}  // namespace boxbeam::plot
