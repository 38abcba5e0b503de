#include "boxbeam/section/shear_flow.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/torsion.hpp"

namespace boxbeam {
namespace {

using Eigen::RowVector3d;
using RowVector6d = Eigen::Matrix<double, 1, 6>;
using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

constexpr std::size_t gauss_points = 7;

/// Calls `visit(index, fraction, weight)` at the points of a rule on [0, 1]. Along straight walls
/// nothing is of higher degree than 3, for which two points are exact.
template <class Visit>
void at_gauss_points(const Wall& wall, const Visit& visit) {
  if (wall.radius == 0.0) {
    static const double x = 0.5 / std::sqrt(3.0);
    visit(0, 0.5 + x, 0.5);
    visit(1, 0.5 - x, 0.5);
    return;
  }
  using Rule = boost::math::quadrature::gauss<double, gauss_points>;
  std::size_t index = 0;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double x = 0.5 * Rule::abscissa()[i];
    const double weight = 0.5 * Rule::weights()[i];
    visit(index++, 0.5 + x, weight);
    if (x != 0.0) visit(index++, 0.5 - x, weight);
  }
}

/// The flow in a wall, as far as integrals along it ask for it.
struct WallFlows {
  std::array<CutFactors, gauss_points> inside;
  std::size_t points = 0;  ///< of the rule
  CutFactors start, end;
};

template <class Flow>
WallFlows flows_in(const WallGraph& graph, std::size_t wall, const Flow& flow) {
  WallFlows flows;
  at_gauss_points(graph.walls[wall], [&](std::size_t k, double f, double) {
    flows.inside[k] = flow(wall, f);
    flows.points = std::max(flows.points, k + 1);
  });
  flows.start = flow(wall, 0.0);
  flows.end = flow(wall, 1.0);
  return flows;
}

/// Nothing where a profile is solid; `cells_of` finds the cells of the walls, or opens them alone.
std::optional<StressedWalls> stressed_walls_of(const Section& section,
                                               const std::vector<Hole>& holes,
                                               WallCells (&cells_of)(const WallGraph&)) {
  std::optional<WallGraph> graph = wall_graph_of(section, holes);
  if (!graph) return std::nullopt;
  StressedWalls walls;
  walls.graph = *std::move(graph);
  walls.cells = cells_of(walls.graph);
  walls.plane = normal_stress_plane(sums_of(outline_of(section, holes)));
  return walls;
}

/// Resultant of the normal stresses of some material per N, M_y, M_z: alpha, beta_y, beta_z.
RowVector3d force_of(const Vector3d& material, const StressedWalls& walls) {
  return material.transpose() * walls.plane;
}

RowVector3d force_of_component(const StressedWalls& walls, std::size_t component) {
  return force_of(walls.cells.total[component], walls);
}

/// The material that hangs on a wall at a fraction of it.
Vector3d hanging_at(const StressedWalls& walls, std::size_t wall, double fraction) {
  return walls.cells.upstream[wall] + material_up_to(walls.graph.walls[wall], fraction);
}

void set_flow_of_components(ShearFlow& flow) {
  for (std::size_t component = 0; component < flow.at.cells.total.size(); ++component) {
    RowVector3d slope = RowVector3d::Zero();
    for (const ShearFlow::Nearby& near : flow.taper)
      slope += near.weight * force_of_component(near.walls, component);
    flow.out_of_component.push_back(flow_out_of(force_of_component(flow.at, component), slope));
  }
}

/// Flow of the walls cut open.
CutFactors open_flow(const ShearFlow& flow, std::size_t wall, double fraction) {
  RowVector3d slope = RowVector3d::Zero();
  for (const ShearFlow::Nearby& near : flow.taper)
    slope += near.weight * force_of(hanging_at(near.walls, wall, fraction), near.walls);
  const std::size_t component = flow.at.cells.component[wall];
  const Vector3d hanging = hanging_at(flow.at, wall, fraction);
  const double share = hanging[0] / flow.at.cells.total[component][0];
  return share * flow.out_of_component[component] - flow_out_of(force_of(hanging, flow.at), slope);
}

/// Calls `visit` with what the cells beside a wall add to its flow.
template <class Visit>
void at_cells_of(const ShearFlow& flow, std::size_t wall, const Visit& visit) {
  const std::vector<Cell>& cells = flow.at.cells.cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const Cell::Side& side : cells[i].sides) {
      if (side.wall == wall)
        visit(side.sign * flow.cell_flows.row(static_cast<Eigen::Index>(i)).transpose());
    }
  }
}

