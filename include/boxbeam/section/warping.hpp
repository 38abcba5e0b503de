#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// How a thin-walled path without cells warps about its shear centre.
struct Warping {
  /// omega of mean zero along a wall, linear between the ends of its mid-line [m^2].
  struct Line {
    Eigen::Vector2d from, to;  ///< (y, z) [m]
    double omega_from = 0.0, omega_to = 0.0;
    double thickness = 0.0;  ///< [m]
  };
  double I_w = 0.0;      ///< [m^6]
  double largest = 0.0;  ///< size of omega, of mean zero, where it is largest, on mid-lines [m^2]
  std::vector<Line> walls;
};

/// omega at the place of the mid-lines that is nearest to a given one (y, z) [m^2]: a force F along
/// the beam that comes in there makes a bimoment B = F omega. Source: Vlasov (1961).
double omega_near(const Warping& of, const Eigen::Vector2d& place);

/// Nothing of other profiles.
///
///     I_w = int omega^2 dA - (int omega dA)^2/A,  omega(s) = int r ds
///
/// r  distance of a wall's mid-line from the shear centre. What warps over the thickness of walls
/// is left out, on the safe side. Source: Vlasov, Thin-walled elastic beams (1961).
std::optional<Warping> warping_of(const Profile& profile);

/// Its I_w alone [m^6].
std::optional<double> warping_constant_of(const Profile& profile);

}  // namespace boxbeam
