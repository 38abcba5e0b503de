// The buckling of mechanisms in space that are stopped: against closed forms of columns.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/box_boom.hpp"
#include "support/luffing_boom.hpp"

namespace stopped_in_space_test {

using namespace boxbeam;
using namespace test::box_boom;

namespace {

constexpr double E = 210e9, L = 4.0, P = 100e3;
/// Of the box 200 x 300, flanges 20, webs 12, about its vertical axis, the weaker one.
const double I_z = (0.3 * std::pow(0.2, 3) - 0.26 * std::pow(0.176, 3)) / 12.0;

/// Pressed along its axis at its tip.
std::string pressed(const std::string& joints, const char* along = "[-1, 0, 0]",
                    const std::string& more = "") {
  return boom(joints,
              fmt::format("direction = {}\nlaw = {{ kind = \"harmonic\", mean = \"{} N\", "
                          "amplitude = \"0.1 N\", frequency = \"1 Hz\" }}\n",
                          along, P),
              more);
}

const std::string clamp = R"(
[joints.heel]
kind = "fixed"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
)";

/// By teeth on a wheel that is held.
const std::string teeth = R"([bodies.wheel]
points = { c = ["0 m", "0 m", "0 m"] }

[joints.wheel]
kind = "revolute"
connect = ["ground", "wheel.c"]
at = ["0 m", "0 m", "-0.9 m"]
axis = "y"

[joints.teeth]
kind = "gear"
joints = ["wheel", "heel"]
ratio = 0.5

[drivers.wheel]
joint = "wheel"
kind = "hold"
value = "0 deg"
)";

/// At so many times P it buckles.
std::optional<double> critical(const std::string& text) {
  const Project project = parse_project("boom.toml", text);
  const std::deque<SituationRun> runs = run_situations(project);
  const SituationRun& run = runs.front();
  return run.motion->critical_factor_at(run.loads.time_of(0), run.loads.diagram(0), 1e4);
}

}  // namespace

TEST_CASE("a boom that is clamped buckles as a cantilever about its weaker axis", "[stability]") {
  const auto factor = critical(pressed(clamp));
  REQUIRE(factor);
  CHECK(*factor * P == Approx(std::pow(std::numbers::pi / (2.0 * L), 2) * E * I_z).epsilon(0.01));
}

// Invariant: what does not move is the ground, however many bodies it is.
TEST_CASE("a boom on bodies that joints and drivers hold buckles as one on the ground",
          "[stability]") {
  std::string joints;
  std::string before = "ground";
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    joints +=
        fmt::format(R"([bodies.post-{0}]
mass = "10 kg"
uniform_rod = ["O", "A"]
points = {{ O = ["0 m", "0 m", "0 m"], A = ["0 m", "0.2 m", "0.3 m"] }}
[joints.post-{0}]
kind = "{1}"
connect = ["{2}", "post-{0}.O"]
{3}
)",
                    i, i == 20 ? "revolute" : "fixed", before,
                    i == 20 ? "axis = \"z\"\n[drivers.post]\njoint = \"post-20\"\nkind = \"hold\"\n"
                              "value = \"0 deg\""
                            : "");
    before = fmt::format("post-{}.A", i);
  }
  joints +=
      fmt::format("[joints.heel]\nkind = \"fixed\"\nconnect = [\"{}\", \"arm.heel\"]\n", before);
  const auto carried = critical(pressed(joints)), clamped = critical(pressed(clamp));
  REQUIRE(carried);
  REQUIRE(clamped);
  CHECK(*carried == Approx(*clamped).epsilon(1e-6));
}

TEST_CASE(
    "a boom that a strut holds in the plane in which it luffs buckles across it as a cantilever",
    "[stability]") {
  // The force along the boom leaves the strut without one; the hinge about y clamps it about z.
  const auto factor = critical(pressed(hinged + strut));
  REQUIRE(factor);
  const double N_cr = std::pow(std::numbers::pi / (2.0 * L), 2) * E * I_z;
  CHECK(*factor * P == Approx(N_cr).epsilon(0.01));

  const Verification of = verify(parse_project("boom.toml", pressed(hinged + strut)));
  REQUIRE(of.model.second_order.across);
  CHECK(of.model.second_order.across->part == Approx(P / N_cr).epsilon(0.01));
  CHECK_FALSE(of.model.second_order.across->assumed);
}

