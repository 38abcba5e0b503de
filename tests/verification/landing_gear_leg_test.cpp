// The leg of a landing gear verified as a beam: what must hold whatever the numbers are.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace landing_gear_leg_test {

using namespace boxbeam;

namespace {

const Project& gear() {
  static const Project project =
      read_project(test::project_file("sections/landing-gear/retraction.toml"));
  return project;
}

/// The whole world turned: what hangs on the ground, what is given in its axes, and gravity.
void turn_world(spatial::Mechanism& mechanism, const Eigen::Matrix3d& R) {
  mechanism.gravity = R * mechanism.gravity;
  for (spatial::Joint& joint : mechanism.joints) {
    if (joint.parent != spatial::ground) continue;
    joint.at = R * joint.at;
    joint.axis = R * joint.axis;
    joint.turn = R * joint.turn;
  }
  for (spatial::AppliedLoad& load : mechanism.loads) {
    if (load.axes == spatial::ground) load.direction = R * load.direction;
    if (load.at.body == spatial::ground) load.at.p = R * load.at.p;
  }
  for (spatial::LineForce& line : mechanism.line_forces) {
    if (line.axes == spatial::ground) line.direction = R * line.direction;
  }
}

Project turned(Project project, const Eigen::Matrix3d& R) {
  turn_world(spatial_of(project), R);
  for (Situation& situation : project.situations) {
    if (situation.changed) turn_world(std::get<spatial::Mechanism>(*situation.changed), R);
  }
  return project;
}

std::map<std::string, double> factors_of(const Verification& verification) {
  std::map<std::string, double> factors;
  for (const CheckResult& result : verification.checks) {
    factors[result.check.id] = result.check.safety_factor;
  }
  return factors;
}

}  // namespace

TEST_CASE("the whole world turned at random: the same cut forces and factors") {
  const Verification upright = verify(gear());
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  for (int run = 0; run < 3; ++run) {
    const Eigen::Matrix3d R =
        spatial::rotation_about(Eigen::Vector3d(any(random), any(random), any(random)) * 2.0);
    const Verification tilted = verify(turned(gear(), R));
    REQUIRE(tilted.stations.size() == upright.stations.size());
    for (std::size_t i = 0; i < upright.stations.size(); ++i) {
      for (const auto& [which, name] : cut_forces_looked_at(gear())) {
        const Envelope& a = upright.stations[i].of[which];
        const Envelope& b = tilted.stations[i].of[which];
        CAPTURE(run, i, name);
        CHECK(b.smallest.value == Approx(a.smallest.value).epsilon(1e-9).margin(1e-5));
        CHECK(b.largest.value == Approx(a.largest.value).epsilon(1e-9).margin(1e-5));
      }
    }
    const auto expected = factors_of(upright), found = factors_of(tilted);
    REQUIRE(found.size() == expected.size());
    for (const auto& [id, factor] : expected) {
      CAPTURE(run, id);
      REQUIRE(found.count(id) == 1);
      CHECK(found.at(id) == Approx(factor).epsilon(1e-8));
    }
  }
}

TEST_CASE("the leg at the landing's peak: forces at the tyre and weights by hand") {
  // Level and leg down, peak at 0.1 s. Beam axes: x down the leg, z along x''', y along y'''. From
  // the foot's cut the tyre stands 0.35 m against z and 0.33 m further along x.
  const Verification verification = verify(gear());
  const auto run = [&] {
    for (const SituationRun& of : run_situations(gear())) {
      if (of.situation->name == "landing") {
        return of.loads.diagram_at(si<Time>(0.1)).at({gear().beam.length(), Side::before});
      }
    }
    return CutForces{};
  }();
  const double up = 45e3, aft = 12e3, side = 8e3, g = 9.81;
  const double below = (18.0 + 62.0) * g;  // weight beyond the cut
  // The force of what lies beyond, on the face: x down, y forward, z to +x.
  CHECK(run.N.value() == Approx(-up + below).epsilon(1e-9));
  CHECK(run.V_y.value() == Approx(-aft).epsilon(1e-9));
  CHECK(run.V_z.value() == Approx(side).epsilon(1e-9));
  // Moment about the foot, r x F of the tyre at (0.33, 0, -0.35) and of the weights on the axle.
  const Eigen::Vector3d tyre =
      Eigen::Vector3d(0.33, 0.0, -0.35).cross(Eigen::Vector3d(-up, -aft, side));
  const Eigen::Vector3d axle = Eigen::Vector3d(0, 0, -0.175).cross(Eigen::Vector3d(18.0 * g, 0, 0));
  const Eigen::Vector3d wheel = Eigen::Vector3d(0, 0, -0.35).cross(Eigen::Vector3d(62.0 * g, 0, 0));
  const Eigen::Vector3d moment = tyre + axle + wheel;
  CHECK(run.T.value() == Approx(moment.x()).epsilon(1e-9));
  CHECK(run.M_y.value() == Approx(moment.y()).epsilon(1e-9));
  CHECK(run.M_z.value() == Approx(moment.z()).epsilon(1e-9));
}

