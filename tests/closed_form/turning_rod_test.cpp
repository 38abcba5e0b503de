// Cut forces in a rod that turns in space, through the whole chain joints -> beam loads -> cut
// forces, against their closed forms. Uniform rod of length L and mass m, rho A = m/L.

#include <cmath>
#include <numbers>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "catch.hpp"

namespace turning_rod_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

constexpr double L = 4.5;
constexpr double rho = 7850.0;
// Outside and inside of the box.
constexpr double w = 0.1, h = 0.2, v = 0.08, g = 0.18;
constexpr double A = w * h - v * g;
constexpr double I_y = (w * h * h * h - v * g * g * g) / 12.0;
constexpr double I_z = (h * w * w * w - g * v * v * v) / 12.0;
constexpr double m = rho * A * L;

TaperedBeam uniform_rod(bool rotary_inertia) {
  const Section tube{symmetric_box(w * metre, h * metre, 0.01 * metre, 0.01 * metre), {}};
  TaperedBeam beam;
  beam.density = si<Density>(rho);
  beam.rotary_inertia = rotary_inertia;
  double start = 0.0;
  for (const double piece : {1.2, 1.05, 2.25}) {
    beam.segments.push_back({"", si<Length>(start), si<Length>(piece), tube, tube});
    start += piece;
  }
  return beam;
}

/// A rod on a revolute joint about z, at `pivot` of its axis; its axis leans by `angle` from z
/// towards x.
struct Rod {
  TaperedBeam beam;
  Mechanism mechanism;
  BeamBody body;

  Rod(double pivot, double angle, Driver driver, bool rotary_inertia = false)
      : beam(uniform_rod(rotary_inertia)) {
    BeamPlacement placement;
    placement.body = 0;
    // x of the beam along the axis, z of the beam in the plane of axis and shaft.
    placement.axes.col(0) = Vector3d(std::sin(angle), 0.0, std::cos(angle));
    placement.axes.col(2) = Vector3d(-std::cos(angle), 0.0, std::sin(angle));
    placement.axes.col(1) = Vector3d::UnitY();
    placement.start = -pivot * placement.axes.col(0);
    mechanism.bodies.resize(1);
    give_mass(mechanism.bodies[0], placement, beam);
    mechanism.joints.resize(1);
    mechanism.joints[0].kind = JointKind::revolute;
    mechanism.joints[0].driver = std::move(driver);
    body = beam_body_of(beam, placement, mechanism);
  }

  Wrench joint(double time) const {
    const Chain chain(mechanism);
    return chain.joint_wrenches(chain.at(time))[0];
  }

  CutForceDiagram diagram(double time) const {
    const Chain chain(mechanism);
    return cut_forces_of(beam_loads_of(chain, chain.at(time), body));
  }
};

constexpr double across = std::numbers::pi / 2.0;  // of the shaft

CutForces at(const CutForceDiagram& diagram, double s, Side side = Side::both) {
  return diagram.at({si<Length>(s), side});
}

}  // namespace

TEST_CASE("a rod that turns about its end at a constant rate: N = rho A w^2 (L^2 - s^2)/2") {
  const double rate = 11.0;
  const CutForceDiagram diagram = Rod(0.0, across, RateDriver{0.3, rate}).diagram(0.7);
  const double size = rho * A * rate * rate * L * L / 2.0;
  for (double s = 0.0; s < L; s += 0.15) {
    const CutForces cut = at(diagram, s);
    CHECK(cut.N.value() ==
          Approx(rho * A * rate * rate * (L * L - s * s) / 2.0).margin(1e-12 * size));
    for (const double other :
         {cut.V_y.value(), cut.V_z.value(), cut.T.value(), cut.M_y.value(), cut.M_z.value()}) {
      CHECK(std::abs(other) < 1e-12 * size);
    }
  }
}

