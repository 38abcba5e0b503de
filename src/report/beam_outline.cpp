#include "beam_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/section/section.hpp"

namespace boxbeam::plot {
namespace {

/// Lower and upper end of a profile in a plane [mm].
std::pair<double, double> reach_of(const Profile& profile, Plane plane) {
  const Extent extent = extent_of(profile);
  const bool upright = plane == Plane::xz;
  return {1e3 * (upright ? extent.z_low : extent.y_low).value(),
          1e3 * (upright ? extent.z_high : extent.y_high).value()};
}

/// Lines along the beam, a pair of rows for each segment.
struct Lines {
  std::vector<Row2> upper, lower;

  void add(double s, const std::pair<double, double>& reach) {
    lower.emplace_back(s, reach.first);
    upper.emplace_back(s, reach.second);
  }
};

Lines border_of(const TaperedBeam& beam, Plane plane) {
  Lines lines;
  for (const Segment& segment : beam.segments) {
    lines.add(segment.start.value(), reach_of(segment.from.outer, plane));
    lines.add(segment.end().value(), reach_of(segment.to.outer, plane));
  }
  return lines;
}

/// Diaphragms across the profile, with a gap for an opening in their middle.
void add_diaphragms(std::vector<Row4>& strokes, const TaperedBeam& beam, Plane plane) {
  for (const Diaphragm& of : beam.diaphragms) {
    const auto [low, high] = reach_of(section_at(beam, {of.s}).outer, plane);
    const double s = of.s.value(), middle = 0.5 * (low + high), half = 0.5e3 * of.opening.value();
    strokes.emplace_back(s, low, 0.0, middle - half - low);
    strokes.emplace_back(s, middle + half, 0.0, high - middle - half);
  }
}

/// Thin lines inside: the inner faces of the flanges where they are seen, an inner profile, and
/// diaphragms.
std::vector<Row4> inner_lines_of(const TaperedBeam& beam, Plane plane) {
  std::vector<Row4> strokes;
  for (const Segment& segment : beam.segments) {
    const double s = segment.start.value();
    const auto add = [&](double from, double to) {
      strokes.emplace_back(s, from, segment.length.value(), to - from);
    };
    const bool hollow = std::holds_alternative<Box>(segment.from.outer) ||
                        std::holds_alternative<RectangularTube>(segment.from.outer);
    if (plane == Plane::xz && hollow) {
      add(1e3 * clear_top_of(segment.from.outer).value(),
          1e3 * clear_top_of(segment.to.outer).value());
      add(1e3 * clear_bottom_of(segment.from.outer).value(),
          1e3 * clear_bottom_of(segment.to.outer).value());
    }
    if (!segment.from.inner) continue;
    const auto from = reach_of(*segment.from.inner, plane);
    const auto to = reach_of(*segment.to.inner, plane);
    add(from.first, to.first);
    add(from.second, to.second);
  }
  add_diaphragms(strokes, beam, plane);
  return strokes;
}

/// Holes as they are seen: round where they go through the walls in front, else a gap in the
/// border.
void draw_holes(Script& gp, const Project& project, Plane plane) {
  for (const BeamHole& at : project.holes) {
    const double s = at.s.value();
    const double d = at.hole.diameter.value();
    const bool in_front = (at.hole.walls == HoleWalls::webs) == (plane == Plane::xz);
    const double place = 1e3 * at.hole.position.value();
    if (in_front) {
      for (const double centre : {place, -place}) {
        const bool mirrored = at.hole.walls == HoleWalls::flanges;
        if (centre != place && !mirrored) continue;
        gp << fmt::format(
            "set object ellipse center {},{} size {},{} front fs solid noborder fc rgb '#ffffff'\n"
            "set object ellipse center {},{} size {},{} front fs empty border lc rgb '#303030'\n",
            s, centre, d, 1e3 * d, s, centre, d, 1e3 * d);
      }
      continue;
    }
    const auto reach = reach_of(section_at(project.beam, {at.s}).outer, plane);
    for (const double edge : {reach.first, reach.second}) {
      gp << fmt::format("set arrow from {},{} to {},{} nohead lw 3 lc rgb '#ffffff' front\n",
                        s - 0.5 * d, edge, s + 0.5 * d, edge);
    }
  }
}

}  // namespace

std::pair<double, double> range_of_s(const TaperedBeam& beam) {
  const double length = beam.length().value();
  return {-0.02 * length, 1.02 * length};
}

void draw_outline(Script& gp, const Project& project, const Verification& verification, Plane plane,
                  const Frame& frame) {
  const char* axis = plane == Plane::xz ? "z" : "y";
  const TaperedBeam& beam = project.beam;
  const Lines border = border_of(beam, plane);
  std::vector<Row2> outline = border.upper;
  outline.insert(outline.end(), border.lower.rbegin(), border.lower.rend());
  outline.push_back(outline.front());
  double low = 0.0;
  double high = 0.0;
  for (const Row2& row : outline) {
    low = std::min(low, std::get<1>(row));
    high = std::max(high, std::get<1>(row));
  }
  const double height = high - low;
  const std::string name = fmt::format("outline_{}", axis);
  gp.block(name, outline);
  std::vector<std::string> curves{
      fmt::format("${} using 1:2 with filledcurves closed fc rgb '#e3eaf2'", name)};
  const std::vector<Row4> inner = inner_lines_of(beam, plane);
  if (!inner.empty()) {
    gp.block("inner_" + name, inner);
    curves.push_back(
        fmt::format("$inner_{} using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0'", name));
  }
  curves.push_back(fmt::format("${} using 1:2 with lines lc rgb '#303030' lw 1.3", name));

  const auto [s_low, s_high] = range_of_s(beam);
  const Panel panel{frame, s_low, s_high, low - 0.35 * height, high + 0.35 * height};
  std::vector<Row2> supports;
  for (const BeamLoadRow& row : verification.pictures.loads) {
    const Row2 place(row.s.value(), low - 0.17 * height);
    const bool known = std::any_of(supports.begin(), supports.end(), [&](const Row2& other) {
      return std::abs(std::get<0>(other) - row.s.value()) < 1e-6 * beam.length().value();
    });
    // A load that slides has no place of its own.
    const bool slides =
        std::any_of(verification.pictures.loads.begin(), verification.pictures.loads.end(),
                    [&](const BeamLoadRow& other) {
                      return !row.name.empty() && other.name == row.name &&
                             std::abs((other.s - row.s).value()) > 1e-6 * beam.length().value();
                    });
    if (!known && !slides) supports.push_back(place);
  }
  if (!supports.empty()) {
    gp.block("supports_" + name, supports);
    curves.push_back(
        fmt::format("$supports_{} using 1:2 with points pt 9 ps 1 lc rgb '#303030'", name));
  }
  place(gp, panel);
  put_heading(gp, panel, fmt::format("beam, {} [mm]", axis));
  // An axis that ends with the beam: two or three figures say how high it is.
  double step = tic_step(height, 2);
  for (int most = 3; step > 0.8 * height; ++most) step = tic_step(height, most);
  gp << "set ytics " << step << "\n";
  draw_holes(gp, project, plane);
  Labels labels;
  labels.keep_free({frame.left - 44.0, frame.top + 7.0, frame.left + 60.0, frame.top + 23.0});
  for (const BeamPoint& point : beam.points) {
    const double s = point.s.value();
    const Pixel top = panel.at(s, high + 0.1 * height);
    put_line(gp, top, panel.at(s, low - 0.1 * height), "lw 0.8 dt (2,3) lc rgb '#707070' front");
    Frame above = frame;
    above.left -= 30.0;
    above.right += 12.0;
    above.top += 20.0;
    above.bottom = top.y() - 2.0;
    labels.put(gp, fitted(point.name, 150.0), top, above, "#202020", 2.0);
  }
  gp.plot(curves);
}

}  // namespace boxbeam::plot
