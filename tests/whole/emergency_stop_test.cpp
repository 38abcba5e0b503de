// An arm that is started, runs and is stopped in an emergency, verified whole: model, verdict line
// and report; its largest moment against one oscillator under Duhamel's integral.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace emergency_stop_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double length = 4.0, tip = 900.0, E = 210e9;
constexpr double width = 0.12, height = 0.16, plate = 0.008;
// Up to full speed in `start`, then running, then stopped within `brake`.
constexpr double start = 0.8, stop_at = 1.4, brake = 0.2, full_speed = 0.35;

double speed_at(double t) {
  if (t <= 0.0 || t >= stop_at + brake) return 0.0;
  if (t < start) return full_speed * 0.5 * (1.0 - std::cos(pi * t / start));
  if (t < stop_at) return full_speed;
  return full_speed * 0.5 * (1.0 + std::cos(pi * (t - stop_at) / brake));
}

std::string angle_table() {
  std::string rows = "t [s],angle [rad]\n";
  double angle = 0.0;
  const double h = 0.0005;
  for (int i = 0; i <= 3200; ++i) {
    if (i % 50 == 0) rows += fmt::format("{:.6f},{:.12f}\n", h * i, angle);
    angle += h * speed_at(h * (i + 0.5));
  }
  return rows;
}

std::string arm(const std::string& model) {
  return fmt::format(R"([case]
name = "arm"
title = "Arm that is stopped in an emergency"
kind = "planar"

[mechanism]
gravity = ["0 m/s^2", "0 m/s^2"]

[bodies.arm]
points = {{ A = ["0 m", "0 m"], B = ["{} m", "0 m"] }}
sketch = {{ at = ["0 m", "0 m"], angle = "0 deg" }}

[bodies.load]
mass = "{} kg"
inertia = "0.001 kg m^2"
points = {{ B = ["0 m", "0 m"] }}
sketch = {{ at = ["{} m", "0 m"], angle = "0 deg" }}

[joints.A]
kind = "pin"
connect = ["arm.A", "ground"]
at = ["0 m", "0 m"]

[joints.B]
kind = "rigid"
connect = ["arm.B", "load.B"]

[drivers.motor]
point = "arm.A"
coordinate = "angle"
kind = "table"
file = "angle.csv"

[sections.box]
kind = "box"
width = "{} m"
height = "{} m"
flange = "{} m"
web = "{} m"

[beam]
body = "arm"
density = "7850 kg/m^3"

[[beam.segments]]
length = "{} m"
section = "box"

[material]
steel = "S355"

[strength]
required = 1.1

[fatigue]
category = 71
loading = "spectrum"
gamma_Ff = 1.0
gamma_Mf = 1.35
cycles = 1e4
required = 1.0

[model]
{}
)",
                     length, tip, length, width, height, plate, plate, length, model);
}

double largest_root_moment(const std::deque<SituationRun>& runs) {
  const StationHistory root(runs.front().loads, {Length{}, Side::behind});
  return std::abs(
      root.largest([](const CutForces& cut) { return std::abs(cut.M_y.value()); }).value);
}

}  // namespace

TEST_CASE("an emergency stop is verified with the vibration that it leaves", "[emergency_stop]") {
  const test::TemporaryFolder folder;
  folder.write("angle.csv", angle_table());
  const std::string path = folder.write("arm.toml", arm("damping = \"5 ms\""));
  const Project project = read_project(path);

  const ModelledRuns by_model = run_by_chosen_model(project);
  CHECK(by_model.model.chosen.level == ModelLevel::modal);
  CHECK_THAT(by_model.model.reason, !Catch::Contains("not estimated"));
  const double moment = largest_root_moment(by_model.runs);
  const double rigid = largest_root_moment(run_situations(project));
  CHECK(moment > 1.2 * rigid);

  // One oscillator: the tip's mass and 33/140 of the beam's, which its static shape has (Rayleigh),
  // on 3 E I/L^3; base acceleration alpha x, moment m L (relative acceleration); the beam's own
  // inertia m_b L^2/3 in the rigid moment.
  const double I =
      (width * std::pow(height, 3) - (width - 2 * plate) * std::pow(height - 2 * plate, 3)) / 12.0;
  const double A = width * height - (width - 2 * plate) * (height - 2 * plate);
  const double own = 7850.0 * A * length;
  const double omega = std::sqrt(3.0 * E * I / std::pow(length, 3) / (tip + 33.0 / 140.0 * own));
  CHECK(2.0 * pi * by_model.model.frequencies.front() == Approx(omega).epsilon(0.02));
  const double zeta = 0.5 * omega * 0.005;
  double u = 0.0, v = 0.0, most = 0.0;
  const double h = 1e-5;
  for (double t = 0.0; t < 2.5; t += h) {
    const double alpha = (speed_at(t + h) - speed_at(t)) / h;
    v += h * (alpha - omega * omega * u - 2.0 * zeta * omega * v);
    u += h * v;
    most = std::max(most, std::abs(omega * omega * u + 2.0 * zeta * omega * v));
  }
  CHECK(moment == Approx(most * (tip + own / 3.0) * length * length).epsilon(0.02));

  const Verification verified = verify(project);
  for (const NotJudged& of : verified.not_judged) {
    INFO(of.what << ": " << of.reason);
    CHECK_THAT(of.what, !Catch::Contains("vibration"));
  }
  // The record goes on behind the stop until little is left.
  REQUIRE(verified.motions.size() == 1);
  CHECK(verified.motions.front().period.value() > stop_at + brake + 2.0 * 2.0 * pi / omega);
  CHECK_FALSE(verified.motions.front().closed);
  // The whole document, too.
  const test::ProgramResult result =
      test::run_program({"verify", path, "--json", "-"}, folder.path());
  INFO(result.err);
  const auto document = nlohmann::json::parse(result.out);
  CHECK(document["model"]["chosen"] == "modal");
}

TEST_CASE("what a stop leaves without damping is said where fatigue is asked", "[emergency_stop]") {
  const test::TemporaryFolder folder;
  folder.write("angle.csv", angle_table());
  const Project project = read_project(folder.write("arm.toml", arm("")));
  const Verification verified = verify(project);
  bool said = false;
  for (const NotJudged& of : verified.not_judged)
    said = said || of.reason.find("does not die out") != std::string::npos;
  CHECK(said);
}

}  // namespace emergency_stop_test
