#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/section/section.hpp"

/// Closed rings of walls as their shear flow goes round them.
namespace oracle {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A stretch of the ring between two of its nodes, straight or round: material as first moments up
/// to a fraction of it, geometry along the mid-line. What hangs on its start (an overhang of a
/// flange, a stiffener) is a lump.
struct Piece {
  std::string name;             ///< of the plate; "" in rounds
  Vector2d from, to;            ///< of the material, on the mid-line
  Vector2d node_from, node_to;  ///< mid-lines meet here
  double thickness = 0.0;
  bool solid = true;
  double radius = 0.0, angle = 0.0, sweep = 0.0;  ///< rounds
  Vector3d lump = Vector3d::Zero();
  bool bar = false;  ///< one stands at its end

  double length() const { return radius > 0.0 ? radius * std::abs(sweep) : (to - from).norm(); }
  Vector2d at(double f) const {
    if (radius == 0.0) return from + f * (to - from);
    const double a = angle + f * sweep;
    return {radius * std::cos(a), radius * std::sin(a)};
  }
  Vector2d along(double f) const {
    if (radius == 0.0) return (to - from).normalized();
    const double a = angle + f * sweep;
    return {-std::sin(a), std::cos(a)};
  }
  Vector3d material(double f) const {
    if (!solid) return Vector3d::Zero();
    if (radius == 0.0) {
      const double area = f * thickness * length();
      const Vector2d centre = at(0.5 * f);
      return {area, area * centre.x(), area * centre.y()};
    }
    // int over the ring's sector of r dr dphi (1, r cos, r sin).
    const double r3 = thickness * (radius * radius + thickness * thickness / 12.0);
    const double b = angle + f * sweep;
    return {thickness * radius * f * sweep, r3 * (std::sin(b) - std::sin(angle)),
            -r3 * (std::cos(b) - std::cos(angle))};
  }
};

/// A wall that hangs on the ring: its material begins at `free` and ends at `foot`, whence its flow
/// goes on to the ring's node.
struct Branch {
  Vector2d free, foot, node;
  double thickness = 0.0;

  Vector3d material(double f) const {
    const double area = f * thickness * (foot - free).norm();
    const Vector2d centre = free + 0.5 * f * (foot - free);
    return {area, area * centre.x(), area * centre.y()};
  }
};

/// A closed ring of walls with its branches: a box or a round tube.
struct Ring {
  std::vector<Piece> pieces;
  std::vector<Branch> branches;
  double own_torsion = 0.0;  ///< sum of s t^3/3
  double I_T = 0.0;

  /// All material before each piece, its own lump included; set when all pieces are there.
  std::vector<Vector3d> before_piece;
  void add_up() {
    Vector3d sum = Vector3d::Zero();
    for (const Piece& piece : pieces) {
      sum += piece.lump;
      before_piece.push_back(sum);
      sum += piece.material(1.0);
    }
  }
  Vector3d before(std::size_t index) const { return before_piece[index]; }
  Vector3d total() const { return before(pieces.size() - 1) + pieces.back().material(1.0); }
};

/// Of a box, a sharp rectangular tube or a round one.
Ring ring_of(const boxbeam::Profile& profile, const std::vector<boxbeam::Hole>& holes);

}  // namespace oracle
