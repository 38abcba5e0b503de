// A shaft that teeth turn, as the verified beam: its cut forces against those of a cantilever with
// the textbook's forces of a gear at its end, Shigley, Mechanical Engineering Design, chapter 13.

#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace geared_shaft_test {

using namespace boxbeam;

namespace {

/// A shaft of 0.5 m along z that turns in its bearing at its start, with a wheel at its end; what
/// is on the other side of the teeth has 100 N m on it.
std::string shaft(const std::string& other) {
  return R"([case]
name = "shaft"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[bodies.shaft]
points = { A = ["0 m", "0 m", "0 m"] }
[joints.bearing]
kind = "revolute"
connect = ["ground", "shaft.A"]
axis = "z"
[bodies.pinion]
points = { C = ["0 m", "0 m", "0 m"] }
)" + other +
         R"(
[drivers.bearing]
joint = "bearing"
kind = "constant rate"
start = "0 deg"
rate = "60 rpm"
[motion]
duration = "2 s"
[sections.tube]
kind = "round tube"
diameter = "60 mm"
wall = "5 mm"
[beam]
body = "shaft"
start = "A"
axis = "z"
z = "x"
density = "1e-6 kg/m^3"
[[beam.segments]]
length = "0.5 m"
section = "tube"
[material]
steel = "S355"
[strength]
required = 1.0
)";
}

void check_cuts(const std::string& text, double N, double M, double T) {
  const Project project = parse_project("shaft.toml", text);
  const std::deque<SituationRun> runs = run_situations(project);
  const SituationRun& run = runs.front();
  for (const std::size_t i : {0U, 7U, 30U, 71U}) {
    const CutForces at = run.loads.diagram(i).at({Length{}, Side::behind});
    CHECK(at.N.value() == Approx(N).margin(1e-3));
    CHECK(std::hypot(at.M_y.value(), at.M_z.value()) == Approx(M).epsilon(1e-5));
    CHECK(std::abs(at.T.value()) == Approx(T).epsilon(1e-5));
  }
}

}  // namespace

TEST_CASE(
    "a shaft bears the force along its wheel and what pushes the wheels apart, all around it") {
  // A pinion of 0.1 m beside a wheel of 0.2 m: F = 1 kN, F/cos 20 deg across the shaft's end.
  check_cuts(shaft(R"(
[joints.pinion]
kind = "revolute"
connect = ["ground", "pinion.C"]
at = ["0.3 m", "0 m", "0.5 m"]
axis = "z"
[joints.teeth]
kind = "gear"
joints = ["pinion", "bearing"]
ratio = -0.5
mesh = "ground"
at = ["0.2 m", "0 m", "0.5 m"]
[forces.load]
kind = "couple"
point = "pinion.C"
direction = "z"
size = "100 N m"
)"),
             0.0, 0.5 * 1000.0 / std::cos(20.0 * std::numbers::pi / 180.0), 200.0);
}

TEST_CASE("a bevel wheel presses its shaft as well, at the lever of its radius") {
  // Axes that meet 0.1 m beyond the end, pinion of 0.1 m and wheel of 0.2 m in the middle of their
  // width, tan(delta) = 2 of the wheel: F = 1 kN, radial F tan 20 deg cos(delta), axial F tan 20
  // deg sin(delta), away from the apex, which bends the shaft by 0.2 m the other way.
  const double apart = 1000.0 * std::tan(20.0 * std::numbers::pi / 180.0);
  const double radial = apart / std::sqrt(5.0), axial = 2.0 * apart / std::sqrt(5.0);
  const double M = std::hypot(0.5 * 1000.0, 0.5 * radial - 0.2 * axial);
  check_cuts(shaft(R"(
[joints.pinion]
kind = "revolute"
connect = ["ground", "pinion.C"]
at = ["0 m", "0 m", "0.6 m"]
axis = "x"
[joints.teeth]
kind = "gear"
joints = ["pinion", "bearing"]
ratio = 0.5
mesh = "ground"
at = ["0.2 m", "0 m", "0.5 m"]
[forces.load]
kind = "couple"
point = "pinion.C"
direction = "x"
size = "100 N m"
)"),
             -axial, M, 200.0);
}

}  // namespace geared_shaft_test
