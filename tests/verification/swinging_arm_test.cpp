// Vibration of an arm that swings under forces and gives way at its heel, against a double pendulum
// of rigid bodies.

#include <algorithm>
#include <cmath>
#include <string>

#include "catch.hpp"
#include "support/space_arm.hpp"

namespace swinging_arm_test {

using namespace boxbeam;
using namespace test::space_arm;

namespace {

/// A stiff arm that swings under its weight and a shaken tip with a hub at its heel, to which it is
/// held by a joint that gives way, or by a hinge with a torsion spring.
struct Pendulum {
  double hub = 200.0;        ///< about the hinge [kg m^2]
  double stiffness = 1.5e5;  ///< [N m/rad]
  double duration = 3.0;     ///< [s]

  Moved moved(double at_hub, double between, bool hinged) const {
    const std::string joint =
        hinged
            ? fmt::format(
                  "kind = \"revolute\"\naxis = \"y\"\nmoved_by = \"forces\"\nstart = "
                  "\"{:.17g} rad\"\n",
                  between)
            : fmt::format("kind = \"fixed\"\nturning_stiffness = \"{:.15g} N m/rad\"\n", stiffness);
    const std::string spring =
        hinged ? fmt::format(
                     "[forces.spring]\nkind = \"torsion spring\"\njoint = "
                     "\"root\"\nstiffness = \"{:.15g} N m/rad\"\nfree_angle = \"0 rad\"\n",
                     stiffness)
               : "";
    return Moved(arm(fmt::format(R"(
[bodies.hub]
mass = "10 kg"
inertia = ["{0:.15g} kg m^2", "{0:.15g} kg m^2", "{0:.15g} kg m^2"]
points = {{ o = ["0 m", "0 m", "0 m"] }}
[joints.hinge]
kind = "revolute"
connect = ["ground", "hub.o"]
at = ["0 m", "0 m", "0 m"]
axis = "y"
moved_by = "forces"
start = "{1:.17g} rad"
[joints.root]
connect = ["hub.o", "arm.heel"]
{2}{3}[forces.shaking]
kind = "force"
point = "arm.tip"
direction = "z"
axes = "arm"
law = {{ kind = "harmonic", mean = "0 N", amplitude = "300 N", frequency = "4 Hz", phase = "90 deg" }}
[motion]
duration = "{4:.15g} s"
)",
                                 hub, at_hub, joint, spring, duration),
                     "density = \"7850 kg/m^3\"\n",
                     "[model]\nyoungs_modulus = \"900000 GPa\"\nshear_modulus = "
                     "\"350000 GPa\"\n",
                     9.81));
  }
};

double heel_moment(const BeamLoads& loads) { return cuts_of(loads, 0.0)[4]; }

}  // namespace

// The same as two rigid bodies, of any turns: they begin where the joint that gives way bears the
// moment of the rigid motion, and hub and arm together have not turned. What is left out is of the
// order of the square of the turning over the circular frequency of hub and arm.
TEST_CASE("an arm that swings and gives way at its heel is a double pendulum",
          "[elastic_by_forces]") {
  for (const double stiffness : {1e5, 4e5}) {
    Pendulum pendulum;
    pendulum.stiffness = stiffness;
    constexpr double begin = -1.0;
    const Moved moved = pendulum.moved(begin, 0.0, false);
    const ElasticMotionInSpace elastic = moved.by(3, 8);
    const double arm = 7850.0 * properties_of(moved.project.beam.segments[0].from).area.value() *
                       std::pow(4.0, 3) / 3.0;
    const double given = heel_moment(moved.rigid().loads_at(si<Time>(0.0))) / stiffness;
    const double turned = -given * arm / (pendulum.hub + arm);
    const Moved both = pendulum.moved(begin + turned, given, true);
    double largest = 0.0, apart = 0.0, rigidly = 0.0, turning = 0.0;
    for (int i = 0; i <= 600; ++i) {
      const double t = pendulum.duration * i / 600.0;
      const spatial::State state = both.chain().at(t);
      const double expected = stiffness * state.coordinates[1].value;
      const double found = heel_moment(elastic.loads_at(si<Time>(t)));
      largest = std::max(largest, std::abs(expected));
      apart = std::max(apart, std::abs(found - expected));
      rigidly =
          std::max(rigidly, std::abs(heel_moment(moved.rigid().loads_at(si<Time>(t))) - expected));
      turning = std::max(turning, moved.chain().at(t).bodies[0].omega.norm());
    }
    const double square = stiffness * (1.0 / pendulum.hub + 1.0 / arm);
    const double left_out = turning * turning / square;
    INFO("stiffness " << stiffness << ", largest " << largest << ", apart " << apart
                      << ", of rigid bodies " << rigidly << ", left out " << left_out);
    CHECK(apart < (1e-3 + left_out) * largest);
    CHECK(rigidly > 0.1 * largest);
  }
}

}  // namespace swinging_arm_test
