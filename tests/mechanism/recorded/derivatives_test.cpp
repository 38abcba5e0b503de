// Derivatives of series of instants, and how many instants their waves have.

#include "boxbeam/mechanism/recorded/derivatives.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace derivatives_test {

using namespace boxbeam;
using recorded::derivatives_of;
using recorded::shortest_wave_of;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// sin(t), so many instants to a wave.
std::pair<std::vector<double>, std::vector<double>> sine(int per_wave, int waves) {
  std::vector<double> times, values;
  for (int i = 0; i <= per_wave * waves; ++i) {
    times.push_back(turn * i / per_wave);
    values.push_back(std::sin(times.back()));
  }
  return {times, values};
}

}  // namespace

TEST_CASE("derivatives of a polynomial of the fourth degree are exact but at the ends",
          "[recorded]") {
  std::vector<double> times, values;
  for (const double t : {0.0, 0.3, 0.5, 0.8, 1.2, 1.5, 1.9}) {
    times.push_back(t);
    values.push_back(1.0 - 2.0 * t + 3.0 * t * t - t * t * t + 0.5 * t * t * t * t);
  }
  const auto [first, second] = derivatives_of(times, values);
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    const double t = times[i];
    CHECK(first[i] == Approx(-2.0 + 6.0 * t - 3.0 * t * t + 2.0 * t * t * t));
    CHECK(second[i] == Approx(6.0 - 6.0 * t + 6.0 * t * t));
  }
}

TEST_CASE("derivatives of a wave of twelve instants", "[recorded]") {
  // By hand, h = pi/6: the five weights (-1, 16, -30, 16, -1)/(12 h^2) give of -sin(t)
  // (30 - 32 cos(h) + 2 cos(2 h))/(12 h^2) = 0.99917, (1, -8, 0, 8, -1)/(12 h) of cos(t)
  // (8 sin(h) - sin(2 h))/(6 h) = 0.99762; three would give (sin(h/2)/(h/2))^2 = 0.97737.
  const auto [times, values] = sine(12, 3);
  const auto [first, second] = derivatives_of(times, values);
  const double h = turn / 12.0;
  CHECK(second[15] ==
        Approx(-(30.0 - 32.0 * std::cos(h) + 2.0 * std::cos(2.0 * h)) / (12.0 * h * h)));
  CHECK(first[12] == Approx((8.0 * std::sin(h) - std::sin(2.0 * h)) / (6.0 * h)));
  CHECK(second[15] == Approx(-1.0).epsilon(1e-3));
}

TEST_CASE("where steps differ much the parabola through three instants holds", "[recorded]") {
  // By hand, through (0.1, 1), (0.2, 0), (5, 0): slopes -10 and 0, 2 (0 + 10)/4.9.
  const auto [first, second] = derivatives_of({0.0, 0.1, 0.2, 5.0, 5.1}, {0.0, 1.0, 0.0, 0.0, 1.0});
  CHECK(second[2] == Approx(20.0 / 4.9));
  CHECK(derivatives_of({0.0, 2.0}, {1.0, 5.0}).first == std::vector<double>{2.0, 2.0});
}

TEST_CASE("the instants of the shortest larger wave", "[recorded]") {
  for (const int per_wave : {6, 12, 40}) {
    const auto [times, values] = sine(per_wave, 4);
    CHECK(shortest_wave_of(times, values).instants == static_cast<std::size_t>(per_wave));
  }
  // Ripples of a tenth of the whole are none, and a line has none.
  auto [times, values] = sine(40, 4);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += i % 2 == 0 ? 0.1 : -0.1;
  CHECK(shortest_wave_of(times, values).instants >= 36);
  CHECK(shortest_wave_of({0.0, 1.0, 2.0}, {0.0, 1.0, 2.0}).instants == 0);
  CHECK(shortest_wave_of({0.0, 1.0, 2.0}, {1.0, 1.0, 1.0}).instants == 0);
}

}  // namespace derivatives_test
