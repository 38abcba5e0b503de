// Stiffness and mass of a beam as an elastic link. Expected numbers: hand formulas of the box.

#include "boxbeam/project/link_profile.hpp"

#include <cmath>

#include "catch.hpp"

namespace link_profile_test {

using namespace boxbeam;

namespace {

constexpr double E = 2.1e11, G = 8.1e10, density = 7850.0;

Length mm(double value) { return si<Length>(value * 1e-3); }

/// A box of the drill truck's boom, 300 x 220 x 10 mm (height x width x plate), and one that tapers
/// from it to 200 mm height.
TaperedBeam boxes() {
  const Section tall{symmetric_box(mm(220), mm(300), mm(10), mm(10)), {}};
  const Section low{symmetric_box(mm(220), mm(200), mm(10), mm(10)), {}};
  TaperedBeam beam;
  beam.segments = {{"S1", si<Length>(0.0), si<Length>(1.5), tall, tall},
                   {"S2", si<Length>(1.5), si<Length>(2.0), tall, low}};
  beam.density = si<Density>(density);
  return beam;
}

double area_of(double height) { return 2.0 * 0.22 * 0.01 + 2.0 * 0.01 * (height - 0.02); }

double second_moment_of(double height) {
  return (0.22 * std::pow(height, 3) - 0.20 * std::pow(height - 0.02, 3)) / 12.0;
}

}  // namespace

TEST_CASE("a beam gives the stiffness and mass of a link, whole boxes and tapers", "[flexible]") {
  TaperedBeam beam = boxes();
  const auto stretches = link_stretches_of(beam, E, G);
  REQUIRE(stretches.size() == 2);
  CHECK(stretches[0].start == 0.0);
  CHECK(stretches[0].length == 1.5);
  CHECK(stretches[1].start == 1.5);
  CHECK(stretches[1].length == 2.0);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const double x : {0.0, 0.37, 1.3}) {
      const double height = i == 0 ? 0.3 : 0.3 - 0.05 * x;
      const flexible::LinkStretch& stretch = stretches[i];
      CHECK(stretch.EA(x) == Approx(E * area_of(height)).epsilon(1e-12));
      CHECK(stretch.GA(x) == Approx(G * 2.0 * 0.01 * height).epsilon(1e-12));  // two webs, 2 t h
      CHECK(stretch.EI(x) == Approx(E * second_moment_of(height)).epsilon(1e-12));
      CHECK(stretch.mass(x) == Approx(density * area_of(height)).epsilon(1e-12));
      CHECK(stretch.rotary(x) == 0.0);
    }
  }
  beam.rotary_inertia = true;
  const auto turning = link_stretches_of(beam, E, G);
  CHECK(turning[1].rotary(1.0) == Approx(density * second_moment_of(0.25)).epsilon(1e-12));
}

TEST_CASE("a link of a turned profile bends freely sideways", "[flexible]") {
  // A plate on edge, b = 10 mm, h = 200 mm, turned by 30 deg: with principal moments I_1 and I_2,
  // I_y - I_yz^2/I_z = I_1 I_2/I_z.
  const double c = std::sqrt(0.75), s = 0.5;
  Polygon turned;
  for (const auto& [y, z] : {std::pair{-5.0, -100.0}, {5.0, -100.0}, {5.0, 100.0}, {-5.0, 100.0}}) {
    turned.outer.push_back({mm(c * y - s * z), mm(s * y + c * z)});
  }
  TaperedBeam beam = boxes();
  beam.segments.resize(1);
  beam.segments[0].from = beam.segments[0].to = Section{turned, {}};
  const double I_1 = 0.01 * 0.008 / 12.0, I_2 = 0.2 * 1e-6 / 12.0;
  const double I_z = c * c * I_2 + s * s * I_1;
  const auto stretches = link_stretches_of(beam, E, G);
  CHECK(stretches[0].EI(0.4) == Approx(E * I_1 * I_2 / I_z).epsilon(1e-9));
}

}  // namespace link_profile_test
