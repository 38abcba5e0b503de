#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "boxbeam/mechanism/flexible/structure.hpp"

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
///     (K (1 + i omega tau) + i omega C - omega^2 M) q = f
///
/// for one frequency after another; omega^2 = `square` may be negative (a shift for eigenvalues)
/// and zero (statics).
///
/// Method: rigid elements are gathered from the ends of a link towards one that stays, by a
/// recursion on the dynamic stiffness D of all that lies behind a spring of flexibility F,
/// S = D (I + F D)^-1 (Riccati transfer). No stiffness is formed: rigid springs have F = 0, and
/// statically S = 0, without round-off. What stays, one element of every link and the forces of the
/// joints, is a small dense system. Work and memory grow linearly with the elements.
/// Source: Horner, Pilkey, Journal of Mechanical Design 100 (1978), the Riccati transfer matrix
/// method; mixed formulation.
template <class Scalar>
class DynamicStiffness {
 public:
  /// Throws AnalysisError where a link or a group of them is free to move (names them), or an
  /// undamped structure is in resonance.
  DynamicStiffness(const Structure& structure, double square);

  Deformation<Scalar> solve(const LinkColumns<Scalar>& loads) const;

 private:
  struct Work;
  const Structure* structure_;
  double square_;
};

/// No loads.
template <class Scalar>
LinkColumns<Scalar> no_loads(const Structure& structure);

/// Weight and constant loads.
LinkColumns<double> static_loads(const Structure& structure);

/// The amplitudes of the harmonic loads as phasors: the load is the imaginary part of
/// f e^(i omega t).
LinkColumns<Complex> harmonic_loads(const Structure& structure);

/// M q, the inertia of a motion.
template <class Scalar>
LinkColumns<Scalar> mass_times(const Structure& structure, const LinkColumns<Scalar>& motion);

/// Whether any link or joint damps.
bool is_damped(const Structure& structure);

/// Static and harmonic response. A motion is static + Im(harmonic e^(i omega t)).
struct Response {
  double frequency = 0.0;  ///< [Hz]; zero: static only
  Deformation<double> constant;
  Deformation<Complex> harmonic;
};

/// Throws AnalysisError where the structure is free to move or, undamped, in resonance.
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

/// The motion (x, y, phi) of a place, world axes.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> motion_at(const Structure& structure, const Attachment& place,
                                      const Deformation<Scalar>& of);

}  // namespace boxbeam::flexible
