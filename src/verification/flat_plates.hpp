#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "kinked_flanges.hpp"

namespace boxbeam {

/// The sine of 10 degrees: plates that lean no more to each other are parallel.
inline constexpr double hardly_turned = 0.17364817766693033;

/// A straight plate where a segment begins or ends. SI.
struct FlatPlate {
  std::string name, called;               ///< "top flange", "the top flange"
  std::array<Eigen::Vector2d, 2> ends;    ///< of its clear width, on its mid-line
  std::array<Eigen::Vector2d, 2> slopes;  ///< of these, along the beam
  std::array<std::size_t, 2> nodes{};
  Length clear;
  Area area, inside;  ///< all of it; what stands on none of the plates beside it
  Stress yield_strength;
  bool outstand = false;
  PlateForce force{};                  ///< along the beam
  std::array<PlateForce, 2> halves{};  ///< of each half of its depth
  bool high = false;                   ///< of the section, across it
  double thickness = 0.0;

  Eigen::Vector2d direction() const { return (ends[1] - ends[0]).normalized(); }
  Eigen::Vector2d normal() const { return {-direction().y(), direction().x()}; }
  Eigen::Vector2d middle() const { return 0.5 * (ends[0] + ends[1]); }
  bool across_z() const { return std::abs(normal().y()) >= std::abs(normal().x()); }
};

/// The plates where a segment ends, or begins; none of profiles that are not made of plates.
std::vector<FlatPlate> flat_plates_at(const Project& project, std::size_t segment, bool end);

}  // namespace boxbeam
