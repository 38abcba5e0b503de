// Vibration of a beam that swings in the plane, or stands, as forces decide, against pendulums of
// rigid bodies and Euler's column.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/elastic_motion.hpp"
#include "catch.hpp"
#include "support/apart.hpp"
#include "support/slender_beam.hpp"

namespace swinging_in_plane_test {

using namespace boxbeam;
using namespace test::apart;
using Eigen::Vector2d;

namespace {

using test::slender::Beam;
using test::slender::L;

constexpr double g = 9.81, pi = std::numbers::pi;

/// What carries a hub: a hinge of the ground, the end of a rod that hangs itself, or a hinge of the
/// ground while the hub is the rocker of a four-bar with a crank and a coupler.
enum class Carried { by_hinge, by_rod, in_loop };

/// A beam that hangs from a hub, and a couple on the hub that comes once. `hinged`: the beam turns
/// on the hub against a spring.
struct Pendulum {
  double spring = 5e6;  ///< [N m/rad]
  double couple = 2e4;  ///< [N m]
  Carried carried = Carried::by_hinge;
  double holding = 0.0;  ///< of a spring between the hub and the rod [N m/rad]
  double turn = 0.0;     ///< of all of it and of its weight [rad]
  static constexpr double rod = 3.0;

  Beam made(bool hinged) const {
    Beam of;
    const Eigen::Rotation2Dd about(turn);
    of.mechanism.gravity = about * Vector2d(0.0, -g);
    const double hangs = turn - 0.5 * pi;
    const Vector2d hinge =
        carried == Carried::by_rod ? Vector2d(about * Vector2d(0.0, -rod)) : Vector2d(0.0, 0.0);
    Body& beam = of.mechanism.bodies.front();
    beam.sketch.centre = hinge + about * Vector2d(0.0, -0.5 * L);
    beam.sketch.angle = hangs;
    Body hub;
    hub.name = "hub";
    hub.mass = 40.0;
    hub.inertia = 500.0;
    hub.sketch.centre = hinge;
    hub.sketch.angle = hangs;
    of.mechanism.bodies.push_back(hub);
    if (carried == Carried::by_rod) {
      Body carrying;
      carrying.name = "rod";
      carrying.mass = 200.0;
      carrying.inertia = 150.0;
      carrying.sketch.centre = 0.5 * hinge;
      carrying.sketch.angle = hangs;
      of.mechanism.bodies.push_back(carrying);
      of.mechanism.joints.push_back({"top", planar::Pin{{2, {-0.5 * rod, 0.0}}, {}}});
      of.mechanism.joints.push_back({"hinge", planar::Pin{{1, {0.0, 0.0}}, {2, {0.5 * rod, 0.0}}}});
    } else {
      of.mechanism.joints.push_back({"hinge", planar::Pin{{1, {0.0, 0.0}}, {}}});
    }
    if (carried == Carried::in_loop) {
      // From the hub's top over the coupler to the top of a crank of 1.2 m beside it.
      const Vector2d top(0.0, 1.0), foot(2.0, 0.0), end(2.0, 1.2);
      const auto bar = [&](const std::string& name, double mass, const Vector2d& from,
                           const Vector2d& to) {
        const Vector2d line = to - from;
        Body body;
        body.name = name;
        body.mass = mass;
        body.inertia = mass * line.squaredNorm() / 12.0;
        body.sketch.centre = about * (0.5 * (from + to));
        body.sketch.angle = turn + std::atan2(line.y(), line.x());
        of.mechanism.bodies.push_back(body);
        const double half = 0.5 * line.norm();
        const auto index = static_cast<int>(of.mechanism.bodies.size()) - 1;
        return std::pair(planar::Attachment{index, {-half, 0.0}},
                         planar::Attachment{index, {half, 0.0}});
      };
      const auto [crank_foot, crank_end] = bar("crank", 300.0, foot, end);
      const auto [coupler_top, coupler_end] = bar("coupler", 200.0, top, end);
      of.mechanism.joints.push_back(
          {"foot", planar::Pin{crank_foot, {planar::ground, about * foot}}});
      of.mechanism.joints.push_back({"top", planar::Pin{coupler_top, {1, {-1.0, 0.0}}}});
      of.mechanism.joints.push_back({"end", planar::Pin{coupler_end, crank_end}});
    }
    const planar::Attachment at_hub{1, {0.0, 0.0}};
    if (holding > 0.0) {
      planar::TorsionSpring slow;
      slow.a = at_hub;
      slow.b = {2, {0.5 * rod, 0.0}};
      slow.stiffness = holding;
      of.mechanism.forces.push_back({"holding", slow});
    }
    if (hinged) {
      of.mechanism.joints.push_back({"root", planar::Pin{of.start(), at_hub}});
      planar::TorsionSpring between;
      between.a = of.start();
      between.b = at_hub;
      between.stiffness = spring;
      of.mechanism.forces.push_back({"between", between});
    } else {
      of.mechanism.joints.push_back({"root", planar::Rigid{of.start(), at_hub}});
    }
    planar::Couple turning;
    turning.a = at_hub;
    turning.size = TableDriver{TableCurve({0.0, 0.1, 0.15, 1.0, 1.05, 3.0},
                                          {0.0, 0.0, couple, couple, 0.0, 0.0},
                                          Interpolation::linear, Beyond::hold)};
    of.mechanism.forces.push_back({"turning", turning});
    of.mechanism.duration.length = 2.0;
    of.solve(768);
    return of;
  }