TEST_CASE("a rod that starts to turn about its end bends: V_y and M_z by alpha") {
  // Inertia -rho A alpha x along y of the beam, on what lies behind the cut.
  const double alpha = 7.0;
  for (const bool rotary : {false, true}) {
    const CutForceDiagram diagram =
        Rod(0.0, across, PolynomialDriver{{0.2, 0.0, 0.5 * alpha}}, rotary).diagram(0.0);
    const double own = rotary ? rho * I_z * alpha : 0.0;  // couple per length about z
    const double size = rho * A * alpha * L * L * L / 3.0;
    for (double s = 0.0; s < L; s += 0.15) {
      const CutForces cut = at(diagram, s);
      const double V = -rho * A * alpha * (L * L - s * s) / 2.0;
      const double M =
          -rho * A * alpha * ((L * L * L - s * s * s) / 3.0 - s * (L * L - s * s) / 2.0);
      CHECK(cut.V_y.value() == Approx(V).margin(1e-12 * size));
      CHECK(cut.M_z.value() == Approx(M - own * (L - s)).margin(1e-12 * size));
      CHECK(std::abs(cut.N.value()) < 1e-12 * size);
      CHECK(std::abs(cut.M_y.value()) < 1e-12 * size);
      CHECK(std::abs(cut.T.value()) < 1e-12 * size);
    }
  }
}

TEST_CASE("a rod on its middle that leans against its shaft: m L^2/12 w^2 sin cos") {
  const double rate = 9.0;
  for (const double angle : {0.3, 0.8, 1.4, 2.2}) {
    const Rod rod(L / 2.0, angle, RateDriver{0.0, rate});
    // At t = 0 the rod lies in the plane x z of the world: its upper end is pulled outwards, so the
    // shaft turns it back, about -y.
    const double size = m * L * L / 12.0 * rate * rate;
    const double moment = size * std::sin(angle) * std::cos(angle);
    CHECK((rod.joint(0.0).moment + moment * Vector3d::UnitY()).norm() < 1e-12 * size);
    CHECK(rod.joint(0.0).force.norm() < 1e-12 * size);
    // Each half takes one half of it: in the middle, m L^2/24 w^2 sin cos, the ends bent outwards.
    // The load on the half behind lies along -z of the beam and puts +z in tension.
    const CutForceDiagram diagram = rod.diagram(0.0);
    CHECK(at(diagram, L / 2.0, Side::behind).M_y.value() ==
          Approx(moment / 2.0).margin(1e-12 * size));
    CHECK(at(diagram, L / 2.0, Side::before).M_y.value() ==
          Approx(-moment / 2.0).margin(1e-12 * size));
    // N at s, x = |s - L/2| from the middle: rho A w^2 sin^2 (L^2/4 - x^2)/2.
    for (const double s : {0.3, 1.0, 2.0, 3.3, 4.2}) {
      const double x = s - L / 2.0;
      CHECK(at(diagram, s).N.value() == Approx(rho * A * rate * rate * std::sin(angle) *
                                               std::sin(angle) * (L * L / 4.0 - x * x) / 2.0));
    }
  }
}

TEST_CASE("the same rod that starts to turn: m L^2/12 alpha sin^2 about the shaft") {
  const double alpha = 5.0;
  for (const double angle : {0.3, 0.8, 2.2}) {
    const Rod rod(L / 2.0, angle, PolynomialDriver{{0.0, 0.0, 0.5 * alpha}});
    const double size = m * L * L / 12.0 * alpha;
    // Angular momentum of a rod along e: m L^2/12 (omega - e (e . omega)).
    const Vector3d e(std::sin(angle), 0.0, std::cos(angle));
    const Vector3d moment = size * (Vector3d::UnitZ() - std::cos(angle) * e);
    CHECK(moment.z() == Approx(size * std::sin(angle) * std::sin(angle)));
    CHECK((rod.joint(0.0).moment - moment).norm() < 1e-12 * size);
  }
}

