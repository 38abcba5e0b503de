#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/mechanism/flexible/structure.hpp"

namespace test {

/// Mass, stiffness and damping of the whole structure as dense matrices in the generalised
/// coordinates of the source:
///
///     rigid link    q = (x, y, phi)
///     bending link  q = (x, y, phi_0, eta_1, phi_1, ..., eta_n, phi_n)
///     axial link    q = (x, y, delta, xi_1, ..., xi_n)
///     full link     q = (x, y, phi_0, xi_1, eta_1, phi_1, ...)
///
/// x and y of the first rigid element's node, world axes; eta and xi the shifts of the others
/// across and along the link beyond it. M = B^T M_RFE B, K = B^T K_SDE B + sum of J^T C J over
/// joints, B the full coordinates of the rigid elements from q. Precondition: no joint is rigid.
/// Source: Wojnarowski, Wojciech, Płosa, Płoski, Mechanika 85 (1987), equations (2), (3), (5) to
/// (11); their vectors begin with element 1 where these begin with 0.
struct SourceMatrices {
  Eigen::MatrixXd M, K, C;
  std::vector<std::string> names;        ///< of the coordinates, "boom.eta_3"
  std::vector<Eigen::Index> link_start;  ///< first coordinate of each link
};

SourceMatrices matrices_of(const boxbeam::flexible::Structure& structure);

/// Full coordinates (u, w, phi) of a link's elements from its generalised coordinates.
Eigen::MatrixXd coordinates_of(const boxbeam::flexible::Link& link,
                               const boxbeam::flexible::DividedLink& divided);

}  // namespace test
