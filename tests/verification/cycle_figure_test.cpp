// One cycle as it is drawn: frames, drivers.

#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/verify.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/verification/pictures.hpp"
#include "catch.hpp"
#include "support/rig.hpp"
#include "support/shaken_beam.hpp"

namespace cycle_figure_test {

using namespace boxbeam;

namespace {

const std::vector<std::string> shipped{
    "sections/sledge-rig/rig.toml",          "sections/sledge-rig/friction.toml",
    "sections/four-bar-rocker/rocker.toml",  "sections/slider-crank-press/press.toml",
    "sections/scissor-lift/lift.toml",       "sections/landing-gear/gear.toml",
    "sections/landing-gear/retraction.toml", "sections/pump-jack/beam.toml",
    "sections/drill-truck/truck.toml"};

/// A shipped case with its pictures; all that a test may want of it.
struct Drawn {
  explicit Drawn(const std::string& path)
      : project(read_project(test::project_file(path))),
        runs(run_situations(project)),
        cycle(cycle_figure_of(project, runs.front())),
        drivers(runs.front().motion->driver_lines(runs.front().loads)) {}

  Project project;
  std::deque<SituationRun> runs;
  CycleFigure cycle;
  std::vector<DriverLine> drivers;
};

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// Energy that a driver gives over its samples, by the trapezoidal rule: on whole periods of a
/// smooth motion it is exact to round-off.
double work_of(const DriverLine& line) {
  double work = 0.0;
  for (std::size_t i = 1; i < line.times.size(); ++i) {
    work += 0.5 * (line.force[i] * line.speed[i] + line.force[i - 1] * line.speed[i - 1]) *
            (line.times[i] - line.times[i - 1]);
  }
  return work;
}

}  // namespace

TEST_CASE("every frame has the same bodies, and cut forces at the same stations") {
  for (const std::string& path : shipped) {
    CAPTURE(path);
    const Drawn drawn(path);
    const CycleFigure& cycle = drawn.cycle;
    REQUIRE(cycle.frames.size() == 48);
    CHECK(cycle.stations.size() <= 80);
    CHECK(std::is_sorted(cycle.stations.begin(), cycle.stations.end(),
                         [](const Station& a, const Station& b) { return a.s < b.s; }));
    for (const CycleFrame& frame : cycle.frames) {
      CHECK(frame.values.size() == cycle.stations.size());
      REQUIRE(frame.posture.bodies.size() == cycle.frames[0].posture.bodies.size());
      for (std::size_t b = 0; b < frame.posture.bodies.size(); ++b) {
        CHECK(frame.posture.bodies[b].points.size() ==
              cycle.frames[0].posture.bodies[b].points.size());
      }
      CHECK(frame.posture.loads.size() == cycle.frames[0].posture.loads.size());
    }
    // Rigid bodies keep their lengths while they move; elastic ones are drawn magnified.
    if (std::holds_alternative<flexible::Mechanism>(drawn.project.mechanism)) continue;
    for (const CycleFrame& frame : cycle.frames) {
      for (std::size_t b = 0; b < frame.posture.bodies.size(); ++b) {
        const auto& now = frame.posture.bodies[b].points;
        const auto& first = cycle.frames[0].posture.bodies[b].points;
        for (std::size_t k = 1; k < now.size(); ++k) {
          CHECK((now[k] - now[0]).norm() ==
                Approx((first[k] - first[0]).norm()).epsilon(1e-9).margin(1e-12));
        }
      }
    }
  }
}

TEST_CASE("frames divide a cycle evenly: without its end where it repeats, else with it") {
  const Drawn rig("sections/sledge-rig/rig.toml");
  const LoadHistory& closed = rig.runs.front().loads;
  REQUIRE(closed.closed());
  CHECK(rig.cycle.frames.back().time.value() ==
        Approx((closed.begin() + closed.period() * (47.0 / 48.0)).value()).epsilon(1e-12));
  const Drawn gear("sections/landing-gear/retraction.toml");
  const LoadHistory& open = gear.runs.front().loads;
  REQUIRE_FALSE(open.closed());
  CHECK(gear.cycle.frames.back().time.value() ==
        Approx((open.begin() + open.period()).value()).epsilon(1e-12));
}

TEST_CASE("the jumps of N and V in a frame are the loads drawn in it") {
  for (const std::string& path : shipped) {
    CAPTURE(path);
    const Drawn drawn(path);
    const CycleFigure& cycle = drawn.cycle;
    for (const CycleFrame& frame : cycle.frames) {
      double scale = 1e-9;
      for (const BeamLoadRow& row : frame.posture.loads) scale = std::max(scale, row.force.norm());
      for (std::size_t k = 1; k < cycle.stations.size(); ++k) {
        if (cycle.stations[k].s != cycle.stations[k - 1].s) continue;
        Eigen::Vector3d jump = Eigen::Vector3d::Zero();
        for (const BeamLoadRow& row : frame.posture.loads) {
          const double apart = std::abs((row.s - cycle.stations[k].s).value());
          if (apart < 1e-9 * drawn.project.beam.length().value()) jump += row.force;
        }
        const CutForces& before = frame.values[k - 1];
        const CutForces& behind = frame.values[k];
        // What acts on the beam is taken over by the cut: N falls by it.
        const Eigen::Vector3d change((behind.N - before.N).value(),
                                     (behind.V_y - before.V_y).value(),
                                     (behind.V_z - before.V_z).value());
        CHECK((change + jump).norm() <= 1e-9 * scale);
      }
    }
  }
}

TEST_CASE("loads carry the names of the joints and forces that they come from") {
  // All three act at the same place of the beam.
  const Project project = parse_project("shaken.toml", test::shaken_beam);
  const std::deque<SituationRun> runs = run_situations(project);
  const CycleFigure cycle = cycle_figure_of(project, runs.front());
  std::vector<std::string> names;
  for (const BeamLoadRow& row : cycle.frames.front().posture.loads) names.push_back(row.name);
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"exciter", "guide", "mount"});
}

