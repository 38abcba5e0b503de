#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace boxbeam {

/// Polynomial of degree at most `Degree` with coefficients in ascending order,
/// p(x) = c[0] + c[1] x + ... The degree is part of the type, so that products and integrals are
/// exact and need no memory.
template <int Degree>
struct Polynomial {
  static constexpr std::size_t size = static_cast<std::size_t>(Degree) + 1;
  std::array<double, size> c{};

  double operator()(double x) const {
    double sum = c[size - 1];
    for (std::size_t i = size - 1; i-- > 0;) sum = sum * x + c[i];
    return sum;
  }
};

template <int A, int B>
Polynomial<(A > B ? A : B)> operator+(const Polynomial<A>& a, const Polynomial<B>& b) {
  Polynomial<(A > B ? A : B)> sum;
  for (std::size_t i = 0; i < a.size; ++i) sum.c[i] += a.c[i];
  for (std::size_t i = 0; i < b.size; ++i) sum.c[i] += b.c[i];
  return sum;
}

template <int A>
Polynomial<A> operator*(double factor, Polynomial<A> p) {
  for (double& c : p.c) c *= factor;
  return p;
}

template <int A>
void add(Polynomial<A>& sum, double factor, const Polynomial<A>& p) {
  for (std::size_t i = 0; i < p.size; ++i) sum.c[i] += factor * p.c[i];
}

template <int A, int B>
Polynomial<A + B> operator*(const Polynomial<A>& a, const Polynomial<B>& b) {
  Polynomial<A + B> product;
  for (std::size_t i = 0; i < a.size; ++i) {
    for (std::size_t j = 0; j < b.size; ++j) product.c[i + j] += a.c[i] * b.c[j];
  }
  return product;
}

/// The integral that is `value_at_zero` at x = 0.
template <int A>
Polynomial<A + 1> integral_of(const Polynomial<A>& p, double value_at_zero = 0.0) {
  Polynomial<A + 1> result;
  result.c[0] = value_at_zero;
  for (std::size_t i = 0; i < p.size; ++i) result.c[i + 1] = p.c[i] / static_cast<double>(i + 1);
  return result;
}

template <int A>
Polynomial<(A > 0 ? A - 1 : 0)> derivative_of(const Polynomial<A>& p) {
  Polynomial<(A > 0 ? A - 1 : 0)> result;
  for (std::size_t i = 1; i < p.size; ++i) result.c[i - 1] = p.c[i] * static_cast<double>(i);
  return result;
}

/// What the value at each of these places weighs in that at x of the polynomial through them:
/// Lagrange. `Places`: an array or vector.
template <class Places>
Places lagrange_weights(const Places& places, double x) {
  Places weights = places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    weights[i] = 1.0;
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != i) weights[i] *= (x - places[k]) / (places[i] - places[k]);
  }
  return weights;
}

/// The polynomial of degree `Degree` that agrees with `f` at Degree + 1 points of [0, length]:
/// `f` itself where `f` is such a polynomial. Newton's divided differences on equal steps.
template <int Degree, class Function>
Polynomial<Degree> interpolate(const Function& f, double length) {
  constexpr std::size_t n = Polynomial<Degree>::size;
  std::array<double, n> x{};
  std::array<double, n> d{};
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = n > 1 ? length * static_cast<double>(i) / static_cast<double>(n - 1) : 0.0;
    d[i] = f(x[i]);
  }
  for (std::size_t order = 1; order < n; ++order) {
    for (std::size_t i = n - 1; i >= order; --i) {
      d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - order]);
    }
  }
  Polynomial<Degree> result;
  for (std::size_t i = n; i-- > 0;) {  // Horner's scheme in Newton's form, expanded
    for (std::size_t k = n - 1; k > 0; --k) result.c[k] = result.c[k - 1] - x[i] * result.c[k];
    result.c[0] = d[i] - x[i] * result.c[0];
  }
  return result;
}

/// The same polynomial of the distance from another place, p(x + by), by Horner's scheme.
template <int Degree>
Polynomial<Degree> shifted(const Polynomial<Degree>& p, double by) {
  if (by == 0.0) return p;
  Polynomial<Degree> result;
  for (std::size_t i = p.size; i-- > 0;) {
    for (std::size_t k = p.size - 1; k > 0; --k) result.c[k] = result.c[k - 1] + by * result.c[k];
    result.c[0] = p.c[i] + by * result.c[0];
  }
  return result;
}

}  // namespace boxbeam
