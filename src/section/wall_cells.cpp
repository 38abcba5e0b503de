#include "boxbeam/section/wall_cells.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace boxbeam {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Walls at each node, in their order, of all nodes in one list.
class WallsAtNodes {
 public:
  explicit WallsAtNodes(const WallGraph& graph)
      : begin_(graph.nodes.size() + 2, 0), walls_(2 * graph.walls.size()) {
    for (const Wall& wall : graph.walls) {
      ++begin_[wall.from + 2];
      ++begin_[wall.to + 2];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for (std::size_t i = 0; i < graph.walls.size(); ++i) {
      walls_[begin_[graph.walls[i].from + 1]++] = i;
      walls_[begin_[graph.walls[i].to + 1]++] = i;
    }
  }
  std::span<const std::size_t> operator[](std::size_t node) const {
    return std::span(walls_).subspan(begin_[node], begin_[node + 1] - begin_[node]);
  }

 private:
  std::vector<std::size_t> begin_, walls_;
};

std::size_t other_end(const Wall& wall, std::size_t node) {
  return wall.from == node ? wall.to : wall.from;
}

/// Breadth-first trees; fills upstream, component and total.
void cut_open(const WallGraph& graph, WallCells& cells) {
  const WallsAtNodes at(graph);
  std::vector<std::size_t> parent(graph.nodes.size(), none);  // wall towards the root
  std::vector<std::size_t> component(graph.nodes.size(), none);
  std::vector<std::size_t> order;
  order.reserve(graph.nodes.size());
  for (std::size_t root = 0; root < graph.nodes.size(); ++root) {
    if (component[root] != none) continue;
    component[root] = cells.total.size();
    cells.total.emplace_back(Vector3d::Zero());
    std::size_t next = order.size();
    order.push_back(root);
    for (; next < order.size(); ++next) {
      for (const std::size_t wall : at[order[next]]) {
        const std::size_t node = other_end(graph.walls[wall], order[next]);
        if (component[node] != none) continue;
        component[node] = component[root];
        parent[node] = wall;
        order.push_back(node);
      }
    }
  }
  std::vector<bool> in_tree(graph.walls.size(), false);
  for (const std::size_t wall : parent) {
    if (wall != none) in_tree[wall] = true;
  }
  // A chord is cut at its end `to` and hangs on its node `from`.
  std::vector<Vector3d> hanging(graph.nodes.size(), Vector3d::Zero());
  cells.upstream.resize(graph.walls.size());
  cells.component.resize(graph.walls.size());
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Vector3d material = material_up_to(graph.walls[i], 1.0);
    cells.component[i] = component[graph.walls[i].from];
    cells.total[cells.component[i]] += material;
    if (in_tree[i]) continue;
    cells.upstream[i] = -material;
    hanging[graph.walls[i].from] += material;
  }
  for (std::size_t k = order.size(); k-- > 0;) {
    const std::size_t node = order[k];
    if (parent[node] == none) continue;
    const std::size_t i = parent[node];
    const Wall& wall = graph.walls[i];
    const Vector3d material = material_up_to(wall, 1.0);
    cells.upstream[i] = wall.from == node ? hanging[node] : Vector3d(-hanging[node] - material);
    hanging[other_end(wall, node)] += hanging[node] + material;
  }
}

/// Area swept about the origin by the mid-line from node to node, twice.
double swept_by(const WallGraph& graph, const Wall& wall) {
  const Vector2d& from = graph.nodes[wall.from];
  const Vector2d& to = graph.nodes[wall.to];
  double twice = cross(from, to);
  if (wall.radius > 0.0) {
    twice +=
        wall.radius * wall.radius * (wall.sweep - std::sin(wall.sweep));  // segment of a circle
  }
  return twice;
}

/// The bounded faces of the walls as a plane figure: every cell once.
void find_cells(const WallGraph& graph, WallCells& cells) {
  // A half is a wall walked in one sense: 2 i from `from`, 2 i + 1 from `to`.
  const auto begin_of = [&](std::size_t half) {
    const Wall& wall = graph.walls[half / 2];
    return half % 2 == 0 ? wall.from : wall.to;
  };
  const auto heading_of = [&](std::size_t half) {
    const Vector2d way = graph.nodes[begin_of(half ^ 1U)] - graph.nodes[begin_of(half)];
    return std::atan2(way.y(), way.x());
  };
  std::vector<std::vector<std::size_t>> leaving(graph.nodes.size());  // by heading, ascending
  std::vector<double> heading(2 * graph.walls.size());
  for (std::size_t half = 0; half < heading.size(); ++half) {
    leaving[begin_of(half)].push_back(half);
    heading[half] = heading_of(half);
  }
  for (auto& halves : leaving) {
    std::sort(halves.begin(), halves.end(),
              [&](std::size_t a, std::size_t b) { return heading[a] < heading[b]; });
  }
  // With the face to the left, the way on is the next clockwise from the way back.
  const auto next_of = [&](std::size_t half) {
    const auto& halves = leaving[begin_of(half ^ 1U)];
    const auto back = std::find(halves.begin(), halves.end(), half ^ 1U);
    return back == halves.begin() ? halves.back() : *(back - 1);
  };
  std::vector<bool> done(2 * graph.walls.size(), false);
  for (std::size_t first = 0; first < done.size(); ++first) {
    if (done[first]) continue;
    Cell cell;
    double scale = 0.0;
    std::size_t half = first;
    do {
      done[half] = true;
      const Wall& wall = graph.walls[half / 2];
      const double sign = half % 2 == 0 ? 1.0 : -1.0;
      cell.sides.push_back({half / 2, sign});
      cell.area += 0.5 * sign * swept_by(graph, wall);
      scale += (graph.nodes[wall.to] - graph.nodes[wall.from]).squaredNorm();
      half = next_of(half);
    } while (half != first);
    if (cell.area <= 1e-12 * scale) continue;  // the outside, or a tree walked round
    cell.component = cells.component[cell.sides.front().wall];
    cells.cells.push_back(std::move(cell));
  }
}

}  // namespace

double slenderness_of(const WallGraph& graph, const Wall& wall) {
  const double links =
      (wall.start - graph.nodes[wall.from]).norm() + (graph.nodes[wall.to] - wall.end).norm();
  return (length_of(wall) + links) / wall.thickness;
}

WallCells opened_walls_of(const WallGraph& graph) {
  WallCells result;
  cut_open(graph, result);
  return result;
}

WallCells wall_cells_of(const WallGraph& graph) {
  WallCells result = opened_walls_of(graph);
  find_cells(graph, result);
  const auto n = static_cast<Eigen::Index>(result.cells.size());
  Eigen::MatrixXd around = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(graph.walls.size()));
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const Cell::Side& side : result.cells[static_cast<std::size_t>(i)].sides) {
      around(i, static_cast<Eigen::Index>(side.wall)) += side.sign;
    }
  }
  Eigen::VectorXd slenderness(static_cast<Eigen::Index>(graph.walls.size()));
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    slenderness[static_cast<Eigen::Index>(i)] = slenderness_of(graph, graph.walls[i]);
  }
  result.flexibility = around * slenderness.asDiagonal() * around.transpose();
  return result;
}

Eigen::VectorXd flows_per_twist(const WallCells& cells) {
  const auto n = static_cast<Eigen::Index>(cells.cells.size());
  Eigen::VectorXd area(n);
  for (Eigen::Index i = 0; i < n; ++i) area[i] = cells.cells[static_cast<std::size_t>(i)].area;
  if (n == 0) return area;
  return cells.flexibility.ldlt().solve(2.0 * area);
}

}  // namespace boxbeam
