// Stops that part and balls with clearance in space, against closed forms, the plane and a turned
// world.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "boxbeam/mechanism/spatial/motion.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

namespace spatial_clearance_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double m = 2.0, g = 9.81, c = 0.05, k = 2e5;

/// A mass that three slides, square to each other and turned by R, let go anywhere.
Mechanism free_mass(const Matrix3d& R, const Vector3d& start, const Vector3d& rate) {
  Mechanism mechanism;
  for (int i = 0; i < 3; ++i) {
    Joint joint;
    joint.name = "slide " + std::to_string(i);
    joint.kind = JointKind::prismatic;
    joint.parent = i - 1;
    joint.axis = R.col(i);
    joint.moved_by = MovedBy::forces;
    joint.start = start[i];
    joint.start_rate = rate[i];
    mechanism.joints.push_back(joint);
    mechanism.bodies.emplace_back().name = joint.name;
  }
  mechanism.bodies[2].mass = m;
  return mechanism;
}

Spring ball(const Impact& impact) {
  Spring spring{"ball", {ground, Vector3d::Zero()}, {2, Vector3d::Zero()}, k, c, 0.0, Acts::pulling,
                impact};
  spring.clearance = true;
  return spring;
}

Mechanism ball_in_socket(const Matrix3d& R, const Vector3d& rate, double until) {
  Mechanism mechanism = free_mass(R, Vector3d::Zero(), rate);
  mechanism.gravity = R * Vector3d(0.0, -g, 0.0);
  mechanism.springs = {ball({1.5, 0.7})};
  mechanism.duration.length = until;
  return mechanism;
}

Vector3d place_at(const Chain& chain, double time) { return chain.at(time).bodies[2].position; }

}  // namespace

TEST_CASE("a mass between two stops in space loses its restitution at each of them") {
  constexpr double v = 2.0, e = 0.8;
  for (const double exponent : {1.0, 1.5}) {
    CAPTURE(exponent);
    Mechanism mechanism = free_mass(Matrix3d::Identity(), {0.5, 0.0, 0.0}, {v, 0.0, 0.0});
    const auto stop = [&](const char* name, double x) {
      return Spring{name, {ground, {x, 0.0, 0.0}}, {2, Vector3d::Zero()}, 1e7, 0.1,
                    0.0,  Acts::pushing,           Impact{exponent, e}};
    };
    mechanism.springs = {stop("left", -0.1), stop("right", 1.1)};
    mechanism.duration.length = 3.0;
    const Chain chain(mechanism);
    const std::vector<double>& changes = chain.forced()->changes();
    REQUIRE(changes.size() >= 8);
    for (std::size_t i = 1; 2 * i < changes.size(); ++i) {
      const State between = chain.at(0.5 * (changes[2 * i - 1] + changes[2 * i]));
      CHECK(std::abs(between.coordinates[0].rate) ==
            Approx(v * std::pow(e, static_cast<double>(i))).epsilon(1e-6));
    }
    // In the first of them it pushes, by the closed form where nothing is lost no more than this.
    const State pressed = chain.at(0.5 * (changes[0] + changes[1]));
    CHECK(force_of(mechanism, 1, pressed).x() < 0.0);
    // Newton's law of the mass.
    CHECK(force_of(mechanism, 1, pressed).x() ==
          Approx(m * pressed.coordinates[0].acceleration).epsilon(1e-9));
  }
}

TEST_CASE("a ball with clearance moves in a plane as the plane's pin does") {
  const Vector3d rate(0.35, 0.0, 0.0);
  const Mechanism mechanism = ball_in_socket(Matrix3d::Identity(), rate, 0.6);
  const Chain chain(mechanism);
  planar::Mechanism plane;
  plane.gravity = {0.0, -g};
  boxbeam::Body body;
  body.name = "pin";
  body.mass = m;
  body.inertia = 0.01;
  plane.bodies = {body};
  plane.forces = {
      {"bearing", planar::PinWithClearance{{planar::ground}, {0}, c, k, Impact{1.5, 0.7}}}};
  // Touches that come slowly ask for fine steps: the time of one is its place over its velocity.
  planar::FreeSolver solver(plane, 1e-13);
  planar::State state = solver.start(0.0, Vector3d::Zero(), rate);
  for (const double time : {0.15, 0.3, 0.45, 0.6}) {
    state = solver.advance(time, state);
    const Vector3d place = place_at(chain, time);
    CHECK(place.x() == Approx(state.q[0]).margin(1e-8));
    CHECK(place.y() == Approx(state.q[1]).margin(1e-8));
    CHECK(std::abs(place.z()) < 1e-12);
  }
  REQUIRE(solver.changes().size() >= 5);
  REQUIRE(chain.forced()->changes().size() == solver.changes().size());
  for (std::size_t i = 0; i < solver.changes().size(); ++i)
    CHECK(chain.forced()->changes()[i] == Approx(solver.changes()[i]).epsilon(1e-8));
}

TEST_CASE("a ball with clearance does not see how the world is turned") {
  const Vector3d rate(0.3, 0.1, -0.2);
  const Matrix3d R =
      Eigen::AngleAxisd(1.1, Vector3d(1.0, -2.0, 0.7).normalized()).toRotationMatrix();
  const Mechanism here = ball_in_socket(Matrix3d::Identity(), rate, 0.5);
  const Mechanism there = ball_in_socket(R, rate, 0.5);
  const Chain straight(here), turned(there);
  REQUIRE(straight.forced()->changes().size() >= 3);
  for (const double time : {0.1, 0.25, 0.4, 0.5})
    CHECK((R * place_at(straight, time) - place_at(turned, time)).norm() < 1e-8);
}

TEST_CASE("what a motion in space is looked at holds its impacts") {
  Mechanism mechanism = ball_in_socket(Matrix3d::Identity(), {0.35, 0.0, 0.0}, 0.3);
  // The third slide is held, so that a joint bears something.
  mechanism.joints[2].moved_by = MovedBy::driver;
  mechanism.gravity.z() = -1.0;
  const Chain chain(mechanism);
  const Motion motion = motion_of(chain);
  CHECK(motion.changes.size() == chain.forced()->changes().size());
}

TEST_CASE("impacts of what drivers move, and balls outside of their sockets, are refused") {
  const auto said = [](const Mechanism& mechanism) {
    return test::refusal_of<AnalysisError>([&] { const Chain chain(mechanism); });
  };
  Mechanism driven = ball_in_socket(Matrix3d::Identity(), Vector3d::Zero(), 0.3);
  for (Joint& joint : driven.joints) joint.moved_by = MovedBy::driver;
  CHECK(said(driven).find("leave the clearance nothing to do") != std::string::npos);
  driven.springs[0].clearance = false;
  CHECK(said(driven).find("nothing parts from a stop by itself") != std::string::npos);
  Mechanism outside = ball_in_socket(Matrix3d::Identity(), Vector3d::Zero(), 0.3);
  outside.joints[0].start = 0.08;
  CHECK(said(outside).find("80 mm from the middle of its socket") != std::string::npos);
}

}  // namespace spatial_clearance_test