TEST_CASE("the couple of a load in world axes is its moment in those of the beam") {
  // Planar beam axes have y into the plane: counter-clockwise is positive about the world's z only.
  for (const std::string& path : shipped) {
    CAPTURE(path);
    const Drawn drawn(path);
    for (const CycleFrame& frame : drawn.cycle.frames) {
      for (const BeamLoadRow& row : frame.posture.loads) {
        CHECK(row.couple.norm() == Approx(row.moment.norm()).margin(1e-9));
        if (!drawn.project.in_space) {
          CHECK(row.couple.z() == Approx(-row.moment.y()).margin(1e-9));
        }
      }
    }
  }
}

TEST_CASE("the envelope of the frames lies within that of the verification") {
  for (const char* path : {"sections/sledge-rig/rig.toml", "sections/landing-gear/gear.toml"}) {
    CAPTURE(path);
    const Project project = read_project(test::project_file(path));
    const Verification verification = verify(project, Figures::with);
    const CycleFigure& cycle = verification.pictures.cycles.front();
    for (const StationEnvelope& exact : verification.stations) {
      for (std::size_t k = 0; k < cycle.stations.size(); ++k) {
        if (cycle.stations[k] != exact.station) continue;
        for (const auto& [which, name] : cut_forces_looked_at(project)) {
          CAPTURE(to_text(exact.station), name);
          const Envelope& of = exact.of[which];
          const double near =
              1e-9 * (std::abs(of.largest.value) + std::abs(of.smallest.value)) + 1e-9;
          CHECK(value_of(cycle.largest[k], which) <= of.largest.value + near);
          CHECK(value_of(cycle.smallest[k], which) >= of.smallest.value - near);
        }
      }
    }
  }
}

TEST_CASE("a posture of the cycle is the posture at its time") {
  const Drawn drawn("sections/sledge-rig/rig.toml");
  const CycleFrame& frame = drawn.cycle.frames[17];
  const PostureFigure again = postures_of(drawn.project, drawn.runs.front())(frame.time, "");
  REQUIRE(again.bodies.size() == frame.posture.bodies.size());
  for (std::size_t b = 0; b < again.bodies.size(); ++b) {
    for (std::size_t k = 0; k < again.bodies[b].points.size(); ++k) {
      CHECK((again.bodies[b].points[k] - frame.posture.bodies[b].points[k]).norm() < 1e-12);
    }
  }
}