TEST_CASE("teeth hold a boom in the plane in which it luffs", "[stability]") {
  // The weaker axis lies along the hinge: a cantilever by the tooth at 0.6 m from it alone.
  std::string text = pressed(hinged + teeth);
  text.replace(text.find("z = \"z\""), 7, "z = \"y\"");
  const auto factor = critical(text);
  REQUIRE(factor);
  CHECK(*factor * P == Approx(std::pow(std::numbers::pi / (2.0 * L), 2) * E * I_z).epsilon(0.01));
}

TEST_CASE("a boom that is pulled does not buckle, nor is one looked at whose holds the case says",
          "[stability]") {
  CHECK(*critical(pressed(clamp, "[1, 0, 0]")) == 1e4);
  const std::string held =
      "[[beam.restraints]]\nstation = \"0 m\"\nholds = [\"along y\", \"along z\"]\n"
      "[[beam.restraints]]\nstation = \"4 m\"\nholds = [\"along y\", \"along z\"]\n";
  const Verification of =
      verify(parse_project("boom.toml", pressed(hinged + strut, "[-1, 0, 0]", held)));
  CHECK(of.model.second_order.across->part ==
        Approx(P / (std::pow(std::numbers::pi / L, 2) * E * I_z)).epsilon(0.01));
}

TEST_CASE("a strut that is pressed tilts with what it carries", "[stability]") {
  // Pushed down at its tip the boom hangs on a strut at its end, which stands upright on a ball: it
  // keeps its plane by the hinge alone, against which the strut of length h leans: across, a
  // cantilever of stiffness 3 E I_z/L^3 that N/h of the strut takes away, where nothing presses it.
  const double h = 2.0;
  const std::string text =
      pressed(hinged + R"([joints.strut]
kind = "distance"
connect = ["ground", "arm.tip"]
at = ["4 m", "0 m", "-2 m"]
length = "2 m"
)",
              "[0, 0, -1]",
              // So that the boom is stressed at all.
              "\n[forces.little]\npoint = \"arm.lug\"\ndirection = \"-z\"\nkind = "
              "\"force\"\nsize = \"0.1 kN\"\n");
  const auto factor = critical(text);
  REQUIRE(factor);
  const double N_cr = h * 3.0 * E * I_z / (L * L * L);
  CHECK(*factor * P == Approx(N_cr).epsilon(0.01));

  // Though nothing presses the beam.
  const Verification of = verify(parse_project("boom.toml", text));
  REQUIRE(of.model.second_order.across);
  CHECK(of.model.second_order.across->part == Approx(P / N_cr).epsilon(0.01));
}

// Closed form, and the same of either body beneath.
TEST_CASE("a cylinder of two bodies that is pressed tilts as a strut of its length",
          "[stability]") {
  const double h = 2.0, N_cr = h * 3.0 * E * I_z / (L * L * L);
  // Of so much stroke, the head so far above the piston's point.
  const auto cylinder = [](double stroke, double above) {
    return fmt::format(R"([bodies.barrel]
points = {{ o = ["0 m", "0 m", "0 m"] }}
[bodies.piston]
points = {{ o = ["0 m", "0 m", "0 m"], head = ["0 m", "0 m", "{} m"] }}
[joints.foot]
kind = "universal"
connect = ["ground", "barrel.o"]
at = ["4 m", "0 m", "-2 m"]
axis = "x"
second_axis = "y"
[joints.head]
kind = "spherical"
connect = ["piston.head", "arm.tip"]
closes = true
[joints.stroke]
kind = "prismatic"
connect = ["barrel.o", "piston.o"]
axis = "z"
[drivers.stroke]
joint = "stroke"
kind = "hold"
value = "{} m"
)",
                       above, stroke);
  };
  for (const std::string& of : {cylinder(2.0, 0.0), cylinder(0.5, 1.5)}) {
    const auto factor = critical(pressed(hinged + of, "[0, 0, -1]"));
    REQUIRE(factor);
    CHECK(*factor * P == Approx(N_cr).epsilon(0.01));
  }
}

TEST_CASE("in the plane in which it luffs a boom buckles as the mechanism in the plane does",
          "[stability]") {
  // By the exact elements of the plane, whatever the force in the strut.
  for (const double degrees : {180.0, 190.0, 200.0}) {
    const Verification plane =
        verify(parse_project("plane.toml", test::luffing_in_plane(degrees, 120.0)));
    const auto factor = critical(test::luffing_in_space(degrees, 120.0));
    REQUIRE(factor);
    CHECK(1.0 / *factor == Approx(plane.model.second_order.in_plane.part).epsilon(0.01));
  }
}

}  // namespace stopped_in_space_test
