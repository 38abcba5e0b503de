// Arms that swing fast with a mass on their end, by the model that is chosen against beams of large
// deflection, which know nothing of modes nor of axes that turn. Their end mass turns as they do.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"
#include "support/corotational_mechanism.hpp"
#include "support/program.hpp"

namespace turning_arm_test {

using namespace boxbeam;

namespace {

/// `joined`: the joint between arm and mass.
Project arm_with_mass(double mass, const std::string& joined) {
  return parse_project("arm.toml", fmt::format(R"(
[case]
name = "arm"
kind = "planar"
[mechanism]
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[bodies.arm]
points = {{ C = ["0 m", "0 m"], D = ["3 m", "0 m"] }}
sketch = {{ at = ["1.5 m", "0 m"], angle = "0 deg" }}
[bodies.mass]
mass = "{} kg"
inertia = "1 kg m^2"
points = {{ D = ["-0.15 m", "0 m"] }}
sketch = {{ at = ["3.15 m", "0 m"], angle = "0 deg" }}
[joints.C]
kind = "pin"
connect = ["arm.C", "ground"]
at = ["0 m", "0 m"]
{}
[drivers.shaft]
kind = "constant rate"
point = "arm.C"
coordinate = "angle"
start = "0 deg"
rate = "1 rpm"
[sections.box]
kind = "box"
width = "80 mm"
height = "100 mm"
flange = "5 mm"
web = "5 mm"
[beam]
body = "arm"
density = "7850 kg/m^3"
[[beam.segments]]
length = "3 m"
from = "box"
to = "box"
[material]
steel = "S355"
[strength]
required = 1.0
[model]
damping = "0.002 s"
)",
                                               mass, joined));
}

/// The shaft swings by `amplitude` at a part of the arm's first frequency, and the elements of the
/// reference do not shear.
void swing(Project& project, double amplitude, double part, double first_frequency) {
  planar::Mechanism& mechanism = planar_of(project);
  for (planar::Joint& joint : mechanism.joints)
    if (planar::is_driver(joint))
      std::get<planar::Driven>(joint.kind).driver =
          HarmonicDriver{0.3, amplitude, part * full_turn * first_frequency, 0.0, {}};
  mechanism.duration = {};
  project.model.shear_modulus = 1e15;
}

}  // namespace

TEST_CASE("a mass that turns with a swinging arm vibrates with it as far as modes say",
          "[elastic_scenes][unsanitized]") {
  const std::string rigid = "[joints.D]\nkind = \"rigid\"\nconnect = [\"arm.D\", \"mass.D\"]\n";
  for (const auto& [mass, amplitude, part] :
       {std::tuple(40.0, 1.0, 0.15), std::tuple(40.0, 1.4, 0.15), std::tuple(150.0, 1.0, 0.2)}) {
    Project project = arm_with_mass(mass, rigid);
    swing(project, 0.1, 0.1, 1.0);
    const double first = run_by_chosen_model(project).model.frequencies.front();
    swing(project, amplitude, part, first);
    const auto [choice, runs] = run_by_chosen_model(project);
    INFO(choice.reason);
    CHECK(choice.chosen.level == ModelLevel::modal);
    const double tolerance = choice.tolerance;
    // What the arm would not hold if the terms of turning were not right for the mass as well.
    const double turning = std::pow(amplitude * part, 2);
    CHECK(turning > 2.0 * tolerance);
    const double found =
        stress_history(runs.front().loads, compared_places_of(project.beam)).cwiseAbs().maxCoeff();
    test::CorotationalOptions options;
    options.steps = 600;
    const test::CorotationalStress beam = test::corotational_stress(project, options);
    CHECK(beam.settled);
    INFO("found " << found * 1e-6 << " MPa, expected " << beam.governing * 1e-6);
    CHECK(found == Approx(beam.governing).epsilon(tolerance));
  }
}

}  // namespace turning_arm_test
