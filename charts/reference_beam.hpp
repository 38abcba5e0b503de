#pragma once

#include <complex>

#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam::charts {

/// The cantilever whose every answer is known: uniform, without shear and rotary inertia, bending
/// stiffness, mass per length and length one; a force of one across its free end, constant and as
/// amplitude. `retardation` as that of a link.
flexible::Mechanism unit_cantilever(int parts, flexible::Element element, double retardation = 0.0);

/// beta L of the k-th free vibration, k = 1, 2, ...: cos(x) cosh(x) = -1. Its circular frequency is
/// (beta L)^2. Source: Timoshenko, Vibration Problems in Engineering (1937).
long double cantilever_root(int k);

/// Moment at the root under the vibrating force, over the static one:
///
///     (sinh x + sin x)/(x (1 + cosh x cos x)),   x^4 = omega^2
///
/// Source: the equation of Euler and Bernoulli's beam, w'''' = omega^2 w.
long double cantilever_root_moment(long double omega);

/// The rigid elements of a divided cantilever as they are, solved from end to end in long numbers:
/// what a solver should say of the same equations.
///
///     springs    gap = F f/(1 + i omega tau)
///     elements   -omega^2 M q = loads - f before + f behind
///
/// Valid for one link that is clamped without give at its start and does not strain along its axis;
/// only forces across it count. Source: Holzer (1921), Myklestad (1944): the initial value method.
class ChainReference {
 public:
  using Number = std::complex<long double>;

  explicit ChainReference(const flexible::Structure& structure);

  /// What the clamp does to the beam, a couple, under the harmonic load at the end.
  Number root_moment(long double omega) const;
  /// The first circular frequency without damping, next to a guess, by the secant rule.
  long double first_omega(long double guess) const;

 private:
  struct State {
    Number w{}, phi{}, force{}, couple{};
  };
  /// Balance of the last element, which must vanish: force and couple, of a start at the root.
  State balance(long double omega, const State& root, long double load) const;

  const flexible::DividedLink* link_;
  long double retardation_;
  long double load_;
};

}  // namespace boxbeam::charts
