#pragma once

#include <Eigen/Core>

#include "boxbeam/project/robot.hpp"

namespace boxbeam::robots {

inline constexpr double steel_density =
    7850.0;  // [kg/m^3], EN 1991-1-1, table A.4: 77 to 78.5 kN/m^3

/// The link that is the beam: the wanted one, or the heaviest that a joint carries. Throws
/// InputError where there is none.
std::size_t beam_link_of(const Robot& robot, const std::string& wanted);

/// The placeholder beam in a link: where it lies, and a section as heavy as the link.
struct PlaceholderBeam {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();  ///< that carries the link, in its axes [m]
  double start = 0.0, length = 1.0;                 ///< along the axis from the joint [m]
  double width = 0.0, wall = 0.0;                   ///< of a square box [m]
  const char* why = "";
};

PlaceholderBeam placeholder_beam(const Robot& robot, std::size_t link);

}  // namespace boxbeam::robots
