#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "canvas.hpp"

namespace boxbeam::plot {
namespace {

double decade_below(double value) { return std::pow(10.0, std::floor(std::log10(value))); }
double decade_above(double value) { return std::pow(10.0, std::ceil(std::log10(value))); }

/// Marks of an axis of ranges, closer than decades.
std::string range_tics(double low, double high) {
  std::string tics;
  const auto last = static_cast<int>(std::lround(std::log10(high)));
  for (auto power = static_cast<int>(std::lround(std::log10(low))); power <= last; ++power) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double tic = digit * std::pow(10.0, power);
      if (tic <= 1.001 * high) tics += fmt::format("{:.6g},", tic);
    }
  }
  tics.pop_back();
  return tics;
}

/// A place on the curve between two lives, in the middle of what is seen.
struct OnCurve {
  double cycles = 0.0, range = 0.0;  ///< [MPa]
};

OnCurve near_on(const SnFigure& figure, double cycles) {
  OnCurve best;
  double nearest = 1e300;
  for (std::size_t i = 0; i < figure.cycles.size(); ++i) {
    const double apart = std::abs(std::log(figure.cycles[i] / cycles));
    if (apart >= nearest) continue;
    nearest = apart;
    best = {figure.cycles[i], 1e-6 * figure.spectrum[i]};
  }
  return best;
}

/// The slopes of the curve's branches, each in the middle of its branch.
void label_slopes(Script& gp, Labels& labels, const SnFigure& figure, const SnCurve& curve,
                  const Panel& panel) {
  double from = panel.x_low;
  const double end = curve.cut_off ? *curve.cut_off : panel.x_high;
  for (const SnBranch& branch : curve.branches) {
    const double to = std::min(branch.until, end);
    if (to > 3.0 * from) {
      const OnCurve middle = near_on(figure, std::sqrt(from * to));
      labels.put(gp, fmt::format("m = {:g}", branch.slope), panel.at(middle.cycles, middle.range),
                 panel.frame, colour(0), 6.0);
    }
    from = std::max(from, to);
  }
}

std::vector<LegendEntry> legend_of(const SnFigure& figure) {
  std::vector<LegendEntry> legend{
      {figure.published_step
           ? fmt::format("published step, category {} taken at 5e6 cycles", figure.name)
           : fmt::format("{}, category {}, spectrum", figure.code, figure.name),
       "lw 2 lc rgb '" + std::string(colour(0)) + "'"}};
  if (!figure.published_step)
    legend.push_back(
        {"the same, constant range", fmt::format("lw 1.4 dt (6,4) lc rgb '{}'", colour(0))});
  legend.push_back({"ranges of the governing place, partial factors applied", "",
                    fmt::format("pt 7 ps 0.7 lc rgb '{}'", colour(1))});
  if (figure.required != 1.0)
    legend.push_back(
        {fmt::format("these times the required factor {}", text::significant(figure.required, 3)),
         "", fmt::format("pt 6 ps 0.8 lw 1.2 lc rgb '{}'", colour(1))});
  return legend;
}

/// The curves of other categories, thin.
void put_others(Script& gp, Labels& labels, const SnFigure& figure, const Panel& panel,
                std::vector<std::string>& curves) {
  for (std::size_t k = 0; k < figure.others.size(); ++k) {
    const SnFigure::Other& other = figure.others[k];
    std::vector<Row2> rows;
    for (std::size_t i = 0; i < figure.cycles.size(); ++i)
      rows.emplace_back(figure.cycles[i], 1e-6 * other.spectrum[i]);
    const std::string data = fmt::format("other{}", k);
    gp.block(data, rows);
    labels.keep_off(panel, rows);
    curves.push_back(fmt::format("${} using 1:2 with lines lw 0.9 lc rgb '#7d8b99'", data));
    const auto& [n, strength] = rows[20 + 6 * k % 24];
    if (strength < panel.y_high)
      labels.put(gp, "category " + other.name, panel.at(n, strength), panel.frame, "#5d6b79", 4.0);
  }
}

/// From the ranges that work to those that are needed, where they are seen.
void put_arrows(Script& gp, Labels& labels, const Panel& panel, const std::vector<Row2>& work,
                const std::vector<Row2>& needed, double lowest) {
  for (std::size_t i = 0; i < work.size(); ++i) {
    const Pixel from = panel.at(std::get<0>(work[i]), std::get<1>(work[i]));
    const Pixel to = panel.at(std::get<0>(needed[i]), std::get<1>(needed[i]));
    if (std::get<1>(work[i]) < lowest || (to - from).norm() < 8.0) continue;
    const Eigen::Vector2d way = (to - from).normalized();
    put_arrow(gp, from + 4.0 * way, to - 4.0 * way,
              fmt::format("lw 0.9 lc rgb '{}' size screen 0.008,20 filled", colour(1)));
    labels.keep_off(from, to);
  }
}