/// Flow without twist: cut open, and closed again by the cells' flows.
CutFactors transverse_flow(const ShearFlow& flow, std::size_t wall, double fraction) {
  CutFactors factors = open_flow(flow, wall, fraction);
  at_cells_of(flow, wall, [&](const CutFactors& of_cell) { factors += of_cell; });
  return factors;
}

/// The same of flows that are cut open.
void add_cells(const ShearFlow& flow, std::size_t wall, WallFlows& flows) {
  at_cells_of(flow, wall, [&](const CutFactors& of_cell) {
    for (std::size_t k = 0; k < flows.points; ++k) flows.inside[k] += of_cell;
    flows.start += of_cell;
    flows.end += of_cell;
  });
}

/// Integral of the open flow over length by thickness of a wall, links to its nodes included.
CutFactors warp_of(const ShearFlow& flow, std::size_t index, const WallFlows& open) {
  const Wall& wall = flow.at.graph.walls[index];
  CutFactors sum = CutFactors::Zero();
  at_gauss_points(wall,
                  [&](std::size_t k, double, double weight) { sum += weight * open.inside[k]; });
  sum *= length_of(wall);
  sum += (wall.start - flow.at.graph.nodes[wall.from]).norm() * open.start;
  sum += (flow.at.graph.nodes[wall.to] - wall.end).norm() * open.end;
  return sum / wall.thickness;
}

void close_cells(ShearFlow& flow, const std::vector<WallFlows>& open) {
  const std::vector<Cell>& cells = flow.at.cells.cells;
  const auto n = static_cast<Eigen::Index>(cells.size());
  flow.cell_flows.setZero(n, 6);
  if (n == 0) return;
  Eigen::Matrix<double, Eigen::Dynamic, 6> gap(n, 6);
  gap.setZero();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const Cell::Side& side : cells[static_cast<std::size_t>(i)].sides) {
      gap.row(i) -= side.sign * warp_of(flow, side.wall, open[side.wall]).transpose();
    }
  }
  flow.cell_flows = flow.at.cells.flexibility.ldlt().solve(gap);
}

/// Adds a force per cut force along a way from one place to the next.
void add_force(Eigen::Matrix<double, 3, 6>& sum, const CutFactors& flow, const Vector2d& from,
               const Vector2d& to) {
  const Vector2d way = to - from;
  sum.row(0) += way.x() * flow.transpose();
  sum.row(1) += way.y() * flow.transpose();
  sum.row(2) += cross(from, to) * flow.transpose();
}

/// V_y, V_z and T of the flows along the mid-lines.
template <class FlowsIn>
Eigen::Matrix<double, 3, 6> along_walls(const WallGraph& graph, const FlowsIn& flows_in_wall) {
  Eigen::Matrix<double, 3, 6> sum = Eigen::Matrix<double, 3, 6>::Zero();
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Wall& wall = graph.walls[i];
    const double length = length_of(wall);
    const WallFlows& flows = flows_in_wall(i);
    at_gauss_points(wall, [&](std::size_t k, double f, double weight) {
      const Vector2d at = point_on(wall, f);
      add_force(sum, flows.inside[k], at, at + weight * length * direction_on(wall, f));
    });
    add_force(sum, flows.start, graph.nodes[wall.from], wall.start);
    add_force(sum, flows.end, wall.end, graph.nodes[wall.to]);
  }
  return sum;
}

/// V_y, V_z and T of the normal stresses, which follow the material in a taper.
Eigen::Matrix<double, 3, 6> of_inclined_stress(const ShearFlow& flow) {
  Eigen::Matrix<double, 3, 6> sum = Eigen::Matrix<double, 3, 6>::Zero();
  if (flow.taper.empty()) return sum;
  for (std::size_t i = 0; i < flow.at.graph.walls.size(); ++i) {
    const Wall& wall = flow.at.graph.walls[i];
    if (!wall.solid) continue;
    const double area = material_up_to(wall, 1.0)[0];
    at_gauss_points(wall, [&](std::size_t, double f, double weight) {
      Vector2d slope = Vector2d::Zero();
      for (const ShearFlow::Nearby& near : flow.taper) {
        slope += near.weight * point_on(near.walls.graph.walls[i], f);
      }
      const Vector2d at = point_on(wall, f);
      const RowVector3d force = weight * area * RowVector3d(1.0, at.x(), at.y()) * flow.at.plane;
      CutFactors factors = CutFactors::Zero();
      factors[cut_force::N] = force[0];
      factors[cut_force::M_y] = force[1];
      factors[cut_force::M_z] = force[2];
      add_force(sum, factors, at, at + slope);
    });
  }
  return sum;
}

