// A part of a link in the exact form: against the continuous beam's transfer matrix in long double,
// and the cut forces that its inertia leaves along a vibrating beam.

#include "boxbeam/mechanism/flexible/link_stiffness.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "catch.hpp"
#include "support/continuous_beam.hpp"
#include "support/elastic_beams.hpp"

namespace exact_part_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Bar;
using test::End;

namespace {

/// A cantilever with a force of amplitude one across its end.
Mechanism shaken(const Bar& bar, int parts, double frequency, double retardation = 0.0) {
  Mechanism mechanism = test::cantilever_of(bar, parts, Element::exact);
  mechanism.links.front().retardation = retardation;
  mechanism.loads = {test::load_at(bar.L, Eigen::Vector3d::Zero(), {0.0, 1.0, 0.0})};
  mechanism.frequency = frequency;
  return mechanism;
}

/// (w, phi, V, M) of the cantilever at a distance from its root.
test::State state_of(const Bar& bar, double omega, double s) {
  const long double square = static_cast<long double>(omega) * static_cast<long double>(omega);
  const test::Transfer T = test::transfer_of(bar, square, static_cast<long double>(bar.L));
  // V and M at the root so that V = 1 and M = 0 at the end.
  const long double det = T(2, 2) * T(3, 3) - T(2, 3) * T(3, 2);
  const test::State root(0.0L, 0.0L, T(3, 3) / det, -T(3, 2) / det);
  return test::transfer_of(bar, square, static_cast<long double>(s)) * root;
}

}  // namespace

TEST_CASE("exact part: nodes and spring have the dynamic stiffness of the continuous beam",
          "[exact]") {
  const Bar bar = test::steel_bar(0.7, 0.3, 0.1);
  for (const double phase : {1e-8, 1e-3, 0.3, 1.0}) {
    // z mu h^4/EI (1 + EI/(GA h^2) + rho I/(mu h^2)) = phase, the longest part that is resolved.
    const double h = bar.L;
    const double square =
        phase / (h * h * (bar.mass * h * h / bar.EI + bar.mass / bar.GA + bar.rotary / bar.EI));
    const Mechanism mechanism = test::beam_of(bar, 1, End::free, End::free, Element::exact);
    const Structure structure = structure_of(mechanism);
    REQUIRE(pieces_at(structure, 0.999 * square) == 1);
    const LinkStiffness<double> link = link_stiffness_of<double>(structure, 0, square, 0.0);
    const auto part = link.part(0);
    // From d_1 = A d_0 + B p_0: K_01 = -B^-1.
    const test::Transfer T =
        test::transfer_of(bar, static_cast<long double>(square), static_cast<long double>(h));
    const long double det = T(0, 2) * T(1, 3) - T(0, 3) * T(1, 2);
    const double K_ww = -1.0 / part.f11;
    CAPTURE(phase);
    CHECK(K_ww == Approx(static_cast<double>(-T(1, 3) / det)).epsilon(1e-12));
    CHECK(K_ww * part.from_end == Approx(static_cast<double>(T(0, 3) / det)).epsilon(1e-12));
    CHECK(K_ww * part.from_start == Approx(static_cast<double>(T(1, 2) / det)).epsilon(1e-12));
    // K_00 = B^-1 A less the spring: what inertia leaves, small against both.
    const long double ww = (T(1, 3) * T(0, 0) - T(0, 3) * T(1, 0)) / det - T(1, 3) / det;
    CHECK(link.node(0).ww == Approx(static_cast<double>(ww)).epsilon(1e-12 + 1e-17 / phase));
    CHECK(link.node(1).ww == Approx(link.node(0).ww).epsilon(1e-12));
    CHECK(link.node(1).wp == Approx(-link.node(0).wp).epsilon(1e-12));
    CHECK(link.node(1).pp == Approx(link.node(0).pp).epsilon(1e-12));
  }
}

