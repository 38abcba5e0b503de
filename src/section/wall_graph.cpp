#include "boxbeam/section/wall_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/section/outline.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double quarter = 0.5 * std::numbers::pi;

/// Places along a line where something begins or ends, and nodes that are to stand there.
class Line {
 public:
  /// Walls along the line y = const (upright) or z = const, from one level to another.
  Line(WallGraph& graph, Wall pattern, bool upright, double across)
      : graph_(graph), pattern_(std::move(pattern)), upright_(upright), across_(across) {}

  void cut(double at) { cuts_.push_back({at, false, 0}); }
  void cut(double at, std::size_t node) { cuts_.push_back({at, true, node}); }
  void hollow(double low, double high) {
    hollows_.push_back({low, high});
    cut(low);
    cut(high);
  }

  /// Walls between the cuts, in ascending order. `first` and `last` are nodes that the ends belong
  /// to, if they lie elsewhere (a web's on the mid-line of the flange).
  void build(std::optional<std::size_t> first, std::optional<std::size_t> last) {
    std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) { return a.at < b.at; });
    std::size_t from = node_of(cuts_.front(), first);
    for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
      const bool at_end = i + 2 == cuts_.size();
      const std::size_t to = node_of(cuts_[i + 1], at_end ? last : std::nullopt);
      Wall wall = pattern_;
      wall.from = from;
      wall.to = to;
      wall.start = place(cuts_[i].at);
      wall.end = place(cuts_[i + 1].at);
      const double middle = 0.5 * (cuts_[i].at + cuts_[i + 1].at);
      wall.solid = std::none_of(hollows_.begin(), hollows_.end(), [&](const auto& hole) {
        return middle > hole[0] && middle < hole[1];
      });
      graph_.walls.push_back(wall);
      from = to;
    }
  }

 private:
  struct Cut {
    double at;
    bool known;
    std::size_t node;
  };

  Vector2d place(double at) const {
    return upright_ ? Vector2d(across_, at) : Vector2d(at, across_);
  }

  std::size_t node_of(const Cut& cut, std::optional<std::size_t> elsewhere) {
    if (cut.known) return cut.node;
    if (elsewhere) return *elsewhere;
    graph_.nodes.push_back(place(cut.at));
    return graph_.nodes.size() - 1;
  }

  WallGraph& graph_;
  Wall pattern_;
  bool upright_;
  double across_;
  std::vector<Cut> cuts_;
  std::vector<std::array<double, 2>> hollows_;
};

Wall pattern_of(double thickness, WallPart part, bool inner) {
  Wall wall;
  wall.thickness = thickness;
  wall.part = part;
  wall.inner = inner;
  return wall;
}

std::size_t add_node(WallGraph& graph, double y, double z) {
  graph.nodes.emplace_back(y, z);
  return graph.nodes.size() - 1;
}

void cut_holes(Line& line, const std::vector<Hole>& holes, HoleWalls walls) {
  for (const Hole& hole : holes) {
    if (hole.walls != walls) continue;
    const double at = hole.position.value();
    const double radius = 0.5 * hole.diameter.value();
    line.hollow(at - radius, at + radius);
    if (walls == HoleWalls::flanges && at != 0.0) line.hollow(-at - radius, -at + radius);
  }
}

void add_walls(WallGraph& graph, const Box& box, const std::vector<Hole>& holes, bool inner) {
  const double y = 0.5 * box.width.value();
  const double z = 0.5 * box.height.value();
  const double t_top = box.top_flange.value(), t_bottom = box.bottom_flange.value();
  const double t_left = box.left_web.value(), t_right = box.right_web.value();
  const double y_left = y - 0.5 * t_left, y_right = -y + 0.5 * t_right;
  const double z_top = z - 0.5 * t_top, z_bottom = -z + 0.5 * t_bottom;
  const std::size_t top_left = add_node(graph, y_left, z_top);
  const std::size_t top_right = add_node(graph, y_right, z_top);
  const std::size_t bottom_left = add_node(graph, y_left, z_bottom);
  const std::size_t bottom_right = add_node(graph, y_right, z_bottom);

  Line top(graph, pattern_of(t_top, WallPart::top_flange, inner), false, z_top);
  Line bottom(graph, pattern_of(t_bottom, WallPart::bottom_flange, inner), false, z_bottom);
  Line left(graph, pattern_of(t_left, WallPart::left_web, inner), true, y_left);
  Line right(graph, pattern_of(t_right, WallPart::right_web, inner), true, y_right);
  for (Line* flange : {&top, &bottom}) {
    flange->cut(-y);
    flange->cut(y);
    cut_holes(*flange, holes, HoleWalls::flanges);
  }
  top.cut(y_left, top_left);
  top.cut(y_right, top_right);
  bottom.cut(y_left, bottom_left);
  bottom.cut(y_right, bottom_right);
  for (Line* web : {&left, &right}) {
    web->cut(-z + t_bottom);
    web->cut(z - t_top);
    cut_holes(*web, holes, HoleWalls::webs);
  }

  for (const Stiffener& bar : box.stiffeners) {
    const double place = bar.place.value(), depth = bar.depth.value();
    Wall wall = pattern_of(bar.thickness.value(), WallPart::stiffener, inner);
    switch (bar.plate) {
      case BoxPlate::top_flange:
        wall.from = add_node(graph, place, z_top);
        wall.start = {place, z - t_top};
        wall.end = {place, z - t_top - depth};
        top.cut(place, wall.from);
        break;
      case BoxPlate::bottom_flange:
        wall.from = add_node(graph, place, z_bottom);
        wall.start = {place, -z + t_bottom};
        wall.end = {place, -z + t_bottom + depth};
        bottom.cut(place, wall.from);
        break;
      case BoxPlate::left_web:
        wall.from = add_node(graph, y_left, place);
        wall.start = {y - t_left, place};
        wall.end = {y - t_left - depth, place};
        left.cut(place, wall.from);
        break;
      case BoxPlate::right_web:
        wall.from = add_node(graph, y_right, place);
        wall.start = {-y + t_right, place};
        wall.end = {-y + t_right + depth, place};
        right.cut(place, wall.from);
        break;
    }
    wall.to = add_node(graph, wall.end.x(), wall.end.y());
    graph.walls.push_back(wall);
  }
  top.build({}, {});
  bottom.build({}, {});
  left.build(bottom_left, top_left);
  right.build(bottom_right, top_right);
}

