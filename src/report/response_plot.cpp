#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "plot_script.hpp"

namespace boxbeam::plot {
namespace {

/// More joints than colours go on with dashes.
std::string joint_style(std::size_t joint) {
  constexpr std::size_t colours = 6;
  return fmt::format("lw 1.6 dt {} lc rgb '{}'", joint < colours ? 1 : 2, colour(joint));
}

std::vector<LegendEntry> joint_legend(const JointLines& lines) {
  std::vector<LegendEntry> legend;
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    legend.push_back({lines.names[j], joint_style(j)});
  }
  return legend;
}

void send_lines(Script& gp, const JointLines& lines, double scale, const std::string& prefix) {
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    std::vector<Row2> rows;
    for (std::size_t i = 0; i < lines.at.size(); ++i) {
      rows.emplace_back(scale * lines.at[i], 1e-3 * lines.force[j][i]);
    }
    gp.block(fmt::format("{}{}", prefix, j), rows);
  }
}

std::string all_lines(const JointLines& lines, const std::string& prefix) {
  std::string plot;
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    plot += fmt::format("{}${}{} using 1:2 with lines {} notitle", j > 0 ? ", " : "", prefix, j,
                        joint_style(j));
  }
  return plot;
}

/// 1, 2 or 5 times a power of ten: a step that divides a span into three or more.
double tic_step(double span) {
  if (!(span > 0.0)) return 1.0;
  const double third = span / 3.0;
  const double power = std::pow(10.0, std::floor(std::log10(third)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= third) return digit * power;
  }
  return power;
}

/// One panel for every joint, two beside each other.
void panels(Script& gp, const std::string& name, const std::string& title, const JointLines& lines,
            const std::string& abscissa, double scale) {
  const auto count = static_cast<int>(lines.names.size());
  const int rows = (count + 1) / 2;
  const int height = 130 + 150 * rows;
  gp.begin(name, 1000, height);
  send_lines(gp, lines, scale, "joint");
  gp << "set multiplot layout " << rows << ",2 margins 0.06,0.98," << 70.0 / height << ","
     << 1.0 - 60.0 / height << " spacing 0.07," << 32.0 / height << " title " << quoted(title)
     << " noenhanced\n"
     << "set xrange [0:" << scale * lines.at.back() << "]\nunset key\n"
     << "set offsets 0,0,graph 0.25,graph 0.05\n";
  for (int j = 0; j < count; ++j) {
    const auto index = static_cast<std::size_t>(j);
    const bool lowest = j + 2 >= count;
    const auto [low, high] =
        std::minmax_element(lines.force[index].begin(), lines.force[index].end());
    gp << "set format x '" << (lowest ? "%g" : "") << "'\n"
       << (lowest ? "set xlabel " + quoted(abscissa) : std::string("unset xlabel")) << "\n"
       << "set ytics " << tic_step(1e-3 * (*high - *low)) << "\n"
       << "set label 1 " << quoted(lines.names[index] + "  [kN]")
       << " at graph 0.02,0.9 left noenhanced front\n"
       << "plot $joint" << j << " using 1:2 with lines lw 1.6 lc rgb '" << colour(index)
       << "' notitle\n";
  }
  gp << "unset multiplot\n";
}

}  // namespace

void frequency_response(Script& gp, const Project&, const Verification& verification) {
  const ElasticFigures& figures = *verification.elastic;
  const JointLines& lines = figures.over_frequency;
  constexpr int width = 1000;
  constexpr int height = 640;
  gp.begin("frequency-response", width, height);
  send_lines(gp, lines, 1.0, "joint");
  // Peaks without damping are as high as the grid happens to meet them: what is drawn ends above
  // what the drive gives.
  double drive = 0.0;
  for (const JointVibration& joint : figures.motion.joints) {
    drive = std::max(drive, joint.force.largest);
  }
  const double top = std::pow(10.0, std::ceil(std::log10(std::max(30e-3 * drive, 1e-9))));
  gp << "set title 'Largest force of the joints under the harmonic loads, over their frequency'\n"
     << "set logscale y\nset format y '10^{%T}'\nunset key\n"
     << "set lmargin at screen 0.08\nset rmargin at screen 0.98\nset bmargin at screen 0.2\n"
     << "set xlabel 'frequency [Hz]'\nset ylabel 'force [kN]'\n"
     << "set xrange [0:" << lines.at.back() << "]\n"
     << "set yrange [" << 1e-5 * top << ":" << top << "]\n"
     << "set arrow 1 from first " << figures.motion.frequency << ",graph 0 to first "
     << figures.motion.frequency << ",graph 1 nohead lw 1.2 dt 3 lc rgb '#202020' front\n"
     << "set label 1 'drive' at first " << figures.motion.frequency
     << ",graph 0.97 left offset 0.5,0 tc rgb '#202020' front\n";
  const std::vector<LegendEntry> legend = joint_legend(lines);
  draw_legend(gp, legend, width, height, 18);
  gp << "plot " << all_lines(lines, "joint") << "\n";
}

void joint_forces(Script& gp, const Project&, const Verification& verification) {
  panels(gp, "joint-forces", "Length of the joint forces over a period, static part included",
         verification.elastic->over_period, "t [ms]", 1e3);
}

void sudden_start(Script& gp, const Project&, const Verification& verification) {
  panels(gp, "sudden-start",
         "Length of the joint forces after the harmonic loads are switched on at t = 0",
         verification.elastic->after_start, "t [s]", 1.0);
}

}  // namespace boxbeam::plot
