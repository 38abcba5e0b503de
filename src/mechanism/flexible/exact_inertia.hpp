#pragma once

#include <boost/math/quadrature/gauss.hpp>

#include "boxbeam/beam/beam_loads.hpp"
#include "exact_part.hpp"

namespace boxbeam::flexible {

/// What f is over [0, h], as a cubic that has its ends, its integral and its moment: cut forces of
/// such a load are exact at both ends of the part, and within it to the fourth order of its length.
///
///     c_3 = 10 a + 60 b - 120 d,  a = f_1 - f_0,  b = J_0 - f_0,  d = J_1 - f_0/2
///
/// J_0, J_1: integrals of f and t f over t = x/h. By Gauss's rule with 10 points.
template <class Function>
std::array<Polynomial<3>, 2> cubic_of(const Function& f, double h) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  Complex J_0{}, J_1{};
  const auto add = [&](double t, double weight) {
    const Complex value = f(t * h);
    J_0 += weight * value;
    J_1 += weight * t * value;
  };
  for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
    add(0.5 - 0.5 * Gauss::abscissa()[k], 0.5 * Gauss::weights()[k]);
    add(0.5 + 0.5 * Gauss::abscissa()[k], 0.5 * Gauss::weights()[k]);
  }
  const Complex start = f(0.0);
  const Complex a = f(h) - start;
  const Complex b = J_0 - start;
  const Complex d = J_1 - 0.5 * start;
  const Complex c_3 = 10.0 * a + 60.0 * b - 120.0 * d;
  const Complex c_2 = 3.0 * a - 6.0 * b - 1.5 * c_3;
  const Complex c[] = {start, (a - c_2 - c_3) / h, c_2 / (h * h), c_3 / (h * h * h)};
  std::array<Polynomial<3>, 2> parts;
  for (std::size_t i = 0; i < 4; ++i) {
    parts[0].c[i] = c[i].real();
    parts[1].c[i] = c[i].imag();
  }
  return parts;
}

/// The inertia of a part over [from, to] within it, from that of its nodes' motion times omega^2:
/// real and imaginary part.
inline std::array<LineLoad, 2> exact_inertia_of(const ExactPart<Complex>& part,
                                                const LinkStretch& stretch, double from, double to,
                                                const Eigen::Vector3cd& q_0,
                                                const Eigen::Vector3cd& q_1) {
  const double h = to - from;
  const double by = from - stretch.start;
  const auto moved = [&](double x) { return part.at(from + x, q_0, q_1); };
  const auto along = cubic_of([&](double x) { return stretch.mass(by + x) * moved(x)[0]; }, h);
  const auto across = cubic_of([&](double x) { return stretch.mass(by + x) * moved(x)[1]; }, h);
  const auto couple = cubic_of([&](double x) { return stretch.rotary(by + x) * moved(x)[2]; }, h);
  std::array<LineLoad, 2> lines;
  for (std::size_t i : {0U, 1U}) {
    lines[i] = {si<Length>(from), si<Length>(h), {}, {}};
    lines[i].force[0] = along[i];
    lines[i].force[2] = across[i];
    // y points into the plane: counter-clockwise is negative about it.
    lines[i].couple[1] = -1.0 * couple[i] + Polynomial<4>{};
  }
  return lines;
}

}  // namespace boxbeam::flexible
