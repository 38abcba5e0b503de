// A beam that hits a stop between two instants of its motion, against the closed form of its peak.

#include <cmath>
#include <string>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/unsaid.hpp"
#include "catch.hpp"

namespace impact_peaks_test {

using namespace boxbeam;

namespace {

/// An arm of 1 m on a hinge, without gravity, whose end meets a stop square to it.
std::string swinging_arm(const std::string& stop) {
  return "[case]\nname = \"arm\"\nkind = \"planar\"\n"
         "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
         "[bodies.arm]\npoints = { A = [\"0 m\", \"0 m\"], B = [\"1 m\", \"0 m\"] }\n"
         "sketch = { at = [\"0 m\", \"0 m\"], angle = \"0.1 rad\", angular_velocity = \"-2 "
         "rad/s\", "
         "velocity = [\"0 m/s\", \"0 m/s\"] }\n"
         "[joints.pivot]\nkind = \"pin\"\nconnect = [\"arm.A\", \"ground\"]\nat = [\"0 m\", \"0 "
         "m\"]\n"
         "[forces.stop]\nkind = \"spring\"\nconnect = [\"ground\", \"arm.B\"]\n"
         "at = [\"1 m\", \"-0.3 m\"]\nfree_length = \"0.3 m\"\nacts = \"pushing\"\n" +
         stop +
         "[motion]\nduration = \"0.1 s\"\n"
         "[sections.tube]\nkind = \"round tube\"\ndiameter = \"100 mm\"\nwall = \"5 mm\"\n"
         "[beam]\nbody = \"arm\"\ndensity = \"7850 kg/m^3\"\n"
         "[[beam.segments]]\nlength = \"1 m\"\nsection = \"tube\"\n"
         "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
         "[fatigue]\ncategory = 100\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
         "required = 1.0\n";
}

}  // namespace

TEST_CASE("the peak of an impact between two instants is found") {
  constexpr double k = 1e8, omega = 2.0, length = 1.0;
  const Project project =
      parse_project("arm.toml", swinging_arm("stiffness = \"100 kN/mm\"\nrestitution = 1.0\n"));
  const MassProperties of = mass_properties_of(project.beam);
  const double about_hinge = of.inertia.value() + of.mass.value() * std::pow(of.centre.value(), 2);
  const std::deque<SituationRun> runs = run_situations(project);
  const planar::Motion& motion = planar_motion_of(runs.front());
  REQUIRE(motion.changes.size() == 2);
  // Of the mass J/L^2 at the arm's end: F = v sqrt(k m), pi sqrt(m/k) long.
  const double mass = about_hinge / (length * length);
  const double peak = omega * length * std::sqrt(k * mass);
  const double duration = motion.changes[1] - motion.changes[0];
  CHECK(duration == Approx(std::acos(-1.0) * std::sqrt(mass / k)).epsilon(1e-3));
  const double step = motion.period / static_cast<double>(motion.states.size());
  CHECK(step > 0.5 * duration);
  // Just inside the end the shear force is the stop's.
  const StationHistory end(runs.front().loads, {si<Length>(length), Side::before});
  const TurningPoint most =
      end.largest([](const CutForces& cut) { return std::abs(cut.V_z.value()); });
  CHECK(most.value == Approx(peak).epsilon(2e-3));
  // The hinge bears the rest of what brakes the arm: the moment half-way, of an even beam with the
  // line load 3 F s/L^2 of its inertia against F at its end, F L (1/2 - 5/16).
  const StationHistory middle(runs.front().loads, {si<Length>(0.5 * length), Side::before});
  const TurningPoint bent =
      middle.largest([](const CutForces& cut) { return std::abs(cut.M_y.value()); });
  CHECK(bent.value == Approx(peak * length * (0.5 - 5.0 / 16.0)).epsilon(2e-3));
}

TEST_CASE("the verdict line says what rigid bodies do not know of an impact") {
  const Project parts =
      parse_project("arm.toml", swinging_arm("stiffness = \"100 kN/mm\"\nrestitution = 0.8\n"));
  const std::vector<NotJudged> said = impacts_not_judged(parts);
  REQUIRE(said.size() == 1);
  CHECK(said[0].what == "impacts in stop");
  CHECK(said[0].reason.find("the pressure where they touch") != std::string::npos);
  const Project damped = parse_project(
      "arm.toml", swinging_arm("stiffness = \"100 kN/mm\"\ndamping = \"1 kN s/m\"\n"));
  CHECK(impacts_not_judged(damped).empty());
}

}  // namespace impact_peaks_test