/// The walls' own torsion constant s t^3/3.
double own_torsion_of(const Wall& wall) {
  return length_of(wall) * wall.thickness * wall.thickness * wall.thickness / 3.0;
}

/// Bredt's flow in a wall per torque.
double cell_flow_in(const ShearFlow& flow, std::size_t wall) {
  double sum = 0.0;
  const std::vector<Cell>& cells = flow.at.cells.cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const Cell::Side& side : cells[i].sides) {
      if (side.wall == wall)
        sum += side.sign * flow.cell_flows_per_torque[static_cast<Eigen::Index>(i)];
    }
  }
  return sum;
}

/// Torsion constants of the outer and the inner profile. Precondition: thin-walled.
std::vector<double> torsion_constants_of(const Section& section) {
  std::vector<double> constants{torsion_constant_of(section.outer)->value()};
  if (section.inner) constants.push_back(torsion_constant_of(*section.inner)->value());
  return constants;
}

/// Cells carry what a component's torsion constant has beyond its walls' own s t^3/3.
void set_torsion(ShearFlow& flow, const Section& section) {
  const std::vector<double> constants = torsion_constants_of(section);
  const double whole = std::accumulate(constants.begin(), constants.end(), 0.0);
  flow.twist_per_torque = 1.0 / whole;
  const WallCells& cells = flow.at.cells;
  flow.cell_flows_per_torque = flows_per_twist(cells);
  std::vector<double> own(constants.size(), 0.0), bredt(constants.size(), 0.0);
  for (std::size_t i = 0; i < flow.at.graph.walls.size(); ++i) {
    own[cells.component[i]] += own_torsion_of(flow.at.graph.walls[i]);
  }
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    bredt[cells.cells[i].component] +=
        2.0 * cells.cells[i].area * flow.cell_flows_per_torque[static_cast<Eigen::Index>(i)];
  }
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    const std::size_t c = cells.cells[i].component;
    flow.cell_flows_per_torque[static_cast<Eigen::Index>(i)] *=
        (constants[c] - own[c]) / bredt[c] / whole;
  }
}

/// Whether a thin-walled profile mirrors itself about both axes, as its sizes alone tell.
bool mirrors_twice(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    return box->stiffeners.empty() && box->top_flange == box->bottom_flange &&
           box->left_web == box->right_web;
  }
  return std::holds_alternative<RectangularTube>(profile) ||
         std::holds_alternative<RoundTube>(profile);
}

/// Torque, per cut force, of the forces that walls carry by bending across their own thickness: all
/// that flows along the mid-lines do not carry. Their stress differs across the thickness by
/// t d(sigma)/dn, so that a stretch ds carries t^3/12 n n^T ds of what is common to all, in its
/// middle: wherever the origin lies.
RowVector6d torque_across_walls(const WallGraph& graph, const Eigen::Matrix<double, 2, 6>& forces) {
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
  Eigen::RowVector2d turning = Eigen::RowVector2d::Zero();
  for (const Wall& wall : graph.walls) {
    if (!wall.solid) continue;
    const double bending = length_of(wall) * std::pow(wall.thickness, 3) / 12.0;
    at_gauss_points(wall, [&](std::size_t, double f, double weight) {
      const Vector2d along = direction_on(wall, f);
      const Vector2d normal(-along.y(), along.x());
      stiffness += weight * bending * normal * normal.transpose();
      turning += weight * bending * cross(point_on(wall, f), normal) * normal.transpose();
    });
  }
  // Along walls that are all parallel the flows carry everything.
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix2d> solver;
  solver.setThreshold(1e-9);
  return turning * solver.compute(stiffness).solve(forces);
}

