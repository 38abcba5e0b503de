#pragma once

#include <cmath>

namespace boxbeam::charts {

/// A quantity with its first two time derivatives, that formulas of positions are carried out with:
/// what comes out has its velocity and acceleration. Source: Griewank, Walther, Evaluating
/// Derivatives (2008), chapter 13 (Taylor arithmetic).
template <class Scalar>
struct Jet {
  Scalar x{}, v{}, a{};

  friend Jet operator+(const Jet& p, const Jet& q) { return {p.x + q.x, p.v + q.v, p.a + q.a}; }
  friend Jet operator-(const Jet& p, const Jet& q) { return {p.x - q.x, p.v - q.v, p.a - q.a}; }
  friend Jet operator*(const Jet& p, const Jet& q) {
    return {p.x * q.x, p.v * q.x + p.x * q.v, p.a * q.x + Scalar(2) * p.v * q.v + p.x * q.a};
  }
  friend Jet operator*(Scalar c, const Jet& p) { return {c * p.x, c * p.v, c * p.a}; }
  friend Jet operator/(const Jet& p, const Jet& q) {
    const Scalar x = p.x / q.x;
    const Scalar v = (p.v - x * q.v) / q.x;
    return {x, v, (p.a - Scalar(2) * v * q.v - x * q.a) / q.x};
  }
  friend Jet sqrt(const Jet& p) {
    using std::sqrt;
    const Scalar x = sqrt(p.x);
    const Scalar v = p.v / (Scalar(2) * x);
    return {x, v, (p.a / Scalar(2) - v * v) / x};
  }
  friend Jet cos(const Jet& p) {
    using std::cos;
    using std::sin;
    const Scalar c = cos(p.x);
    const Scalar s = sin(p.x);
    return {c, -s * p.v, -s * p.a - c * p.v * p.v};
  }
  friend Jet sin(const Jet& p) {
    using std::cos;
    using std::sin;
    const Scalar c = cos(p.x);
    const Scalar s = sin(p.x);
    return {s, c * p.v, c * p.a - s * p.v * p.v};
  }
  friend Jet atan2(const Jet& q, const Jet& p) {
    using std::atan2;
    const Scalar square = p.x * p.x + q.x * q.x;
    const Scalar v = (p.x * q.v - q.x * p.v) / square;
    const Scalar change = Scalar(2) * (p.x * p.v + q.x * q.v);
    return {atan2(q.x, p.x), v, (p.x * q.a - q.x * p.a - v * change) / square};
  }
};

/// A point or vector in the plane that moves.
template <class Scalar>
struct JetVector {
  Jet<Scalar> x, y;

  friend JetVector operator+(const JetVector& p, const JetVector& q) {
    return {p.x + q.x, p.y + q.y};
  }
  friend JetVector operator-(const JetVector& p, const JetVector& q) {
    return {p.x - q.x, p.y - q.y};
  }
  friend JetVector operator*(const Jet<Scalar>& c, const JetVector& p) {
    return {c * p.x, c * p.y};
  }
  friend Jet<Scalar> dot(const JetVector& p, const JetVector& q) { return p.x * q.x + p.y * q.y; }
  /// Turned by a quarter, to the left.
  friend JetVector left_of(const JetVector& p) { return {Scalar(-1) * p.y, p.x}; }
};

}  // namespace boxbeam::charts