TEST_CASE("a flight counts its situations as one history, rainflow over all their ends") {
  const Project& project = gear();
  const auto runs = run_situations(project);
  const Station station{project.beam.length(), Side::before};
  const StressInfluence influence = [] {
    StressInfluence plain;
    plain.normal[cut_force::M_y] = 1e4;  // any stress will do
    plain.normal[cut_force::N] = 200.0;
    return plain;
  }();
  StressPoint point;
  point.station = station;
  point.name = "test";
  point.influence = influence;
  point.yield_strength = si<Stress>(355e6);
  point.detail = &project.fatigue.beam;
  const auto result =
      check_fatigue(project, histories_at(runs, station), point, Criterion::fatigue);
  REQUIRE(result);
  // The same by brute force: all stresses at very many instants, one situation after the other.
  std::vector<double> history;
  for (const std::size_t part : project.situations.back().between) {
    const SituationRun& run = run_of(runs, project.situations[part]);
    const double begin = run.loads.begin().value(), period = run.loads.period().value();
    for (int k = 0; k <= 20000; ++k) {
      const Time time = si<Time>(begin + period * k / 20000.0);
      history.push_back(
          stress_at(influence, run.loads.diagram_at(time).at(station)).normal.value());
    }
  }
  CountingRule rule;
  rule.counting = Counting::periodic;
  double expected = 0.0, found = 0.0;  // damage by slope 3, which all cycles add to
  for (const Cycle& cycle : count_cycles(history, rule)) {
    expected += cycle.count * std::pow(cycle.range.value(), 3);
  }
  for (const SpectrumRow& row : result->basis->spectrum) {
    CHECK(row.situation == "flight");
    found += row.cycle.count / 20000.0 * std::pow(row.cycle.range.value(), 3);
  }
  CHECK(found == Approx(expected).epsilon(1e-6));
}

TEST_CASE("a situation that hangs bodies up otherwise verifies the same beam") {
  const std::string file = test::project_file("sections/landing-gear/retraction.toml");
  const std::string yaw = "joints.yaw.connect=[\"leg.B\", \"aircraft.A\"]";
  const std::string hinge = "joints.hinge.connect=[\"climb.A\", \"leg.B\"]";
  const auto landing_of = [](const Project& project) {
    const SituationRun run(project, project.situations[2], {}, {});
    return run.loads.diagram_at(si<Time>(0.07)).at({0.4 * metre, Side::both});
  };
  const Project whole = read_project(file, {yaw, hinge});
  const Project one = read_project(file, {"situations.2.set." + yaw, "situations.2.set." + hinge});
  const CutForces expected = landing_of(whole), found = landing_of(one);
  for (const auto& [which, name] : cut_forces_looked_at(one)) {
    CAPTURE(name);
    CHECK(value_of(found, which) == Approx(value_of(expected, which)).epsilon(1e-12).margin(1e-6));
  }
}

TEST_CASE("ranges of distortion do not hang on which instants are looked at") {
  // The pulses of the landing as they are, and half an instant later: at the instants beside their
  // tops 1 - cos(1.875 deg) = 5.4e-4 of their amplitude is missing.
  const auto range_at = [](double phase) {
    std::vector<std::string> set;
    for (const auto& [name, mean] :
         {std::pair{"up", 22.5}, std::pair{"aft", 6.0}, std::pair{"side", 4.0}})
      set.push_back(fmt::format(
          "situations.2.set.forces.tyre_{}.law={{ kind = \"harmonic\", mean = \"{} kN\", amplitude "
          "= \"{} kN\", phase = \"{} deg\", frequency = \"5 Hz\" }}",
          name, mean, mean, phase));
    const Verification of =
        verify(read_project(test::project_file("sections/landing-gear/retraction.toml"), set));
    const CheckResult* const result = of.governing(Criterion::distortion_fatigue);
    REQUIRE(result != nullptr);
    CHECK(result->check.situation == "flight");
    const double top = 0.1 - (phase + 90.0) / (360.0 * 5.0);
    CHECK(std::abs(result->check.time.value() - top) < 1.05e-3);
    return result->distortion->size.angle;
  };
  const double expected = range_at(-90.0);
  CHECK(expected > 0.0);
  CHECK(range_at(-88.125) == Approx(expected).epsilon(1e-6));
}

}  // namespace landing_gear_leg_test