TEST_CASE("a conical pendulum of a rod: w^2 = 3 g/(2 L cos b) needs no moment at its hinge") {
  const double gravity = 9.81;
  for (const double b : {0.2, 0.7, 1.3}) {  // from the plumb line
    const double rate = std::sqrt(3.0 * gravity / (2.0 * L * std::cos(b)));
    Rod rod(0.0, std::numbers::pi - b, RateDriver{0.0, rate});
    rod.mechanism.gravity = {0.0, 0.0, -gravity};
    const Wrench joint = rod.joint(1.1);
    CHECK(joint.moment.norm() < 1e-12 * m * gravity * L);
    CHECK(joint.force.z() == Approx(m * gravity));
    // Its centre runs on a circle of radius L/2 sin b.
    const Vector3d plane(joint.force.x(), joint.force.y(), 0.0);
    CHECK(plane.norm() == Approx(m * rate * rate * L / 2.0 * std::sin(b)));
    // Bending all the same: along the rod from its end the load across is linear, zero in moment at
    // the hinge. q(x) = rho A (g sin b - w^2 x sin b cos b); M(s) = int_s^L q (x - s) dx.
    const CutForceDiagram diagram = rod.diagram(0.0);
    for (double s = 0.0; s < L; s += 0.25) {
      const double l = L - s;
      const double M =
          rho * A * std::sin(b) *
          (gravity * l * l / 2.0 - rate * rate * std::cos(b) * (s * l * l / 2.0 + l * l * l / 3.0));
      // The beam's z points away from the plumb line and up; weight lies along -z.
      CHECK(at(diagram, s, Side::behind).M_y.value() == Approx(M).margin(1e-11 * m * gravity * L));
    }
  }
}

TEST_CASE("a rod that spins up about its own axis: T = -rho (I_y + I_z) alpha (L - s)") {
  const double alpha = 600.0;
  const PolynomialDriver driver{{0.4, 30.0, 0.5 * alpha}};
  const double size = rho * (I_y + I_z) * alpha * L;
  const CutForceDiagram diagram = Rod(0.0, 0.0, driver, true).diagram(0.0);
  const CutForceDiagram line = Rod(0.0, 0.0, driver, false).diagram(0.0);
  for (double s = 0.0; s < L; s += 0.15) {
    CHECK(at(diagram, s).T.value() ==
          Approx(-rho * (I_y + I_z) * alpha * (L - s)).margin(1e-12 * size));
    CHECK(std::abs(at(line, s).T.value()) < 1e-12 * size);
    CHECK(std::abs(at(diagram, s).M_y.value()) < 1e-12 * size);
    CHECK(std::abs(at(diagram, s).M_z.value()) < 1e-12 * size);
  }
  CHECK(Rod(0.0, 0.0, driver, true).joint(0.0).moment.z() == Approx(size).epsilon(1e-12));
}

TEST_CASE("a rod that falls from its hinge is bent most at a third of its length") {
  // Let go level: q = m g/L (1 - 3/2 x/L) down, M = m g/(4 L^2) x (L - x)^2, at L/3 m g L/27, hinge
  // m g/4; upright below it turns with 3 g/L: N = 5/2 m g. Source: every textbook of dynamics (a
  // chimney that falls breaks there).
  constexpr double gravity = 9.81;
  Rod rod(0.0, across, PolynomialDriver{{0.0}});
  rod.mechanism.gravity = {0.0, 0.0, -gravity};
  Joint& hinge = rod.mechanism.joints[0];
  hinge.axis = Vector3d::UnitY();
  hinge.moved_by = MovedBy::forces;
  rod.mechanism.duration.length = 2.0;
  const CutForceDiagram level = rod.diagram(0.0);
  CHECK(std::abs(at(level, 0.0, Side::behind).V_z.value()) == Approx(0.25 * m * gravity));
  for (const double s : {0.2 * L, L / 3.0, 0.7 * L}) {
    const double M = m * gravity / (4.0 * L * L) * s * (L - s) * (L - s);
    CHECK(std::abs(at(level, s).M_y.value()) == Approx(M).epsilon(1e-9));
  }
  CHECK(std::abs(at(level, L / 3.0).M_y.value()) == Approx(m * gravity * L / 27.0));
  // Of the uniform rod on its hinge a quarter of a swing from rest at 90 degrees:
  // K(sin 45 deg) sqrt(2 L/(3 g)).
  const double quarter = std::comp_ellint_1(std::sqrt(0.5)) * std::sqrt(2.0 * L / (3.0 * gravity));
  const CutForceDiagram upright = rod.diagram(quarter);
  CHECK(at(upright, 0.0, Side::behind).N.value() == Approx(2.5 * m * gravity).epsilon(1e-7));
  CHECK(std::abs(at(upright, 0.5 * L).M_y.value()) < 1e-6 * m * gravity * L);
}

}  // namespace turning_rod_test
