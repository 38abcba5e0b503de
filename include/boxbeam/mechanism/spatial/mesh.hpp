#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "boxbeam/mechanism/spatial/mechanism.hpp"

namespace boxbeam::spatial {

/// What a case says of two wheels that roll on each other, or of a wheel on a rack, each carried by
/// a joint: seen from the body that keeps their axes
///
///     q_second = ratio q_first + offset
struct Gearing {
  std::size_t first = 0;   ///< index of the joint that carries the first wheel, or the pinion
  std::size_t second = 0;  ///< of the one that carries the second, or the rack
  double ratio = 1.0;      ///< of turns about the axes of the joints; of a rack its advance in a
                           ///< radian [m], the radius of the pitch circle
  double offset = 0.0;     ///< [rad or m]
  double pressure_angle = 0.0;        ///< [rad]
  std::optional<Attachment> at = {};  ///< a place at which the teeth meet, on the pitch line
};

/// The teeth of a gearing, or why it has none and what to write.
struct MeshFound {
  std::optional<Mesh> mesh;
  std::string problem, hint;
};

/// Where teeth meet and how they push. Seen from the body that keeps both axes the wheels move
/// alike on one line, the pitch line: with parallel axes it divides their distance d,
///
///     r_1 = d ratio/(ratio - 1),  r_2 = r_1/ratio
///
/// for turns about one direction; with axes that meet it goes through their apex along
/// a_1 - ratio a_2; beside a rack it lies at its radius. Along it the teeth meet at the level of
/// both joints, or at the place that is given. A tooth force F along the pitch circles comes with
/// |F| tan(pressure angle) that pushes the wheels apart, square to the pitch line; on straight
/// bevel gears its parts are |F| tan cos(delta) and |F| tan sin(delta). Helical teeth push along
/// the axes as well, which is left out. Refused: axes that cross, that lie in line or that no body
/// keeps; wheels that turn alike (a belt); joints that do not turn. Source: Shigley, Mechanical
/// Engineering Design, chapter 13.
MeshFound mesh_of(const Mechanism& mechanism, const Gearing& gearing);

}  // namespace boxbeam::spatial
