#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "boxbeam/verification/drawn_histories.hpp"
#include "canvas.hpp"

namespace boxbeam::plot {
void stress(Script& gp, const Project& project, const Verification& verification) {
  std::vector<const CheckResult*> shown;
  for (const std::size_t i : drawn_over_time(verification.checks))
    shown.push_back(&verification.checks[i]);
  const CheckResult* const governing = shown.front();
  const std::size_t running = governing->basis->running;
  std::vector<LegendEntry> legend;
  double low = 0.0;
  double high = 0.0;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const Check& check = shown[k]->check;
    std::string title = fmt::format("s = {} m, {}", to_text(check.station), check.point);
    if (check.criterion == Criterion::fatigue)
      title += ": range " + text::MPa(check.acting.value());
    legend.push_back({title, line_style(k, k == 0 ? 2.2 : 1.5)});
    const std::vector<double>& history = shown[k]->basis->history;
    low = std::min(low, 1e-6 * *std::min_element(history.begin(), history.end()));
    high = std::max(high, 1e-6 * *std::max_element(history.begin(), history.end()));
  }
  constexpr double height = 240.0;
  const double below = footing_room + height_of_legend(legend);
  gp.begin("stress", below + height + 28.0);
  const std::vector<double>& times = governing->basis->times;
  const auto [y_low, y_high] = range_with_zero(low, high, 0.16);
  const Panel panel{
      {56.0, below, 600.0, below + height}, times.front(), times.back(), y_low, y_high};
  place(gp, panel);
  const std::string& situation = project.situations[running].name;
  put_text(gp, fitted("normal stress [MPa]" + (situation.empty() ? "" : ", " + situation), 580.0),
           {12.0, panel.frame.top + 14.0});
  put_footing(gp, panel, "t [s]");
  draw_legend(gp, legend, 2.0);
  Labels labels;
  labels.keep_off(panel.at(panel.x_low, 0.0), panel.at(panel.x_high, 0.0));
  std::vector<std::string> curves{"0 with lines lc rgb '#505050' lw 0.9"};
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const CheckBasis& basis = *shown[k]->basis;
    std::vector<Row2> rows;
    for (std::size_t i = 0; i < basis.times.size(); ++i) {
      rows.emplace_back(basis.times[i], basis.history[i] * 1e-6);
    }
    const std::string data = fmt::format("history{}", k);
    gp.block(data, rows);
    labels.keep_off(panel, rows);
    curves.push_back(fmt::format("${} using 1:2 with lines {}", data, legend[k].style));
  }
  std::vector<Row2> extremes;
  for (const Extreme& extreme : {governing->basis->highest, governing->basis->lowest}) {
    if (extreme.situation == running)
      extremes.emplace_back(extreme.time.value(), extreme.value * 1e-6);
  }
  if (!extremes.empty()) {
    gp.block("extremes", extremes);
    curves.push_back(
        fmt::format("$extremes using 1:2 with points pt 7 ps 0.6 lc rgb '{}'", colour(0)));
  }
  for (const auto& [time, value] : extremes) {
    labels.put(gp, fmt::format("{} MPa at {}", text::significant(value), text::seconds(time)),
               panel.at(time, value), panel.frame, colour(0), 5.0);
  }
  gp.plot(curves);
}

}  // namespace boxbeam::plot
