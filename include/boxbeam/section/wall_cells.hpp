#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/section/wall_graph.hpp"

namespace boxbeam {

/// A cell: the walls around it, counter-clockwise, and the area inside their mid-lines.
struct Cell {
  struct Side {
    std::size_t wall;
    double sign;  ///< -1: the wall is walked from `to` to `from`
  };
  std::vector<Side> sides;
  double area = 0.0;  ///< [m^2]
  std::size_t component = 0;
};

/// Walls cut open into trees, and their cells. A cut stands at the end `to` of one wall of each
/// independent cycle, so that every wall has material on one side only that hangs on it.
struct WallCells {
  /// Per wall: material (area, of y dA, of z dA) whose force the shear flow at its start carries,
  /// on the side that the wall leads away from.
  std::vector<Eigen::Vector3d> upstream;
  std::vector<std::size_t> component;  ///< of each wall
  std::vector<Eigen::Vector3d> total;  ///< material of each component
  std::vector<Cell> cells;
  /// Of the integrals of ds/t around each cell and, negative, along walls common to two.
  Eigen::MatrixXd flexibility;
};

/// Precondition: no walls cross away from nodes.
WallCells wall_cells_of(const WallGraph& graph);

/// Of the cells of walls only how they are cut open: what hangs on each wall, and the material of
/// each component.
WallCells opened_walls_of(const WallGraph& graph);

/// Length over thickness of a wall between its nodes along the mid-line.
double slenderness_of(const WallGraph& graph, const Wall& wall);

/// Shear flow in each cell when the section twists by one radian per length, by shear modulus
/// [m^2], component by component in one vector:
///
///     sum_j f_ij q_j = 2 A_i
///
/// Source: Bredt (1896); multicell tubes: Megson, Aircraft Structures, 23.4.
Eigen::VectorXd flows_per_twist(const WallCells& cells);

}  // namespace boxbeam
