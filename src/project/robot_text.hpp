#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/robot.hpp"

/// Values of a robot as a case writes them.
namespace boxbeam::robots {

/// "0.25 m" in quotes; what a case would refuse as too small to be meant is zero.
std::string quantity(double value, const WantedDimension& of, const char* unit);

/// Three lengths.
std::string place_text(const Eigen::Vector3d& p);

/// [xx, yy, zz], or three rows where there are products.
std::string inertia_text(const Eigen::Matrix3d& I);

/// "x", "-z", or three numbers.
std::string direction_text(const Eigen::Vector3d& given);

/// Turns one after the other, as the case writes them; or "".
std::string turn_text(const std::vector<Turn>& given);

/// What a case would refuse, or does not mean, of a mass and an inertia; "" where all is well.
struct InertiaDoubt {
  std::string words;
  bool refused = false;
};

InertiaDoubt doubt_of(const Inertial& of);

}  // namespace boxbeam::robots
