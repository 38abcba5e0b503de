#pragma once

#include <Eigen/LU>
#include <cmath>

#include "support/elastic_beams.hpp"

/// The uniform beam as a continuum: its equations integrated along it, exact for any frequency.
///
///     w' = phi + V/GA,   phi' = M/EI,   V' = -omega^2 mu w,   M' = -V - omega^2 rho I phi
///
/// w shift across, phi turn, V and M what the part behind a cut does to that before it.
/// Timoshenko's beam; with GA = infinity and rho I = 0 that of Euler and Bernoulli. Source: Pestel,
/// Leckie, Matrix Methods in Elastomechanics (1963), chapter 5.
namespace test {

using State = Eigen::Matrix<long double, 4, 1>;
using Transfer = Eigen::Matrix<long double, 4, 4>;

/// (w, phi, V, M) at a distance from (w, phi, V, M) at the start: exp(A s), by the series of a
/// short piece and repeated squaring, in lengths and forces of the bar.
inline Transfer transfer_of(const Bar& bar, long double square, long double s) {
  Transfer A = Transfer::Zero();
  A(0, 1) = 1.0L;
  A(0, 2) = 1.0L / static_cast<long double>(bar.GA);
  A(1, 3) = 1.0L / static_cast<long double>(bar.EI);
  A(2, 0) = -square * static_cast<long double>(bar.mass);
  A(3, 1) = -square * static_cast<long double>(bar.rotary);
  A(3, 2) = -1.0L;
  // Lengths in s, V in EI/s^2, M in EI/s.
  const State unit(s, 1.0L, bar.EI / (s * s), bar.EI / s);
  const Transfer scaled = unit.cwiseInverse().asDiagonal() * (s * A) * unit.asDiagonal();
  int halvings = 0;
  while (std::ldexp(scaled.cwiseAbs().maxCoeff(), -halvings) > 0.1L) ++halvings;
  const Transfer small = scaled * std::ldexp(1.0L, -halvings);
  Transfer sum = Transfer::Identity(), term = Transfer::Identity();
  for (int k = 1; k < 20; ++k) {
    term = (term * small / static_cast<long double>(k)).eval();
    sum += term;
  }
  for (int i = 0; i < halvings; ++i) sum = (sum * sum).eval();
  return unit.asDiagonal() * sum * unit.cwiseInverse().asDiagonal();
}

/// What an end lets go: rows of (w, phi, V, M) that are zero there.
inline Eigen::Array<int, 2, 1> zero_rows(End end) {
  switch (end) {
    case End::free: return {2, 3};
    case End::pinned: return {0, 3};
    case End::clamped: return {0, 1};
  }
  return {0, 0};
}

/// Zero at the squares of the angular frequencies of a beam's free vibrations.
inline long double frequency_function(const Bar& bar, End start, End end, long double square) {
  const Transfer T = transfer_of(bar, square, bar.L);
  const auto zero = zero_rows(end);
  const auto start_zero = zero_rows(start);
  Eigen::Matrix<long double, 2, 2> part;
  Eigen::Index column = 0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    if (i == start_zero[0] || i == start_zero[1]) continue;
    part.col(column++) << T(zero[0], i), T(zero[1], i);
  }
  return part.determinant();
}

/// The square of the angular frequency next to a guess, by the secant rule.
inline double exact_square_near(const Bar& bar, End start, End end, double guess) {
  long double a = guess, b = guess * (1.0L + 1e-4L);
  long double fa = frequency_function(bar, start, end, a);
  long double fb = frequency_function(bar, start, end, b);
  for (int i = 0; i < 60 && fb != fa && std::abs(b - a) > 1e-17L * std::abs(b); ++i) {
    const long double c = b - fb * (b - a) / (fb - fa);
    a = b, fa = fb;
    b = c, fb = frequency_function(bar, start, end, b);
  }
  return static_cast<double>(b);
}

/// A vibrating beam under a force and a couple at its end (amplitudes): the start state, with what
/// the ends do not let go unknown.
struct BeamVibration {
  State start, end;  ///< (w, phi, V, M)
};
inline BeamVibration vibration_of(const Bar& bar, End start, long double square, long double force,
                                  long double couple) {
  const Transfer T = transfer_of(bar, square, bar.L);
  const auto zero = zero_rows(start);
  Eigen::Matrix<long double, 2, 2> part;
  Eigen::Array<Eigen::Index, 2, 1> unknown;
  Eigen::Index column = 0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    if (i == zero[0] || i == zero[1]) continue;
    unknown[column] = i;
    part.col(column++) << T(2, i), T(3, i);
  }
  const Eigen::Matrix<long double, 2, 1> x =
      part.fullPivLu().solve(Eigen::Matrix<long double, 2, 1>(force, couple));
  BeamVibration result{State::Zero(), {}};
  result.start[unknown[0]] = x[0];
  result.start[unknown[1]] = x[1];
  result.end = T * result.start;
  return result;
}

}  // namespace test
