#include "boxbeam/numerics/polynomial.hpp"

#include <array>
#include <cmath>
#include <random>

#include "catch.hpp"

namespace polynomial_test {

using namespace boxbeam;

namespace {

/// Coefficients between -1 and 1.
template <int Degree>
Polynomial<Degree> random_polynomial(std::mt19937& random) {
  std::uniform_real_distribution<double> coefficient(-1.0, 1.0);
  Polynomial<Degree> p;
  for (double& c : p.c) c = coefficient(random);
  return p;
}

// The degree of a result is part of its type.
static_assert(decltype(Polynomial<2>{} * Polynomial<1>{})::size == 4);
static_assert(decltype(integral_of(Polynomial<3>{}))::size == 5);
static_assert(decltype(derivative_of(Polynomial<3>{}))::size == 3);
static_assert(decltype(Polynomial<1>{} + Polynomial<3>{})::size == 4);

constexpr double points[] = {-2.0, -0.7, 0.0, 0.3, 1.0, 2.5};

}  // namespace

TEST_CASE("a polynomial is the sum of its powers") {
  // By hand: 1 + 2*2 + 3*4 + 4*8 = 49.
  CHECK(Polynomial<3>{{1.0, 2.0, 3.0, 4.0}}(2.0) == 49.0);
  CHECK(Polynomial<0>{{5.0}}(123.0) == 5.0);
  CHECK(Polynomial<4>{}(0.7) == 0.0);
}

TEST_CASE("sums, products and multiples are those of the values") {
  std::mt19937 random(1);
  for (int run = 0; run < 20; ++run) {
    const Polynomial<2> a = random_polynomial<2>(random);
    const Polynomial<4> b = random_polynomial<4>(random);
    for (const double x : points) {
      CHECK((a + b)(x) == Approx(a(x) + b(x)).margin(1e-12));
      CHECK((b + a)(x) == Approx(a(x) + b(x)).margin(1e-12));
      CHECK((a * b)(x) == Approx(a(x) * b(x)).margin(1e-11));
      CHECK((-2.5 * b)(x) == Approx(-2.5 * b(x)).margin(1e-12));
    }
  }
}

TEST_CASE("the integral has the value by hand") {
  // Integral of 1 + 2x + 3x^2 from 0 to 2: 2 + 4 + 8 = 14.
  const Polynomial<2> p{{1.0, 2.0, 3.0}};
  CHECK(integral_of(p)(2.0) == Approx(14.0).epsilon(1e-15));
  CHECK(integral_of(p, -4.0)(2.0) == Approx(10.0).epsilon(1e-15));
  CHECK(integral_of(p, -4.0)(0.0) == -4.0);
}

TEST_CASE("the derivative has the value by hand") {
  // d/dx (7 + x + x^3) = 1 + 3x^2, 13 at x = 2.
  CHECK(derivative_of(Polynomial<3>{{7.0, 1.0, 0.0, 1.0}})(2.0) == 13.0);
  CHECK(derivative_of(Polynomial<0>{{7.0}})(2.0) == 0.0);
}

TEST_CASE("the derivative of the integral is the polynomial") {
  std::mt19937 random(2);
  const Polynomial<5> p = random_polynomial<5>(random);
  const Polynomial<5> same = derivative_of(integral_of(p, 3.0));
  for (std::size_t i = 0; i < p.size; ++i) CHECK(same.c[i] == Approx(p.c[i]).epsilon(1e-15));
}

TEST_CASE("interpolation gives back a polynomial of its degree") {
  std::mt19937 random(3);
  for (const double length : {0.1, 1.0, 6.2}) {
    const Polynomial<4> p = random_polynomial<4>(random);
    const Polynomial<4> q = interpolate<4>(p, length);
    for (double fraction = 0.0; fraction <= 1.0; fraction += 0.125) {
      CHECK(q(fraction * length) == Approx(p(fraction * length)).epsilon(1e-9).margin(1e-10));
    }
  }
}

TEST_CASE("interpolation agrees with any function at equal steps") {
  const Polynomial<3> p = interpolate<3>([](double x) { return std::exp(x); }, 1.5);
  for (const double x : {0.0, 0.5, 1.0, 1.5}) CHECK(p(x) == Approx(std::exp(x)).epsilon(1e-14));
}

TEST_CASE("interpolation of degree zero takes the value at the start") {
  CHECK(interpolate<0>([](double x) { return 3.0 + x; }, 2.0)(1.0) == 3.0);
}

TEST_CASE("Lagrange's weights give a polynomial from its values at places that lie as they will") {
  std::mt19937 random(4);
  const Polynomial<4> p = random_polynomial<4>(random);
  const std::array<double, 5> places{-0.9, -0.2, 0.1, 0.7, 1.3};
  for (const double x : {-1.2, -0.2, 0.0, 0.45, 2.0}) {
    const std::array<double, 5> weights = lagrange_weights(places, x);
    double value = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      value += weights[i] * p(places[i]);
      sum += weights[i];
    }
    CHECK(value == Approx(p(x)).epsilon(1e-12).margin(1e-12));
    CHECK(sum == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("a polynomial from another place has the values that it had") {
  std::mt19937 random(5);
  const Polynomial<3> p = random_polynomial<3>(random), q = shifted(p, 0.8);
  for (const double x : {-0.5, 0.0, 0.7, 1.5})
    CHECK(q(x) == Approx(p(x + 0.8)).epsilon(1e-12).margin(1e-12));
}

}  // namespace polynomial_test