/// Exact area and first moments of the corner of a rolled tube in the first quadrant, beyond the
/// lines from which both walls are straight.
Vector3d corner_lump(const RectangularTube& tube) {
  const double r_o = tube.outer_radius.value(), r_i = tube.inner_radius.value();
  const double t = tube.wall.value();
  const double flat = std::max(r_o, t + r_i);
  // Square of side `flat`, less the outer spandrel, less the clear square with its fillet. All
  // about the outer sharp corner, both directions alike: area and distance integral.
  constexpr double pi = std::numbers::pi;
  const auto spandrel = [](double r) {
    // r^2 (1 - pi/4), centroid (10 - 3 pi)/(12 - 3 pi) r from its corner.
    const double area = r * r * (1.0 - 0.25 * pi);
    return std::array{area, area * r * (10.0 - 3.0 * pi) / (12.0 - 3.0 * pi)};
  };
  const auto [outer_area, outer_first] = spandrel(r_o);
  const auto [inner_area, inner_first] = spandrel(r_i);
  const double clear = flat - t;
  const double area = flat * flat - outer_area - (clear * clear - inner_area);
  const double first = 0.5 * flat * flat * flat - outer_first -
                       (clear * clear * (t + 0.5 * clear) - (inner_area * t + inner_first));
  const double y = 0.5 * tube.width.value(), z = 0.5 * tube.height.value();
  return {area, y * area - first, z * area - first};
}

void add_walls(WallGraph& graph, const RectangularTube& tube, const std::vector<Hole>& holes,
               bool inner) {
  if (tube.outer_radius.value() == 0.0) {
    add_walls(graph, symmetric_box(tube.width, tube.height, tube.wall, tube.wall), holes, inner);
    return;
  }
  const double t = tube.wall.value();
  const double y = 0.5 * tube.width.value(), z = 0.5 * tube.height.value();
  const double flat = std::max(tube.outer_radius.value(), t + tube.inner_radius.value());
  const Vector3d lump = corner_lump(tube);
  std::size_t ends[4][2];  // of each corner, counter-clockwise from the first quadrant
  const double signs[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [s_y, s_z] = signs[k];
    Wall wall = pattern_of(t, WallPart::corner, inner);
    wall.centre = {s_y * (y - flat), s_z * (z - flat)};
    wall.radius = flat - 0.5 * t;
    wall.angle = static_cast<double>(k) * quarter;
    wall.sweep = quarter;
    wall.lump = Vector3d(lump[0], s_y * lump[1], s_z * lump[2]);
    wall.start = point_on(wall, 0.0);
    wall.end = point_on(wall, 1.0);
    wall.from = ends[k][0] = add_node(graph, wall.start.x(), wall.start.y());
    wall.to = ends[k][1] = add_node(graph, wall.end.x(), wall.end.y());
    graph.walls.push_back(wall);
  }
  const auto build = [&](WallPart part, bool upright, double across, double half, std::size_t low,
                         std::size_t high) {
    Line line(graph, pattern_of(t, part, inner), upright, across);
    line.cut(-half, low);
    line.cut(half, high);
    cut_holes(line, holes, upright ? HoleWalls::webs : HoleWalls::flanges);
    line.build({}, {});
  };
  build(WallPart::top_flange, false, z - 0.5 * t, y - flat, ends[1][0], ends[0][1]);
  build(WallPart::bottom_flange, false, -z + 0.5 * t, y - flat, ends[2][1], ends[3][0]);
  build(WallPart::left_web, true, y - 0.5 * t, z - flat, ends[3][1], ends[0][0]);
  build(WallPart::right_web, true, -y + 0.5 * t, z - flat, ends[2][0], ends[1][1]);
}

