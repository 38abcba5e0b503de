#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boxbeam/report/format.hpp"
#include "ink.hpp"

namespace boxbeam::plot {
namespace {

constexpr double width = 0.5 * figure_width;
constexpr double panel_height = 150.0;
constexpr std::size_t most_criteria = 4;

/// A criterion's largest utilisation at each station where it is judged, in order along the beam.
struct Curve {
  const Check* worst = nullptr;
  std::vector<Row2> rows;  ///< s [m], utilisation [%]
};

Curve curve_of(const Verification& verification, Criterion criterion) {
  Curve curve;
  std::map<std::pair<double, Side>, double> largest;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (check.criterion != criterion || !check.on_beam) continue;
    if (curve.worst == nullptr) curve.worst = &check;  // the worst of all come first
    double& most = largest[{check.station.s.value(), check.station.side}];
    most = std::max(most, 100.0 * check.utilisation());
  }
  for (const auto& [station, percent] : largest) curve.rows.emplace_back(station.first, percent);
  return curve;
}

/// Those that are used most.
std::vector<Curve> curves_of(const Verification& verification) {
  std::vector<Curve> curves;
  for (const Criterion criterion : criteria) {
    Curve curve = curve_of(verification, criterion);
    if (curve.worst != nullptr) curves.push_back(std::move(curve));
  }
  std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
    return a.worst->utilisation() > b.worst->utilisation();
  });
  if (curves.size() > most_criteria) curves.resize(most_criteria);
  return curves;
}

/// The steps of a dashed line.
std::vector<double> dashes_of(std::size_t i) {
  constexpr double long_dash = 7.0, gap = 3.0, dot = 1.5;
  if (i == 0) return {};
  if (i == 1) return {long_dash, gap};
  if (i == 2) return {dot, gap};
  return {long_dash, gap, dot, gap};
}

}  // namespace

Drawing use_along_beam(const Project& project, const Verification& verification) {
  const std::vector<Curve> curves = curves_of(verification);
  double highest = 100.0;
  for (const Curve& curve : curves) highest = std::max(highest, 100.0 * curve.worst->utilisation());
  const double below = text_line * static_cast<double>(curves.size()) + 4.0 + footing_room;
  Drawing drawing{width, below + panel_height + heading_room, {}};
  const Panel panel{{44.0, below, width - 12.0, below + panel_height},
                    0.0,
                    project.beam.length().value(),
                    0.0,
                    1.1 * highest};
  put_axes(drawing, panel);
  put_heading(drawing, panel, "largest utilisation [%]");
  put_footing(drawing, panel, "s [m], from the start of the beam");
  put_line(drawing, panel.at(panel.x_low, 100.0), panel.at(panel.x_high, 100.0),
           {"#202020", 1.3, {6.0, 3.0}, "", ""});
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Pen pen{colour(k), 1.8, dashes_of(k), "", ""};
    Line line{{}, pen};
    for (const auto& [s, percent] : curves[k].rows) line.points.push_back(panel.at(s, percent));
    const Check& worst = *curves[k].worst;
    const Pixel at = panel.at(worst.station.s.value(), 100.0 * worst.utilisation());
    if (line.points.size() > 1) drawing.shapes.emplace_back(std::move(line));
    drawing.shapes.emplace_back(Dot{at, 2.5, {"", 1.0, {}, colour(k), ""}});
    const double row = below - footing_room - text_line * (static_cast<double>(k) + 0.5);
    put_line(drawing, {6.0, row}, {30.0, row}, pen);
    put_text(drawing,
             fitted(fmt::format("{}: {} at s = {} m", to_text(worst.criterion),
                                text::percent(worst.utilisation()), to_text(worst.station)),
                    width - 40.0),
             {36.0, row});
  }
  if (!curves.empty() && curves.front().worst == &verification.checks.front().check) {
    const Check& worst = *curves.front().worst;
    drawing.shapes.emplace_back(
        Dot{panel.at(worst.station.s.value(), 100.0 * worst.utilisation()), 6.0, {"#202020", 1.6}});
  }
  return drawing;
}

}  // namespace boxbeam::plot
