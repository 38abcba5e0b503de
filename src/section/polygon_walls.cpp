#include "boxbeam/section/polygon_walls.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

using Place = Eigen::Vector2d;
using Loop = std::vector<Place>;

constexpr double infinity = std::numeric_limits<double>::infinity();

double cross(const Place& a, const Place& b) { return a.x() * b.y() - a.y() * b.x(); }

double area_of(const Loop& loop) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += cross(loop[i], loop[(i + 1) % loop.size()]);
  return 0.5 * sum;
}

double perimeter_of(const Loop& loop) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return sum;
}

/// The outer border first; all with the material on their left.
std::vector<Loop> loops_of(const Polygon& polygon) {
  std::vector<Loop> loops;
  const auto add = [&](const std::vector<SectionPlace>& places, double sign) {
    Loop loop;
    for (const SectionPlace& of : places) loop.emplace_back(of.y.value(), of.z.value());
    if (sign * area_of(loop) < 0.0) std::reverse(loop.begin(), loop.end());
    loops.push_back(std::move(loop));
  };
  add(polygon.outer, 1.0);
  for (const std::vector<SectionPlace>& hollow : polygon.hollows) add(hollow, -1.0);
  return loops;
}

/// How far the material reaches from a place of the border in a direction.
double reach(const std::vector<Loop>& loops, const Place& from, const Place& direction,
             double nothing) {
  double nearest = infinity;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Place a = loop[i] - from, way = loop[(i + 1) % loop.size()] - loop[i];
      const double by = cross(direction, way);
      if (by == 0.0) continue;
      const double distance = cross(a, way) / by, along = cross(a, direction) / by;
      if (distance > nothing && along >= 0.0 && along <= 1.0) nearest = std::min(nearest, distance);
    }
  }
  return nearest;
}

/// A step of a border.
struct Step {
  double length, thickness;
  Place direction;
};

std::vector<Step> steps_of(const std::vector<Loop>& loops, const Loop& loop, int per_edge,
                           double nothing) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Place way = loop[(i + 1) % loop.size()] - loop[i];
    const double length = way.norm();
    if (length <= nothing) continue;
    const Place direction = way / length, inward(-direction.y(), direction.x());
    for (int k = 0; k < per_edge; ++k) {
      const Place at = loop[i] + (k + 0.5) / per_edge * way;
      steps.push_back({length / per_edge, reach(loops, at, inward, nothing), direction});
    }
  }
  return steps;
}

/// The stretch around a step.
PolygonWall stretch_around(const std::vector<Step>& steps, std::size_t middle) {
  constexpr double as_thin = 1.5;
  const double turned = std::cos(std::numbers::pi / 6.0);
  const Step& of = steps[middle];
  const auto goes_on = [&](const Step& step) {
    return step.thickness <= as_thin * of.thickness && step.direction.dot(of.direction) >= turned;
  };
  const std::size_t count = steps.size();
  double length = of.length;
  std::size_t taken = 1;
  for (std::size_t k = 1; taken < count && goes_on(steps[(middle + k) % count]); ++k, ++taken)
    length += steps[(middle + k) % count].length;
  for (std::size_t k = 1; taken < count && goes_on(steps[(middle + count - k) % count]);
       ++k, ++taken)
    length += steps[(middle + count - k) % count].length;
  return {si<Length>(length), si<Length>(of.thickness)};
}

/// Between a corner of one border and an edge of another.
double nearest_of(const Loop& corners, const Loop& edges) {
  double nearest = infinity;
  for (const Place& corner : corners) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Place way = edges[(i + 1) % edges.size()] - edges[i];
      const double part =
          std::clamp((corner - edges[i]).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
      nearest = std::min(nearest, (corner - edges[i] - part * way).norm());
    }
  }
  return nearest;
}

}  // namespace

std::optional<PolygonWall> most_slender_wall_of(const Polygon& polygon) {
  const std::vector<Loop> loops = loops_of(polygon);
  const double size = perimeter_of(loops.front());
  if (!(size > 0.0)) return std::nullopt;
  std::size_t edges = 0;
  for (const Loop& loop : loops) edges += loop.size();
  const int per_edge = std::clamp(static_cast<int>(800 / edges), 3, 32);
  std::optional<PolygonWall> worst;
  for (const Loop& loop : loops) {
    const std::vector<Step> steps = steps_of(loops, loop, per_edge, 1e-9 * size);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const PolygonWall here = stretch_around(steps, i);
      if (!worst || here.slenderness() > worst->slenderness()) worst = here;
    }
  }
  return worst;
}

SecondMoment least_torsion_constant_of(const Polygon& polygon) {
  const SectionProperties of = properties_of(Section{polygon, {}});
  const double squared = of.area.value() * of.area.value();
  double I = 0.85 * squared * squared /
             (4.0 * std::numbers::pi * std::numbers::pi * (of.I_y + of.I_z).value());
  const std::vector<Loop> loops = loops_of(polygon);
  const Loop& outer = loops.front();
  double t = infinity;
  for (std::size_t i = 1; i < loops.size(); ++i)
    t = std::min({t, nearest_of(loops[i], outer), nearest_of(outer, loops[i])});
  if (loops.size() > 1) {
    const double perimeter = perimeter_of(outer);
    const double inside = std::max(0.0, area_of(outer) - perimeter * t);
    I = std::max(I, 4.0 * t * inside * inside / perimeter);
  }
  return si<SecondMoment>(I);
}

}  // namespace boxbeam
