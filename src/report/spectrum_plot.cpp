#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "canvas.hpp"

namespace boxbeam::plot {

void spectrum(Script& gp, const Project&, const Verification& verification) {
  const CheckResult& governing = *verification.governing(Criterion::fatigue);
  std::vector<SpectrumRow> rows = governing.basis->spectrum;
  std::stable_sort(rows.begin(), rows.end(), [](const SpectrumRow& a, const SpectrumRow& b) {
    return a.cycle.range > b.cycle.range;
  });
  const double damage = governing.basis->damage;
  // A stair: ranges over how many cycles are as large or larger.
  std::vector<Row2> stair;
  double count = 0.0;
  const double first = std::pow(10.0, std::floor(std::log10(0.5 * rows.front().cycle.count)));
  for (const SpectrumRow& row : rows) {
    const double range = 1e-6 * row.cycle.range.value();
    stair.emplace_back(count == 0.0 ? first : count, range);
    count += row.cycle.count;
    stair.emplace_back(count, range);
  }
  stair.emplace_back(count, 0.0);
  constexpr double height = 250.0;
  gp.begin("spectrum", footing_room + height + 52.0);
  const double last = std::pow(10.0, std::ceil(std::log10(1.01 * count)));
  const Panel panel{{56.0, footing_room, 600.0, footing_room + height},
                    first,
                    last,
                    0.0,
                    1.15 * std::get<1>(stair.front()),
                    true,
                    false};
  gp << "set logscale x\nset format x '10^{%T}'\nset xtics 10\nset mxtics 1\n";
  place(gp, panel);
  put_footing(gp, panel, "cycles in the wanted life with this range or a larger one");
  put_text(gp,
           fitted(fmt::format("{}; s = {} m, {}",
                              damage > 0.0 ? "D = " + text::factor(damage) : "no damage",
                              to_text(governing.check.station), governing.check.point),
                  gp.width() - 24.0),
           {12.0, panel.frame.top + 34.0});
  put_heading(gp, panel,
              "stress range [MPa]: share of the damage, loads as they are with partial factors");
  gp.block("stair", stair);
  Labels labels;
  labels.keep_off(panel, stair);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto [x, y] = stair[2 * i + 1];
    // What is too small to be seen goes without a name.
    if (y < 0.02 * std::get<1>(stair.front())) continue;
    std::string label =
        fmt::format("{}: {}", text::significant(y, 3),
                    rows[i].damage > 0.0 ? text::percent(rows[i].damage / damage) : "no damage");
    if (!rows[i].situation.empty()) label += ", " + rows[i].situation;
    labels.put(gp, fitted(label, 240.0), panel.at(x, y), panel.frame, colour(1), 5.0);
  }
  gp.plot({"$stair using 1:2 with filledcurves y1=0 fc rgb '#e3eaf2'",
           fmt::format("$stair using 1:2 with lines {}", line_style(0, 1.8))});
}

}  // namespace boxbeam::plot
