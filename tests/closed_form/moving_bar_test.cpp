// Cut forces in moving bars through the whole chain mechanism -> reactions -> beam loads -> cut
// forces, against their closed forms.

#include <cmath>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"

namespace moving_bar_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double length = 6.2;
constexpr double mass = 100.0;

/// A uniform bar of 6.2 m and 100 kg in three segments, so that pieces must meet.
TaperedBeam uniform_bar() {
  const Section tube{symmetric_box(0.1 * metre, 0.2 * metre, 0.01 * metre, 0.01 * metre), {}};
  const double area = properties_of(tube).area.value();
  TaperedBeam beam;
  beam.density = si<Density>(mass / (area * length));
  double start = 0.0;
  for (const double piece : {1.7, 2.0, 2.5}) {
    beam.segments.push_back({"", si<Length>(start), si<Length>(piece), tube, tube});
    start += piece;
  }
  return beam;
}

struct Bar {
  TaperedBeam beam = uniform_bar();
  Mechanism mechanism;
  BeamBody body;

  /// Pinned at its start; its angle follows `driver`, or it falls where the driver exerts nothing.
  explicit Bar(const HarmonicDriver& driver, double gravity) {
    body = beam_body_of(beam, 0);
    const MassProperties properties = mass_properties_of(beam);
    mechanism.gravity = {0.0, -gravity};
    mechanism.bodies = {Body{"bar", properties.mass.value(), properties.inertia.value(), {}, {}}};
    mechanism.bodies[0].sketch = {{body.centre, 0.0}, 0.0};
    mechanism.joints = {{"pin", Pin{{0, {-body.centre, 0.0}}, {ground, {0.0, 0.0}}}},
                        {"motor", Driven{{0, {-body.centre, 0.0}}, Coordinate::angle, driver}}};
  }

  State state(double time) {
    InstantSolver solver(mechanism);
    State result = solver.solve_from_sketch(time, sketch_of(mechanism));
    // The joint's moment acts at the pin: body points of a driven angle have no place of their own.
    return result;
  }

  CutForceDiagram diagram(double time) {
    return cut_forces_of(beam_loads_of(mechanism, state(time), body));
  }
};

}  // namespace

TEST_CASE("uniform rotating bar: N, V and M at the pinned end's distance x") {
  // Without gravity, omega and alpha about the end:
  // N = m omega^2 (L^2 - x^2)/(2 L), V = m alpha (L^2 - x^2)/(2 L) up to sign,
  // M = m alpha (2 L^3 - 3 L^2 x + x^3)/(6 L) up to sign (d'Alembert, by integration).
  const HarmonicDriver driver{0.4, 0.7, 3.0, 0.2};
  Bar bar(driver, 0.0);
  const double time = 0.63;
  const DriverState motion = driver_at(driver, time);
  const double omega = motion.rate;
  const double alpha = motion.acceleration;
  const CutForceDiagram diagram = bar.diagram(time);
  for (const double x : {0.001, 0.5, 1.7, 2.6, 3.7, 5.0, 6.199}) {
    const CutForces cut = diagram.at({si<Length>(x), Side::behind});
    const double quadratic = (length * length - x * x) / (2.0 * length);
    const double N = mass * omega * omega * quadratic;
    // The part behind x is accelerated along +z by alpha: the cut pushes it, V acts against z.
    const double V = -mass * alpha * quadratic;
    const double M = mass * alpha *
                     (2.0 * std::pow(length, 3) - 3.0 * length * length * x + std::pow(x, 3)) /
                     (6.0 * length);
    CHECK(cut.N.value() == Approx(N).epsilon(1e-11));
    CHECK(cut.V_z.value() == Approx(V).epsilon(1e-11));
    CHECK(cut.M_y.value() == Approx(M).epsilon(1e-11).margin(1e-9));
  }
}

