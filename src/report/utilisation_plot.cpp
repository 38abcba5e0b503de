#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam_outline.hpp"
#include "boxbeam/report/format.hpp"

namespace boxbeam::plot {
namespace {

/// The worst check of a criterion at every station, in the order of the beam.
std::vector<const CheckResult*> worst_along(const Verification& verification, Criterion criterion) {
  std::vector<const CheckResult*> worst;
  // The worst of all come first.
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion != criterion || !result.check.on_beam) continue;
    const bool known = std::any_of(worst.begin(), worst.end(), [&](const CheckResult* other) {
      return other->check.station == result.check.station;
    });
    if (!known) worst.push_back(&result);
  }
  std::sort(worst.begin(), worst.end(), [](const CheckResult* a, const CheckResult* b) {
    const Station& one = a->check.station;
    const Station& other = b->check.station;
    return one.s < other.s ||
           (one.s == other.s && one.side == Side::before && other.side != Side::before);
  });
  return worst;
}

/// What a curve of the figure shows.
struct Curve {
  Criterion criterion;
  std::vector<Row2> rows;
  const CheckResult* worst;
};

}  // namespace

void utilisation(Script& gp, const Project& project, const Verification& verification) {
  std::vector<Curve> curves;
  double highest = 100.0;
  for (const Criterion criterion : criteria) {
    Curve curve{criterion, {}, nullptr};
    for (const CheckResult* result : worst_along(verification, criterion)) {
      const double percent = 100.0 * result->check.utilisation();
      curve.rows.emplace_back(result->check.station.s.value(), percent);
      highest = std::max(highest, percent);
      const bool worse =
          curve.worst == nullptr || result->check.utilisation() > curve.worst->check.utilisation();
      if (worse) curve.worst = result;
    }
    if (!curve.rows.empty()) curves.push_back(std::move(curve));
  }
  std::vector<LegendEntry> legend;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Check& worst = curves[k].worst->check;
    legend.push_back({fmt::format("{}: {} at s = {} m", to_text(worst.criterion),
                                  text::percent(worst.utilisation()), to_text(worst.station)),
                      line_style(k, 1.6)});
  }
  const double below = footing_room + height_of_legend(legend);
  constexpr double height = 270.0;
  gp.begin("utilisation", below + height + heading_room + outline_height + 40.0);
  const double top = gp.height() - 40.0;
  gp << "set format x ''\n";
  draw_outline(gp, project, verification, Plane::xz, {56.0, top - outline_height, 600.0, top});
  const auto [s_low, s_high] = range_of_s(project.beam);
  const Panel panel{{56.0, below, 600.0, below + height}, s_low, s_high, 0.0, 1.15 * highest};
  place(gp, panel);
  put_heading(gp, panel, "utilisation [%], the worst place of every section that is checked");
  draw_legend(gp, legend, 2.0);
  gp << "set format x '%g'\n";
  put_footing(gp, panel, "s [m], from the start of the beam");
  std::vector<std::string> plots{"100 with lines lw 1.3 dt (6,3) lc rgb '#202020'"};
  Labels labels;
  labels.keep_off(panel.at(s_low, 100.0), panel.at(s_high, 100.0));
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const std::string data = fmt::format("u{}", k);
    gp.block(data, curves[k].rows);
    plots.push_back(fmt::format("${} using 1:2 with lines {}", data, line_style(k, 1.6)));
    plots.push_back(
        fmt::format("${} using 1:2 with points pt 7 ps 0.3 lc rgb '{}'", data, colour(k)));
    labels.keep_off(panel, curves[k].rows);
  }
  std::vector<std::size_t> order(curves.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return curves[a].worst->check.utilisation() > curves[b].worst->check.utilisation();
  });
  const double bound = gp.width() - 4.0;
  for (const std::size_t k : order) {
    const Check& check = curves[k].worst->check;
    const double percent = 100.0 * check.utilisation();
    // Small ones stand in the legend alone.
    if (k != order.front() && percent < 0.2 * highest) continue;
    const Pixel at = panel.at(check.station.s.value(), percent);
    std::string label = text::percent(check.utilisation());
    if (k == order.front()) {
      label += fmt::format(": {} at s = {} m, {}", to_text(check.criterion), to_text(check.station),
                           check.point);
      put_line(gp, at + Pixel(0.0, 0.1), at, "lw 1 lc rgb '#202020'");
      gp << "set object circle at " << check.station.s.value() << "," << percent
         << " size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4\n";
    }
    labels.put(gp, fitted(label, 400.0), at,
               {panel.frame.left, panel.frame.bottom, bound, panel.frame.top}, colour(k), 6.0);
  }
  gp.plot(plots);
}

}  // namespace boxbeam::plot