/// Where the curve has its numbers. `curve`: of EN 1993-1-9, or nullptr.
void put_marks(Script& gp, Labels& labels, const SnFigure& figure, const SnCurve* curve,
               const Panel& panel, std::vector<std::string>& curves) {
  std::vector<Row2> marks;
  const auto mark = [&](double n, double pascals, const std::string& what) {
    if (pascals <= 0.0 || n < panel.x_low || n > panel.x_high) return;
    marks.emplace_back(n, 1e-6 * pascals);
    labels.put(gp, fmt::format("{} {} MPa", what, text::significant(1e-6 * pascals, 3)),
               panel.at(n, 1e-6 * pascals), panel.frame, "#202020", 6.0);
  };
  if (curve != nullptr) {
    mark(curve->reference_cycles, curve->reference.value(), "category " + figure.name + ":");
    if (curve->constant_amplitude_limit)
      mark(*curve->constant_amplitude_limit, figure.knee, "knee");
    if (curve->cut_off) mark(*curve->cut_off, figure.cut_off, "cut-off");
    label_slopes(gp, labels, figure, *curve, panel);
  } else {
    mark(5e6, figure.knee, figure.published_step ? "step" : "knee");
    mark(1e8, figure.cut_off, "at 1e8 cycles:");
  }
  if (!marks.empty()) {
    gp.block("marks", marks);
    curves.push_back("$marks using 1:2 with points pt 6 ps 0.7 lc rgb '#202020'");
  }
}

}  // namespace

void sn(Script& gp, const Project&, const Verification& verification) {
  const SnFigure& figure = *verification.pictures.sn;
  std::vector<Row2> line, constant;
  double strongest = 0.0;
  for (std::size_t i = 0; i < figure.cycles.size(); ++i) {
    line.emplace_back(figure.cycles[i], figure.spectrum[i] * 1e-6);
    constant.emplace_back(figure.cycles[i], figure.constant_amplitude[i] * 1e-6);
    strongest = std::max(strongest, figure.spectrum[i] * 1e-6);
  }
  std::vector<Row2> work, needed;
  double cycles = 0.0, range = 0.0;  // of the largest range
  double fewest = figure.cycles.front();
  for (const auto& [n, pascals] : figure.working) {
    work.emplace_back(n, pascals * 1e-6);
    needed.emplace_back(n, pascals * 1e-6 * figure.required);
    // The standard's lines begin at 1e4; rare cycles stand before them.
    fewest = std::min(fewest, decade_below(0.7 * n));
    if (pascals * 1e-6 <= range) continue;
    cycles = n;
    range = pascals * 1e-6;
  }
  // Small ranges stand below the curves; the largest of them is always seen.
  const double weakest = 1e-6 * figure.spectrum.back();
  double lowest = decade_below(0.7 * weakest);
  if (range > 0.0) lowest = std::min(lowest, decade_below(0.7 * range));
  const double highest = decade_above(std::max(strongest, 1.2 * range * figure.required));

  const CheckResult* governing = verification.governing(Criterion::fatigue);
  const bool en = !figure.published_step && governing != nullptr && governing->basis.has_value();
  const bool shows_constant = !figure.published_step;
  const std::vector<LegendEntry> legend = legend_of(figure);
  constexpr double height = 330.0;
  const double below = footing_room + height_of_legend(legend);
  gp.begin("sn", below + height + 30.0);
  // A little more than whole decades, so that the numbers at their ends are written.
  const Panel panel{{56.0, below, 600.0, below + height},
                    fewest,
                    1e9,
                    0.999 * lowest,
                    1.001 * highest,
                    true,
                    true};
  gp << "set logscale xy\nset format x '10^{%T}'\nset xtics 10\nset mxtics 1\n"
     << "set ytics (" << range_tics(lowest, highest) << ")\n";
  place(gp, panel);
  put_footing(gp, panel, "cycles N");
  put_heading(gp, panel, "stress range [MPa]");
  draw_legend(gp, legend, 2.0);
  gp.block("line", line);
  gp.block("work", work);
  gp.block("needed", needed);
  Labels labels;
  std::vector<std::string> curves;
  labels.keep_off(panel, line);
  if (en) put_others(gp, labels, figure, panel, curves);
  curves.push_back(fmt::format("$line using 1:2 with lines lw 2 lc rgb '{}'", colour(0)));
  if (shows_constant) {
    gp.block("constant", constant);
    labels.keep_off(panel, constant);
    curves.push_back(
        fmt::format("$constant using 1:2 with lines lw 1.4 dt (6,4) lc rgb '{}'", colour(0)));
  }
  curves.push_back(fmt::format("$work using 1:2 with points pt 7 ps 0.7 lc rgb '{}'", colour(1)));
  curves.push_back(
      fmt::format("$needed using 1:2 with points pt 6 ps 0.8 lw 1.2 lc rgb '{}'", colour(1)));
  put_arrows(gp, labels, panel, work, needed, lowest);
  if (range >= lowest) {
    labels.put(gp, text::significant(range, 3) + " MPa", panel.at(cycles, range), panel.frame,
               colour(1), 6.0);
    if (figure.required != 1.0)
      labels.put(gp, text::significant(range * figure.required, 3) + " MPa",
                 panel.at(cycles, range * figure.required), panel.frame, colour(1), 6.0);
  }
  put_marks(gp, labels, figure, en ? &governing->basis->curves.front() : nullptr, panel, curves);
  gp.plot(curves);
}

}  // namespace boxbeam::plot
