#pragma once

#include <cassert>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "joint_kinds.hpp"

/// The constraint equations in any arithmetic: what the sources that instantiate them share.
namespace boxbeam::planar {

template <class Scalar>
Eigen::Matrix<Scalar, 2, 1> left_of(const Eigen::Matrix<Scalar, 2, 1>& vector) {
  return {-vector.y(), vector.x()};
}

template <class Scalar>
Scalar whole_turn() {
  if constexpr (std::is_floating_point_v<Scalar>) {
    return Scalar(2) * std::numbers::pi_v<Scalar>;
  } else {
    return Scalar(full_turn);
  }
}

/// Takes joints apart into terms and notes where their derivatives go.
template <class Scalar>
struct ConstraintEquationsOf<Scalar>::Builder {
  ConstraintEquationsOf& equations;
  int bodies;

  int index_of(const Attachment& point) const { return point.body == ground ? bodies : point.body; }

  Term between(Kind kind, const Attachment& a, const Attachment& b) const {
    Term term;
    term.kind = kind;
    term.a = index_of(a);
    term.b = index_of(b);
    term.p_a = a.p.cast<Scalar>();
    term.p_b = b.p.cast<Scalar>();
    return term;
  }

  void add(Term term) const {
    term.row = static_cast<int>(equations.pattern_.rows);
    equations.pattern_.rows += term.kind == Kind::coincide ? 2 : 1;
    equations.terms_.push_back(term);
  }

  void add_along(const Attachment& a, const Attachment& b, const Eigen::Vector2d& n, double r,
                 double offset) const {
    Term term = between(Kind::along, a, b);
    term.n = n.cast<Scalar>();
    term.ratio = static_cast<Scalar>(r);
    term.offset = static_cast<Scalar>(offset);
    add(term);
  }

  // The equations that EquationsOfKind tells.
  void coincide(const Attachment& a, const Attachment& b) const {
    add(between(Kind::coincide, a, b));
  }

  void across(const Attachment& point, const Attachment& guide, double direction) const {
    add_along(point, guide, {-std::sin(direction), std::cos(direction)}, 0.0, 0.0);
  }

  void along(const Attachment& a, const Attachment& b, double direction, double r,
             double offset) const {
    add_along(a, b, {std::cos(direction), std::sin(direction)}, r, offset);
  }

  void coordinate(const Attachment& point, int axis) const {
    add_along(point, {}, Eigen::Vector2d::Unit(axis), 0.0, 0.0);
  }

  void turn(const Attachment& a, const Attachment& b, double ratio, double offset) const {
    Term term = between(Kind::turn, a, b);
    term.ratio = static_cast<Scalar>(ratio);
    term.offset = static_cast<Scalar>(offset);
    add(term);
  }

  void length(const Attachment& a, const Attachment& b, double length) const {
    Term term = between(Kind::length, a, b);
    term.offset = static_cast<Scalar>(length);
    add(term);
  }

  void mesh(const Attachment& a, const Attachment& b, double r_a, double r_b, double offset) const {
    Term term = between(Kind::mesh, a, b);
    term.ratio = static_cast<Scalar>(r_a);
    term.r_b = static_cast<Scalar>(r_b);
    term.offset = static_cast<Scalar>(offset);
    add(term);
  }

  void follows(const Driver& driver) const {
    Term& term = equations.terms_.back();
    term.driver = static_cast<int>(equations.drivers_.size());
    equations.drivers_.push_back(&driver);
    equations.driver_rows_.push_back(term.row);
  }

