// Screws: as joints of the tree against derivatives of their postures by the product rule, and as
// joints that close loops against closed forms; balances hold in both.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "catch.hpp"
#include "support/moving.hpp"
#include "support/random_tree.hpp"
#include "support/spatial_balance.hpp"

namespace screw_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::add;
using test::check_balance;
using test::closing;
using test::joint_of;
using test::set_mass;

namespace {

constexpr double full = 2.0 * std::numbers::pi;

Mechanism tree_of_screws(test::Chance& chance) {
  Mechanism tree = test::random_tree(chance, 12);
  tree.line_forces.clear();  // the balance does not know them
  for (std::size_t i = 0; i < tree.joints.size(); i += 2) {
    tree.joints[i].kind = JointKind::screw;
    tree.joints[i].lead = chance.any(1.5);
  }
  return tree;
}

/// A nut that shifts along u, and a spindle that turns about u at rest along it, in its thread.
struct NutAndSpindle {
  Mechanism mechanism;
  int nut = 0, spindle = 0;

  NutAndSpindle(const Vector3d& u, double lead, const Driver& driver, bool nut_driven) {
    Joint slide = joint_of("nut", JointKind::prismatic, ground, Vector3d::Zero(), u);
    Joint turn = joint_of("spindle", JointKind::revolute, ground, Vector3d::Zero(), u);
    (nut_driven ? slide : turn).driver = driver;
    nut = add(mechanism, slide, !nut_driven);
    spindle = add(mechanism, turn, nut_driven);
    ClosingJoint thread =
        closing("thread", ClosingKind::screw, {nut, Vector3d::Zero()}, {spindle, Vector3d::Zero()});
    thread.axis = u;
    thread.lead = lead;
    mechanism.closing.push_back(thread);
    mechanism.duration.length = 1.0;
  }
};

}  // namespace

TEST_CASE("screws of random trees turn and advance as the derivatives of their postures") {
  test::Chance chance(401);
  for (int k = 0; k < 40; ++k) {
    const Mechanism mechanism = tree_of_screws(chance);
    const Chain chain(mechanism);
    for (const double time : {0.21, 0.5, 0.83}) {
      const State state = chain.at(time);
      const auto expected = test::moving_bodies_of(mechanism, time);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto near = [](const test::Vector& exact, const Vector3d& value) {
          return (exact.cast<double>() - value).norm() <=
                 1e-11 * (1.0 + static_cast<double>(exact.norm()));
        };
        CHECK(near(expected[i].p.value, state.bodies[i].position));
        CHECK(near(expected[i].p.rate, state.bodies[i].velocity));
        CHECK(near(expected[i].p.second, state.bodies[i].acceleration));
        CHECK(near(omega_of(expected[i].R), state.bodies[i].omega));
        CHECK(near(alpha_of(expected[i].R), state.bodies[i].alpha));
      }
      check_balance(chain, time);
    }
  }
}

TEST_CASE(
    "A nut that is pushed turns its spindle by a turn per lead, right-handed or left-handed") {
  // x = -lead theta/(2 pi) of a nut, for a right-handed spindle turns into it. Power: the driver of
  // the nut bears F = (m + I (2 pi/lead)^2) x'' - f + T (2 pi/lead), T on the spindle, f on the
  // nut.
  test::Chance chance(7);
  for (const double lead : {0.005, -0.02, 0.3}) {
    const Vector3d u = chance.direction();
    const double stroke = 40.0 * std::abs(lead), omega = full;
    NutAndSpindle of(u, lead, HarmonicDriver{0.0, stroke, omega, 0.0, {}}, true);
    Mechanism& mechanism = of.mechanism;
    const double m = 3.0, inertia = 0.02, f = 70.0, T = 5.0;
    mechanism.bodies[0].mass = m;
    mechanism.bodies[1].mass = 1.0;
    mechanism.bodies[1].inertia = inertia * Matrix3d::Identity();
    mechanism.loads.push_back({"f",
                               LoadKind::force,
                               of.nut,
                               {of.nut, Vector3d::Zero()},
                               ground,
                               u,
                               PolynomialDriver{{f}}});
    mechanism.loads.push_back({"T",
                               LoadKind::couple,
                               of.spindle,
                               {of.spindle, Vector3d::Zero()},
                               ground,
                               u,
                               PolynomialDriver{{T}}});
    const Chain chain(mechanism);
    CHECK(chain.loops()->equations() == 5);
    CHECK(chain.loops()->repeating() == 4);  // both are held in line anyhow
    for (const double time : {0.0, 0.113, 0.4, 0.77, 0.951}) {
      const State state = chain.at(time);
      const double x = stroke * std::sin(omega * time);
      CHECK(state.coordinates[1].value == Approx(-full * x / lead).margin(1e-9));
      CHECK(state.coordinates[1].rate ==
            Approx(-full / lead * omega * stroke * std::cos(omega * time)).margin(1e-8));
      const double a = -omega * omega * x;
      const double drive = (m + inertia * std::pow(full / lead, 2)) * a - f + T * full / lead;
      CHECK(u.dot(chain.joint_wrenches(state)[0].force) ==
            Approx(drive).epsilon(1e-9).margin(1e-9 * T * full / std::abs(lead)));
      check_balance(chain, time);
    }
  }
}