void add_walls(WallGraph& graph, const RoundTube& tube, const std::vector<Hole>&, bool inner) {
  constexpr std::size_t parts = 8;
  const std::size_t first = graph.nodes.size();
  for (std::size_t k = 0; k < parts; ++k) {
    Wall wall = pattern_of(tube.wall.value(), WallPart::path, inner);
    wall.radius = 0.5 * (tube.diameter - tube.wall).value();
    wall.sweep = full_turn / parts;
    wall.angle = static_cast<double>(k) * wall.sweep;
    wall.start = point_on(wall, 0.0);
    wall.end = point_on(wall, 1.0);
    wall.from = first + k;
    wall.to = first + (k + 1) % parts;
    graph.nodes.push_back(wall.start);
    graph.walls.push_back(wall);
  }
}

void add_walls(WallGraph& graph, const ThinWalled& path, const std::vector<Hole>&, bool inner) {
  const std::size_t first = graph.nodes.size();
  for (const SectionPlace& node : path.nodes) add_node(graph, node.y.value(), node.z.value());
  for (const ThinWall& given : path.walls) {
    Wall wall = pattern_of(given.thickness.value(), WallPart::path, inner);
    wall.from = first + given.from;
    wall.to = first + given.to;
    const Vector2d a = graph.nodes[wall.from], b = graph.nodes[wall.to];
    const Vector2d along = (b - a).normalized();
    // What reaches beyond its node is a stub of its own, so that its force enters at the node.
    const auto add_stub = [&](std::size_t node, const Vector2d& outwards, double reach) {
      Wall stub = wall;
      stub.from = node;
      stub.start = graph.nodes[node];
      stub.end = stub.start + reach * outwards;
      stub.to = add_node(graph, stub.end.x(), stub.end.y());
      graph.walls.push_back(stub);
    };
    const double trim_from = given.trim_from.value(), trim_to = given.trim_to.value();
    wall.start = a + std::max(0.0, trim_from) * along;
    wall.end = b - std::max(0.0, trim_to) * along;
    graph.walls.push_back(wall);
    if (trim_from < 0.0) add_stub(wall.from, -along, -trim_from);
    if (trim_to < 0.0) add_stub(wall.to, along, -trim_to);
  }
}

bool is_solid(const Profile& profile) {
  return std::holds_alternative<Plate>(profile) || std::holds_alternative<Polygon>(profile);
}

void add_walls(WallGraph&, const Plate&, const std::vector<Hole>&, bool) {}
void add_walls(WallGraph&, const Polygon&, const std::vector<Hole>&, bool) {}

}  // namespace

std::optional<WallGraph> wall_graph_of(const Section& section, const std::vector<Hole>& holes) {
  if (is_solid(section.outer) || (section.inner && is_solid(*section.inner))) return std::nullopt;
  WallGraph graph;
  std::visit([&](const auto& shape) { add_walls(graph, shape, holes, false); }, section.outer);
  if (section.inner) {
    std::visit([&](const auto& shape) { add_walls(graph, shape, {}, true); }, *section.inner);
  }
  return graph;
}

double length_of(const Wall& wall) {
  return wall.radius > 0.0 ? wall.radius * std::abs(wall.sweep) : (wall.end - wall.start).norm();
}

Vector2d point_on(const Wall& wall, double fraction) {
  if (wall.radius == 0.0) return wall.start + fraction * (wall.end - wall.start);
  const double angle = wall.angle + fraction * wall.sweep;
  return wall.centre + wall.radius * Vector2d(std::cos(angle), std::sin(angle));
}

Vector2d direction_on(const Wall& wall, double fraction) {
  if (wall.radius == 0.0) return (wall.end - wall.start).normalized();
  const double angle = wall.angle + fraction * wall.sweep;
  return (wall.sweep > 0.0 ? 1.0 : -1.0) * Vector2d(-std::sin(angle), std::cos(angle));
}

Vector3d material_up_to(const Wall& wall, double fraction) {
  if (!wall.solid) return Vector3d::Zero();
  if (wall.lump) return fraction * *wall.lump;
  const double t = wall.thickness;
  if (wall.radius == 0.0) {
    const double area = fraction * t * (wall.end - wall.start).norm();
    const Vector2d centre = point_on(wall, 0.5 * fraction);
    return {area, area * centre.x(), area * centre.y()};
  }
  // Sector of a ring: r dr gives t r_m, r^2 dr gives t (r_m^2 + t^2/12).
  const double sign = wall.sweep > 0.0 ? 1.0 : -1.0;
  const double from = wall.angle, to = wall.angle + fraction * wall.sweep;
  const double area = t * wall.radius * fraction * std::abs(wall.sweep);
  const double radial = sign * t * (wall.radius * wall.radius + t * t / 12.0);
  return {area, wall.centre.x() * area + radial * (std::sin(to) - std::sin(from)),
          wall.centre.y() * area - radial * (std::cos(to) - std::cos(from))};
}

}  // namespace boxbeam
