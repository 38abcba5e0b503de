#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

namespace boxbeam {

/// A number that is rounded to so many significant decimal digits after every operation, as in a
/// calculation by hand or one that carries only what it prints. Rounds half to even, as far as the
/// double that it is calculated in tells halves apart. Valid for up to 15 digits and magnitudes
/// between 1e-290 and 1e290. A scalar of Eigen's matrices.
template <int Digits>
class Decimal {
  static_assert(Digits > 0 && Digits <= 15);

 public:
  Decimal() = default;
  // Implicit as that of double from int, so that formulas are written alike in every scalar.
  Decimal(double value) : value_(rounded(value)) {}

  explicit operator double() const { return value_; }
  explicit operator float() const { return static_cast<float>(value_); }
  explicit operator long double() const { return static_cast<long double>(value_); }
  explicit operator int() const { return static_cast<int>(value_); }

  Decimal operator-() const { return exactly(-value_); }
  friend Decimal operator+(Decimal a, Decimal b) { return a.value_ + b.value_; }
  friend Decimal operator-(Decimal a, Decimal b) { return a.value_ - b.value_; }
  friend Decimal operator*(Decimal a, Decimal b) { return a.value_ * b.value_; }
  friend Decimal operator/(Decimal a, Decimal b) { return a.value_ / b.value_; }
  Decimal& operator+=(Decimal b) { return *this = *this + b; }
  Decimal& operator-=(Decimal b) { return *this = *this - b; }
  Decimal& operator*=(Decimal b) { return *this = *this * b; }
  Decimal& operator/=(Decimal b) { return *this = *this / b; }
  friend bool operator==(Decimal a, Decimal b) { return a.value_ == b.value_; }
  friend auto operator<=>(Decimal a, Decimal b) { return a.value_ <=> b.value_; }

  friend Decimal abs(Decimal a) { return exactly(std::abs(a.value_)); }
  friend Decimal sqrt(Decimal a) { return std::sqrt(a.value_); }
  friend Decimal sin(Decimal a) { return std::sin(a.value_); }
  friend Decimal cos(Decimal a) { return std::cos(a.value_); }
  friend Decimal atan2(Decimal y, Decimal x) { return std::atan2(y.value_, x.value_); }
  friend Decimal remainder(Decimal a, Decimal b) { return std::remainder(a.value_, b.value_); }
  friend bool isfinite(Decimal a) { return std::isfinite(a.value_); }

 private:
  static Decimal exactly(double value) {
    Decimal result;
    result.value_ = value;
    return result;
  }

  static double rounded(double value) {
    if (value == 0.0 || !std::isfinite(value)) return value;
    const int place = static_cast<int>(std::floor(std::log10(std::abs(value)))) - Digits + 1;
    // A power of ten up to 22 and a whole number are exact: their quotient is the nearest double.
    const double unit = power_of_ten(std::abs(place));
    return place < 0 ? std::nearbyint(value * unit) / unit : std::nearbyint(value / unit) * unit;
  }

  static double power_of_ten(int exponent) {
    static constexpr std::array<double, 23> exact{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                  1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                  1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    return exponent < 23 ? exact[static_cast<std::size_t>(exponent)] : std::pow(10.0, exponent);
  }

  double value_ = 0.0;
};

}  // namespace boxbeam

template <int Digits>
struct Eigen::NumTraits<boxbeam::Decimal<Digits>> : Eigen::NumTraits<double> {
  using Real = boxbeam::Decimal<Digits>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;

  enum { RequireInitialization = 1, ReadCost = 1, AddCost = 50, MulCost = 50 };

  static Real epsilon() { return std::pow(10.0, 1 - Digits); }
  static Real dummy_precision() { return std::pow(10.0, 2 - Digits); }
  static int digits10() { return Digits; }
};

template <int Digits>
struct std::numeric_limits<boxbeam::Decimal<Digits>> : std::numeric_limits<double> {
  static boxbeam::Decimal<Digits> epsilon() { return std::pow(10.0, 1 - Digits); }
  static boxbeam::Decimal<Digits> min() { return 1e-290; }
};
