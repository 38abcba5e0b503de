// Numbers of so many decimal digits: by hand, as in any textbook on rounding errors.

#include "boxbeam/numerics/decimal.hpp"

#include <rapidcheck.h>

#include <Eigen/LU>
#include <cmath>

#include "catch.hpp"
#include "support/property.hpp"

namespace decimal_test {

using boxbeam::Decimal;

namespace {

using Five = Decimal<5>;

double of(Five number) { return static_cast<double>(number); }

}  // namespace

TEST_CASE("a decimal number keeps its significant digits (by hand)") {
  CHECK(of(Five(3.14159265)) == 3.1416);
  CHECK(of(Five(-0.000123456)) == -0.00012346);
  CHECK(of(Five(99999.6)) == 100000.0);
  CHECK(of(Five(1234567.0)) == 1234600.0);
  CHECK(of(Five(0.0)) == 0.0);
  CHECK(of(Five(1.0) / Five(3.0)) == 0.33333);
  CHECK(of(sqrt(Five(2.0))) == 1.4142);
  CHECK(of(sin(Five(1.0))) == 0.84147);
  CHECK(std::isinf(of(Five(1.0) / Five(0.0))));
}

TEST_CASE("sums of decimal numbers lose what is small, differences what is alike (by hand)") {
  CHECK(of(Five(12345.0) + Five(0.4)) == 12345.0);
  CHECK(of(Five(12345.0) + Five(0.6)) == 12346.0);
  // 1.0000 + 0.00004 three times: nothing is added, as pairs first it is.
  Five sum = 1.0;
  for (int i = 0; i < 3; ++i) sum += 0.00004;
  CHECK(of(sum) == 1.0);
  CHECK(of(Five(1.0) + (Five(0.00004) + Five(0.00004) + Five(0.00004))) == 1.0001);
  // 1 - cos(0.012) = 7.19991e-5: as a difference one digit is left, as 2 sin^2(0.006) four are.
  CHECK(of(Five(1.0) - cos(Five(0.012))) == 0.00007);
  CHECK(of(Five(2.0) * sin(Five(0.006)) * sin(Five(0.006))) == 0.000072);
}

TEST_CASE("the error of every operation is at most half a unit of the last digit") {
  test::holds([] {
    const double a = *rc::gen::inRange(-1000000, 1000000) / 977.0 + 1e-3;
    const double b = *rc::gen::inRange(-1000000, 1000000) / 661.0 + 1e-3;
    const Five x(a);
    const Five y(b);
    const auto near = [](Five rounded, double exact) {
      if (exact == 0.0) return of(rounded) == 0.0;
      const double unit = std::pow(10.0, std::floor(std::log10(std::abs(exact))) - 4.0);
      return std::abs(of(rounded) - exact) <= 0.5000001 * unit;
    };
    RC_ASSERT(near(x, a));
    RC_ASSERT(near(x + y, of(x) + of(y)));
    RC_ASSERT(near(x - y, of(x) - of(y)));
    RC_ASSERT(near(x * y, of(x) * of(y)));
    RC_ASSERT(near(x / y, of(x) / of(y)));
    RC_ASSERT(of(Five(of(x))) == of(x));
  });
}

TEST_CASE("Eigen solves in decimal numbers (Forsythe and Moler's system, three digits)") {
  // 0.0001 x + y = 1, x + y = 2: x = 1.00010, y = 0.99990. Without pivoting three digits give
  // x = 0; with it 1.00. Source: Forsythe and Moler, Computer Solution of Linear Algebraic Systems
  // (1967), section 9.
  using Three = Decimal<3>;
  Eigen::Matrix<Three, 2, 2> matrix;
  matrix << 0.0001, 1.0, 1.0, 1.0;
  const Eigen::Matrix<Three, 2, 1> right(Three(1.0), Three(2.0));
  const Eigen::Matrix<Three, 2, 1> x = matrix.partialPivLu().solve(right);
  CHECK(static_cast<double>(x[0]) == 1.0);
  CHECK(static_cast<double>(x[1]) == 1.0);
  const Three factor = Three(1.0) / matrix(0, 0);
  const Three y = (right[1] - factor * right[0]) / (matrix(1, 1) - factor * matrix(0, 1));
  CHECK(static_cast<double>(y) == 1.0);
  CHECK(static_cast<double>((right[0] - y) / matrix(0, 0)) == 0.0);
}

}  // namespace decimal_test