  /// Of a beam far stiffer than its root, which gives way.
  ElasticMotion elastic(const Beam& of) const {
    constexpr double stiff = 1e6;
    ElasticBody body = of.elastic(stiff * test::slender::E, stiff * test::slender::G);
    planar::ElasticJoint root;
    root.joint = planar::joint_index(of.mechanism, "root");
    root.turning_stiffness = spring;
    body.joints = {root};
    return {of.rigid(), body, 1};
  }
};

/// From the pendulum whose root turns, which knows no small motions.
Apart apart_from_pendulum(const Pendulum& pendulum) {
  const Beam rigid = pendulum.made(false), hinged = pendulum.made(true);
  const ElasticMotion elastic = pendulum.elastic(rigid);
  Apart apart;
  double turned = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const Time time = si<Time>(2.0 * i / 400.0);
    const BeamLoads expected = hinged.rigid().loads(time), found = elastic.loads_at(time),
                    stiff = rigid.rigid().loads(time);
    CHECK(unbalanced(found, L, 1e3) < 1e-9);
    for (const double s : {0.0, 0.4 * L})
      apart.add(bending(expected, s), bending(found, s), bending(stiff, s));
    turned = std::max(turned, std::abs(rigid.finder->at(time.value()).v[2]));
  }
  // It turns far, and fast enough that what turning adds counts.
  CHECK(turned > 1.0);
  return apart;
}

}  // namespace

TEST_CASE("a root that gives way turns as a pendulum of two bodies does",
          "[elastic_by_forces_in_plane]") {
  std::vector<Pendulum> pendulums(4);
  pendulums[1].carried = pendulums[2].carried = Carried::by_rod;
  pendulums[2].holding = 2e4;
  pendulums[3].carried = Carried::in_loop;
  for (const Pendulum& pendulum : pendulums) {
    const Apart soft = apart_from_pendulum(pendulum);
    INFO("carried " << static_cast<int>(pendulum.carried) << ", held by " << pendulum.holding
                    << ", largest " << soft.largest << ", apart " << soft.found
                    << ", of rigid bodies " << soft.rigid);
    CHECK(soft.found < 3e-3 * soft.largest);
    CHECK(soft.rigid > 0.15 * soft.largest);
  }
}

TEST_CASE("a turned pendulum has the same loads", "[elastic_by_forces_in_plane]") {
  Pendulum straight, turned;
  turned.turn = 0.7;
  const Beam one = straight.made(false), other = turned.made(false);
  const ElasticMotion elastic = straight.elastic(one), elsewhere = turned.elastic(other);
  double largest = 0.0, apart = 0.0;
  for (int i = 0; i <= 50; ++i) {
    const Time time = si<Time>(2.0 * i / 50.0);
    const double moment = bending(elastic.loads_at(time), 0.0);
    largest = std::max(largest, std::abs(moment));
    apart = std::max(apart, std::abs(bending(elsewhere.loads_at(time), 0.0) - moment));
  }
  CHECK(apart < 1e-5 * largest);
}

// A column of 12 m on a spring, its foot guided, under a mass of 1.5 times pi^2 E I/(4 L^2).
TEST_CASE("a column that forces move and that buckles is refused by its name",
          "[elastic_by_forces_in_plane]") {
  for (const bool buckles : {true, false}) {
    Beam of;
    const double critical = pi * pi * test::slender::E * test::slender::I / (4.0 * L * L);
    Body& beam = of.mechanism.bodies.front();
    beam.sketch.centre = {0.0, 0.5 * L};
    beam.sketch.angle = 0.5 * pi;
    Body top;
    top.name = "top";
    top.mass = (buckles ? 1.5 : 0.2) * critical / g;
    top.inertia = 1.0;
    top.sketch.centre = {0.0, L};
    of.mechanism.bodies.push_back(top);
    planar::Slider foot;
    foot.point = of.start();
    foot.direction = 0.5 * pi;
    foot.angle = 0.5 * pi;
    planar::Spring below;
    below.a = of.start();
    below.b = {planar::ground, {0.0, -1.0}};
    below.free_length = 1.0;
    below.stiffness = 1e6;
    of.mechanism.gravity = {0.0, -g};
    of.mechanism.joints = {
        {"foot", foot}, {"head", planar::Rigid{{1, {0.0, 0.0}}, {0, {0.5 * L, 0.0}}, -0.5 * pi}}};
    of.mechanism.forces = {{"below", below}};
    of.mechanism.duration.length = 0.2;
    of.solve(96);
    if (buckles)
      CHECK_THROWS_WITH(ElasticMotion(of.rigid(), of.elastic(), 2), Catch::Contains("buckles"));
    else
      CHECK_NOTHROW(ElasticMotion(of.rigid(), of.elastic(), 2));
  }
}

}  // namespace swinging_in_plane_test
