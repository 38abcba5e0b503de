#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "boxbeam/verification/animation.hpp"

/// A mechanism that moves, as a document that viewers of three-dimensional scenes show.
namespace boxbeam {

/// A surface of triangles, counter-clockwise seen from outside.
struct Surface {
  std::vector<Eigen::Vector3d> corners;  ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A beam by the outer border of its sections, in its axes: a closed body for every segment, of
/// thin-walled paths for every wall of it. Arcs are of straight pieces, 7.5 degrees each.
Surface surface_of(const TaperedBeam& beam);

/// A straight rod, a prism of six sides whose corners are so far from its axis.
void add_rod(Surface& surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
             double radius);

/// A cube about a place.
void add_block(Surface& surface, const Eigen::Vector3d& centre, double side);

/// A scene with its animation, whole in one document; metres, seconds from the begin of the motion.
/// y is up in such scenes: a root node turns the world of a mechanism in space, where z is. A node
/// for every body, with nodes for the joints on it, and one for every rod and spring, which changes
/// its length by its scale. Single precision. Source: Khronos, glTF 2.0 specification.
std::string gltf_of(const Animation& animation, const Project& project);

}  // namespace boxbeam
