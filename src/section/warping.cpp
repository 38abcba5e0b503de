#include "boxbeam/section/warping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/wall_graph.hpp"

namespace boxbeam {
namespace {

/// Twice the area that the way from one place to another sweeps about a pole.
double swept(const Eigen::Vector2d& pole, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d arm = from - pole, way = to - from;
  return arm.x() * way.y() - arm.y() * way.x();
}

}  // namespace

std::optional<Warping> warping_of(const Profile& profile) {
  const Section section{profile, {}};
  if (!std::holds_alternative<ThinWalled>(profile) || enclosed_area_of(profile).value() > 0.0)
    return std::nullopt;
  const auto centre = torsion_properties_of(section).shear_centre;
  if (!centre) return std::nullopt;
  const Eigen::Vector2d pole(centre->y.value(), centre->z.value());
  const WallGraph graph = *wall_graph_of(section, {});
  // What has no cells hangs together by one way only from any node to any other.
  std::vector<std::optional<double>> omega(graph.nodes.size());
  omega[graph.walls.front().from] = 0.0;
  for (bool found = true; found;) {
    found = false;
    for (const Wall& wall : graph.walls) {
      if (omega[wall.from].has_value() == omega[wall.to].has_value()) continue;
      const double way = swept(pole, graph.nodes[wall.from], graph.nodes[wall.to]);
      if (omega[wall.from])
        omega[wall.to] = *omega[wall.from] + way;
      else
        omega[wall.from] = *omega[wall.to] - way;
      found = true;
    }
  }
  std::vector<Warping::Line> lines;
  double area = 0.0, first = 0.0, square = 0.0;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Wall& wall : graph.walls) {
    const Eigen::Vector2d& node = graph.nodes[wall.from];
    const double a = *omega[wall.from] + swept(pole, node, wall.start);
    const double b = *omega[wall.from] + swept(pole, node, wall.end);
    const double dA = wall.thickness * length_of(wall);
    area += dA;
    first += 0.5 * (a + b) * dA;
    square += (a * a + a * b + b * b) / 3.0 * dA;
    lines.push_back({wall.start, wall.end, a, b, wall.thickness});
    lowest = std::min({lowest, a, b});
    highest = std::max({highest, a, b});
  }
  const double mean = first / area;
  for (Warping::Line& line : lines) {
    line.omega_from -= mean;
    line.omega_to -= mean;
  }
  return Warping{square - first * mean, std::max(highest - mean, mean - lowest), std::move(lines)};
}

double omega_near(const Warping& of, const Eigen::Vector2d& place) {
  double least = std::numeric_limits<double>::infinity(), omega = 0.0;
  for (const Warping::Line& line : of.walls) {
    const Eigen::Vector2d way = line.to - line.from;
    const double part = std::clamp((place - line.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (place - line.from - part * way).norm();
    if (distance >= least) continue;
    least = distance;
    omega = std::lerp(line.omega_from, line.omega_to, part);
  }
  return omega;
}

std::optional<double> warping_constant_of(const Profile& profile) {
  const auto of = warping_of(profile);
  return of ? std::optional(of->I_w) : std::nullopt;
}

}  // namespace boxbeam