TEST_CASE("A screw does not lose turns, however many pass between two looks") {
  // 60 turns within 1/200 of the time looked at, from rest to rest: a thread looks alike after
  // each.
  constexpr double lead = 0.01, turns = 60.0;
  const Vector3d u = Vector3d(1.0, 2.0, -0.5).normalized();
  const StepDriver step{0.0, turns * full, 0.5, 0.505};
  const NutAndSpindle by_turn(u, lead, step, false);
  const Chain chain(by_turn.mechanism);
  for (const double time : {0.9, 0.501, 0.5025, 0.505, 0.3, 1.0}) {
    const State state = chain.at(time);
    CHECK(state.coordinates[0].value ==
          Approx(-lead / full * driver_at(step, time).value).margin(1e-10));
  }
  const StepDriver push{0.0, turns * lead, 0.5, 0.505};
  const NutAndSpindle by_nut(u, lead, push, true);
  const Chain pushed(by_nut.mechanism);
  for (const double time : {0.9, 0.501, 0.5025, 0.505, 0.3, 1.0}) {
    CHECK(pushed.at(time).coordinates[1].value ==
          Approx(-full / lead * driver_at(push, time).value).margin(1e-7));
  }
  // As often as it is looked at, so that each look finds it where the one before did.
  const HarmonicDriver swing{0.0, 5.0 * full, 96.0 * full, 0.0, {}};
  const NutAndSpindle fast(u, lead, swing, false);
  const Chain swinging(fast.mechanism);
  for (const double time : {0.25 / 96.0, 0.4975, 0.73}) {
    CHECK(swinging.at(time).coordinates[0].value ==
          Approx(-lead / full * driver_at(swing, time).value).margin(1e-10));
  }
}

TEST_CASE("A force drives a screw against both inertias") {
  // a = (F + T (2 pi/lead))/(m + I (2 pi/lead)^2), and so it goes from its start.
  constexpr double lead = 0.4, m = 5.0, inertia = 0.03, F = 11.0, T = -0.2;
  const double k = full / lead;
  const double a = (F + T * k) / (m + inertia * k * k);
  const Vector3d u = Vector3d(2.0, -1.0, 0.7).normalized();
  const auto load = [&](const char* name, LoadKind kind, double size) {
    return AppliedLoad{name, kind, 0, {0, Vector3d::Zero()}, ground, u, PolynomialDriver{{size}}};
  };
  // Alone on a screw, or a shaft in the ground's thread that slides by forces and turns by loops.
  Mechanism alone;
  Joint joint = joint_of("screw", JointKind::screw, ground, {0.1, 0.2, 0.3}, u);
  joint.lead = lead;
  joint.start = 0.4;
  joint.start_rate = 2.0;
  add(alone, joint, false);
  alone.joints[0].moved_by = MovedBy::forces;
  Mechanism loop;
  joint.kind = JointKind::prismatic;
  joint.start = 0.4 / k;
  joint.start_rate = 2.0 / k;
  add(loop, joint, false);
  loop.joints[0].moved_by = MovedBy::forces;
  const int shaft = add(loop, joint_of("turn", JointKind::revolute, 0, Vector3d::Zero(), u), true);
  ClosingJoint thread =
      closing("thread", ClosingKind::screw, {ground, {0.1, 0.2, 0.3}}, {shaft, Vector3d::Zero()});
  thread.axis = u;
  thread.lead = lead;
  loop.closing.push_back(thread);
  for (Mechanism* of : {&alone, &loop}) {
    of->bodies.back().mass = m;
    of->bodies.back().inertia = inertia * Matrix3d::Identity();
    of->duration.length = 2.0;
    of->loads = {load("F", LoadKind::force, F), load("T", LoadKind::couple, T)};
    for (AppliedLoad& each : of->loads)
      each.on = each.at.body = static_cast<int>(of->bodies.size()) - 1;
    const Chain chain(*of);
    const double scale = of == &alone ? k : 1.0;  // its coordinate is the angle
    for (const double time : {0.0, 0.7, 1.3, 2.0}) {
      const State state = chain.at(time);
      const double x = (0.4 + 2.0 * time) / k + 0.5 * a * time * time;
      CHECK(state.coordinates[0].value == Approx(scale * x).epsilon(1e-9));
      CHECK(state.coordinates[0].acceleration == Approx(scale * a).epsilon(1e-9));
      CHECK((state.bodies.back().omega - k * (2.0 / k + a * time) * u).norm() < 1e-8);
      check_balance(chain, time);
    }
  }
}

