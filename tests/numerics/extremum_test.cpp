#include "boxbeam/numerics/extremum.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace extremum_test {

using namespace boxbeam;

// What the search promises: the place to 2^-22 of the bracket, the value of a smooth function to
// 1e-13 of its variation.
constexpr double place = 1.0 / (1 << 22);

TEST_CASE("the maximum of a sine is one, at a quarter turn") {
  const Extremum top = find_maximum([](double x) { return std::sin(x); }, 1.0, 2.0);
  CHECK(top.at == Approx(0.5 * std::numbers::pi).margin(place));
  CHECK(top.value == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("the maximum of a parabola is its vertex wherever it lies in the bracket") {
  for (int i = 1; i < 100; ++i) {
    const double vertex = 0.01 * i;
    const Extremum top =
        find_maximum([&](double x) { return 3.0 - (x - vertex) * (x - vertex); }, 0.0, 1.0);
    CAPTURE(vertex);
    CHECK(top.at == Approx(vertex).margin(place));
    CHECK(top.value == Approx(3.0).margin(1e-13));
  }
}

TEST_CASE("a bracket far from zero loses no accuracy") {
  // The same parabola, shifted by a million: the error is that of the bracket, not of the place.
  const double far = 1e6;
  const Extremum top =
      find_maximum([&](double x) { return -(x - far - 0.37) * (x - far - 0.37); }, far, far + 1.0);
  CHECK(top.at - far == Approx(0.37).margin(place));
  CHECK(top.value == Approx(0.0).margin(1e-13));
}

TEST_CASE("place and value scale with the bracket and the function") {
  const auto f = [](double x) { return x * std::exp(-x); };  // largest at 1, value 1/e
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const Extremum top =
        find_maximum([&](double x) { return 200.0 * f(x / scale); }, 0.3 * scale, 2.5 * scale);
    CAPTURE(scale);
    CHECK(top.at == Approx(scale).margin(2.2 * place * scale));
    CHECK(top.value == Approx(200.0 / std::numbers::e).epsilon(1e-12));
  }
}

TEST_CASE("the value found is the function's at the place found") {
  const auto f = [](double x) { return std::cos(3.0 * x) + 0.2 * x; };
  const Extremum top = find_maximum(f, -0.8, 0.9);
  CHECK(top.value == Approx(f(top.at)).epsilon(1e-15));
  // Nothing near it is higher.
  for (const double step : {-0.1, -1e-3, 1e-3, 0.1}) CHECK(f(top.at + step) < top.value);
}

TEST_CASE("where the function only rises, the upper end is approached") {
  const Extremum top = find_maximum([](double x) { return x; }, 2.0, 5.0);
  CHECK(top.at == Approx(5.0).margin(3.0 * place));
  CHECK(top.at <= 5.0);
}

}  // namespace extremum_test
