// The spline against cubics it must reproduce, its smoothness and its order.

#include "boxbeam/numerics/cubic_spline.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace cubic_spline_test {

using namespace boxbeam;

TEST_CASE("a clamped spline reproduces a cubic with zero slope at both ends") {
  // 3 x^2 - 2 x^3 on [0, 1] (hand): a cubic spline with these end slopes is unique.
  const auto f = [](double x) { return x * x * (3.0 - 2.0 * x); };
  std::vector<double> x{0.0, 0.13, 0.4, 0.55, 0.9, 1.0};
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  const CubicSpline spline(x, y, SplineEnds::clamped);
  for (int i = 0; i <= 100; ++i) {
    const double at = 0.01 * i;
    const Derivatives d = spline.at(at);
    CHECK(d.value == Approx(f(at)).margin(1e-15));
    CHECK(d.first == Approx(6.0 * at * (1.0 - at)).margin(1e-13));
    CHECK(d.second == Approx(6.0 - 12.0 * at).margin(1e-12));
  }
  // Outside it rests.
  CHECK(spline.at(-1.0).value == 0.0);
  CHECK(spline.at(2.0).value == 1.0);
  CHECK(spline.at(2.0).first == 0.0);
}

TEST_CASE("value, slope and bend go on over every point, and over the end of a period") {
  const std::vector<double> x{0.0, 0.2, 0.5, 0.6, 1.0, 1.3};
  const std::vector<double> y{1.0, -0.3, 0.4, 2.0, 0.1, 1.0};
  const double h = 1e-9;
  for (const SplineEnds ends : {SplineEnds::clamped, SplineEnds::periodic}) {
    const CubicSpline spline(x, y, ends);
    for (std::size_t i = ends == SplineEnds::periodic ? 0 : 1; i + 1 < x.size(); ++i) {
      CHECK(spline.at(x[i]).value == Approx(y[i]).margin(1e-14));
      const Derivatives before = spline.at(x[i] - h);
      const Derivatives behind = spline.at(x[i] + h);
      CHECK(std::abs(before.value - behind.value) < 1e-6);
      CHECK(std::abs(before.first - behind.first) < 1e-5);
      CHECK(std::abs(before.second - behind.second) < 1e-4);
    }
  }
}

TEST_CASE("a periodic spline through a sine converges with the fourth order") {
  const auto error_with = [](int n) {
    std::vector<double> x, y;
    for (int i = 0; i <= n; ++i) {
      x.push_back(static_cast<double>(i) / n);
      y.push_back(i == n ? 0.0 : std::sin(2.0 * std::numbers::pi * i / n));
    }
    const CubicSpline spline(x, y, SplineEnds::periodic);
    double worst = 0.0;
    for (int k = 0; k < 1000; ++k) {
      const double at = k / 1000.0 + 3.0;  // three periods on
      worst =
          std::max(worst, std::abs(spline.at(at).value - std::sin(2.0 * std::numbers::pi * at)));
    }
    return worst;
  };
  // Source of the order: de Boor (1978), chapter V.
  const double order = std::log2(error_with(20) / error_with(40));
  CHECK(order > 3.8);
  CHECK(order < 4.2);
}

TEST_CASE("the shortest periodic spline has two intervals") {
  const CubicSpline spline({0.0, 0.5, 1.0}, {1.0, -1.0, 1.0}, SplineEnds::periodic);
  CHECK(spline.at(0.25).value == Approx(0.0).margin(1e-15));  // by symmetry
  CHECK(spline.at(0.5).first == Approx(0.0).margin(1e-14));
  CHECK(spline.at(1.5).value == Approx(-1.0));
}

}  // namespace cubic_spline_test
