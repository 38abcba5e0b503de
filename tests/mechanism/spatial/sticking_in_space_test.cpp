// Contacts in space that stick and slide under forces, against closed forms, the plane and turned
// frames.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/motion.hpp"
#include "catch.hpp"

namespace sticking_in_space_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double g = 9.81;

Friction dry(double mu, double standing = 0.0) { return {mu, 0.0, 0.0, 0.0, standing}; }

/// A block that slides along a turned x; on the ground or on another block.
int add_block(Mechanism& to, const char* name, const Matrix3d& turned, double mass,
              const Friction& friction, double rate, int on = ground) {
  Joint joint;
  joint.name = name;
  joint.kind = JointKind::prismatic;
  joint.parent = on;
  joint.turn = on == ground ? turned : Matrix3d::Identity();
  joint.axis = on == ground ? Vector3d(turned.col(0)) : Vector3d::UnitX();
  joint.moved_by = MovedBy::forces;
  joint.start_rate = rate;
  joint.friction = friction;
  spatial::Body& body = to.bodies.emplace_back();
  body.name = name;
  body.mass = mass;
  body.inertia = 0.1 * mass * Matrix3d::Identity();
  to.joints.push_back(joint);
  return static_cast<int>(to.bodies.size()) - 1;
}

void add_spring(Mechanism& to, const Matrix3d& turned, int on, double stiffness) {
  Spring spring;
  spring.name = "spring";
  spring.a = {ground, turned * Vector3d(-3.0, 0.0, 0.0)};
  spring.b = {on, Vector3d::Zero()};
  spring.stiffness = stiffness;
  spring.free_length = 3.0;
  to.springs.push_back(spring);
}

void add_push(Mechanism& to, const Matrix3d& turned, int on, double size, double rate) {
  spatial::AppliedLoad push;
  push.name = "push";
  push.on = on;
  push.at = {on, Vector3d::Zero()};
  push.direction = turned.col(0);
  push.size = HarmonicDriver{0.0, size, rate, 0.0};
  to.loads.push_back(push);
}

const Matrix3d askew =
    (Eigen::AngleAxisd(0.7, Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.4, Vector3d::UnitY()) *
     Eigen::AngleAxisd(1.1, Vector3d::UnitX()))
        .toRotationMatrix();

/// Two blocks on each other, tied by springs and pushed, with gravity across, -z turned.
Mechanism stacked(const Matrix3d& turned) {
  Mechanism of;
  of.gravity = turned * Vector3d(0.0, 0.0, -g);
  of.duration.length = 1.5;
  const int low = add_block(of, "low", turned, 3.0, dry(0.12, 0.2), 0.4);
  const int high = add_block(of, "high", turned, 2.0, dry(0.3), -0.9, low);
  add_spring(of, turned, low, 150.0);
  add_spring(of, turned, high, 60.0);
  add_push(of, turned, high, 9.0, 7.0);
  return of;
}

}  // namespace

TEST_CASE("in space a block that slides against a stop comes back as far as friction lets it") {
  // Work, piece by piece: to the stop, d into it, out of it and back until it stands.
  constexpr double mu = 0.3, v0 = 2.0, at = 0.2, m = 5.0, k = 1e6, length = 0.2;
  for (const Matrix3d& turned : {Matrix3d(Matrix3d::Identity()), askew}) {
    Mechanism of;
    of.gravity = turned * Vector3d(0.0, 0.0, -g);
    of.duration.length = 2.0;
    const int block = add_block(of, "block", turned, m, dry(mu), v0);
    Spring stop;
    stop.name = "stop";
    stop.a = {ground, turned * Vector3d(at + length, 0.0, 0.0)};
    stop.b = {block, Vector3d::Zero()};
    stop.stiffness = k;
    stop.free_length = length;
    stop.acts = Spring::Acts::pushing;
    of.springs.push_back(stop);
    const double into = v0 * v0 - 2.0 * mu * g * at, F = mu * m * g;
    const double d = (std::sqrt(F * F + k * m * into) - F) / k;
    const double out_of = into - 4.0 * mu * g * d;
    const Chain chain(of);
    for (const double time : {1.0, 2.0}) {
      const State state = chain.at(time);
      CHECK(state.coordinates[0].value == Approx(at - out_of / (2.0 * mu * g)).epsilon(1e-7));
      CHECK(std::abs(state.coordinates[0].rate) < 1e-10);
    }
  }
}

