// Statically indeterminate and tapered beams at rest against the closed forms of beam theory
// without shear. Sources: Roark's Formulas for Stress and Strain, tables 8.1 and 8.10; Timoshenko,
// Strength of Materials I, chapters 5 to 7. M_y > 0 puts the upper side in tension, q and P act
// downwards.

#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "catch.hpp"
#include "support/rest_frame.hpp"

namespace beam_at_rest_test {

using namespace boxbeam;
using namespace boxbeam::frame;
using test::AtRest;

namespace {

constexpr double L = 3.0, b = 0.08, h = 0.12;
constexpr double q = 4e3, P = 9e3;
constexpr double EI = 2.1e11 * b * h * h * h / 12.0;

Approx exactly(double value) { return Approx(value).epsilon(1e-10).margin(0.0); }

Structure prismatic(double length) {
  return test::level_frame({test::segment(0.0, length, test::solid(b, h), test::solid(b, h))});
}

/// Fixed at s = 0, propped at s = L.
Structure propped(const std::array<double, 6>& prop = test::roller) {
  Structure of = prismatic(L);
  test::support(of, 0.0, test::fixed);
  test::support(of, L, prop);
  return of;
}

TEST_CASE("propped cantilever under a uniform load: 3 q L/8, q L^2/8, q L^4/(184.6 E I)",
          "[frame]") {
  Structure of = propped();
  test::act(of, test::uniform(0.0, L, -q));
  const AtRest at(of);
  CHECK(at.reaction(1) == exactly(3.0 * q * L / 8.0));
  CHECK(at.moment(0.0) == exactly(q * L * L / 8.0));
  CHECK(at.reaction(0) + at.reaction(1) == exactly(q * L));
  // w = q x^2 (L - x)(3 L - 2 x)/(48 E I), x from the fixed end; largest at x = L (15 - sqrt
  // 33)/16.
  const double x = L * (15.0 - std::sqrt(33.0)) / 16.0;
  CHECK(L - x == Approx(0.4215 * L).epsilon(1e-4));
  const double largest = q * x * x * (L - x) * (3.0 * L - 2.0 * x) / (48.0 * EI);
  CHECK(largest == Approx(q * std::pow(L, 4) / (184.635 * EI)).epsilon(1e-5));
  CHECK(-at.rise(x) == exactly(largest));
}

TEST_CASE("propped cantilever under a force: 5 P/16, 3 P L/16, 7 P L^3/(768 E I)", "[frame]") {
  Structure of = propped();
  test::act(of, test::push(0.5 * L, -P));
  const AtRest at(of);
  CHECK(at.reaction(1) == exactly(5.0 * P / 16.0));
  CHECK(at.moment(0.0) == exactly(3.0 * P * L / 16.0));
  CHECK(-at.rise(0.5 * L) == exactly(7.0 * P * L * L * L / (768.0 * EI)));
  const auto lowest =
      boost::math::tools::brent_find_minima([&](double s) { return at.rise(s); }, 0.0, L, 40);
  CHECK(-lowest.second == exactly(P * L * L * L / (48.0 * std::sqrt(5.0) * EI)));
}

TEST_CASE("propped cantilever under a force anywhere: P a^2 (3 L - a)/(2 L^3)", "[frame]") {
  for (const double a : {0.1 * L, 0.37 * L, 0.9 * L}) {
    Structure of = propped();
    test::act(of, test::push(a, -P));
    const AtRest at(of);
    CHECK(at.reaction(1) == exactly(P * a * a * (3.0 * L - a) / (2.0 * L * L * L)));
    const double c = L - a;
    CHECK(at.moment(0.0) == exactly(P * c * (L * L - c * c) / (2.0 * L * L)));
  }
}

TEST_CASE("a prop that is a spring: (3 q L/8)/(1 + 3 E I/(k L^3))", "[frame]") {
  for (const double k : {1e3, 1e6, 1e9}) {
    Structure of = propped({0.0, k, 0.0, 0.0, 0.0, 0.0});
    test::act(of, test::uniform(0.0, L, -q));
    const AtRest at(of);
    CHECK(at.reaction(1) == exactly(3.0 * q * L / 8.0 / (1.0 + 3.0 * EI / (k * L * L * L))));
    CHECK(-at.rise(L) == exactly(at.reaction(1) / k));
  }
}

TEST_CASE("a prop that sinks: 3 E I d/L^3", "[frame]") {
  constexpr double sinks = 0.004;
  Structure of = propped();
  test::act(of, Settlement{1, {0.0, -sinks, 0.0}, Eigen::Vector3d::Zero()});
  const AtRest at(of);
  CHECK(-at.reaction(1) == exactly(3.0 * EI * sinks / (L * L * L)));
  CHECK(at.moment(0.0) == exactly(3.0 * EI * sinks / (L * L)));
  CHECK(-at.rise(L) == exactly(sinks));
}

TEST_CASE("a propped cantilever warmer above: M = 1.5 E I kappa, R = M/L", "[frame]") {
  Structure of = propped();
  constexpr double rise = 30.0;  // from the lower to the upper side
  test::act(of, HeatAction{0, 0.0, 0.0, rise / h});
  const AtRest at(of);
  // Free, the beam would bend away from the warm upper side; the prop pushes it back.
  const double kappa = of.members[0].expansion * rise / h;
  CHECK(std::abs(at.moment(0.0)) == exactly(1.5 * EI * kappa));
  CHECK(std::abs(at.reaction(1)) == exactly(1.5 * EI * kappa / L));
  CHECK(at.reaction(1) > 0.0);
}

TEST_CASE("a cantilever warmer above curls down without stress", "[frame]") {
  Structure of = prismatic(L);
  test::support(of, 0.0, test::fixed);
  test::act(of, HeatAction{0, 20.0, 0.0, 250.0});
  const AtRest at(of);
  const double alpha = of.members[0].expansion;
  CHECK(at.rise(L) == exactly(-0.5 * alpha * 250.0 * L * L));
  CHECK(at.statics.motion_at(0, L, at.equilibrium).x() == exactly(alpha * 20.0 * L));
  CHECK(at.moment(0.3 * L) == 0.0);
}

TEST_CASE("held at both ends a warm beam pushes with E A alpha dT", "[frame]") {
  Structure of = prismatic(L);
  test::support(of, 0.0, test::fixed);
  test::support(of, L, test::fixed);
  test::act(of, HeatAction{0, 20.0, 0.0, 0.0});
  const AtRest at(of);
  CHECK(at.equilibrium.members[0].cut.at({si<Length>(1.0)}).N.value() ==
        exactly(-2.1e11 * b * h * of.members[0].expansion * 20.0));
}

TEST_CASE("two spans under a uniform load: 3, 10, 3 q L/8 and q L^2/8", "[frame]") {
  Structure of = prismatic(2.0 * L);
  test::support(of, 0.0, test::pinned);
  test::support(of, L, test::roller);
  test::support(of, 2.0 * L, test::roller);
  SECTION("loaded") {
    test::act(of, test::uniform(0.0, 2.0 * L, -q));
    const AtRest at(of);
    CHECK(at.reaction(0) == exactly(3.0 * q * L / 8.0));
    CHECK(at.reaction(1) == exactly(10.0 * q * L / 8.0));
    CHECK(at.reaction(2) == exactly(3.0 * q * L / 8.0));
    CHECK(at.moment(L) == exactly(q * L * L / 8.0));
  }
  SECTION("the middle sinks: M = 3 E I d/L^2, R = 6 E I d/L^3") {
    test::act(of, Settlement{1, {0.0, -0.003, 0.0}, Eigen::Vector3d::Zero()});
    const AtRest at(of);
    CHECK(-at.moment(L) == exactly(3.0 * EI * 0.003 / (L * L)));
    CHECK(-at.reaction(1) == exactly(6.0 * EI * 0.003 / (L * L * L)));
  }
}

TEST_CASE("three spans under a uniform load: 0.4, 1.1 q L", "[frame]") {
  Structure of = prismatic(3.0 * L);
  test::support(of, 0.0, test::pinned);
  for (int k = 1; k <= 3; ++k) test::support(of, k * L, test::roller);
  test::act(of, test::uniform(0.0, 3.0 * L, -q));
  const AtRest at(of);
  CHECK(at.reaction(0) == exactly(0.4 * q * L));
  CHECK(at.reaction(1) == exactly(1.1 * q * L));
  CHECK(at.reaction(2) == exactly(1.1 * q * L));
  CHECK(at.moment(L) == exactly(0.1 * q * L * L));
}

TEST_CASE("fixed at both ends: q L^2/12 and q L^4/(384 E I)", "[frame]") {
  Structure of = prismatic(L);
  test::support(of, 0.0, test::fixed);
  test::support(of, L, test::fixed);
  test::act(of, test::uniform(0.0, L, -q));
  const AtRest at(of);
  CHECK(at.moment(0.0) == exactly(q * L * L / 12.0));
  CHECK(at.moment(0.5 * L) == exactly(-q * L * L / 24.0));
  CHECK(-at.rise(0.5 * L) == exactly(q * std::pow(L, 4) / (384.0 * EI)));
}

TEST_CASE("a triangular load on a cantilever: q L^2/6 and q L^4/(30 E I)", "[frame]") {
  Structure of = prismatic(L);
  test::support(of, 0.0, test::fixed);
  test::act(of, LineAction{0, 0.0, L, {0.0, -q, 0.0}, Eigen::Vector3d::Zero()});
  const AtRest at(of);
  CHECK(at.moment(0.0) == exactly(q * L * L / 6.0));
  CHECK(-at.rise(L) == exactly(q * std::pow(L, 4) / (30.0 * EI)));
}

/// P L^3/(E I_tip) c_n: the deflection of a cantilever of I = I_tip (1 + a s)^n, s from its tip as
/// a part of the length. Source: integration of P s^2/(E I), by hand.
struct Tapered {
  const char* what;
  Section root, tip;
  double I_tip, c;
};

TEST_CASE("tapered cantilevers bend as the integral says", "[frame]") {
  constexpr double a = 0.8, A = 1.0 + a;
  const double ln = std::log(A);
  const auto solid = [](double width, double height) { return test::solid(width, height); };
  const std::vector<Tapered> all{
      {"n = 1", solid(A * b, h), solid(b, h), b * h * h * h / 12.0,
       (a * a / 2.0 - a + ln) / (a * a * a)},
      {"n = 3", solid(b, A * h), solid(b, h), b * h * h * h / 12.0,
       (ln + 2.0 / A - 1.0 / (2.0 * A * A) - 1.5) / (a * a * a)},
      {"n = 4", solid(A * b, A * h), solid(b, h), b * h * h * h / 12.0, 1.0 / (3.0 * A * A * A)},
  };
  for (const Tapered& of : all) {
    INFO(of.what);
    Structure beam = test::level_frame({test::segment(0.0, L, of.root, of.tip)});
    test::support(beam, 0.0, test::fixed);
    test::act(beam, test::push(L, -P));
    CHECK(-AtRest(beam).rise(L) == exactly(P * L * L * L / (2.1e11 * of.I_tip) * of.c));
  }
  CHECK(all[0].c == Approx(0.2105208).epsilon(1e-6));
  CHECK(all[1].c == Approx(0.0870640).epsilon(1e-6));
  CHECK(all[2].c == Approx(0.0571559).epsilon(1e-6));
}

TEST_CASE("shear adds P L/(k G A) to a cantilever", "[frame]") {
  Structure of = prismatic(L);
  of.members[0].shear_modulus = 8.1e10;
  test::support(of, 0.0, test::fixed);
  test::act(of, test::push(L, -P));
  CHECK(-AtRest(of).rise(L) ==
        exactly(P * L * L * L / (3.0 * EI) + P * L / (8.1e10 * 5.0 / 6.0 * b * h)));
}

TEST_CASE("a stepped cantilever: P/3E [(L^3 - L_1^3)/I_root + L_1^3/I_tip]", "[frame]") {
  constexpr double L_1 = 1.1;
  Structure of = test::level_frame(
      {test::segment(0.0, L - L_1, test::solid(b, 2.0 * h), test::solid(b, 2.0 * h)),
       test::segment(L - L_1, L_1, test::solid(b, h), test::solid(b, h))});
  test::support(of, 0.0, test::fixed);
  test::act(of, test::push(L, -P));
  const double near_tip = L_1 * L_1 * L_1;
  CHECK(-AtRest(of).rise(L) ==
        exactly(P / 3.0 * ((L * L * L - near_tip) / (8.0 * EI) + near_tip / EI)));
}

TEST_CASE("what nothing holds is named", "[frame]") {
  Structure of = prismatic(L);
  test::support(of, 0.0, test::roller);
  test::support(of, L, test::roller);
  CHECK_THROWS_WITH(Statics(of), Catch::Matchers::Contains("member \"beam\" can shift along x"));
  Structure turning = prismatic(L);
  test::support(turning, 0.4, test::pinned);
  CHECK_THROWS_WITH(Statics(turning), Catch::Matchers::Contains("free to move"));
}

}  // namespace

}  // namespace beam_at_rest_test
