// Equivalent mass: a mass on a slider is itself, a lever multiplies by the ratio squared.

#include "boxbeam/mechanism/planar/equivalent_mass.hpp"

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace equivalent_mass_test {

using namespace boxbeam;
using namespace boxbeam::planar;

TEST_CASE("a mass driven along a line feels like itself") {
  Mechanism mechanism;
  mechanism.bodies = {Body{"block", 7.0, 0.0, {}, {}}, Body{"hand", 0.0, 0.0, {}, {}}};
  mechanism.joints = {{"line", Slider{{0}, {}, 0.0, 0.0}},
                      {"grip", Pin{{0}, {1}}},
                      {"hand angle", AngleCoupling{{1}, {0}, 1.0, 0.0}},
                      {"motor", Driven{{1}, Coordinate::x, HarmonicDriver{0.0, 0.1, 6.0, 0.0}}}};
  InstantSolver solver(mechanism);
  const Motion motion = solve_motion(mechanism, 16);
  const EquivalentMass mass = equivalent_mass_of(mechanism, motion, 1, 0, 0, 10.0);
  CHECK(mass.given == Approx(7.0).epsilon(1e-12));
  CHECK(mass.per_mass == Approx(1.0).epsilon(1e-12));
  CHECK(mass.needed == Approx(10.0).epsilon(1e-12));
}

TEST_CASE("the mass that is asked for is reached, and the lever ratio squared is its slope") {
  const Project& project = test::rig();
  const EquivalentMassDemand& demand = project.equivalent_mass.value();
  const Motion motion = solve_motion(planar_of(project), 96);
  const EquivalentMass mass = equivalent_mass_of(planar_of(project), motion, demand.joint,
                                                 demand.on, demand.adjust, 20000.0);
  // Small swings of the lever: d(m_eq)/d(m_sledge) = (3.2 m / 3.0 m)^2 but for second order.
  CHECK(mass.per_mass == Approx(3.2 * 3.2 / 9.0).epsilon(1e-4));

  Mechanism adjusted = planar_of(project);
  adjusted.bodies[static_cast<std::size_t>(demand.adjust)].mass = mass.needed;
  const EquivalentMass reached = equivalent_mass_of(
      adjusted, solve_motion(adjusted, 96), demand.joint, demand.on, demand.adjust, 20000.0);
  CHECK(reached.given == Approx(20000.0).epsilon(1e-10));
}

TEST_CASE("a body without influence cannot be adjusted") {
  const Project& project = test::rig();
  const Motion motion = solve_motion(planar_of(project), 16);
  const int joint = joint_index(planar_of(project), "C");
  const int lower_rod = body_index(planar_of(project), "lower_rod");
  const int blade = body_index(planar_of(project), "blade");
  CHECK_THROWS_AS(equivalent_mass_of(planar_of(project), motion, joint, lower_rod, blade, 1.0),
                  AnalysisError);
}

}  // namespace equivalent_mass_test
