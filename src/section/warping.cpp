#include "boxbeam/section/warping.hpp"

#include <algorithm>
#include <limits>

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
  double area = 0.0, first = 0.0, second = 0.0;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Wall& wall : graph.walls) {
    const Eigen::Vector2d& node = graph.nodes[wall.from];
    const double a = *omega[wall.from] + swept(pole, node, wall.start);
    const double b = *omega[wall.from] + swept(pole, node, wall.end);
    const double dA = wall.thickness * length_of(wall);
    area += dA;
    first += 0.5 * (a + b) * dA;
    second += (a * a + a * b + b * b) / 3.0 * dA;
    lowest = std::min({lowest, a, b});
    highest = std::max({highest, a, b});
  }
  const double mean = first / area;
  return Warping{second - first * mean, std::max(highest - mean, mean - lowest)};
}

std::optional<double> warping_constant_of(const Profile& profile) {
  const auto of = warping_of(profile);
  return of ? std::optional(of->I_w) : std::nullopt;
}

}  // namespace boxbeam
