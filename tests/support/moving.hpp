#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "boxbeam/mechanism/spatial/mechanism.hpp"

/// Postures of bodies in space, differentiated twice in time by the product rule, in long double.
/// Angular velocities and accelerations come from the derivatives of the rotation matrix; no
/// formula for the motion of relative frames is used, so that these can be tested against it.
namespace test {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;

/// A quantity and its first two time derivatives.
template <class Value>
struct Moving {
  Value value, rate, second;
};

template <class Value>
Moving<Value> operator+(const Moving<Value>& a, const Moving<Value>& b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}

/// (a b)'' = a'' b + 2 a' b' + a b''.
template <class Value>
Moving<Value> operator*(const Moving<Matrix>& a, const Moving<Value>& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.second * b.value + 2 * (a.rate * b.rate) + a.value * b.second};
}

inline Moving<Vector> operator*(const Moving<Matrix>& a, const Vector& fixed) {
  return {a.value * fixed, a.rate * fixed, a.second * fixed};
}

inline Moving<Matrix> operator*(const Moving<Matrix>& a, const Matrix& fixed) {
  return {a.value * fixed, a.rate * fixed, a.second * fixed};
}

inline Moving<Vector> along(const Vector& axis, const Moving<Real>& q) {
  return {axis * q.value, axis * q.rate, axis * q.second};
}

template <class Value>
Moving<Value> fixed(const Value& value) {
  return {value, Real(0) * value, Real(0) * value};
}

/// Rotation about a unit axis, I + sin q K + (1 - cos q) K^2.
inline Moving<Matrix> turned(const Vector& axis, const Moving<Real>& q) {
  Matrix K;
  K << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  const Matrix K2 = K * K;
  const Real s = std::sin(q.value), c = std::cos(q.value), square = q.rate * q.rate;
  return {Matrix::Identity() + s * K + (1 - c) * K2, q.rate * (c * K + s * K2),
          (q.second * c - square * s) * K + (q.second * s + square * c) * K2};
}

/// The vector w of a skew-symmetric matrix [w]x, from its skew part.
inline Vector axial(const Matrix& W) {
  return Vector(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1)) / 2;
}

/// From R' R^T = [omega]x.
inline Vector omega_of(const Moving<Matrix>& R) { return axial(R.rate * R.value.transpose()); }

/// From (R' R^T)' = R'' R^T + R' R'^T, the second part of which is symmetric.
inline Vector alpha_of(const Moving<Matrix>& R) { return axial(R.second * R.value.transpose()); }

struct MovingBody {
  Moving<Matrix> R;  ///< R_WB
  Moving<Vector> p;  ///< of the origin, in the world
};

inline Moving<Vector> point_of(const MovingBody& body, const Eigen::Vector3d& p) {
  return body.p + body.R * Vector(p.cast<Real>());
}

/// All bodies of a tree, as the documentation of the joint defines them.
inline std::vector<MovingBody> moving_bodies_of(const boxbeam::spatial::Mechanism& mechanism,
                                                double time) {
  using namespace boxbeam;
  const MovingBody world{fixed<Matrix>(Matrix::Identity()), fixed<Vector>(Vector::Zero())};
  std::vector<MovingBody> bodies;
  for (const spatial::Joint& joint : mechanism.joints) {
    const MovingBody& parent =
        joint.parent < 0 ? world : bodies[static_cast<std::size_t>(joint.parent)];
    const DriverState state = driver_at(joint.driver, time);
    const Moving<Real> q{state.value, state.rate, state.acceleration};
    const Vector axis = joint.axis.cast<Real>();
    const Matrix turn = joint.turn.cast<Real>();
    MovingBody body{parent.R * turn, parent.p + parent.R * Vector(joint.at.cast<Real>())};
    if (joint.kind == spatial::JointKind::revolute) {
      body.R = parent.R * (turned(axis, q) * turn);
    } else if (joint.kind == spatial::JointKind::prismatic) {
      body.p = body.p + parent.R * along(axis, q);
    } else if (joint.kind == spatial::JointKind::screw) {
      const Real advance = Real(joint.lead) / (2 * std::numbers::pi_v<Real>);
      body.R = parent.R * (turned(axis, q) * turn);
      body.p = body.p + parent.R * along(advance * axis, q);
    }
    body.p = body.p + body.R * Vector(-joint.point.cast<Real>());
    bodies.push_back(body);
  }
  return bodies;
}

/// Second moments of mass about the centre, int b b^T dm = tr(I)/2 1 - I, body axes.
inline Matrix second_moments_of(const boxbeam::spatial::Body& body) {
  const Matrix inertia = body.inertia.cast<Real>();
  return inertia.trace() / 2 * Matrix::Identity() - inertia;
}

/// Kinetic energy, m c'^2/2 + tr(R' S R'^T)/2, S the second moments of mass; and its rate.
struct Energy {
  Real value = 0, rate = 0;
};

inline Energy energy_of(const boxbeam::spatial::Body& body, const MovingBody& moving) {
  const Moving<Vector> c = point_of(moving, body.centre);
  const Matrix S = second_moments_of(body);
  const Real m = body.mass;
  return {
      m / 2 * c.rate.squaredNorm() + (moving.R.rate * S * moving.R.rate.transpose()).trace() / 2,
      m * c.rate.dot(c.second) + (moving.R.rate * S * moving.R.second.transpose()).trace()};
}

/// Rate of change of momentum, and of angular momentum about the world's origin,
/// int r x r'' dm = m c x c'' + 2 axial((R S R''^T)^T).
struct MomentumRate {
  Vector force, moment;
};

inline MomentumRate momentum_rate_of(const boxbeam::spatial::Body& body, const MovingBody& moving) {
  const Moving<Vector> c = point_of(moving, body.centre);
  const Matrix A = moving.R.value * second_moments_of(body) * moving.R.second.transpose();
  const Real m = body.mass;
  return {m * c.second, m * c.value.cross(c.second) + 2 * axial(A.transpose())};
}

}  // namespace test
