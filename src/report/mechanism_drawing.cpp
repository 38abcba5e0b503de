#include "mechanism_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/format.hpp"

namespace boxbeam::plot {

std::string draw_bodies(Script& gp, const PostureFigure& posture, const View& view,
                        const Ink& ink) {
  std::vector<std::string> plots;
  const auto strokes = [&](const std::string& name, const std::vector<PostureFigure::Stroke>& lines,
                           const std::string& style) {
    if (lines.empty()) return;
    std::vector<Row4> rows;
    for (const auto& line : lines) {
      const Eigen::Vector3d along = line.to - line.from;
      rows.emplace_back(line.from[view.across], line.from[view.up], along[view.across],
                        along[view.up]);
    }
    gp.block(name, rows);
    plots.push_back(fmt::format("${} using 1:2:3:4 with vectors nohead {} lc rgb '{}'", name, style,
                                ink.colour));
  };
  const auto points = [&](const std::string& name, const std::vector<Eigen::Vector3d>& places,
                          const std::string& style, const std::string& rgb) {
    if (places.empty()) return;
    std::vector<Row2> rows;
    for (const Eigen::Vector3d& place : places)
      rows.emplace_back(place[view.across], place[view.up]);
    gp.block(name, rows);
    plots.push_back(fmt::format("${} using 1:2 with {} lc rgb '{}'", name, style, rgb));
  };
  std::vector<PostureFigure::Stroke> guides;
  for (const auto& guide : posture.guides) {
    guides.push_back(
        {guide.from - ink.guide_length * guide.to, guide.from + ink.guide_length * guide.to});
  }
  strokes(ink.prefix + "_guides", guides, "lw 1 dt 3");
  strokes(ink.prefix + "_rods", posture.rods, "lw 2 dt 2");
  for (std::size_t b = 0; b < posture.bodies.size(); ++b) {
    const auto& body = posture.bodies[b];
    const std::string name = fmt::format("{}_{}", ink.prefix, b);
    if (body.beam) {
      strokes(name + "_axis", body.strokes, "lw 5");
      points(name, body.points, "points pt 7 ps 0.6", ink.colour);
    } else if (body.points.size() == 1) {
      points(name, body.points, "points pt 5 ps 1.6", ink.colour);
    } else if (!body.strokes.empty()) {
      strokes(name + "_lines", body.strokes, "lw 2");
      points(name, body.points, "points pt 7 ps 0.5", ink.colour);
    } else {
      points(name, body.points, "linespoints lw 2 pt 7 ps 0.5", ink.colour);
    }
  }
  points(ink.prefix + "_grounds", posture.grounds, "points pt 9 ps 1.2", "#505050");
  return fmt::format("{}", fmt::join(plots, ", "));
}

void draw_loads(Script& gp, const PostureFigure& posture, const View& view,
                double metres_per_newton, bool with_size) {
  constexpr const char* ink = "#202020";
  int number = 0;
  double longest = 0.0;
  for (const BeamLoadRow& row : posture.loads) longest = std::max(longest, row.world.norm());
  const auto seen = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector2d(v[view.across], v[view.up]);
  };
  std::vector<std::pair<const BeamLoadRow*, Eigen::Vector2d>> tails;
  for (const BeamLoadRow& row : posture.loads) {
    const double length = seen(row.world).norm();
    if (length < 0.05 * longest && length < 0.3 * row.world.norm()) continue;
    tails.emplace_back(&row, seen(row.place) - metres_per_newton * seen(row.world));
  }
  for (const auto& [load, tail] : tails) {
    const BeamLoadRow& row = *load;
    const Eigen::Vector2d force = seen(row.world);
    const Eigen::Vector2d place = seen(row.place);
    const bool from_left = force.x() > 0.0;
    ++number;
    const std::string name =
        row.name.empty() ? fmt::format("s = {} m", text::significant(row.s.value(), 3)) : row.name;
    gp << "set arrow " << number << " from " << tail.x() << "," << tail.y() << " to " << place.x()
       << "," << place.y() << " lw 2 lc rgb '" << ink << "' front\n";
    gp << "set label " << number << " "
       << quoted(with_size ? name + "  " + text::kN(row.world.norm()) : name) << " at " << tail.x()
       << "," << tail.y();
    if (with_size) {
      gp << (from_left ? " right offset -0.3,0.9" : " left offset 0.3,0.9");
    } else {
      // Beyond the tail, where the arrow itself is not in the way; beside another name apart from
      // it.
      const Eigen::Vector2d back = -force.normalized();
      const char* side = " center";
      for (const auto& [other, other_tail] : tails) {
        const Eigen::Vector2d apart = (tail - other_tail) / (metres_per_newton * longest);
        if (other == &row || std::abs(apart.x()) > 0.8 || std::abs(apart.y()) > 0.6) continue;
        side = apart.x() < 0.0 || (apart.x() == 0.0 && &row < other) ? " right" : " left";
      }
      gp << side << " offset " << 3.2 * back.x() << "," << 0.9 * back.y();
    }
    gp << " tc rgb '" << ink << "' front noenhanced\n";
  }
}

Extent extent_of(const std::vector<PostureFigure>& postures) {
  Extent extent;
  const auto take = [&](const Eigen::Vector3d& point) {
    extent.low = extent.low.cwiseMin(point);
    extent.high = extent.high.cwiseMax(point);
  };
  for (const PostureFigure& posture : postures) {
    for (const auto& body : posture.bodies) {
      for (const Eigen::Vector3d& point : body.points) take(point);
    }
    for (const Eigen::Vector3d& place : posture.grounds) take(place);
  }
  return extent;
}

}  // namespace boxbeam::plot
