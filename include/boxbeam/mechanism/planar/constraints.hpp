#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "boxbeam/numerics/sparse_elimination.hpp"

namespace boxbeam::planar {

/// Position of an attached point in world axes [m].
Eigen::Vector2d position_of(const Attachment& point, const Eigen::VectorXd& q);
/// Velocity and acceleration of an attached point in world axes.
Eigen::Vector2d velocity_of(const Attachment& point, const Eigen::VectorXd& q,
                            const Eigen::VectorXd& v);
Eigen::Vector2d acceleration_of(const Attachment& point, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& v, const Eigen::VectorXd& a);

/// The constraint equations Phi(q, t) = 0 of a mechanism, metres and radians, joint after joint in
/// the order of the mechanism, with their derivatives. Built once; evaluations allocate nothing.
/// Sources: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems (1989), chapter 3;
/// Nikravesh, Planar Multibody Dynamics (2007), chapter 7.
///
/// Scalar: the arithmetic: float, double, long double or Decimal<5>. The mechanism's numbers are
/// rounded to it, and so is what the drivers say, in double, of an instant.
template <class Scalar>
class ConstraintEquationsOf {
 public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Vector2 = Eigen::Matrix<Scalar, 2, 1>;

  explicit ConstraintEquationsOf(const Mechanism& mechanism);

  Eigen::Index rows() const { return pattern_.rows; }
  /// Where the Jacobian dPhi/dq may differ from zero.
  const SparsePattern& pattern() const { return pattern_; }

  /// Factors that make equations and coordinates free of the unit of length: 1/size or 1 per
  /// equation, size or 1 per coordinate.
  const Eigen::VectorXd& row_scale() const { return row_scale_; }
  const Eigen::VectorXd& col_scale() const { return col_scale_; }

  /// The instant and the position that the next evaluations are for.
  void set_time(double time);
  void set_position(const Vector& q);
  /// A position close to the one before: cosines and sines by their series where a body has turned
  /// by less than a milliradian (exact to round-off).
  void move_position(const Vector& q);

  /// An attached point in world axes at the set position [m].
  Vector2 place_of(const Attachment& point) const {
    const Pose& pose =
        poses_[point.body == ground ? poses_.size() - 1 : static_cast<std::size_t>(point.body)];
    return Vector2(pose.x, pose.y) + pose.turned(point.p.cast<Scalar>());
  }

  void evaluate(Vector& phi) const;
  /// Constraints and the values of their Jacobian at once; analytic.
  void evaluate(Vector& phi, std::vector<Scalar>& jacobian) const;
  /// Right side of J v = -dPhi/dt.
  void velocity_right_side(Vector& nu) const;
  /// Right side of J a = -(J v)_q v - d2Phi/dt2.
  void acceleration_right_side(const Vector& v, Vector& gamma) const;

  /// The drivers' present states, in the order of their joints.
  const std::vector<DriverState>& driver_states() const { return driver_states_; }
  /// Values taken instead of the drivers' own at the set time, for continuation along the drivers.
  void set_driver_values(const std::vector<double>& values);
  /// The same with rates and accelerations.
  void set_driver_states(const std::vector<DriverState>& states);
  /// The row of each driver, in the order of their joints.
  const std::vector<Eigen::Index>& driver_rows() const { return driver_rows_; }

 private:
  /// Equations are of five kinds; every joint is made of them.
  enum class Kind {
    coincide,  ///< p_a - p_b (two rows)
    along,     ///< n . (p_a - p_b) + r (phi_a - phi_b) - offset, n fixed to b
    turn,      ///< phi_a - ratio phi_b - offset
    length,    ///< |p_a - p_b| - offset
    mesh,      ///< r (phi_a - theta) + r_b (phi_b - theta) - offset
  };
  struct Term {
    Kind kind = Kind::coincide;
    int row = 0;
    int a = 0, b = 0;  ///< bodies; the ground is the one behind the last
    Vector2 p_a = Vector2::Zero(), p_b = Vector2::Zero();
    Vector2 n = Vector2::Zero();
    Scalar offset{};
    Scalar ratio{};  ///< or r
    Scalar r_b{};
    int driver = -1;
    std::array<std::uint32_t, 6> at{};  ///< places of the Jacobian's entries in the values
  };
  struct Pose {
    Scalar x{}, y{}, angle{}, cos{1}, sin{};

    Vector2 turned(const Vector2& p) const {
      return {cos * p.x() - sin * p.y(), sin * p.x() + cos * p.y()};
    }
  };
  struct Builder;

  Scalar offset_of(const Term& term) const {
    if (term.driver < 0) return term.offset;
    return static_cast<Scalar>(driver_states_[static_cast<std::size_t>(term.driver)].value);
  }
  template <bool with_jacobian>
  void evaluate_terms(Vector& phi, std::vector<Scalar>* jacobian) const;

  std::vector<Term> terms_;
  std::vector<const Driver*> drivers_;
  std::vector<Eigen::Index> driver_rows_;
  std::vector<DriverState> driver_states_;
  std::vector<Pose> poses_;  ///< of the bodies and, last, of the ground
  SparsePattern pattern_;
  std::vector<Scalar> constant_;  ///< the Jacobian with the entries that never change
  Eigen::VectorXd row_scale_, col_scale_;
};

using ConstraintEquations = ConstraintEquationsOf<double>;

}  // namespace boxbeam::planar
