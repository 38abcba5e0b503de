#pragma once

#include <Eigen/Core>
#include <array>

#include "boxbeam/mechanism/flexible/link_stiffness.hpp"

namespace boxbeam::flexible {

/// A part of a link between two nodes as it is, without division, vibrating with omega^2 = z:
///
///     u' = n/EA,  w' = phi + Q/GA,  phi' = m/EI
///     n' = -z mu u,  Q' = -z mu w,  m' = -Q - z rho I phi
///
/// by power series along the part of the state (w, phi, Q, m) from each of its values at the start:
/// for uniform parts those of the closed solutions (exponentials, of which nothing can overflow
/// here), for tapered ones with the moduli divided out term by term. Static and dynamic terms are
/// summed apart, so that the inertia of a short part keeps all its digits. With damping
/// z = omega^2/(1 + i omega tau), and all stiffnesses times 1 + i omega tau.
///
/// The dynamic stiffness is that of two nodes and a spring between them: with d_1 = A d_0 + B p_0
/// and p_1 = C d_0 + E p_0 of d = (w, phi), p = (Q, m),
///
///     f_22 = B_22,  f_11 = det B/B_22,  levers -B_21/B_22 from the start, -B_12/B_22 from the end
///
/// and each node resists what is left. Exact to round-off where `resolves` holds. Sources:
/// Timoshenko, Philosophical Magazine 41 (1921); Pestel, Leckie, Matrix Methods in Elastomechanics
/// (1963), transfer matrices; Banerjee, Computers and Structures 63 (1997), dynamic stiffness.
template <class Scalar>
class ExactPart {
 public:
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

  ExactPart(const Link& link, double from, double to, const Scalar& z);

  /// (u, w, phi) at a place of the part, from those of its nodes.
  Vector3 at(double s, const Vector3& q_0, const Vector3& q_1) const;

  NodeStiffness<Scalar> start, end;
  PartFlexibility<Scalar> between;

 private:
  static constexpr int most_terms = 64;
  /// By powers of the share of the part's length; `terms` of them count.
  using Series = std::array<Scalar, most_terms + 1>;
  /// Of one value at the start: what it does statically, and what inertia adds.
  struct Along {
    Series u{}, phi{}, du{}, dphi{};  ///< u: the shift along or across
    Series dforce{}, dm{};
    int terms = 0;
  };

  void stretch(const Link& link, const LinkStretch& of);
  void bend(const Link& link, const LinkStretch& of);
  void carry_along(const LinkStretch& of);
  void carry_across(const LinkStretch& of);
  Along axial_from(const LinkStretch& of, double u, double n) const;
  Along bending_from(const LinkStretch& of, double w, double phi, double Q, double m) const;

  double from_, h_;
  Scalar z_;
  bool stretches_, bends_;
  std::array<Along, 2> axial_;    ///< of u, n
  std::array<Along, 4> bending_;  ///< of w, phi, Q, m
};

/// Whether a part's series end in round-off, and no resonance of it between held nodes lies below:
///
///     |z| mu h^2/EA <= 1,  |z| (mu h^4/EI + mu h^2/GA + rho I h^2/EI) <= 1,
///     sum over j > 0 of |p_j| (2 h)^j <= p_0 of EA, GA and EI about the part's start
///
/// The first two by Poincare's inequality, integral of f^2 <= (h/pi)^2 that of f'^2 where f is zero
/// at both ends: omega^2 of the part's own vibrations is more than twice z. The third: what is
/// divided by a modulus has a radius of convergence of 2 h.
bool resolves(const Link& link, double from, double to, double square);

}  // namespace boxbeam::flexible
