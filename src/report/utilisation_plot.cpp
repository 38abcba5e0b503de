#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "beam_outline.hpp"
#include "boxbeam/report/format.hpp"

namespace boxbeam::plot {
namespace {

bool before(const Station& one, const Station& other) {
  return one.s < other.s ||
         (one.s == other.s && one.side == Side::before && other.side != Side::before);
}

/// What the places of a kind along the beam share: "fibre" of "fibre +z", and what resists there.
std::string kind_of(const CheckResult& result) {
  std::string kind;
  std::istringstream words(result.check.point);
  for (std::string word; words >> word;) {
    if (!word.starts_with('+') && !word.starts_with('-')) kind += word + " ";
  }
  if (result.basis && !result.basis->curves.empty()) kind += result.basis->curves.front().name;
  return kind;
}

/// The worst check of each kind of place at one station.
struct Section {
  Station station;
  std::map<std::string, const CheckResult*> worst;
};

std::vector<Section> sections_of(const Verification& verification, Criterion criterion) {
  std::vector<Section> sections;
  // The worst of all come first.
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion != criterion || !result.check.on_beam) continue;
    auto section = std::find_if(sections.begin(), sections.end(), [&](const Section& other) {
      return other.station == result.check.station;
    });
    if (section == sections.end())
      section = sections.insert(sections.end(), {result.check.station, {}});
    section->worst.try_emplace(kind_of(result), &result);
  }
  std::sort(sections.begin(), sections.end(),
            [](const Section& a, const Section& b) { return before(a.station, b.station); });
  return sections;
}

Row2 row_of(const CheckResult& result) {
  return {result.check.station.s.value(), 100.0 * result.check.utilisation()};
}

/// The stretches over which a kind of place goes on from section to section.
std::vector<std::vector<Row2>> runs_of(const std::vector<Section>& sections,
                                       const std::string& kind) {
  std::vector<std::vector<Row2>> runs(1);
  for (const Section& section : sections) {
    const auto found = section.worst.find(kind);
    if (found != section.worst.end())
      runs.back().push_back(row_of(*found->second));
    else if (!runs.back().empty())
      runs.emplace_back();
  }
  std::erase_if(runs, [](const std::vector<Row2>& run) {
    return run.empty() || std::get<0>(run.front()) == std::get<0>(run.back());
  });
  return runs;
}

bool is_on(const std::vector<std::vector<Row2>>& lines, const Row2& row) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::vector<Row2>& line) {
    return std::find(line.begin(), line.end(), row) != line.end();
  });
}

/// What the figure shows of a criterion.
struct Curve {
  Criterion criterion = Criterion::yield;
  std::vector<std::vector<Row2>> lines;  ///< of kinds that are somewhere the worst of those
  std::vector<Row2> single;              ///< of each section the worst, where no line leads to it
  const CheckResult* worst = nullptr;
};

Curve curve_of(const Verification& verification, Criterion criterion) {
  Curve curve{criterion, {}, {}, nullptr};
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion != criterion || !result.check.on_beam) continue;
    curve.worst = &result;
    break;
  }
  const std::vector<Section> sections = sections_of(verification, criterion);
  std::map<std::string, std::vector<std::vector<Row2>>> runs;
  for (const Section& section : sections) {
    for (const auto& [kind, result] : section.worst) {
      if (!runs.contains(kind)) runs.emplace(kind, runs_of(sections, kind));
    }
  }
  std::set<std::string> leading;
  for (const Section& section : sections) {
    const std::string* highest = nullptr;
    double most = 0.0;
    for (const auto& [kind, result] : section.worst) {
      if (result->check.utilisation() <= most || !is_on(runs.at(kind), row_of(*result))) continue;
      most = result->check.utilisation();
      highest = &kind;
    }
    if (highest != nullptr) leading.insert(*highest);
    const CheckResult* single = nullptr;
    for (const auto& [kind, result] : section.worst) {
      if (result->check.utilisation() <= most || is_on(runs.at(kind), row_of(*result))) continue;
      most = result->check.utilisation();
      single = result;
    }
    if (single != nullptr) curve.single.push_back(row_of(*single));
  }
  for (const std::string& kind : leading) {
    const auto& of_kind = runs.at(kind);
    curve.lines.insert(curve.lines.end(), of_kind.begin(), of_kind.end());
  }
  return curve;
}

}  // namespace

void utilisation(Script& gp, const Project& project, const Verification& verification) {
  std::vector<Curve> curves;
  double highest = 100.0;
  bool any_single = false;
  for (const Criterion criterion : criteria) {
    Curve curve = curve_of(verification, criterion);
    if (curve.lines.empty() && curve.single.empty()) continue;
    highest = std::max(highest, 100.0 * curve.worst->check.utilisation());
    any_single = any_single || !curve.single.empty();
    curves.push_back(std::move(curve));
  }
  std::vector<LegendEntry> legend;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Check& worst = curves[k].worst->check;
    legend.push_back({fmt::format("{}: {} at s = {} m", to_text(worst.criterion),
                                  text::percent(worst.utilisation()), to_text(worst.station)),
                      line_style(k, 1.6)});
  }
  if (any_single)
    legend.push_back({"holes, single welds and other places of no line", "",
                      "pt 6 ps 0.7 lw 1.3 lc rgb '#202020'"});
  const double below = footing_room + height_of_legend(legend);
  constexpr double height = 270.0;
  gp.begin("utilisation", below + height + heading_room + outline_height + 40.0);
  const double top = gp.height() - 40.0;
  gp << "set format x ''\n";
  draw_outline(gp, project, verification, Plane::xz, {56.0, top - outline_height, 600.0, top});
  const auto [s_low, s_high] = range_of_s(project.beam);
  const Panel panel{{56.0, below, 600.0, below + height}, s_low, s_high, 0.0, 1.15 * highest};
  place(gp, panel);
  put_heading(gp, panel, "utilisation [%], lines through the worst places of one kind");
  draw_legend(gp, legend, 2.0);
  gp << "set format x '%g'\n";
  put_footing(gp, panel, "s [m], from the start of the beam");
  std::vector<std::string> plots{"100 with lines lw 1.3 dt (6,3) lc rgb '#202020'"};
  Labels labels;
  labels.keep_off(panel.at(s_low, 100.0), panel.at(s_high, 100.0));
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (std::size_t i = 0; i < curves[k].lines.size(); ++i) {
      const std::string data = fmt::format("u{}_{}", k, i);
      gp.block(data, curves[k].lines[i]);
      plots.push_back(fmt::format("${} using 1:2 with lines {}", data, line_style(k, 1.6)));
      plots.push_back(
          fmt::format("${} using 1:2 with points pt 7 ps 0.3 lc rgb '{}'", data, colour(k)));
      labels.keep_off(panel, curves[k].lines[i]);
    }
    if (curves[k].single.empty()) continue;
    const std::string data = fmt::format("single{}", k);
    gp.block(data, curves[k].single);
    plots.push_back(
        fmt::format("${} using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '{}'", data, colour(k)));
    for (const auto& [s, percent] : curves[k].single)
      labels.keep_off(panel.at(s, percent), panel.at(s, percent));
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