TEST_CASE("exact part: motion between the nodes is the continuous beam's", "[exact]") {
  const Bar bar = test::steel_bar(4.0, 0.3, 0.1);
  for (const double frequency : {3.0, 40.0, 400.0}) {
    const double omega = 2.0 * std::numbers::pi * frequency;
    const Mechanism mechanism = shaken(bar, 1, frequency);
    const Structure structure = structure_of(mechanism);
    const Deformation<Complex> response = harmonic_response(structure, frequency);
    const FieldAlong<Complex> field{Eigen::Vector2cd::Zero(), omega * omega};
    const auto end = static_cast<double>(state_of(bar, omega, bar.L)[0]);
    for (const double s : {0.1, 1.3, 2.0, 3.77, 4.0}) {
      const test::State expected = state_of(bar, omega, s);
      const Eigen::Vector3cd q = motion_at(structure, {0, {s, 0.0}}, response, field);
      CAPTURE(frequency, s);
      CHECK(q[1].real() == Approx(static_cast<double>(expected[0])).margin(1e-11 * std::abs(end)));
      CHECK(q[2].real() == Approx(static_cast<double>(expected[1])).margin(1e-11 * std::abs(end)));
    }
  }
}

TEST_CASE("exact part: cut forces along a vibrating beam", "[exact]") {
  const Bar bar = test::steel_bar(4.0, 0.3, 0.1);
  for (const double frequency : {3.0, 40.0, 400.0}) {
    const double omega = 2.0 * std::numbers::pi * frequency;
    const TaperedBeam beam = test::beam_of_length(bar.L);
    const Mechanism mechanism = shaken(bar, 16, frequency);
    const Structure structure = structure_of(mechanism);
    const Response response = response_of(structure);
    const BeamResponse loads =
        beam_response_of(structure, 0, beam, response, response.harmonic.motion);
    double largest = 0.0;
    for (int i = 0; i <= 160; ++i) {
      largest = std::max(largest,
                         static_cast<double>(std::abs(state_of(bar, omega, bar.L * i / 160.0)[3])));
    }
    const CutForceDiagram diagram = cut_forces_of(loads.sine);
    for (int i = 1; i < 160; ++i) {
      const double s = bar.L * i / 160.0;
      const test::State expected = state_of(bar, omega, s);
      const CutForces forces = diagram.at({si<Length>(s), Side::both});
      // Bending of the part behind against that before, counter-clockwise: M_y points into the
      // plane.
      const double M = -forces.M_y.value(), V = forces.V_z.value();
      CAPTURE(frequency, s);
      const double tolerance = i % 10 == 0 ? 1e-10 : 1e-6;  // at a node, and between
      CHECK(M == Approx(static_cast<double>(expected[3])).margin(tolerance * largest));
      CHECK(V ==
            Approx(static_cast<double>(expected[2])).margin(100.0 * tolerance * largest / bar.L));
    }
    const Imbalance left = imbalance_of(loads.sine);
    CHECK(left.force.norm() < 1e-10 * largest);
    CHECK(left.moment.norm() < 1e-10 * largest);
  }
}

TEST_CASE("exact part: damping turns the modulus into a complex one", "[exact]") {
  // Euler and Bernoulli with E (1 + i omega tau): x^4 = omega^2/(1 + i omega tau), mu = EI = L = 1.
  for (const double omega : {0.5, 3.6, 30.0}) {
    for (const double tau : {1e-4, 1e-2, 0.3}) {
      const Complex x = std::sqrt(std::sqrt(omega * omega / Complex(1.0, omega * tau)));
      const Complex expected =
          (std::sinh(x) + std::sin(x)) / (x * (1.0 + std::cosh(x) * std::cos(x)));
      const double frequency = omega / (2.0 * std::numbers::pi);
      const Mechanism mechanism = shaken({}, 1, frequency, tau);
      const Structure structure = structure_of(mechanism);
      const Complex moment = joint_force(structure, 0, harmonic_response(structure, frequency)).z();
      CAPTURE(omega, tau);
      CHECK(std::min(std::abs(moment - expected), std::abs(moment + expected)) <
            1e-11 * std::abs(expected));
    }
  }
}

}  // namespace exact_part_test
