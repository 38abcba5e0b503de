// What a model's loads leave unbalanced on the bent beam, against beams whose bending is known in
// closed form.

#include "boxbeam/verification/balance_defect.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "catch.hpp"

namespace balance_defect_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 2.1e11, as_good_as_rigid = 1e17;
constexpr double L = 12.0;
constexpr double w = 0.08, h = 0.1, plate = 0.005;
constexpr double A = w * h - (w - 2 * plate) * (h - 2 * plate);
const double I = (w * h * h * h - (w - 2 * plate) * std::pow(h - 2 * plate, 3)) / 12.0;

/// A slender box beam, the first body of a mechanism, along x from the origin; nothing holds it.
struct Scene {
  TaperedBeam beam;
  planar::Mechanism mechanism;
  planar::Motion motion;
  planar::BeamBody body;
  std::shared_ptr<planar::StateFinder> finder;

  explicit Scene(double density) {
    const Section box{symmetric_box(w * metre, h * metre, plate * metre, plate * metre), {}};
    beam.density = si<Density>(density);
    beam.segments = {{"", Length{}, si<Length>(L), box, box}};
    Body of;
    of.name = "beam";
    of.mass = mass_properties_of(beam).mass.value();
    of.inertia = mass_properties_of(beam).inertia.value();
    of.sketch.centre = {0.5 * L, 0.0};
    mechanism.bodies = {of};
    body = planar::beam_body_of(beam, 0);
  }

  void solve(int instants) {
    motion = planar::solve_motion(mechanism, instants);
    finder = std::make_shared<planar::StateFinder>(mechanism, motion);
  }
  RigidMotion rigid() const {
    return {&mechanism, &motion, &beam, [this](Time time) {
              return planar::beam_loads_of(mechanism, finder->at(time.value()), body);
            }};
  }
  ElasticBody elastic(double modulus) const {
    return {0, 0.5 * L, L, link_stretches_of(beam, modulus, as_good_as_rigid), 0.0, 16};
  }
  LoadHistory history() const {
    return {{si<Time>(motion.begin), si<Time>(motion.period), motion.states.size(), motion.closed},
            rigid().loads};
  }
};

// Fast enough for the mass to count beside what the slope makes of the shear force.
constexpr double force = 400.0, rate = 30.0, moved = 2500.0;

/// Without weight, pinned to the ground and to a mass that slides along x; a force in its middle
/// swings across it, F sin(Omega t).
Scene pushed_beam() {
  Scene of(1e-3);
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

CutForces middle_of(const BeamLoads& loads) {
  return cut_forces_of(loads).at({si<Length>(0.5 * L), Side::behind});
}

/// Its base shakes across its axis.
Scene shaken_beam(double frequency) {
  Scene of(7850.0);
  planar::Slider slider;
  slider.point = {0, {-0.5 * L, 0.0}};
  slider.direction = 0.5 * pi;
  planar::Driven drive;
  drive.point = slider.point;
  drive.coordinate = planar::Coordinate::y;
  drive.driver = HarmonicDriver{0.0, 1e-3, 2 * pi * frequency, 0.0};
  of.mechanism.joints = {{"base", slider}, {"drive", drive}};
  of.solve(48);
  return of;
}

}  // namespace

// A force P in the middle of a pinned beam: w = P L^3/(48 EI) there, and the beam is shorter by
// half the integral of w'^2, 2.4 w^2/L. With P = F sin(Omega t) the mass at its end swings with
// twice the frequency, and the beam bears N = 2 m Omega^2 u cos(2 Omega t), of both signs, which on
// its bent axis takes N w from the moment.
TEST_CASE("a pinned beam that bends moves what it is pinned to, and that loads it along its axis",
          "[balance_defect]") {
  const Scene of = pushed_beam();
  const BalanceDefect defect = balance_defect_of(of.rigid(), of.elastic(E), of.history());
  const double bent = force * L * L * L / (48.0 * E * I);
  const double shorter = 2.4 * bent * bent / L;
  const double N = 2.0 * moved * rate * rate * shorter;
  CHECK(defect.deflection == Approx(bent).epsilon(2e-3));
  // w' = P L^2/(16 EI) at both ends.
  CHECK(defect.turn == Approx(2.0 * force * L * L / (16.0 * E * I)).epsilon(2e-3));
  REQUIRE(defect.loads.size() == of.motion.states.size());
  for (std::size_t i = 0; i < defect.loads.size(); ++i) {
    const planar::State& state = of.motion.states[i];
    INFO("t = " << state.time);
    const CutForces cut = middle_of(defect.loads[i]);
    const double axial = N * std::cos(2.0 * rate * state.time);
    CHECK(cut.N.value() == Approx(axial).margin(5e-3 * N));
    const double M = middle_of(of.rigid().loads(si<Time>(state.time))).M_y.value();
    const double nearer = shorter * std::pow(std::sin(rate * state.time), 2);
    const double expected = -axial * M * L * L / (12.0 * E * I) - M * nearer / L;
    CHECK(cut.M_y.value() == Approx(expected).margin(5e-3 * N * bent));
  }
}

TEST_CASE("the loads of what is defective are in balance", "[balance_defect]") {
  const Scene of = pushed_beam();
  const BalanceDefect defect = balance_defect_of(of.rigid(), of.elastic(E), of.history());
  for (const BeamLoads& loads : defect.loads) {
    const Imbalance over = imbalance_of(loads);
    CHECK(over.force.norm() < 1e-9 * force);
    CHECK(over.moment.norm() < 1e-9 * force * L);
  }
}

TEST_CASE("a beam that does not bend leaves nothing unbalanced", "[balance_defect]") {
  for (const Scene& of : {pushed_beam(), shaken_beam(0.3)}) {
    const LoadHistory history = of.history();
    const BalanceDefect defect =
        balance_defect_of(of.rigid(), of.elastic(as_good_as_rigid), history);
    CHECK(defect.deflection < 1e-5 * L);
    for (const BeamLoads& loads : defect.loads) {
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
    const double f_1 = std::pow(first / L, 2) * std::sqrt(E * I / (7850.0 * A)) / (2 * pi);
    const Scene of = shaken_beam(r * f_1);
    const double beta = first * std::sqrt(r);
    const double magnified = 2.0 * std::sin(beta) * std::sinh(beta) /
                             (beta * beta * (1.0 + std::cos(beta) * std::cosh(beta)));
    const double added = magnified - 1.0;
    INFO("r = " << r);
    CHECK(error_by_balance(of.rigid(), of.elastic(E), 2, of.history()) ==
          Approx(added / (1.0 - added)).epsilon(0.03));
  }
}

TEST_CASE("friction, and bodies that move along the bent beam, are no matter of balance",
          "[balance_defect]") {
  Scene of = pushed_beam();
  CHECK(obstacle_to_balance(of.mechanism, 0).empty());
  auto& guide = std::get<planar::Slider>(of.mechanism.joints[2].kind);
  guide.friction.viscous = 10.0;
  CHECK(obstacle_to_balance(of.mechanism, 0) == "joint guide rubs");
  guide.friction = {};
  guide.guide.body = 0;
  CHECK_FALSE(obstacle_to_balance(of.mechanism, 0).empty());
}

}  // namespace balance_defect_test
