// The axial force of a link in its stiffness, against Euler's columns, tapered and heavy ones.

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"
#include "catch.hpp"

namespace axial_force_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A column along x on the ground, as good as rigid in shear and along its axis.
flexible::Mechanism column(const Polynomial<4>& EI, double length, int parts) {
  flexible::Mechanism mechanism;
  flexible::Link& link = mechanism.links.emplace_back();
  link.name = "column";
  link.length = length;
  link.parts = parts;
  flexible::LinkStretch& stretch = link.stretches.emplace_back();
  stretch.length = length;
  stretch.EI = EI;
  stretch.EA.c[0] = stretch.GA.c[0] = 1e9 * EI.c[0];
  stretch.mass.c[0] = 1.0;
  return mechanism;
}

void hold(flexible::Mechanism& mechanism, double s, const std::array<double, 3>& stiffness) {
  flexible::Joint& joint = mechanism.joints.emplace_back();
  joint.name = "support";
  joint.a = {0, {s, 0.0}};
  joint.b = {flexible::ground, {s, 0.0}};
  joint.stiffness = stiffness;
}

/// How often `compression` must count for the column to buckle.
double critical_factor(const flexible::Mechanism& mechanism,
                       const std::function<double(double)>& compression, double guess) {
  const auto buckles = [&](double factor) {
    flexible::Structure structure = flexible::structure_of(mechanism);
    flexible::load_axially(structure.links[0],
                           [&](double s, Side) { return -factor * compression(s); });
    return flexible::DynamicStiffness<double>(structure, 0.0, 0.0).frequencies_below() > 0;
  };
  double low = 0.5 * guess;
  double high = 2.0 * guess;
  REQUIRE_FALSE(buckles(low));
  REQUIRE(buckles(high));
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (buckles(middle) ? high : low) = middle;
  }
  return low;
}

double even(double) { return 1.0; }

}  // namespace

// Timoshenko, Gere, Theory of Elastic Stability (1961), chapter 2.
TEST_CASE("columns buckle at Euler's loads", "[axial_force]") {
  struct Case {
    std::string name;
    std::vector<std::pair<double, std::array<double, 3>>> holds;
    double factor;  // N_cr L^2/EI
  };
  const std::vector<Case> cases{
      {"pinned", {{0.0, {infinite, infinite, 0.0}}, {1.0, {0.0, infinite, 0.0}}}, pi * pi},
      {"clamped and free", {{0.0, {infinite, infinite, infinite}}}, pi * pi / 4.0},
      // tan x = x
      {"clamped and pinned",
       {{0.0, {infinite, infinite, infinite}}, {1.0, {0.0, infinite, 0.0}}},
       20.190728556426629},
      {"clamped",
       {{0.0, {infinite, infinite, infinite}}, {1.0, {0.0, infinite, infinite}}},
       4.0 * pi * pi}};
  for (const Case& of : cases) {
    for (const int parts : {8, 16}) {
      flexible::Mechanism mechanism = column({{2.0}}, 3.0, parts);
      for (const auto& [part, stiffness] : of.holds) hold(mechanism, 3.0 * part, stiffness);
      const double exact = of.factor * 2.0 / 9.0;
      INFO(of.name << ", " << parts << " parts");
      CHECK(critical_factor(mechanism, even, exact) ==
            Approx(exact).epsilon(parts == 8 ? 8e-3 : 5e-4));  // of fourth order
    }
  }
}

// I ~ (1 + (r - 1) x/L)^2 has a closed solution: N_cr L^2/(E I_min) =
// (r - 1)^2 (pi^2/ln^2 r + 1/4). Source: Timoshenko, Gere (1961), section 2.14 (Dinnik).
TEST_CASE("a tapered column buckles at the load of its closed solution", "[axial_force]") {
  for (const double r : {1.5, 2.0, 3.0}) {
    const double k = r - 1.0;
    flexible::Mechanism mechanism = column({{1.0, 2.0 * k, k * k}}, 1.0, 16);
    hold(mechanism, 0.0, {infinite, infinite, 0.0});
    hold(mechanism, 1.0, {0.0, infinite, 0.0});
    const double exact = k * k * (std::pow(pi / std::log(r), 2) + 0.25);
    CHECK(critical_factor(mechanism, even, exact) == Approx(exact).epsilon(3e-3));
  }
}

// Greenhill (1881): q L^3/EI = 9/4 j^2, j = 1.8663509 the first zero of J_(-1/3).
TEST_CASE("a clamped mast buckles under its own weight at Greenhill's height", "[axial_force]") {
  flexible::Mechanism mechanism = column({{1.0}}, 1.0, 16);
  hold(mechanism, 0.0, {infinite, infinite, infinite});
  const double exact = 7.837347;
  CHECK(critical_factor(
            mechanism, [](double s) { return 1.0 - s; }, exact) == Approx(exact).epsilon(2e-3));
}

// omega^2 = omega_1^2 (1 + N/N_cr) for a pinned uniform beam. Source: Timoshenko, Young, Weaver,
// Vibration Problems in Engineering (1974), section 5.12.
TEST_CASE("tension raises and compression lowers the frequency of a pinned beam", "[axial_force]") {
  flexible::Mechanism mechanism = column({{1.0}}, 1.0, 32);
  hold(mechanism, 0.0, {infinite, infinite, 0.0});
  hold(mechanism, 1.0, {0.0, infinite, 0.0});
  const double first = pi / 2.0;  // (pi/L)^2 sqrt(EI/mu)/(2 pi)
  for (const double part : {-0.9, -0.5, 0.0, 1.0, 10.0}) {
    flexible::Structure structure = flexible::structure_of(mechanism);
    flexible::load_axially(structure.links[0], [&](double, Side) { return part * pi * pi; });
    CHECK(flexible::modes_of(structure, 1).front().frequency ==
          Approx(first * std::sqrt(1.0 + part)).epsilon(5e-4));
  }
}

}  // namespace axial_force_test
