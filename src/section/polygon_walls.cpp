#include "boxbeam/section/polygon_walls.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

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

/// The next border from a place of one in a direction.
struct Facing {
  double distance = infinity;
  const Loop* loop = nullptr;
};

Facing facing(const std::vector<Loop>& loops, const Place& from, const Place& direction,
              double nothing) {
  Facing nearest;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Place a = loop[i] - from, way = loop[(i + 1) % loop.size()] - loop[i];
      const double by = cross(direction, way);
      if (by == 0.0) continue;
      const double distance = cross(a, way) / by, along = cross(a, direction) / by;
      if (distance > nothing && distance < nearest.distance && along >= 0.0 && along <= 1.0)
        nearest = {distance, &loop};
    }
  }
  return nearest;
}

/// A step of a border.
struct Step {
  double length, thickness;
  Place direction;
  bool of_cell;
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
      const Facing behind = facing(loops, at, inward, nothing);
      steps.push_back({length / per_edge, behind.distance, direction, behind.loop != &loop});
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
    return step.thickness <= as_thin * of.thickness && step.direction.dot(of.direction) >= turned &&
           step.of_cell == of.of_cell;
  };
  const std::size_t count = steps.size();
  double length = of.length;
  std::size_t taken = 1;
  for (std::size_t k = 1; taken < count && goes_on(steps[(middle + k) % count]); ++k, ++taken)
    length += steps[(middle + k) % count].length;
  for (std::size_t k = 1; taken < count && goes_on(steps[(middle + count - k) % count]);
       ++k, ++taken)
    length += steps[(middle + count - k) % count].length;
  return {si<Length>(length), si<Length>(of.thickness), of.of_cell};
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

bool is_inside(const Loop& loop, const Place& at) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Place &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y() > at.y()) == (b.y() > at.y())) continue;
    if (at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

/// The bound by the distance d from all borders, 4 (int d dA)^2/A, the integral on a grid of which
/// 5 % is left out: by so much it may be wrong in walls as thin as plates of class 3 are.
double by_distances(const std::vector<Loop>& loops, double thinnest) {
  constexpr double of_grid = 0.95, across_a_wall = 6.0;
  Eigen::AlignedBox2d around;
  for (const Place& corner : loops.front()) around.extend(corner);
  const double wanted = across_a_wall * around.sizes().maxCoeff() / thinnest;
  const int steps = static_cast<int>(std::clamp(wanted, 24.0, 120.0));
  const Place step = around.sizes() / steps;
  double area = 0.0, sum = 0.0;
  for (const Loop& loop : loops) area += area_of(loop);
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const Place at = around.min() + Place((i + 0.5) * step.x(), (k + 0.5) * step.y());
      bool inside = false;  // an odd number of borders
      double nearest = infinity;
      for (const Loop& loop : loops) {
        inside = inside != is_inside(loop, at);
        nearest = std::min(nearest, nearest_of({at}, loop));
      }
      if (inside) sum += nearest;
    }
  }
  sum *= of_grid * step.x() * step.y();
  return 4.0 * sum * sum / area;
}

/// The bound by min(d, t), d from the outer border, t its smallest distance from a hollow. Within s
/// of the border lies no more than U s and, at corners that reach into the section, a sector.
double around_hollows(const std::vector<Loop>& loops) {
  const Loop& outer = loops.front();
  double t = infinity;
  for (std::size_t i = 1; i < loops.size(); ++i)
    t = std::min({t, nearest_of(loops[i], outer), nearest_of(outer, loops[i])});
  double turned = 0.0;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Place in = outer[(i + 1) % outer.size()] - outer[i];
    const Place out = outer[(i + 2) % outer.size()] - outer[(i + 1) % outer.size()];
    turned += std::max(0.0, -std::atan2(cross(in, out), in.dot(out)));
  }
  const double perimeter = perimeter_of(outer);
  const double volume = t * (area_of(outer) - t * (0.5 * perimeter + turned * t / 6.0));
  const double strip = t * (perimeter + 0.5 * turned * t);
  return strip > 0.0 && volume > 0.0 ? 4.0 * volume * volume / strip : 0.0;
}

}  // namespace

std::optional<PolygonWall> most_slender_wall_of(const Polygon& polygon) {
  const std::vector<Loop> loops = loops_of(polygon);
  const double size = perimeter_of(loops.front());
  if (!(size > 0.0)) return std::nullopt;
  std::size_t edges = 0;
  for (const Loop& loop : loops) edges += loop.size();
  const int per_edge = std::clamp(static_cast<int>(800 / std::max<std::size_t>(1, edges)), 3, 32);
  // A wall of a cell is held at both ends and may be three times as slender (42 eps, 14 eps).
  const auto counted = [](const PolygonWall& of) {
    return of.of_cell ? of.slenderness() / 3.0 : of.slenderness();
  };
  std::optional<PolygonWall> worst;
  for (const Loop& loop : loops) {
    const std::vector<Step> steps = steps_of(loops, loop, per_edge, 1e-9 * size);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const PolygonWall here = stretch_around(steps, i);
      if (!worst || counted(here) > counted(*worst)) worst = here;
    }
  }
  return worst;
}

SecondMoment least_torsion_constant_of(const Polygon& polygon) {
  const std::vector<Loop> loops = loops_of(polygon);
  const auto wall = most_slender_wall_of(polygon);
  if (!wall) return {};
  double I = by_distances(loops, wall->thickness.value());
  if (loops.size() > 1) I = std::max(I, around_hollows(loops));
  return si<SecondMoment>(I);
}

}  // namespace boxbeam