TEST_CASE("a block in space slides, stops and stays, however its rail stands") {
  // By hand: mu times the weight across, and its part along: uphill v0^2/(2 a).
  constexpr double mu = 0.45, v0 = 2.0, m = 4.0;
  for (const double slope : {0.0, 0.35, 0.6}) {  // tan: 0, 0.365, 0.684
    for (const bool turned : {false, true}) {
      CAPTURE(slope, turned);
      const Matrix3d frame = turned ? askew : Matrix3d(Matrix3d::Identity());
      Mechanism of;
      of.gravity = g * (frame * Vector3d(-std::sin(slope), 0.0, -std::cos(slope)));
      of.duration.length = 1.0;
      add_block(of, "block", frame, m, dry(mu), v0);
      const Chain chain(of);
      const double up = g * (std::sin(slope) + mu * std::cos(slope)), top = v0 / up;
      REQUIRE(chain.forced()->slip_changes().size() == 1);
      CHECK(chain.forced()->slip_changes()[0].time == Approx(top).epsilon(1e-10));
      const double way = v0 * v0 / (2.0 * up);
      const State state = chain.at(1.0);
      if (std::tan(slope) < mu) {
        CHECK(state.coordinates[0].value == Approx(way).epsilon(1e-10));
        CHECK(std::abs(state.coordinates[0].rate) < 1e-13);
        CHECK(state.friction[0] == Approx(m * g * std::sin(slope)).margin(1e-9));
        CHECK(chain.at(top + 0.01).coordinates[0].value == Approx(way).epsilon(1e-10));
      } else {
        const double down = g * (std::sin(slope) - mu * std::cos(slope));
        CHECK(state.coordinates[0].value ==
              Approx(way - 0.5 * down * std::pow(1.0 - top, 2)).epsilon(1e-9));
      }
      const Motion motion = motion_of(chain);
      CHECK(motion.changes.size() == 1);
    }
  }
}

TEST_CASE("a contact that closes a loop stops what slides in it and holds it") {
  // A sled draws a beam whose end lies in a slot of the ground: by hand half the beam's weight
  // presses there, on the line of the slot, and mu m g/2 stops both masses.
  constexpr double mu = 0.4, v0 = 0.8, sled_mass = 1.5, m = 4.0, l = 2.0;
  for (const bool turned : {false, true}) {
    CAPTURE(turned);
    const Matrix3d frame = turned ? askew : Matrix3d(Matrix3d::Identity());
    Mechanism of;
    of.gravity = g * (frame * Vector3d(0.0, 0.0, -1.0));
    of.duration.length = 1.2;
    const int sled = add_block(of, "sled", frame, sled_mass, {}, v0);
    int carrier = sled;
    for (const char* name : {"cross", "beam"}) {
      Joint joint;
      joint.name = name;
      joint.kind = JointKind::revolute;
      joint.parent = carrier;
      joint.axis = carrier == sled ? Vector3d::UnitY() : Vector3d::UnitZ();
      joint.moved_by = MovedBy::loops;
      of.bodies.emplace_back().name = name;
      of.joints.push_back(joint);
      carrier = static_cast<int>(of.bodies.size()) - 1;
    }
    spatial::Body& beam = of.bodies.back();
    beam.mass = m;
    beam.centre = {0.5 * l, 0.0, 0.0};
    beam.inertia = Vector3d(0.1, 1.0, 1.0).asDiagonal();
    ClosingJoint slot;
    slot.name = "slot";
    slot.kind = ClosingKind::slot;
    slot.a = {ground, frame * Vector3d(l, 0.0, 0.0)};
    slot.b = {carrier, {l, 0.0, 0.0}};
    slot.axis = frame.col(0);
    slot.friction = dry(mu);
    of.closing.push_back(slot);
    const Chain chain(of);
    const double slows = 0.5 * mu * m * g / (sled_mass + m), stop = v0 / slows;
    REQUIRE(chain.forced()->slip_changes().size() == 1);
    CHECK(chain.forced()->slip_changes()[0].joint == "slot");
    CHECK(chain.forced()->slip_changes()[0].time == Approx(stop).epsilon(1e-9));
    CHECK(chain.at(0.5 * stop).friction[0] == Approx(-0.5 * mu * m * g).epsilon(1e-9));
    const State state = chain.at(1.2);
    CHECK(state.coordinates[0].value == Approx(v0 * v0 / (2.0 * slows)).epsilon(1e-9));
    CHECK(std::abs(state.coordinates[0].rate) < 1e-12);
    CHECK(std::abs(state.friction[0]) < 1e-8);
  }
}

