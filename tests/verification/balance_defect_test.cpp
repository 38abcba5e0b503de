// What a model's loads leave unbalanced on the bent beam, against beams whose bending is known in
// closed form.

#include "boxbeam/verification/balance_defect.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "catch.hpp"
#include "support/slender_beam.hpp"

namespace balance_defect_test {

using namespace boxbeam;

namespace {

using namespace test::slender;

constexpr double pi = std::numbers::pi;
constexpr double as_good_as_rigid = 1e17;

// Fast enough for the mass to count beside what the slope makes of the shear force.
constexpr double force = 400.0, rate = 30.0, moved = 2500.0;

/// Without weight, pinned to the ground and to a mass that slides along x; a force in its middle
/// swings across it, F sin(Omega t).
Beam pushed_beam() {
  Beam of(1e-3);
  Body slide;
  slide.name = "slide";
  slide.mass = moved;
  slide.inertia = 1.0;
  slide.sketch.centre = {L, 0.0};
  of.mechanism.bodies.push_back(slide);
  const planar::Pin pivot{{0, {-0.5 * L, 0.0}}, {}};
  const planar::Pin wrist{{0, {0.5 * L, 0.0}}, {1, {0.0, 0.0}}};
  planar::Slider along;
  along.point = {1, {0.0, 0.0}};
  of.mechanism.joints = {{"pivot", pivot}, {"wrist", wrist}, {"guide", along}};
  planar::PointForce push;
  push.at = {0, {0.0, 0.0}};
  push.direction = -0.5 * pi;
  push.size = HarmonicDriver{0.0, force, rate, 0.0};
  of.mechanism.forces = {{"push", push}};
  of.solve(48);
  return of;
}

/// Without weight, nearly level between a pivot and an upright guide that is nearer to it than the
/// beam is long by `reach`; a force in its middle swings across it.
Beam propped_beam(double reach, double push) {
  Beam of(1e-3);
  const double along = L - reach;
  const double up = std::sqrt(L * L - along * along);
  of.mechanism.bodies[0].sketch = {{0.5 * along, 0.5 * up}, std::atan2(up, along)};
  Body slide;
  slide.name = "slide";
  slide.sketch.centre = {along, up};
  of.mechanism.bodies.push_back(slide);
  planar::Slider guide;
  guide.point = {1, {0.0, 0.0}};
  guide.guide.p = {along, 0.0};
  guide.direction = 0.5 * pi;
  of.mechanism.joints = {{"pivot", planar::Pin{{0, {-0.5 * L, 0.0}}, {}}},
                         {"wrist", planar::Pin{{0, {0.5 * L, 0.0}}, {1, {0.0, 0.0}}}},
                         {"guide", guide}};
  planar::PointForce pushing;
  pushing.at = {0, {0.0, 0.0}};
  pushing.direction = -0.5 * pi;
  pushing.size = HarmonicDriver{0.0, push, rate, 0.0};
  of.mechanism.forces = {{"push", pushing}};
  of.solve(48);
  return of;
}

CutForces middle_of(const BeamLoads& loads) {
  return cut_forces_of(loads).at({si<Length>(0.5 * L), Side::behind});
}

}  // namespace

// A force P in the middle of a pinned beam: w = P L^3/(48 EI) there, and the beam is shorter by
// half the integral of w'^2, 2.4 w^2/L. With P = F sin(Omega t) the mass at its end swings with
// twice the frequency, and the beam bears N = 2 m Omega^2 u cos(2 Omega t), of both signs, which on
// its bent axis takes N w from the moment.
TEST_CASE("a pinned beam that bends moves what it is pinned to, and that loads it along its axis",
          "[balance_defect]") {
  const Beam of = pushed_beam();
  const auto defect = balance_defect_of(of.rigid(), of.elastic(E, as_good_as_rigid), of.history());
  REQUIRE(defect);
  const double bent = force * L * L * L / (48.0 * E * I);
  const double shorter = 2.4 * bent * bent / L;
  const double N = 2.0 * moved * rate * rate * shorter;
  CHECK(defect->deflection == Approx(bent).epsilon(2e-3));
  // w' = P L^2/(16 EI) at both ends.
  CHECK(defect->turn == Approx(2.0 * force * L * L / (16.0 * E * I)).epsilon(2e-3));
  REQUIRE(defect->loads.size() == of.motion.states.size());
  for (std::size_t i = 0; i < defect->loads.size(); ++i) {
    const planar::State& state = of.motion.states[i];
    INFO("t = " << state.time);
    const CutForces cut = middle_of(defect->loads[i]);
    const double axial = N * std::cos(2.0 * rate * state.time);
    CHECK(cut.N.value() == Approx(axial).margin(5e-3 * N));
    const double M = middle_of(of.rigid().loads(si<Time>(state.time))).M_y.value();
    const double nearer = shorter * std::pow(std::sin(rate * state.time), 2);
    const double expected = -axial * M * L * L / (12.0 * E * I) - M * nearer / L;
    CHECK(cut.M_y.value() == Approx(expected).margin(5e-3 * N * bent));
  }
}

TEST_CASE("the loads of what is defective are in balance", "[balance_defect]") {
  const Beam of = pushed_beam();
  const auto defect = balance_defect_of(of.rigid(), of.elastic(E, as_good_as_rigid), of.history());
  REQUIRE(defect);
  for (const BeamLoads& loads : defect->loads) {
    const Imbalance over = imbalance_of(loads);
    CHECK(over.force.norm() < 1e-9 * force);
    CHECK(over.moment.norm() < 1e-9 * force * L);
  }
}

TEST_CASE("a beam that does not bend leaves nothing unbalanced", "[balance_defect]") {
  for (const Beam& of : {pushed_beam(), shaken(0.3 / first_frequency(), 48, 1e-3)}) {
    const LoadHistory history = of.history();
    const auto defect =
        balance_defect_of(of.rigid(), of.elastic(as_good_as_rigid, as_good_as_rigid), history);
    REQUIRE(defect);
    CHECK(defect->deflection < 1e-5 * L);
    for (const BeamLoads& loads : defect->loads) {
      CHECK(std::abs(middle_of(loads).M_y.value()) < 1e-5 * history.largest_moment());
    }
  }
}

// A cantilever of Euler and Bernoulli whose base shakes, w = a1 cos bx + a2 cosh bx + a3 (sin bx -
// sinh bx), against the rigid one, whose root moment is rho A omega^2 L^2/2: with beta = b L
//
//     M/M_rigid = 2 sin beta sinh beta/(beta^2 (1 + cos beta cosh beta))
//
// Bending is linear there, so that the first step from the rigid beam is the whole way. (For slow
// motion, beta to 0, it is one.)
TEST_CASE("what is unbalanced under the loads of a rigid beam is what its vibration adds",
          "[balance_defect]") {
  constexpr double first = 1.8751040687119612;
  for (const double r : {0.2, 0.4}) {
    const Beam of = shaken(r, 48, 1e-3);
    const double beta = first * std::sqrt(r);
    const double magnified = 2.0 * std::sin(beta) * std::sinh(beta) /
                             (beta * beta * (1.0 + std::cos(beta) * std::cosh(beta)));
    const double added = magnified - 1.0;
    INFO("r = " << r);
    CHECK(error_by_balance(of.rigid(), of.elastic(E, as_good_as_rigid), 2, of.history()) ==
          Approx(added / (1.0 - added)).epsilon(0.03));
  }
}

// The guide holds the end only along, N = F/(2 sin phi), sin phi = sqrt(2 reach/L), and the beam is
// shorter by N L/(EA): with 0.1 mm of reach 1.7 mm for 400 N and 0.0004 mm for 0.1 N.
TEST_CASE("of a beam that no longer reaches when it is strained nothing is known",
          "[balance_defect]") {
  const Beam of = propped_beam(1e-4, 400.0);
  CHECK_FALSE(balance_defect_of(of.rigid(), of.elastic(), of.history()));
  CHECK(error_by_balance(of.rigid(), of.elastic(), 0, of.history()) == unknown_balance);
  const Beam light = propped_beam(1e-4, 0.1);
  CHECK(balance_defect_of(light.rigid(), light.elastic(), light.history()));
  CHECK(error_by_balance(light.rigid(), light.elastic(), 0, light.history()) < 0.1);
}

TEST_CASE("friction, and bodies that move along the bent beam, are no matter of balance",
          "[balance_defect]") {
  Beam of = pushed_beam();
  CHECK(obstacle_to_balance(of.mechanism, 0).empty());
  auto& guide = std::get<planar::Slider>(of.mechanism.joints[2].kind);
  guide.friction.viscous = 10.0;
  CHECK(obstacle_to_balance(of.mechanism, 0) == "joint guide rubs");
  guide.friction = {};
  guide.guide.body = 0;
  CHECK_FALSE(obstacle_to_balance(of.mechanism, 0).empty());
}

}  // namespace balance_defect_test
