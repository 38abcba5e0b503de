#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/mechanism/flexible/response.hpp"

/// Sums of forces on a whole elastic mechanism, (x, y, moment about the world's origin).
namespace test {

template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> about_origin(const Eigen::Vector2d& at,
                                         const Eigen::Matrix<Scalar, 3, 1>& f) {
  return {f.x(), f.y(), f.z() + at.x() * f.y() - at.y() * f.x()};
}

/// Of columns about the elements' nodes.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> resultant(const boxbeam::flexible::Structure& structure,
                                      const boxbeam::flexible::LinkColumns<Scalar>& columns) {
  Eigen::Matrix<Scalar, 3, 1> sum = Eigen::Matrix<Scalar, 3, 1>::Zero();
  for (std::size_t l = 0; l < structure.links.size(); ++l) {
    const auto& link = structure.mechanism->links[l];
    const Eigen::Rotation2Dd turn(link.angle);
    for (std::size_t i = 0; i < structure.links[l].elements.size(); ++i) {
      const Eigen::Vector2d at =
          link.origin + turn * Eigen::Vector2d(structure.links[l].elements[i].node, 0.0);
      const Eigen::Matrix<Scalar, 3, 1> f = columns[l].col(static_cast<Eigen::Index>(i));
      const double c = std::cos(link.angle), s = std::sin(link.angle);
      sum += about_origin<Scalar>(at, {c * f.x() - s * f.y(), s * f.x() + c * f.y(), f.z()});
    }
  }
  return sum;
}

/// What the ground does to the mechanism through its joints.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> ground_force(const boxbeam::flexible::Structure& structure,
                                         const boxbeam::flexible::Deformation<Scalar>& response) {
  using boxbeam::flexible::ground;
  Eigen::Matrix<Scalar, 3, 1> sum = Eigen::Matrix<Scalar, 3, 1>::Zero();
  const auto& mechanism = *structure.mechanism;
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const auto& joint = mechanism.joints[j];
    const Eigen::Matrix<Scalar, 3, 1> on_a = joint_force<Scalar>(structure, j, response);
    if (joint.b.link == ground && joint.a.link != ground) {
      sum += about_origin<Scalar>(in_world(mechanism, joint.a), on_a);
    } else if (joint.a.link == ground && joint.b.link != ground) {
      sum -= about_origin<Scalar>(in_world(mechanism, joint.b), on_a);
    }
  }
  return sum;
}

struct WeightAndLoad {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double size = 0.0;  ///< of what is summed
};

/// Of the mechanism before any division.
inline WeightAndLoad weight_and_load(const boxbeam::flexible::Mechanism& mechanism) {
  WeightAndLoad result;
  const auto add = [&](const Eigen::Vector3d& f) {
    result.sum += f;
    result.size += f.norm();
  };
  for (const auto& link : mechanism.links) {
    const boxbeam::flexible::RigidMass body = rigid_mass_of(link);
    const Eigen::Vector2d weight = body.mass * mechanism.gravity;
    add(about_origin<double>(link.origin + Eigen::Rotation2Dd(link.angle) * body.centre,
                             {weight.x(), weight.y(), 0.0}));
  }
  for (const auto& load : mechanism.loads) {
    add(about_origin<double>(in_world(mechanism, load.at), load.constant));
  }
  return result;
}

}  // namespace test