TEST_CASE("contacts stick in space as in the plane, whatever the frame") {
  planar::Mechanism flat;
  flat.gravity = {0.0, -g};
  flat.duration.length = 1.5;
  const Mechanism upright = stacked(Matrix3d::Identity());
  for (std::size_t i = 0; i < 2; ++i) {
    boxbeam::Body& body = flat.bodies.emplace_back();
    body.name = upright.bodies[i].name;
    body.mass = upright.bodies[i].mass;
    body.inertia = 0.1 * body.mass;
    planar::Slider rail;
    rail.point = {static_cast<int>(i), {0.0, 0.0}};
    rail.guide = {static_cast<int>(i) - 1, {0.0, 0.0}};
    rail.friction = upright.joints[i].friction;
    flat.joints.push_back({body.name, rail});
    planar::Spring spring;
    spring.a = {planar::ground, {-3.0, 0.0}};
    spring.b = {static_cast<int>(i), {0.0, 0.0}};
    spring.stiffness = upright.springs[i].stiffness;
    spring.free_length = 3.0;
    flat.forces.push_back({body.name, spring});
  }
  planar::PointForce push;
  push.at = {1, {0.0, 0.0}};
  push.size = upright.loads[0].size;
  flat.forces.push_back({"push", push});
  flat.bodies[0].start_velocity = {0.4, 0.0, 0.0};
  flat.bodies[1].start_velocity = {0.4 - 0.9, 0.0, 0.0};
  planar::FreeSolver solver(flat);
  planar::State plane = solver.start(0.0, planar::sketch_of(flat), planar::start_velocity_of(flat));

  const Mechanism tilted = stacked(askew);
  const Chain chain(upright), turned_chain(tilted);
  for (const double time : {0.2, 0.5, 0.9, 1.2, 1.5}) {
    CAPTURE(time);
    plane = solver.advance(time, plane);
    for (const Chain* const each : {&chain, static_cast<const Chain*>(&turned_chain)}) {
      const State state = each->at(time);
      CHECK(state.coordinates[0].value == Approx(plane.q[0]).margin(1e-9));
      CHECK(state.coordinates[1].value == Approx(plane.q[3] - plane.q[0]).margin(1e-9));
      CHECK(state.friction[0] == Approx(plane.friction[0]).margin(1e-6));
      CHECK(state.friction[1] == Approx(plane.friction[1]).margin(1e-6));
    }
  }
  const std::vector<SlipChange>& changes = chain.forced()->slip_changes();
  REQUIRE(changes.size() == solver.slip_changes().size());
  CHECK(changes.size() > 4);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CHECK(changes[i].time == Approx(solver.slip_changes()[i].time).epsilon(1e-8));
    CHECK(changes[i].to == solver.slip_changes()[i].to);
  }
}

}  // namespace sticking_in_space_test