TEST_CASE("A screw jack luffs a boom by the law of cosines") {
  // Foot hinge at F, boom hinge at O, the rod's end on the boom at r: |rod| = L + lead q/(2 pi).
  constexpr double lead = 0.05, r = 1.2, foot = 0.9, L = 1.1;
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -9.81};
  const int boom = add(
      mechanism,
      joint_of("boom", JointKind::revolute, ground, Vector3d::Zero(), -Vector3d::UnitY()), true);
  mechanism.joints.back().start = 0.4;
  const int tube = add(
      mechanism,
      joint_of("foot", JointKind::revolute, ground, {0.0, 0.0, -foot}, -Vector3d::UnitY()), true);
  mechanism.joints.back().start = 0.9;
  Joint screw = joint_of("screw", JointKind::screw, tube, {L, 0.0, 0.0}, Vector3d::UnitX());
  screw.lead = lead;
  screw.driver = HarmonicDriver{0.0, 5.0 * full, 2.0, 0.0, {}};
  const int rod = add(mechanism, screw, false);
  mechanism.closing.push_back(
      closing("eye", ClosingKind::spherical, {boom, {r, 0.0, 0.0}}, {rod, Vector3d::Zero()}));
  set_mass(mechanism.bodies[0], 50.0, {0.7, 0.0, 0.1}, {1.0, 5.0, 5.5});
  set_mass(mechanism.bodies[1], 5.0, {0.3, 0.0, 0.0}, {0.1, 0.4, 0.4});
  set_mass(mechanism.bodies[2], 4.0, {-0.4, 0.01, 0.0}, {0.02, 0.3, 0.3});
  mechanism.duration.length = 3.0;
  const Chain chain(mechanism);
  CHECK(chain.loops()->equations() == 3);
  CHECK(chain.loops()->freedoms() == 2);
  for (int i = 0; i <= 20; ++i) {
    const State state = chain.at(0.15 * i);
    const double length = L + lead / full * state.coordinates[2].value;
    // Boom at angle p above x: (r cos p, r sin p) to (0, -foot).
    const double p = state.coordinates[0].value;
    CHECK(r * r + foot * foot + 2.0 * r * foot * std::sin(p) ==
          Approx(length * length).epsilon(1e-11));
    check_balance(chain, 0.15 * i);
  }
}

TEST_CASE("A screw in a turned world does the same") {
  test::Chance chance(55);
  const Vector3d u = Vector3d::UnitZ();
  const HarmonicDriver driver{0.1, 0.3, 4.0, 0.2, {}};
  const auto made = [&](const Matrix3d& R) {
    NutAndSpindle of(R * u, 0.04, driver, true);
    of.mechanism.gravity = R * Vector3d(1.0, 2.0, -9.0);
    set_mass(of.mechanism.bodies[0], 2.0, R * Vector3d(0.1, 0.0, 0.2), {0.1, 0.1, 0.1});
    set_mass(of.mechanism.bodies[1], 3.0, R * Vector3d(0.0, 0.02, -0.2), {0.2, 0.2, 0.2});
    return of.mechanism;
  };
  const Mechanism straight = made(Matrix3d::Identity());
  const Chain chain(straight);
  for (int k = 0; k < 5; ++k) {
    const Matrix3d R = chance.rotation();
    const Mechanism turned = made(R);
    const Chain other(turned);
    for (const double time : {0.1, 0.6}) {
      const auto a = chain.joint_wrenches(chain.at(time)), b = other.joint_wrenches(other.at(time));
      // Of what does not follow from the thread alone the axial force does, however others share.
      const double along = u.dot(a[2].force), size = std::abs(along);
      CHECK(std::abs((R * u).dot(b[2].force) - along) < 1e-9 * size);
      CHECK(std::abs((R * u).dot(b[0].force) - u.dot(a[0].force)) < 1e-9 * size);
    }
  }
}

}  // namespace screw_test
