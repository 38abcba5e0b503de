#include "boxbeam/mechanism/planar/constraints.hpp"

#include <cmath>

/// Source of the equations: Nikravesh, Planar Multibody Dynamics (2007), chapter 7; Haug,
/// Computer Aided Kinematics and Dynamics of Mechanical Systems (1989), chapter 3.
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

Eigen::Vector2d position_with_arm(const Attachment& point, const Eigen::VectorXd& q,
                                  const Eigen::Vector2d& arm) {
  if (point.body == ground) return arm;
  return q.segment<2>(3 * point.body) + arm;
}

Eigen::Vector2d normal_of(double direction) { return {-std::sin(direction), std::cos(direction)}; }

/// Writes residuals and, where a Jacobian is given, its rows; one equation after the other.
struct Writer {
  const Eigen::VectorXd& q;
  double time;
  Eigen::VectorXd& phi;
  Eigen::MatrixXd* jacobian;
  Eigen::Index row = 0;

  /// Rows of +- d(position)/dq of a point.
  void position_rows(const Attachment& point, const Eigen::Vector2d& arm, double sign) const {
    if (jacobian == nullptr || point.body == ground) return;
    const Eigen::Index i = 3 * point.body;
    (*jacobian)(row, i) += sign;
    (*jacobian)(row + 1, i + 1) += sign;
    (*jacobian)(row, i + 2) -= sign * arm.y();
    (*jacobian)(row + 1, i + 2) += sign * arm.x();
  }

  /// The row of d(n . position)/dq of a point.
  void projected_row(const Attachment& point, const Eigen::Vector2d& arm,
                     const Eigen::Vector2d& n) const {
    if (jacobian == nullptr) return;
    const Eigen::Index i = 3 * point.body;
    (*jacobian)(row, i) = n.x();
    (*jacobian)(row, i + 1) = n.y();
    (*jacobian)(row, i + 2) = n.y() * arm.x() - n.x() * arm.y();
  }

  void angle_entry(int body, double factor) const {
    if (jacobian != nullptr && body != ground) (*jacobian)(row, 3 * body + 2) += factor;
  }

  double angle_of(int body) const { return body == ground ? 0.0 : q[3 * body + 2]; }

  void operator()(const Pin& pin) {
    const Eigen::Vector2d arm_a = arm_of(pin.a, q);
    const Eigen::Vector2d arm_b = arm_of(pin.b, q);
    phi.segment<2>(row) = position_with_arm(pin.a, q, arm_a) - position_with_arm(pin.b, q, arm_b);
    position_rows(pin.a, arm_a, 1.0);
    position_rows(pin.b, arm_b, -1.0);
    row += 2;
  }

  void operator()(const Slider& slider) {
    const Eigen::Vector2d arm = arm_of(slider.point, q);
    const Eigen::Vector2d n = normal_of(slider.direction);
    phi[row] = n.dot(position_with_arm(slider.point, q, arm) - slider.through);
    projected_row(slider.point, arm, n);
    ++row;
    phi[row] = angle_of(slider.point.body) - slider.angle;
    angle_entry(slider.point.body, 1.0);
    ++row;
  }

  void operator()(const AngleCoupling& coupling) {
    phi[row] =
        angle_of(coupling.a.body) - coupling.ratio * angle_of(coupling.b.body) - coupling.offset;
    angle_entry(coupling.a.body, 1.0);
    angle_entry(coupling.b.body, -coupling.ratio);
    ++row;
  }

  void operator()(const Driven& driven) {
    const double wanted = driver_at(driven.driver, time).value;
    if (driven.coordinate == Coordinate::angle) {
      phi[row] = angle_of(driven.point.body) - wanted;
      angle_entry(driven.point.body, 1.0);
    } else {
      const Eigen::Vector2d axis =
          driven.coordinate == Coordinate::x ? Eigen::Vector2d::UnitX() : Eigen::Vector2d::UnitY();
      const Eigen::Vector2d arm = arm_of(driven.point, q);
      phi[row] = axis.dot(position_with_arm(driven.point, q, arm)) - wanted;
      projected_row(driven.point, arm, axis);
    }
    ++row;
  }
};

/// The part of a point's acceleration that its body's rotation rate gives: -omega^2 arm.
Eigen::Vector2d centripetal(const Attachment& point, const Eigen::VectorXd& q,
                            const Eigen::VectorXd& v) {
  if (point.body == ground) return Eigen::Vector2d::Zero();
  const double omega = v[3 * point.body + 2];
  return -omega * omega * arm_of(point, q);
}

}  // namespace

Eigen::Vector2d position_of(const Attachment& point, const Eigen::VectorXd& q) {
  return position_with_arm(point, q, arm_of(point, q));
}

Eigen::Vector2d velocity_of(const Attachment& point, const Eigen::VectorXd& q,
                            const Eigen::VectorXd& v) {
  if (point.body == ground) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d arm = arm_of(point, q);
  const double omega = v[3 * point.body + 2];
  return v.segment<2>(3 * point.body) + omega * Eigen::Vector2d(-arm.y(), arm.x());
}

Eigen::Vector2d acceleration_of(const Attachment& point, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& v, const Eigen::VectorXd& a) {
  if (point.body == ground) return Eigen::Vector2d::Zero();
  return velocity_of(point, q, a) + centripetal(point, q, v);
}

void evaluate_constraints(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                          Eigen::VectorXd& phi) {
  Writer writer{q, time, phi, nullptr};
  for (const Joint& joint : mechanism.joints) std::visit(writer, joint.kind);
}

void evaluate_constraints(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                          Eigen::VectorXd& phi, Eigen::MatrixXd& jacobian) {
  jacobian.setZero();
  Writer writer{q, time, phi, &jacobian};
  for (const Joint& joint : mechanism.joints) std::visit(writer, joint.kind);
}

void velocity_right_side(const Mechanism& mechanism, double time, Eigen::VectorXd& nu) {
  nu.setZero();
  Eigen::Index row = 0;
  for (const Joint& joint : mechanism.joints) {
    if (const auto* driven = std::get_if<Driven>(&joint.kind)) {
      nu[row] = driver_at(driven->driver, time).rate;
    }
    row += equations_of(joint);
  }
}

void acceleration_right_side(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                             const Eigen::VectorXd& v, Eigen::VectorXd& gamma) {
  gamma.setZero();
  Eigen::Index row = 0;
  for (const Joint& joint : mechanism.joints) {
    if (const auto* pin = std::get_if<Pin>(&joint.kind)) {
      gamma.segment<2>(row) = centripetal(pin->b, q, v) - centripetal(pin->a, q, v);
    } else if (const auto* slider = std::get_if<Slider>(&joint.kind)) {
      gamma[row] = -normal_of(slider->direction).dot(centripetal(slider->point, q, v));
    } else if (const auto* driven = std::get_if<Driven>(&joint.kind)) {
      gamma[row] = driver_at(driven->driver, time).acceleration;
      if (driven->coordinate != Coordinate::angle) {
        const Eigen::Vector2d own = centripetal(driven->point, q, v);
        gamma[row] -= driven->coordinate == Coordinate::x ? own.x() : own.y();
      }
    }
    row += equations_of(joint);
  }
}

}  // namespace boxbeam::planar
