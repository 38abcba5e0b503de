// The motion of a case in space as the user gets it: names, senses, axes.

#include "boxbeam/verification/chain_motion_result.hpp"

#include <algorithm>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace chain_motion_result_test {

using namespace boxbeam;

namespace {

Project gear(const std::vector<std::string>& overrides = {}) {
  return read_project(test::project_file("sections/landing-gear/gear.toml"), overrides);
}

template <class Things>
const auto& named(const Things& things, const std::string& name) {
  const auto found =
      std::find_if(things.begin(), things.end(), [&](const auto& of) { return of.name == name; });
  INFO(name);
  REQUIRE(found != things.end());
  return *found;
}

std::vector<std::string> point_names_of(const Project& project) {
  std::vector<std::string> names;
  const ChainMotionResult motion = chain_motion_of(project, {0.0}, "world");
  for (const ChainPoint& point : motion.states.front().points) {
    names.push_back(point.name);
  }
  return names;
}

/// Kinetic and potential energy of all bodies.
double energy_of(const spatial::Mechanism& mechanism, double time) {
  const spatial::State state = spatial::Chain(mechanism).at(time);
  double energy = 0.0;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const spatial::Body& body = mechanism.bodies[i];
    const spatial::Attachment centre{static_cast<int>(i), body.centre};
    const Eigen::Vector3d v = spatial::velocity_of(state, centre);
    const Eigen::Vector3d omega = state.bodies[i].R_WB.transpose() * state.bodies[i].omega;
    energy += 0.5 * body.mass * v.squaredNorm() + 0.5 * omega.dot(body.inertia * omega) -
              body.mass * mechanism.gravity.dot(spatial::position_of(state, centre));
  }
  return energy;
}

}  // namespace

TEST_CASE("a point that joined bodies share is given once, under its plain name", "[space]") {
  Project project = gear();
  CHECK(point_names_of(project) == std::vector<std::string>{"A", "B", "foot", "C", "tyre"});
  // A second place of the name C: both are told apart by their bodies.
  auto& mechanism = spatial_of(project);
  const int axle = spatial::body_index(mechanism, "axle");
  for (spatial::BodyPoint& point : mechanism.bodies[static_cast<std::size_t>(axle)].points) {
    if (point.name == "C") point.p.y() += 0.1;
  }
  CHECK(point_names_of(project) ==
        std::vector<std::string>{"A", "B", "foot", "axle.C", "tyre", "wheel.C"});
}

TEST_CASE("points on the axis of a revolute joint are one place, beside it they are not",
          "[space]") {
  Project project = gear();
  auto& mechanism = spatial_of(project);
  const auto add = [&](const char* body, const Eigen::Vector3d& p) {
    const int index = spatial::body_index(mechanism, body);
    mechanism.bodies[static_cast<std::size_t>(index)].points.push_back({"P", p});
  };
  // The wheel turns about x through C, 0.35 m before the axle's origin.
  add("axle", {-0.6, 0.0, 0.0});
  add("wheel", {-0.25, 0.0, 0.0});
  const auto has = [](const std::vector<std::string>& names, const char* name) {
    return std::count(names.begin(), names.end(), name) == 1;
  };
  CHECK(has(point_names_of(project), "P"));
  for (const char* body : {"axle", "wheel"}) {
    const int index = spatial::body_index(mechanism, body);
    mechanism.bodies[static_cast<std::size_t>(index)].points.back().p.z() = 0.1;
  }
  CHECK(has(point_names_of(project), "axle.P"));
  CHECK(has(point_names_of(project), "wheel.P"));
}

TEST_CASE("joints are told by what they do to the beam, or to the body that they carry",
          "[space]") {
  const Project project = gear();
  const spatial::Chain chain(spatial_of(project));
  for (const double time : {0.0, 0.31}) {
    const spatial::State state = chain.at(time);
    const std::vector<spatial::Wrench> wrenches = chain.joint_wrenches(state);
    const ChainMotionResult motion = chain_motion_of(project, {time}, "world");
    const auto check = [&](const char* name, const char* on, double sign) {
      const ChainJoint& joint = named(motion.states.front().joints, name);
      const auto index = static_cast<std::size_t>(spatial::joint_index(spatial_of(project), name));
      CHECK(joint.on == on);
      CHECK((joint.force - sign * wrenches[index].force).norm() == 0.0);
      CHECK((joint.moment - sign * wrenches[index].moment).norm() == 0.0);
    };
    check("path", "climb", 1.0);
    check("hinge", "leg", 1.0);
    check("foot", "leg", -1.0);  // the leg is the beam and carries the axle
    check("spin", "wheel", 1.0);
    CHECK_FALSE(named(motion.states.front().joints, "foot").drive);
    CHECK(motion.driven == 4);
  }
}

