#include "boxbeam/mechanism/planar/constraints.hpp"

#include <cmath>

#include "constraints_of.hpp"

namespace boxbeam::planar {
namespace {

/// The vector from a body's centre of mass to a point of it, in world axes; for a point of the
/// ground the point itself.
Eigen::Vector2d arm_of(const Attachment& point, const Eigen::VectorXd& q) {
  if (point.body == ground) return point.p;
  const double angle = q[3 * point.body + 2];
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * point.p.x() - s * point.p.y(), s * point.p.x() + c * point.p.y()};
}

}  // namespace

Eigen::Vector2d position_of(const Attachment& point, const Eigen::VectorXd& q) {
  if (point.body == ground) return point.p;
  const Eigen::Vector2d arm = arm_of(point, q);
  return q.segment<2>(3 * point.body) + arm;
}

Eigen::Vector2d velocity_of(const Attachment& point, const Eigen::VectorXd& q,
                            const Eigen::VectorXd& v) {
  if (point.body == ground) return Eigen::Vector2d::Zero();
  const double omega = v[3 * point.body + 2];
  return v.segment<2>(3 * point.body) + omega * left_of<double>(arm_of(point, q));
}

Eigen::Vector2d acceleration_of(const Attachment& point, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& v, const Eigen::VectorXd& a) {
  if (point.body == ground) return Eigen::Vector2d::Zero();
  const double omega = v[3 * point.body + 2];
  return velocity_of(point, q, a) - omega * omega * arm_of(point, q);
}

template class ConstraintEquationsOf<double>;

}  // namespace boxbeam::planar