  /// Notes the entries of all rows in the pattern and in the terms, and writes the constant ones.
  void place_entries() const {
    SparsePattern& pattern = equations.pattern_;
    std::vector<Scalar>& values = equations.constant_;
    std::vector<std::uint32_t*> nowhere;
    const auto begin_row = [&] { pattern.row_start.push_back(static_cast<int>(values.size())); };
    // An entry of the row at hand; `at` learns its place. The ground has no coordinates.
    const auto entry = [&](int body, int coordinate, Scalar value, std::uint32_t* at) {
      if (body == bodies) {
        if (at != nullptr) nowhere.push_back(at);
        return;
      }
      if (at != nullptr) *at = static_cast<std::uint32_t>(values.size());
      pattern.col.push_back(3 * body + coordinate);
      values.push_back(value);
    };
    for (Term& term : equations.terms_) {
      begin_row();
      if (term.kind == Kind::coincide) {
        entry(term.a, 0, Scalar(1), nullptr);
        entry(term.a, 2, Scalar(0), &term.at[0]);
        entry(term.b, 0, Scalar(-1), nullptr);
        entry(term.b, 2, Scalar(0), &term.at[1]);
        begin_row();
        entry(term.a, 1, Scalar(1), nullptr);
        entry(term.a, 2, Scalar(0), &term.at[2]);
        entry(term.b, 1, Scalar(-1), nullptr);
        entry(term.b, 2, Scalar(0), &term.at[3]);
      } else if (term.kind == Kind::turn) {
        entry(term.a, 2, Scalar(1), nullptr);
        entry(term.b, 2, -term.ratio, nullptr);
      } else {
        for (int c = 0; c < 3; ++c)
          entry(term.a, c, Scalar(0), &term.at[static_cast<std::size_t>(c)]);
        for (int c = 0; c < 3; ++c) {
          entry(term.b, c, Scalar(0), &term.at[static_cast<std::size_t>(c) + 3]);
        }
      }
    }
    begin_row();
    values.push_back(Scalar(0));  // a last place for what concerns the ground
    for (std::uint32_t* at : nowhere) *at = static_cast<std::uint32_t>(pattern.col.size());
  }
};

template <class Scalar>
ConstraintEquationsOf<Scalar>::ConstraintEquationsOf(const Mechanism& mechanism) {
  const auto bodies = static_cast<int>(mechanism.bodies.size());
  pattern_.cols = mechanism.coordinates();
  const Builder builder{*this, bodies};
  for (const Joint& joint : mechanism.joints)
    std::visit(EquationsOfKind<const Builder>{builder}, joint.kind);
  builder.place_entries();
  driver_states_.resize(drivers_.size());
  poses_.resize(static_cast<std::size_t>(bodies) + 1);

  const double size = size_of(mechanism);
  row_scale_ = Eigen::VectorXd::Ones(pattern_.rows);
  col_scale_ = Eigen::VectorXd::Ones(pattern_.cols);
  Eigen::Index row = 0;
  for (const Joint& joint : mechanism.joints) {
    for (int k = 0; k < equations_of(joint); ++k, ++row) {
      if (is_length_equation(joint, k)) row_scale_[row] = 1.0 / size;
    }
  }
  for (Eigen::Index i = 0; i < pattern_.cols; ++i) {
    if (i % 3 != 2) col_scale_[i] = size;
  }
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::set_time(double time) {
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    driver_states_[i] = driver_at(*drivers_[i], time);
  }
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::set_driver_values(const std::vector<double>& values) {
  assert(values.size() == drivers_.size());
  for (std::size_t i = 0; i < drivers_.size(); ++i) driver_states_[i] = {values[i], 0.0, 0.0};
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::set_driver_states(const std::vector<DriverState>& states) {
  assert(states.size() == drivers_.size());
  driver_states_ = states;
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::set_position(const Vector& q) {
  using std::cos;
  using std::sin;
  for (std::size_t i = 0; i + 1 < poses_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(3 * i);
    poses_[i] = {q[k], q[k + 1], q[k + 2], cos(q[k + 2]), sin(q[k + 2])};
  }
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::move_position(const Vector& q) {
  using std::abs;
  const Scalar one(1);
  for (std::size_t i = 0; i + 1 < poses_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(3 * i);
    Pose& pose = poses_[i];
    pose.x = q[k];
    pose.y = q[k + 1];
    const Scalar turned = q[k + 2] - pose.angle;
    pose.angle = q[k + 2];
    if (abs(turned) < Scalar(1e-3)) {
      // Terms left out: turned^7/5040 and turned^6/720.
      const Scalar square = turned * turned;
      const Scalar s = turned * (one - square / Scalar(6) * (one - square / Scalar(20)));
      const Scalar c = Scalar(-0.5) * square * (one - square / Scalar(12));  // cosine - 1
      const Scalar cosine = pose.cos;
      pose.cos += c * cosine - s * pose.sin;
      pose.sin += c * pose.sin + s * cosine;
    } else {
      using std::cos;
      using std::sin;
      pose.cos = cos(pose.angle);
      pose.sin = sin(pose.angle);
    }
  }
}

template <class Scalar>
template <bool with_jacobian>
void ConstraintEquationsOf<Scalar>::evaluate_terms(Vector& phi,
                                                   std::vector<Scalar>* jacobian) const {
  const Scalar turn = whole_turn<Scalar>();
  Scalar* const values = with_jacobian ? jacobian->data() : nullptr;
  for (const Term& term : terms_) {
    const Pose& a = poses_[static_cast<std::size_t>(term.a)];
    const Pose& b = poses_[static_cast<std::size_t>(term.b)];
    if (term.kind == Kind::turn) {
      phi[term.row] = a.angle - term.ratio * b.angle - offset_of(term);
      continue;
    }
    const Vector2 arm_a = a.turned(term.p_a);
    const Vector2 arm_b = b.turned(term.p_b);
    const Vector2 d((a.x - b.x) + (arm_a.x() - arm_b.x()), (a.y - b.y) + (arm_a.y() - arm_b.y()));
    if (term.kind == Kind::coincide) {
      phi[term.row] = d.x();
      phi[term.row + 1] = d.y();
      if constexpr (with_jacobian) {
        values[term.at[0]] = -arm_a.y();
        values[term.at[1]] = arm_b.y();
        values[term.at[2]] = arm_a.x();
        values[term.at[3]] = -arm_b.x();
      }
      continue;
    }
    // A row n . (p_a - p_b) + ...: its derivatives by the points and by what else turns with them.
    Vector2 n;
    Scalar by_angle_a(0);
    Scalar by_angle_b(0);
    if (term.kind == Kind::along) {
      n = b.turned(term.n);
      phi[term.row] = n.dot(d) + term.ratio * (a.angle - b.angle) - offset_of(term);
      by_angle_a = term.ratio;
      by_angle_b = left_of(n).dot(d) - term.ratio;
    } else {
      const Scalar distance = d.norm();
      const Vector2 u = distance > Scalar(0) ? Vector2(d / distance) : Vector2(Vector2::UnitX());
      if (term.kind == Kind::length) {
        n = u;
        phi[term.row] = distance - offset_of(term);
      } else {
        using std::atan2;
        using std::remainder;
        const Scalar sum = term.ratio + term.r_b;
        const Scalar theta = atan2(-d.y(), -d.x());
        phi[term.row] =
            remainder(term.ratio * (a.angle - theta) + term.r_b * (b.angle - theta) - term.offset,
                      turn * sum);
        // theta turns by -(left of u) . (dp_a - dp_b)/distance seen from b to a: u points from b.
        n = -sum / distance * left_of(u);
        by_angle_a = term.ratio;
        by_angle_b = term.r_b;
      }
    }
    if constexpr (with_jacobian) {
      values[term.at[0]] = n.x();
      values[term.at[1]] = n.y();
      values[term.at[2]] = n.dot(left_of(arm_a)) + by_angle_a;
      values[term.at[3]] = -n.x();
      values[term.at[4]] = -n.y();
      values[term.at[5]] = -n.dot(left_of(arm_b)) + by_angle_b;
    }
  }
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::evaluate(Vector& phi) const {
  evaluate_terms<false>(phi, nullptr);
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::evaluate(Vector& phi, std::vector<Scalar>& jacobian) const {
  if (jacobian.size() != constant_.size()) jacobian = constant_;
  evaluate_terms<true>(phi, &jacobian);
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::velocity_right_side(Vector& nu) const {
  nu.setZero();
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    nu[driver_rows_[i]] = static_cast<Scalar>(driver_states_[i].rate);
  }
}

template <class Scalar>
void ConstraintEquationsOf<Scalar>::acceleration_right_side(const Vector& v, Vector& gamma) const {
  // Velocities of the ground are none.
  const auto part = [&](int body, int coordinate) {
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(body) + coordinate;
    return i < v.size() ? v[i] : Scalar(0);
  };
  for (const Term& term : terms_) {
    const auto from_driver = static_cast<Scalar>(
        term.driver < 0 ? 0.0 : driver_states_[static_cast<std::size_t>(term.driver)].acceleration);
    if (term.kind == Kind::turn) {
      gamma[term.row] = from_driver;
      continue;
    }
    const Pose& a = poses_[static_cast<std::size_t>(term.a)];
    const Pose& b = poses_[static_cast<std::size_t>(term.b)];
    const Scalar omega_a = part(term.a, 2);
    const Scalar omega_b = part(term.b, 2);
    const Vector2 arm_a = a.turned(term.p_a);
    const Vector2 arm_b = b.turned(term.p_b);
    // The acceleration of p_a - p_b that the rotation rates give.
    const Vector2 centripetal = omega_b * omega_b * arm_b - omega_a * omega_a * arm_a;
    if (term.kind == Kind::coincide) {
      gamma[term.row] = -centripetal.x();
      gamma[term.row + 1] = -centripetal.y();
      continue;
    }
    const Vector2 d((a.x - b.x) + (arm_a.x() - arm_b.x()), (a.y - b.y) + (arm_a.y() - arm_b.y()));
    const Vector2 rate =
        Vector2(part(term.a, 0) - part(term.b, 0), part(term.a, 1) - part(term.b, 1)) +
        omega_a * left_of(arm_a) - omega_b * left_of(arm_b);
    Scalar own(0);
    if (term.kind == Kind::along) {
      const Vector2 n = b.turned(term.n);
      own = n.dot(centripetal) + Scalar(2) * omega_b * left_of(n).dot(rate) -
            omega_b * omega_b * n.dot(d);
    } else {
      const Scalar distance = d.norm();
      const Vector2 u = d / distance;
      const Scalar across = left_of(u).dot(rate);
      if (term.kind == Kind::length) {
        own = u.dot(centripetal) + across * across / distance;
      } else {
        own = -(term.ratio + term.r_b) / distance *
              (left_of(u).dot(centripetal) - Scalar(2) * u.dot(rate) * across / distance);
      }
    }
    gamma[term.row] = from_driver - own;
  }
}

}  // namespace boxbeam::planar