TEST_CASE("drives times the rates of their coordinates are the change of energy", "[space]") {
  const Project project = gear({"forces.drag.size=0 N/m"});
  const spatial::Mechanism& mechanism = spatial_of(project);
  for (const double time : {0.05, 0.25, 0.4}) {
    const ChainInstant state = chain_motion_of(project, {time}, "world").states.front();
    double power = 0.0;
    for (std::size_t i = 0; i < state.joints.size(); ++i) {
      if (!state.joints[i].drive) continue;
      power += *state.joints[i].drive * driver_at(mechanism.joints[i].driver, time).rate;
    }
    const double h = 1e-3;  // central difference of fourth order
    const double change =
        (8.0 * (energy_of(mechanism, time + h) - energy_of(mechanism, time - h)) -
         energy_of(mechanism, time + 2.0 * h) + energy_of(mechanism, time - 2.0 * h)) /
        (12.0 * h);
    CHECK(power == Approx(change).epsilon(1e-7));
  }
}

TEST_CASE("in the axes of a body every vector is turned by its rotation", "[space]") {
  const Project project = gear();
  const std::vector<double> times{0.0, 0.2, 0.5};
  const ChainMotionResult world = chain_motion_of(project, times, "world");
  for (const char* axes : {"leg", "wheel", "climb"}) {
    const ChainMotionResult turned = chain_motion_of(project, times, axes);
    CHECK(turned.axes == axes);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const ChainInstant& a = world.states[k];
      const ChainInstant& b = turned.states[k];
      const Eigen::Matrix3d R_AW = named(a.bodies, axes).rotation.transpose();
      const auto same = [&](const Eigen::Vector3d& in_world, const Eigen::Vector3d& in_axes) {
        CHECK((in_axes - R_AW * in_world).norm() <= 1e-14 * in_world.norm());
        CHECK(in_axes.norm() == Approx(in_world.norm()).epsilon(1e-13));
      };
      for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        same(a.bodies[i].omega, b.bodies[i].omega);
        same(a.bodies[i].alpha, b.bodies[i].alpha);
        same(a.bodies[i].inertia_force, b.bodies[i].inertia_force);
        same(a.bodies[i].inertia_moment, b.bodies[i].inertia_moment);
        same(a.bodies[i].gyroscopic_moment, b.bodies[i].gyroscopic_moment);
        same(a.joints[i].force, b.joints[i].force);
        same(a.joints[i].moment, b.joints[i].moment);
        CHECK(a.joints[i].drive == b.joints[i].drive);
      }
      for (std::size_t i = 0; i < a.points.size(); ++i) {
        same(a.points[i].position, b.points[i].position);
        same(a.points[i].velocity, b.points[i].velocity);
        same(a.points[i].acceleration, b.points[i].acceleration);
      }
      CHECK((named(b.bodies, axes).rotation - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    }
  }
}

TEST_CASE("hand formulas stand beside what the chain gives at their time, in world axes",
          "[space]") {
  Project project = gear();
  project.hand_formulas.clear();
  const int wheel = spatial::body_index(spatial_of(project), "wheel");
  HandFormula formula;
  formula.name = "mine";
  formula.time = si<Time>(0.2);
  formula.formula = {"1", "2", "3"};
  formula.value = {1.0, 2.0, 3.0};
  formula.body = wheel;
  formula.point = {wheel, Eigen::Vector3d::Zero()};
  using Quantity = HandFormula::Quantity;
  for (const Quantity quantity : {Quantity::omega, Quantity::alpha, Quantity::position,
                                  Quantity::velocity, Quantity::acceleration}) {
    formula.quantity = quantity;
    project.hand_formulas.push_back(formula);
  }
  const spatial::State state = spatial::Chain(spatial_of(project)).at(0.2);
  const spatial::BodyMotion& body = state.bodies[static_cast<std::size_t>(wheel)];
  // The wheel's origin is C: the motion of the one is that of the other.
  const Eigen::Vector3d expected[] = {body.omega, body.alpha, body.position, body.velocity,
                                      body.acceleration};
  for (const char* axes : {"world", "leg"}) {
    const ChainMotionResult motion = chain_motion_of(project, {0.0}, axes);
    REQUIRE(motion.hand_formulas.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK((motion.hand_formulas[i].computed - expected[i]).norm() == 0.0);
      CHECK(motion.hand_formulas[i].of == (i < 2 ? "wheel" : "wheel.C"));
    }
  }
}

TEST_CASE("a motion that does not repeat is shown to its end, one that repeats is not", "[space]") {
  Project project = gear();
  const ChainMotionResult open = chain_motion_of(project, {}, "world");
  REQUIRE(open.states.size() == 12);
  CHECK(open.states.front().time == 0.0);
  CHECK(open.states.back().time == Approx(0.5));
  auto& mechanism = spatial_of(project);
  for (spatial::Joint& joint : mechanism.joints) joint.driver = PolynomialDriver{{0.0}};
  mechanism.joints.back().driver = RateDriver{0.0, 10.0};
  mechanism.duration = {};
  const ChainMotionResult closed = chain_motion_of(project, {}, "world");
  REQUIRE(closed.states.size() == 12);
  CHECK(closed.states.back().time == Approx(0.2 * std::numbers::pi * 11.0 / 12.0));
}

}  // namespace chain_motion_result_test
