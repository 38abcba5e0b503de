// Driven gears and wheels that roll against hand formulas: positions, velocities, accelerations,
// and forces by virtual work. Every solved instant is also checked body by body by Newton and
// Euler. Source: Willis (epicyclic trains).

#include <cmath>
#include <string>
#include <utility>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/closed_forms.hpp"

namespace gears_closed_form_test {

using namespace boxbeam;
using namespace boxbeam::planar;
using namespace test::closed_forms;

TEST_CASE("gear pair: external teeth turn the other way") {
  // omega_b = -r_a/r_b omega_a; tooth force = load/r_b, driver = load r_a/r_b.
  const double r_a = 0.08, r_b = 0.2, load = 50.0, J = 0.6;
  const HarmonicDriver driver{0.3, 1.2, 8.0, 0.0, {}};
  Mechanism mechanism;
  mechanism.bodies = {Body{"pinion", 1.0, 0.01, {}, {{0.0, 0.0}, 0.3}},
                      Body{"wheel", 5.0, J, {}, {{r_a + r_b, 0.0}, 0.0}}};
  mechanism.joints = {{"a", Pin{{0}, {ground, {0.0, 0.0}}}},
                      {"b", Pin{{1}, {ground, {r_a + r_b, 0.0}}}},
                      {"mesh", Gear{{0}, {1}, r_a, r_b, r_a * 0.3}},
                      {"motor", Driven{{0}, Coordinate::angle, driver}}};
  mechanism.forces = {{"load", Couple{{1}, {ground}, HarmonicDriver{load, 0.0, 0.0, 0.0, {}}}}};
  const Motion motion = solve_motion(mechanism, 60);
  Errors errors;
  double force_error = 0.0;
  for (const State& state : motion.states) {
    const DriverState a = driver_at(driver, state.time);
    const double ratio = -r_a / r_b;
    errors.add_angle(state, 1, {ratio * (a.value - 0.3), ratio * a.rate, ratio * a.acceleration});
    // Across the line of centres, from the pinion's teeth on the wheel's.
    const double tooth = (J * ratio * a.acceleration - load) / r_b;
    const Reaction mesh = reaction_on(mechanism, state, "mesh", 1);
    const Reaction motor = reaction_on(mechanism, state, "motor", 0);
    force_error = std::max(force_error, std::abs(std::abs(mesh.force.y()) - std::abs(tooth)));
    force_error = std::max(force_error, std::abs(mesh.force.x()));
    force_error = std::max(force_error, std::abs(mesh.moment - tooth * r_b));
    force_error =
        std::max(force_error, std::abs(motor.moment - (0.01 * a.acceleration - tooth * r_a)));
  }
  CHECK(errors.q < 1e-14);
  CHECK(errors.v < 1e-13);
  CHECK(errors.a < 1e-11);
  CHECK(force_error < 1e-10);
  CHECK(worst_imbalance(mechanism, motion) < 1e-13);
}

TEST_CASE("angle coupling: a gearbox of any ratio") {
  const double ratio = -2.5, load = 12.0;
  const HarmonicDriver driver{0.0, 1.2, 8.0, 0.0, {}};
  Mechanism mechanism;
  mechanism.bodies = {Body{"in", 1.0, 0.01, {}, {{0.0, 0.0}, 0.0}},
                      Body{"out", 1.0, 0.0, {}, {{1.0, 0.0}, 0.4}}};
  mechanism.joints = {{"a", Pin{{0}, {ground, {0.0, 0.0}}}},
                      {"b", Pin{{1}, {ground, {1.0, 0.0}}}},
                      {"box", AngleCoupling{{1}, {0}, ratio, 0.4}},
                      {"motor", Driven{{0}, Coordinate::angle, driver}}};
  mechanism.forces = {{"load", Couple{{1}, {ground}, HarmonicDriver{load, 0.0, 0.0, 0.0, {}}}}};
  const Motion motion = solve_motion(mechanism, 60);
  Errors errors;
  for (const State& state : motion.states) {
    const DriverState a = driver_at(driver, state.time);
    errors.add(state, 5, {ratio * a.value + 0.4, ratio * a.rate, ratio * a.acceleration});
    const Reaction motor = reaction_on(mechanism, state, "motor", 0);
    CHECK(motor.moment == Approx(0.01 * a.acceleration - ratio * load).epsilon(1e-12));
  }
  CHECK(errors.q < 1e-14);
  CHECK(errors.v < 1e-13);
  CHECK(errors.a < 1e-11);
  CHECK(worst_imbalance(mechanism, motion) < 1e-13);
}

TEST_CASE("planetary gear with a fixed annulus") {
  // Willis: omega_carrier = omega_sun r_s/(r_s + r_annulus), and the planet turns against the
  // carrier by -r_s/r_p of the sun's turn against it. Sun 0, carrier 1, planet 2.
  const double r_s = 0.06, r_p = 0.03, r_annulus = r_s + 2.0 * r_p;
  const double omega = 10.0, load = 80.0;
  Mechanism mechanism;
  mechanism.bodies = {Body{"sun", 1.0, 0.001, {}, {{0.0, 0.0}, 0.0}},
                      Body{"carrier", 1.0, 0.002, {}, {{0.0, 0.0}, 0.0}},
                      Body{"planet", 0.5, 0.0002, {}, {{r_s + r_p, 0.0}, 0.0}}};
  mechanism.joints = {
      {"sun", Pin{{0}, {ground, {0.0, 0.0}}}},
      {"carrier", Pin{{1}, {ground, {0.0, 0.0}}}},
      {"planet", Pin{{2}, {1, {r_s + r_p, 0.0}}}},
      {"inner", Gear{{0}, {2}, r_s, r_p, 0.0}},
      // The direction from the planet to the centre is pi at the start.
      {"outer", Gear{{2}, {ground, {0.0, 0.0}}, r_p, -r_annulus, pi * (r_annulus - r_p)}},
      {"motor", Driven{{0}, Coordinate::angle, RateDriver{0.0, omega}}}};
  mechanism.forces = {{"load", Couple{{1}, {ground}, HarmonicDriver{-load, 0.0, 0.0, 0.0, {}}}}};
  mechanism.duration.length = 3.0 * 2.0 * pi / omega;  // three turns of the sun: one of the carrier
  const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
  CHECK(freedom.by_rank == 1);
  CHECK(freedom.redundant == 0);
  const Motion motion = solve_motion(mechanism, 200);
  const double carrier_ratio = r_s / (r_s + r_annulus);
  const double planet_ratio = carrier_ratio - r_s / r_p * (1.0 - carrier_ratio);
  Errors errors;
  double moment_error = 0.0;
  for (const State& state : motion.states) {
    const double turn = omega * state.time;
    errors.add(state, 5, {carrier_ratio * turn, carrier_ratio * omega, 0.0});
    errors.add(state, 8, {planet_ratio * turn, planet_ratio * omega, 0.0});
    const double carrier = carrier_ratio * turn;
    errors.add(
        state, 6,
        {(r_s + r_p) * std::cos(carrier), -(r_s + r_p) * std::sin(carrier) * carrier_ratio * omega,
         -(r_s + r_p) * std::cos(carrier) * std::pow(carrier_ratio * omega, 2)});
    // At constant rate: the driver gives what the load takes.
    const Reaction motor = reaction_on(mechanism, state, "motor", 0);
    moment_error = std::max(moment_error, std::abs(motor.moment - load * carrier_ratio));
  }
  CHECK(errors.q < 1e-12);
  CHECK(errors.v < 1e-12);
  CHECK(errors.a < 1e-10);
  CHECK(moment_error < 1e-11);
  CHECK(worst_imbalance(mechanism, motion) < 1e-12);
}

TEST_CASE("rack and pinion, and a wheel that rolls on a fixed rack") {
  const double r = 0.12, load = 500.0, m = 8.0, J = 0.05;
  const HarmonicDriver driver{0.0, 2.0, 3.0, 0.5, {}};
  const double start = driver_at(driver, 0.0).value;
  SECTION("the rack slides: e . (p_pinion - p_rack) + r phi = 0, so x_rack = r phi") {
    Mechanism mechanism;
    mechanism.bodies = {Body{"pinion", 1.0, J, {}, {{0.0, 0.0}, start}},
                        Body{"rack", m, 0.0, {}, {{r * start, -r}, 0.0}}};
    mechanism.joints = {{"axle", Pin{{0}, {ground, {0.0, 0.0}}}},
                        {"guide", Slider{{1}, {ground, {0.0, -r}}}},
                        {"mesh", Rack{{0}, {1}, 0.0, r, 0.0}},
                        {"motor", Driven{{0}, Coordinate::angle, driver}}};
    mechanism.forces = {
        {"load", PointForce{{1}, 0.0, false, HarmonicDriver{-load, 0.0, 0.0, 0.0, {}}}}};
    const Motion motion = solve_motion(mechanism, 60);
    Errors errors;
    double force_error = 0.0;
    for (const State& state : motion.states) {
      const DriverState phi = driver_at(driver, state.time);
      errors.add(state, 3, {r * phi.value, r * phi.rate, r * phi.acceleration});
      const double tooth = load + m * r * phi.acceleration;
      const Reaction mesh = reaction_on(mechanism, state, "mesh", 1);
      const Reaction motor = reaction_on(mechanism, state, "motor", 0);
      force_error = std::max(force_error, (mesh.force - Eigen::Vector2d(tooth, 0.0)).norm());
      force_error =
          std::max(force_error, std::abs(motor.moment - (J * phi.acceleration + tooth * r)));
    }
    CHECK(errors.q < 1e-14);
    CHECK(errors.v < 1e-13);
    CHECK(errors.a < 1e-12);
    CHECK(force_error < 1e-10);
    CHECK(worst_imbalance(mechanism, motion) < 1e-13);
  }
  SECTION("the wheel rolls: x = -r phi") {
    Mechanism mechanism;
    mechanism.gravity = {0.0, -g};
    mechanism.bodies = {Body{"wheel", m, J, {}, {{-r * start, r}, start}}};
    mechanism.joints = {{"height", PinInSlot{{0}, {ground, {0.0, r}}}},
                        {"mesh", Rack{{0}, {ground, {0.0, 0.0}}, 0.0, r, 0.0}},
                        {"motor", Driven{{0}, Coordinate::x, driver}}};
    mechanism.bodies[0].sketch = {{start, r}, -start / r};
    const Motion motion = solve_motion(mechanism, 60);
    Errors errors;
    double force_error = 0.0;
    for (const State& state : motion.states) {
      const DriverState x = driver_at(driver, state.time);
      errors.add(state, 2, {-x.value / r, -x.rate / r, -x.acceleration / r});
      // The pull on the axle moves the mass and, over the contact, the inertia.
      const Reaction motor = reaction_on(mechanism, state, "motor", 0);
      const Reaction mesh = reaction_on(mechanism, state, "mesh", 0);
      const Reaction height = reaction_on(mechanism, state, "height", 0);
      force_error =
          std::max({force_error, std::abs(motor.force.x() - (m + J / (r * r)) * x.acceleration),
                    std::abs(mesh.force.x() + J / (r * r) * x.acceleration),
                    std::abs(height.force.y() - m * g)});
    }
    CHECK(errors.q < 1e-13);
    CHECK(errors.v < 1e-12);
    CHECK(errors.a < 1e-11);
    CHECK(force_error < 1e-10);
    CHECK(worst_imbalance(mechanism, motion) < 1e-13);
  }
}

}  // namespace gears_closed_form_test
