#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "plot_script.hpp"

namespace boxbeam::plot {

void sn(Script& gp, const Project& project, const Verification& verification) {
  const SnFigure& figure = *verification.sn;
  gp.begin("sn", 860, 560);
  std::vector<Row3> rows;
  for (std::size_t i = 0; i < figure.cycles.size(); ++i) {
    rows.emplace_back(figure.cycles[i], figure.spectrum[i] * 1e-6,
                      figure.constant_amplitude[i] * 1e-6);
  }
  gp.block("line", rows);
  std::vector<Row2> work, needed;
  double cycles = 0.0, range = 0.0;  // of the largest range
  for (const auto& [n, pascals] : figure.working) {
    work.emplace_back(n, pascals * 1e-6);
    needed.emplace_back(n, pascals * 1e-6 * figure.required);
    if (pascals * 1e-6 <= range) continue;
    cycles = n;
    range = pascals * 1e-6;
  }
  // The standard's lines begin at 1e4; rare cycles stand before them.
  double fewest = 1e4;
  for (const auto& [n, pascals] : figure.working) {
    fewest = std::min(fewest, std::pow(10.0, std::floor(std::log10(0.7 * n))));
  }
  // Small ranges stand below the curves; the largest of them is always seen.
  double lowest = 10.0;
  if (range > 0.0) {
    lowest = std::min(lowest, std::pow(10.0, std::floor(std::log10(0.7 * range))));
  }
  std::string small_tics;
  for (double decade = lowest; decade < 9.0; decade *= 10.0) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      small_tics += fmt::format("{:.6g},", digit * decade);
    }
  }
  gp.block("work", work);
  gp.block("needed", needed);
  const bool en = !figure.published_step;
  gp << "set title " << quoted("S-N diagram with the governing stress range: " + project.name)
     << " noenhanced\n"
     << "set logscale xy\nset format x '10^{%T}'\nset xlabel 'cycles N'\nset ylabel 'stress range "
        "[MPa]'\n"
     << "set xrange [" << fewest << ":1e9]\nset yrange [" << lowest
     << ":1000]\nset key bottom left\n"
     << "set ytics (" << small_tics << "10,20,30,50,70,100,200,300,500,1000)\n";
  gp << "set label 'knee " << text::significant(figure.knee * 1e-6, 3) << " MPa' at 5e6,"
     << figure.knee * 1e-6 << " right offset -0.6,-0.9 point pt 6\n"
     << "set label '" << (en ? "cut-off " : "at 1e8: ")
     << text::significant(figure.cut_off * 1e-6, 3) << " MPa' at 1e8," << figure.cut_off * 1e-6
     << " left offset 0.6,0.8 point pt 6\n";
  if (en) {
    gp << "set label 'm = 3' at 3e5," << 1.15e-6 * figure.reference * std::cbrt(2e6 / 3e5) << "\n"
       << "set label 'm = 5' at 2.5e7," << 1.12 * figure.knee * 1e-6 * std::pow(5e6 / 2.5e7, 0.2)
       << "\n"
       << "set label 'category " << figure.name << "' at 2e6," << figure.reference * 1e-6
       << " left offset 0.6,0.6 point pt 6\n";
  }
  gp << "set label '" << text::significant(range, 3) << " MPa' at " << cycles << "," << range
     << " left offset 1,-0.7 tc rgb '" << colour(1) << "'\n";
  gp << "plot $line using 1:2 with lines lw 2 lc rgb '" << colour(0) << "' title "
     << quoted(en ? fmt::format("{}, category {}, spectrum", figure.code, figure.name)
                  : fmt::format("published step, category {} taken at 5e6 cycles", figure.name));
  if (en) {
    gp << ", $line using 1:3 with lines lw 1.6 dt 2 lc rgb '" << colour(0)
       << "' title 'constant amplitude (7.1(2))'";
  }
  gp << ", $work using 1:2 with points pt 7 ps 1 lc rgb '" << colour(1)
     << "' title 'governing range, partial factors applied'"
     << ", $needed using 1:2 with points pt 6 ps 1.2 lc rgb '" << colour(1) << "' title '"
     << fmt::format("governing range x required factor {}", text::significant(figure.required, 3))
     << "'\n";
}

}  // namespace boxbeam::plot
