#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "plot_script.hpp"

namespace boxbeam::plot {

void stress(Script& gp, const Project& project, const Verification& verification) {
  gp.begin("stress", 860, 520);
  const CheckResult* governing = verification.governing(Criterion::fatigue);
  if (governing == nullptr) governing = &verification.checks.front();
  const std::size_t running = governing->basis->running;
  const std::vector<double>& instants = governing->basis->times;
  const std::string& situation = project.situations[running].name;
  gp << "set title "
     << quoted("Normal stress over the cycle at the places with the largest ranges: " +
               project.name + (situation.empty() ? "" : ", " + situation))
     << " noenhanced\n"
     << "set xlabel 't [s]'\nset ylabel 'sigma [MPa]'\nset xrange [" << instants.front() << ":"
     << instants.back() << "]\n"
     << "set key outside bottom center horizontal\n";
  std::vector<const CheckResult*> shown;
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion != Criterion::fatigue || !result.basis || shown.size() == 3 ||
        result.basis->running != running)
      continue;
    const bool same_station = std::any_of(
        shown.begin(), shown.end(),
        [&](const CheckResult* other) { return other->check.station == result.check.station; });
    if (!same_station) shown.push_back(&result);
  }
  std::string plot = "plot 0 with lines lc rgb '#505050' lw 1 notitle";
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const CheckBasis& basis = *shown[k]->basis;
    std::vector<Row2> rows;
    for (std::size_t i = 0; i < basis.times.size(); ++i) {
      rows.emplace_back(basis.times[i], basis.history[i] * 1e-6);
    }
    std::vector<Row2> extremes;
    for (const Extreme& extreme : {basis.highest, basis.lowest}) {
      if (extreme.situation != running) continue;
      extremes.emplace_back(extreme.time.value(), extreme.value * 1e-6);
    }
    gp.block(fmt::format("h{}", k), rows);
    gp.block(fmt::format("x{}", k), extremes);
    plot += fmt::format(
        ", $h{} using 1:2 with lines lw {} lc rgb '{}' title {}", k, k == 0 ? 2.4 : 1.6, colour(k),
        quoted(fmt::format("s = {} m, {}: range {}", to_text(shown[k]->check.station),
                           shown[k]->check.point, text::MPa(shown[k]->check.acting.value()))));
    plot +=
        fmt::format(", $x{} using 1:2 with points pt 7 ps 0.7 lc rgb '{}' notitle", k, colour(k));
    if (k > 0) continue;
    // Near the frame a label grows inwards.
    const auto side = [&](double time) {
      const double share = (time - instants.front()) / (instants.back() - instants.front());
      return share < 0.15   ? " left offset 0.6,"
             : share > 0.85 ? " right offset -0.6,"
                            : " center offset 0,";
    };
    for (const Row2& extreme : extremes) {
      gp << "set label '" << text::significant(std::get<1>(extreme)) << " MPa at "
         << text::seconds(std::get<0>(extreme)) << "' at " << std::get<0>(extreme) << ","
         << std::get<1>(extreme) << side(std::get<0>(extreme))
         << (std::get<1>(extreme) > 0 ? 0.9 : -0.9) << " tc rgb '" << colour(0) << "' front\n";
    }
  }
  gp << "set offsets 0,0,graph 0.12,graph 0.12\n" << plot << "\n";
}

}  // namespace boxbeam::plot
