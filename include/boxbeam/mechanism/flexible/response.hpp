#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <complex>
#include <memory>
#include <vector>

#include "boxbeam/mechanism/flexible/link_stiffness.hpp"
#include "boxbeam/mechanism/flexible/structure.hpp"
#include "boxbeam/mechanism/flexible/symmetric_factor.hpp"

namespace boxbeam::flexible {

using Complex = std::complex<double>;

/// Loads on a structure: columns (along, across, couple) about the node of every rigid element,
/// link by link.
template <class Scalar>
using LinkColumns = std::vector<Eigen::Matrix<Scalar, 3, Eigen::Dynamic>>;

/// Motion of all rigid elements and the forces in all joints.
template <class Scalar>
struct Deformation {
  LinkColumns<Scalar> motion;  ///< (u, w, phi) of every rigid element, link axes [m, m, rad]
  /// What each joint does to its a, along its axes and about it [N, N, N m]. On b it acts opposite.
  Eigen::Matrix<Scalar, 3, Eigen::Dynamic> joints;
};

/// Solves the structure under loads that vibrate,
///
///     (K + K_g + i omega C - omega^2 M) q = f,   links: C = tau K
///
/// K_g of the forces that are there before anything moves (`RigidElement::turning`); of the exact
/// form D(omega) q = f in the place of the left side, at the same nodes.
///
/// for one frequency. A `double` solves without damping, at any square of omega: below zero (a
/// shift of eigenvalues), zero (statics) and above.
///
/// Method: rigid elements are gathered from the ends of a link towards one that stays, by a
/// recursion on the dynamic stiffness D of all that lies behind a spring of flexibility F,
/// S = D (I + F D)^-1 (Riccati transfer). No stiffness is formed: rigid springs have F = 0, and
/// statically S = 0, without round-off. What stays, one element of every link and the forces of the
/// joints, is a small dense system. Where a part is nearly in resonance by itself, I + F D loses
/// digits: its pivot is kept from zero and the solution refined. Work and memory grow linearly with
/// the elements.
/// Sources: Horner, Pilkey, Journal of Mechanical Design 100 (1978), the Riccati transfer matrix
/// method; Li, Demmel, ACM Transactions on Mathematical Software 29 (2003), static pivoting.
template <class Scalar>
class DynamicStiffness {
 public:
  /// `omega`: of the damping [rad/s]; `square` = omega^2, or a shift. Throws AnalysisError where
  /// links are free to move (names them) or the structure is undamped and exactly in resonance.
  DynamicStiffness(const Structure& structure, double square, double omega);

  Deformation<Scalar> solve(const LinkColumns<Scalar>& loads) const;

  /// How many natural frequencies lie below the root of `square`; undamped only. At zero: in how
  /// many ways the structure buckles under the forces that are there. Source: Wittrick,
  /// Williams, Quarterly Journal of Mechanics and Applied Mathematics 24 (1971).
  std::size_t frequencies_below() const;

 private:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

  /// How an element that is gathered follows from its neighbour towards the one that stays.
  struct Step {
    Scalar axial{1.0};                        ///< 1/(1 + f D)
    Scalar b11{1.0}, b12{}, b21{}, b22{1.0};  ///< (I + F D)^-1
  };
  /// A joint's force on one element of a link: load per unit of force, in (u, w, phi).
  struct Port {
    std::size_t row = 0;  ///< of the joints' forces
    std::size_t link = 0, element = 0;
    double sign = 1.0;  ///< +1 on a, -1 on b
    Eigen::Vector3d h = Eigen::Vector3d::Zero();
  };
  /// A force of a joint that is not zero.
  struct Row {
    std::size_t joint = 0;
    int axis = 0;
    Scalar flexibility{};
  };
  /// Loads of a link gathered at the places of its springs, and at the element that stays.
  struct Gathered {
    Eigen::Matrix<Scalar, 3, Eigen::Dynamic> at_spring;
    Vector3 at_retained = Vector3::Zero();
  };

  void factor_link(std::size_t link);
  void list_ports();
  void factor_border();
  Deformation<Scalar> solve_resolved(const LinkColumns<Scalar>& loads) const;
  Gathered gather(std::size_t link, const Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& loads) const;
  void spread(std::size_t link, const Gathered& gathered, const Vector3& retained,
              Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& motion) const;
  /// `gaps`: by which the equations of the joints' forces are not fulfilled.
  Deformation<Scalar> solve_once(const LinkColumns<Scalar>& loads, const Vector& gaps) const;
  void refine(const LinkColumns<Scalar>& loads, Deformation<Scalar>& result) const;
  LinkColumns<Scalar> with_joint_forces(const LinkColumns<Scalar>& loads,
                                        const Deformation<Scalar>& of) const;
  [[noreturn]] void fail_singular() const;

