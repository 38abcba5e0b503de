// The exact form of elastic links against the continuous beam in closed form: frequencies of all
// supports from their characteristic equations, rods, and Timoshenko's beam between pins.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "boxbeam/mechanism/flexible/modes.hpp"
#include "catch.hpp"
#include "support/elastic_beams.hpp"

namespace exact_links_test {

using namespace boxbeam::flexible;
using test::Bar;
using test::End;

namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

/// The first roots of an equation above zero, by bisection in long double.
std::vector<double> roots_of(const std::function<long double(long double)>& f, std::size_t count) {
  std::vector<double> roots;
  constexpr long double step = 0.01L;
  for (long double x = 0.5L; roots.size() < count; x += step) {
    long double low = x, high = x + step;
    if (f(low) * f(high) > 0.0L) continue;
    const bool rises = f(high) > 0.0L;
    for (int i = 0; i < 80; ++i) {
      const long double middle = 0.5L * (low + high);
      ((f(middle) > 0.0L) == rises ? high : low) = middle;
    }
    roots.push_back(static_cast<double>(0.5L * (low + high)));
  }
  return roots;
}

std::vector<double> omegas_of(const Mechanism& mechanism, std::size_t count) {
  const Structure structure = structure_of(mechanism);
  std::vector<double> omegas;
  for (const Mode& mode : modes_of(structure, count)) {
    omegas.push_back(2.0 * std::numbers::pi * mode.frequency);
  }
  return omegas;
}

}  // namespace

TEST_CASE("exact links: twenty frequencies of five supports to 1e-12", "[exact]") {
  const auto sech = [](long double x) { return 1.0L / std::cosh(x); };
  struct Support {
    const char* name;
    End start, end;
    std::function<long double(long double)> equation;
    std::size_t free = 0;  ///< motions without strain
  };
  const Support supports[] = {
      {"clamped, free", End::clamped, End::free,
       [&](long double x) { return std::cos(x) + sech(x); }},
      {"pinned, pinned", End::pinned, End::pinned, [](long double x) { return std::sin(x); }},
      {"clamped, clamped", End::clamped, End::clamped,
       [&](long double x) { return std::cos(x) - sech(x); }},
      {"clamped, pinned", End::clamped, End::pinned,
       [](long double x) { return std::sin(x) - std::cos(x) * std::tanh(x); }},
      {"free, free", End::free, End::free, [&](long double x) { return std::cos(x) - sech(x); }, 3},
  };
  constexpr std::size_t count = 20;
  for (const Support& of : supports) {
    const std::vector<double> roots = roots_of(of.equation, count);
    for (const int parts : {1, 3}) {
      CAPTURE(of.name, parts);
      const std::vector<double> omegas =
          omegas_of(test::beam_of({}, parts, of.start, of.end, Element::exact), count + of.free);
      REQUIRE(omegas.size() == count + of.free);
      for (std::size_t i = 0; i < of.free; ++i) CHECK(omegas[i] == 0.0);
      for (std::size_t i = 0; i < count; ++i) {
        CAPTURE(i, omegas[of.free + i] / (roots[i] * roots[i]) - 1.0);
        CHECK(std::abs(omegas[of.free + i] / (roots[i] * roots[i]) - 1.0) < 1e-12);
      }
    }
  }
}

TEST_CASE("exact links: a rod's frequencies are odd quarters of its waves", "[exact]") {
  const Bar bar{2.0, 3.0e8, 1e30, 1.0, 40.0, 0.0};
  const std::vector<double> omegas = omegas_of(
      test::beam_of(bar, 1, End::clamped, End::free, Element::exact, LinkKind::axial), 12);
  const double speed = std::sqrt(bar.EA / bar.mass);
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    const double k = 2.0 * static_cast<double>(i) + 1.0;
    CHECK(omegas[i] == Approx(0.5 * k * std::numbers::pi * speed / bar.L).epsilon(1e-12));
  }
}

TEST_CASE("exact links: Timoshenko's beam between pins, both spectra", "[exact]") {
  // Of a wave sin(n pi x/L): g j W^4 - (1 + (g + j) l^2) W^2 + l^4 = 0 with W^2 = omega^2 mu
  // L^4/EI, l = n pi, j = I/(A L^2), g = EI/(GA_s L^2). n = 0 turns all sections: W^2 = 1/(g j).
  const Bar bar = test::steel_bar(1.0, 0.2, 0.1);
  const long double j = bar.rotary / (bar.mass * bar.L * bar.L);
  const long double g = bar.EI / (bar.GA * bar.L * bar.L);
  std::vector<double> expected{static_cast<double>(std::sqrt(1.0L / (g * j)))};
  for (int n = 1; n <= 30; ++n) {
    const long double l = static_cast<long double>(n) * pi;
    const long double b = 1.0L + (g + j) * l * l;
    const long double root = std::sqrt(b * b - 4.0L * g * j * l * l * l * l);
    expected.push_back(static_cast<double>(std::sqrt(2.0L * l * l * l * l / (b + root))));
    expected.push_back(static_cast<double>(std::sqrt((b + root) / (2.0L * g * j))));
  }
  std::sort(expected.begin(), expected.end());
  constexpr std::size_t count = 20;
  const std::vector<double> omegas =
      omegas_of(test::beam_of(bar, 1, End::pinned, End::pinned, Element::exact), count);
  const double scale = std::sqrt(bar.EI / bar.mass) / (bar.L * bar.L);
  for (std::size_t i = 0; i < count; ++i) {
    CAPTURE(i);
    CHECK(omegas[i] == Approx(scale * expected[i]).epsilon(1e-12));
  }
}

}  // namespace exact_links_test