/// All that follows from the walls of a flow.
void complete(ShearFlow& flow, const Section& section) {
  set_flow_of_components(flow);
  std::vector<WallFlows> flows;
  for (std::size_t i = 0; i < flow.at.graph.walls.size(); ++i) {
    flows.push_back(flows_in(flow.at.graph, i,
                             [&](std::size_t wall, double f) { return open_flow(flow, wall, f); }));
  }
  close_cells(flow, flows);
  set_torsion(flow, section);
  for (std::size_t i = 0; i < flows.size(); ++i) add_cells(flow, i, flows[i]);
  const Eigen::Matrix<double, 3, 6> carried =
      along_walls(flow.at.graph, [&](std::size_t i) -> const WallFlows& { return flows[i]; }) +
      of_inclined_stress(flow);
  Eigen::Matrix<double, 2, 6> missing = -carried.topRows<2>();
  missing(0, cut_force::V_y) += 1.0;
  missing(1, cut_force::V_z) += 1.0;
  flow.torque = -(carried.row(2) + torque_across_walls(flow.at.graph, missing)).transpose();
  flow.torque[cut_force::T] = 1.0;
}

}  // namespace

std::optional<ShearFlow> shear_flow_of(const Section& section, const std::vector<Hole>& holes,
                                       const Taper& taper) {
  std::optional<StressedWalls> walls = stressed_walls_of(section, holes, wall_cells_of);
  if (!walls) return std::nullopt;
  ShearFlow flow;
  flow.at = *std::move(walls);
  for (const NearbySection& near : taper)
    flow.taper.push_back({*stressed_walls_of(near.section, holes, opened_walls_of), near.weight});
  complete(flow, section);
  return flow;
}

ShearFlow prismatic_flow_of(const ShearFlow& tapered, const Section& section) {
  ShearFlow flow;
  flow.at = tapered.at;
  complete(flow, section);
  return flow;
}
CutFactors flow_at(const ShearFlow& flow, std::size_t wall, double fraction) {
  return transverse_flow(flow, wall, fraction) + cell_flow_in(flow, wall) * flow.torque;
}

CutFactors face_shear_of(const ShearFlow& flow, std::size_t wall) {
  // A wall's own stress runs round within its thickness, counter-clockwise for T > 0: forwards on
  // the right.
  return flow.at.graph.walls[wall].thickness * flow.twist_per_torque * flow.torque;
}

WallTorsion wall_torsion_of(const ShearFlow& flow, std::size_t wall, double face) {
  WallTorsion torsion;
  torsion.flow = cell_flow_in(flow, wall);
  torsion.thickness = flow.at.graph.walls[wall].thickness;
  if (face == 0.0) face = torsion.flow < 0.0 ? -1.0 : 1.0;
  torsion.face = face * torsion.thickness * flow.twist_per_torque;
  torsion.I_T = 1.0 / flow.twist_per_torque;
  for (const Wall& each : flow.at.graph.walls) torsion.I_w += own_torsion_of(each);
  const WallCells& cells = flow.at.cells;
  if (cells.cells.size() == 1 && cells.total.size() == 1)
    torsion.enclosed = cells.cells.front().area;
  return torsion;
}

Eigen::Matrix<double, 3, 6> resultants_of(const ShearFlow& flow) {
  Eigen::Matrix<double, 3, 6> sum =
      along_walls(flow.at.graph,
                  [&](std::size_t i) {
                    return flows_in(flow.at.graph, i, [&](std::size_t wall, double f) {
                      return flow_at(flow, wall, f);
                    });
                  }) +
      of_inclined_stress(flow);
  // The walls' own share of the torque, which runs round within their thickness.
  double own = 0.0;
  for (const Wall& wall : flow.at.graph.walls) own += own_torsion_of(wall);
  sum.row(2) += own * flow.twist_per_torque * flow.torque.transpose();
  return sum;
}

std::optional<SectionPlace> shear_centre_of(const Section& section) {
  if (std::holds_alternative<Plate>(section.outer)) return SectionPlace{};
  // It lies on both axes.
  if (mirrors_twice(section.outer) && (!section.inner || mirrors_twice(*section.inner)))
    return SectionPlace{};
  const auto flow = shear_flow_of(section, {}, {});
  if (!flow) return std::nullopt;
  // The torque about the beam axis that V_z and V_y need to pass without twist is y_s V_z - z_s
  // V_y.
  // Round-off is no eccentricity.
  const auto place = [](double x) { return si<Length>(std::abs(x) < 1e-12 ? 0.0 : x); };
  return SectionPlace{place(-flow->torque[cut_force::V_z]), place(flow->torque[cut_force::V_y])};
}

}  // namespace boxbeam