TEST_CASE(
    "falling bar (chimney): the largest moment is m g L sin(theta)/27 at a third of the length") {
  // Pinned at its end and falling, alpha = 3 g sin(theta)/(2 L) with theta from the vertical; here
  // the driver prescribes just this acceleration at rest, so that it exerts no moment.
  // 100 kg, 6.2 m, 90 degrees, g = 9.81: 225.27 N m.
  const double g = 9.81;
  for (const double theta : {0.5, 1.0, 1.5707963267948966}) {
    const double alpha = 3.0 * g * std::sin(theta) / (2.0 * length);
    // angle from the x axis = pi/2 - theta; amplitude and phase so that the rate is 0 at t = 0.
    const double omega = 2.0;
    const double amplitude = alpha / (omega * omega);  // x'' = A omega^2 at sin = -1, angle falls
    const double angle = 1.5707963267948966 - theta;
    const HarmonicDriver driver{angle - amplitude, amplitude, omega, 1.5707963267948966};
    Bar bar(driver, g);
    const State state = bar.state(0.0);
    CHECK(state.a[2] == Approx(-alpha).epsilon(1e-12));
    const auto reactions = reactions_of(bar.mechanism, state);
    CHECK(std::abs(reactions.back().moment) < 1e-9);  // it falls freely

    const CutForceDiagram diagram = bar.diagram(0.0);
    double largest = 0.0;
    for (int i = 1; i < 620; ++i) {
      const double x = 0.01 * i;
      const double M = mass * g * std::sin(theta) / 4.0 * x * std::pow(1.0 - x / length, 2);
      const double computed = diagram.at({si<Length>(x)}).M_y.value();
      CHECK(std::abs(std::abs(computed) - M) < 1e-9 * mass * g * length);
      largest = std::max(largest, std::abs(computed));
    }
    CHECK(largest == Approx(mass * g * length * std::sin(theta) / 27.0).epsilon(1e-5));
  }
}

TEST_CASE("falling bar: 225.27 N m for 100 kg, 6.2 m, horizontal") {
  CHECK(100.0 * 9.81 * 6.2 / 27.0 == Approx(225.27).epsilon(1e-4));
}

TEST_CASE("rotary inertia of the sections enters as a distributed couple and keeps the balance") {
  const HarmonicDriver driver{0.4, 0.7, 3.0, 0.2};
  Bar bar(driver, 9.81);
  bar.beam.rotary_inertia = true;
  bar.body = beam_body_of(bar.beam, 0);
  bar.mechanism.bodies[0].inertia = mass_properties_of(bar.beam).inertia.value();
  const BeamLoads loads = beam_loads_of(bar.mechanism, bar.state(0.63), bar.body);
  const Imbalance open = imbalance_of(loads);
  CHECK(open.force.norm() < 1e-9);
  CHECK(open.moment.norm() < 1e-9);
  // The moment at the driven end grows by the integral of rho I alpha.
  Bar plain(driver, 9.81);
  const double alpha = driver_at(driver, 0.63).acceleration;
  const double I = properties_of(bar.beam.segments[0].from).I_y.value();
  const double more = bar.beam.density.value() * I * length * alpha;
  const double with = cut_forces_of(loads).at({Length{}, Side::behind}).M_y.value();
  const double without = plain.diagram(0.63).at({Length{}, Side::behind}).M_y.value();
  CHECK(with - without == Approx(more).epsilon(1e-9));
}

TEST_CASE("rotary inertia of a section without symmetry keeps the balance in the plane") {
  // Its I_yz turns the bar out of the plane, for which a plane mechanism has no reactions: forces
  // and moments about all three axes sum to nothing.
  Bar bar(HarmonicDriver{0.4, 0.7, 3.0, 0.2}, 9.81);
  bar.beam.rotary_inertia = true;
  for (Section* section : {&bar.beam.segments[0].from, &bar.beam.segments[0].to}) {
    Box box = symmetric_box(si<Length>(0.08), si<Length>(0.1), si<Length>(6e-3), si<Length>(6e-3));
    box.bottom_flange = si<Length>(5e-3);
    box.left_web = si<Length>(4e-3);
    *section = {box, {}};
  }
  const MassProperties mass = mass_properties_of(bar.beam);
  REQUIRE(std::abs(mass.tensor(1, 2)) > 1e-5);
  bar.body = beam_body_of(bar.beam, 0);
  bar.mechanism.bodies[0].mass = mass.mass.value();
  bar.mechanism.bodies[0].inertia = mass.inertia.value();
  const Imbalance open = imbalance_of(beam_loads_of(bar.mechanism, bar.state(0.63), bar.body));
  CHECK(open.force.norm() < 1e-9);
  CHECK(open.moment.norm() < 1e-9);
}

}  // namespace moving_bar_test