TEST_CASE("speed and acceleration of a driver are the differences of its position") {
  for (const std::string& path : shipped) {
    CAPTURE(path);
    const Drawn drawn(path);
    REQUIRE_FALSE(drawn.drivers.empty());
    for (const DriverLine& line : drawn.drivers) {
      CAPTURE(line.name);
      REQUIRE(line.times.size() >= 96);
      REQUIRE(line.position.size() == line.times.size());
      // Central differences of second order: the error is step^2/6 times the third derivative, for
      // a harmonic of which the line has 96 samples (2 pi/96)^2/6 = 0.07 % of the amplitude. A
      // table or step has higher derivatives: 5 % of the largest value.
      for (std::size_t i = 1; i + 1 < line.times.size(); ++i) {
        const double step = line.times[i + 1] - line.times[i - 1];
        CHECK((line.position[i + 1] - line.position[i - 1]) / step ==
              Approx(line.speed[i]).margin(0.05 * largest(line.speed)));
        CHECK((line.speed[i + 1] - line.speed[i - 1]) / step ==
              Approx(line.acceleration[i])
                  .margin(0.05 * largest(line.acceleration) + 1e-9 * largest(line.speed) / step));
      }
    }
  }
}

TEST_CASE("over a cycle without friction the drivers of a mechanism of bodies do no work") {
  for (const char* path :
       {"sections/sledge-rig/rig.toml", "sections/four-bar-rocker/rocker.toml"}) {
    CAPTURE(path);
    const Drawn drawn(path);
    double work = 0.0;
    double turned_over = 0.0;
    for (const DriverLine& line : drawn.drivers) {
      work += work_of(line);
      const double time = line.times.back() - line.times.front();
      turned_over += largest(line.force) * largest(line.speed) * time;
    }
    CHECK(std::abs(work) < 1e-6 * turned_over);
  }
}

TEST_CASE("with friction a driver pays for what rubs") {
  const Drawn drawn("sections/sledge-rig/friction.toml");
  CHECK(work_of(drawn.drivers.front()) > 0.0);
}

TEST_CASE("harmonic loads together never take work out of elastic links") {
  const Drawn drawn("sections/drill-truck/truck.toml");
  double work = 0.0;
  double turned_over = 0.0;
  for (const DriverLine& line : drawn.drivers) {
    work += work_of(line);
    turned_over += largest(line.force) * largest(line.position);
  }
  CHECK(work > -1e-9 * turned_over);
}

TEST_CASE(
    "where a force moves the mechanism, its point moves as the oscillator's closed form says") {
  // m x'' + c x' + k x = F sin(omega t), steady after 8 s: amplitude F/|k - m omega^2 + i c omega|;
  // the force's work in a time of whole periods is what the damper takes, c (omega A)^2/2 each
  // second.
  const Project project = parse_project("shaken.toml", test::shaken_beam);
  const std::deque<SituationRun> runs = run_situations(project);
  const std::vector<DriverLine> lines = runs.front().motion->driver_lines(runs.front().loads);
  REQUIRE(lines.size() == 1);
  const DriverLine& line = lines.front();
  CHECK(line.name == "exciter");
  CHECK_FALSE(line.turns);
  const double mass = 7850.0 * (0.1 * 0.1 - 0.08 * 0.08) * 2.0;
  const double omega = 2.0 * std::numbers::pi * 5.0;
  const double amplitude = 3000.0 / std::hypot(200e3 - mass * omega * omega, 2000.0 * omega);
  CHECK(largest(line.position) == Approx(amplitude).epsilon(2e-3));
  CHECK(largest(line.speed) == Approx(omega * amplitude).epsilon(2e-3));
  CHECK(largest(line.acceleration) == Approx(omega * omega * amplitude).epsilon(2e-3));
  CHECK(largest(line.force) == Approx(3000.0).epsilon(2e-3));
  const double seconds = line.times.back() - line.times.front();
  CHECK(work_of(line) ==
        Approx(seconds * 0.5 * 2000.0 * std::pow(omega * amplitude, 2)).epsilon(1e-4));
}

TEST_CASE("the Newton chain knows no force of the driver") {
  const Project project = read_project(test::project_file("sections/sledge-rig/published.toml"), {},
                                       Dynamics::newton_chain);
  const std::deque<SituationRun> runs = run_situations(project);
  const std::vector<DriverLine> lines = runs.front().motion->driver_lines(runs.front().loads);
  REQUIRE(lines.size() == 1);
  CHECK(lines.front().force.empty());
  // The thesis: 25 mm at 0.7 Hz.
  const HarmonicDriver& exciter = std::get<HarmonicDriver>(
      std::get<planar::Driven>(planar_of(project).joints.back().kind).driver);
  CHECK(largest(lines.front().speed) == Approx(exciter.amplitude * exciter.omega).epsilon(1e-3));
}

}  // namespace cycle_figure_test