  std::shared_ptr<const FinerStructure> finer_;  ///< in the exact form, where it is cut
  const Structure* structure_;                   ///< that, or as it was given
  double square_, omega_;
  std::vector<LinkStiffness<Scalar>> links_;
  std::vector<std::size_t> retained_;                   ///< the element of each link that stays
  std::vector<std::vector<Step>> steps_;                ///< of each link, by element
  std::vector<Eigen::Matrix<Scalar, 3, 3>> stiffness_;  ///< of each link at that element
  std::vector<Port> ports_;
  std::vector<Row> rows_;
  Matrix border_;          ///< scaled
  Eigen::VectorXd scale_;  ///< of unknowns and equations of the border
  SymmetricFactor<Scalar> factor_;
  Eigen::FullPivLU<Matrix> lu_;  ///< in its place where `fully_pivoted_`
  bool fully_pivoted_ = false;
  std::size_t gathered_below_ = 0;  ///< negative pivots within links
  double smallest_pivot_ = 1.0;     ///< within links, relative
};

/// No loads.
template <class Scalar>
LinkColumns<Scalar> no_loads(const Structure& structure);

/// Weight and constant loads.
LinkColumns<double> static_loads(const Structure& structure);

/// The amplitudes of the harmonic loads as phasors: the load is the imaginary part of
/// f e^(i omega t).
LinkColumns<Complex> harmonic_loads(const Structure& structure);

/// M q, the inertia of a motion. Of the exact form M = -dD/d(omega^2) at `square`: q^T M q is the
/// inertia of the links' motion between the nodes as well. Precondition: it is resolved there.
template <class Scalar>
LinkColumns<Scalar> mass_times(const Structure& structure, const LinkColumns<Scalar>& motion,
                               double square = 0.0);

/// Of what a finer structure gives, that of the nodes of the one it was cut from; and the other
/// way, zero in between.
template <class Scalar>
Deformation<Scalar> at_coarse_nodes(const FinerStructure& finer, const Deformation<Scalar>& of);
template <class Scalar>
LinkColumns<Scalar> at_finer_nodes(const FinerStructure& finer, const LinkColumns<Scalar>& of);

/// Whether any link or joint damps.
bool is_damped(const Mechanism& mechanism);

/// Static and harmonic response. A motion is static + Im(harmonic e^(i omega t)).
struct Response {
  double frequency = 0.0;  ///< [Hz]; zero: static only
  Deformation<double> constant;
  Deformation<Complex> harmonic;
};

/// Throws AnalysisError where the structure is free to move or in resonance without damping: a
/// millionth off a natural frequency that the loads excite, damped by less than a millionth of the
/// critical, where the amplitude depends on nothing but that distance.
Response response_of(const Structure& structure);
Deformation<double> static_response(const Structure& structure);
Deformation<Complex> harmonic_response(const Structure& structure, double frequency);

/// The motion at a time.
Deformation<double> at(const Response& response, double time);

/// The largest length of the vector Im(f e^(i omega t)) over a period, of two complex components:
/// the long half axis of its ellipse.
double largest_length(Complex x, Complex y);

/// What a joint does to its a, world axes [N, N, N m].
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> joint_force(const Structure& structure, std::size_t joint,
                                        const Deformation<Scalar>& of);

/// What lies along the links while they have a motion, by their mass: weight, and the inertia
/// -`square` times the motion's acceleration of one, m (g + square q).
template <class Scalar>
struct FieldAlong {
  Eigen::Matrix<Scalar, 2, 1> gravity = Eigen::Matrix<Scalar, 2, 1>::Zero();  ///< world [m/s^2]
  double square = 0.0;  ///< omega^2 of a motion that vibrates [1/s^2]
};

/// The motion (x, y, phi) of a place, world axes. Between the nodes of the corrected form that of
/// the bent axis: the part's forces from its nodes' motion, and from them and the field
///
///     phi' = m/EI,  w' = phi + Q/GA,  u' = n/EA,  m' = -Q,  Q' = -q,  n' = -p
///
/// exact in statics, of tapered links to the rounding of Gauss's rule with 7 points, as far as the
/// nodes are; inertia and weight as parabolas between two nodes. In the exact form a vibration of
/// the field's frequency is that of the continuous link. In the classical form that of the
/// rigid element that holds the place. Source: Timoshenko's beam, by virtual work.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> motion_at(const Structure& structure, const Attachment& place,
                                      const Deformation<Scalar>& of,
                                      const FieldAlong<Scalar>& field = {});

}  // namespace boxbeam::flexible
