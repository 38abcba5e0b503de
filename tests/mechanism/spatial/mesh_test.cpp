// Gears and racks in space against hand formulas: Willis' of epicyclic trains, textbook forces of
// spur and bevel gears, differentials; and against balances that hold in every mechanism.

#include "boxbeam/mechanism/spatial/mesh.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/random_tree.hpp"
#include "support/spatial_balance.hpp"

namespace mesh_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::add;
using test::check_balance;
using test::joint_of;
using test::set_mass;

namespace {

constexpr double degree = std::numbers::pi / 180.0, pressure = 20.0 * degree;
const double tan_20 = std::tan(pressure);

std::size_t index(int body) { return static_cast<std::size_t>(body); }

void add_gear(Mechanism& mechanism, const char* name, int first, int second, double ratio,
              std::optional<Attachment> at = {}) {
  const MeshFound found =
      mesh_of(mechanism, {index(first), index(second), ratio, 0.0, pressure, at});
  INFO(found.problem);
  REQUIRE(found.mesh);
  ClosingJoint joint;
  joint.name = name;
  joint.kind = mechanism.joints[index(second)].kind == JointKind::prismatic ? ClosingKind::rack
                                                                            : ClosingKind::gear;
  joint.a = {first, mechanism.joints[index(first)].point};
  joint.b = {second, mechanism.joints[index(second)].point};
  joint.mesh = *found.mesh;
  mechanism.closing.push_back(joint);
}

void add_couple(Mechanism& mechanism, int on, const Vector3d& axis, double size) {
  mechanism.loads.push_back({"couple",
                             LoadKind::couple,
                             on,
                             {on, Vector3d::Zero()},
                             ground,
                             axis,
                             PolynomialDriver{{size}}});
}

/// Any centre and tensor for each body.
void add_masses(Mechanism& mechanism, test::Chance& chance) {
  for (spatial::Body& body : mechanism.bodies) {
    body.mass = 3.0 + chance.any(2.0);
    body.centre = chance.vector(0.1);
    body.inertia = chance.inertia(body.mass, 0.3);
  }
}

double moment_along(const Chain& chain, const State& state, int joint) {
  const Joint& of = chain.mechanism().joints[index(joint)];
  return in_world(state, of.parent, of.axis).dot(chain.joint_wrenches(state)[index(joint)].moment);
}

/// Sun and annulus of radii s and s + 2 p about z of a base, a carrier there too, and planets of
/// radius p on it.
struct Epicyclic {
  static constexpr double s = 0.12, p = 0.05, ring_radius = s + 2.0 * p;
  Mechanism mechanism;
  int sun = 0, ring = 0, carrier = 0;

  Epicyclic(int base, int planets, Mechanism start = {}) : mechanism(std::move(start)) {
    const auto central = [&](const char* name, const Driver& driver, bool free) {
      Joint joint = joint_of(name, JointKind::revolute, base, Vector3d::Zero(), Vector3d::UnitZ());
      joint.driver = driver;
      return add(mechanism, joint, free);
    };
    sun = central("sun", HarmonicDriver{0.3, 2.0, 3.0, 0.1, {}}, false);
    ring = central("ring", HarmonicDriver{0.0, 0.7, 2.0, 0.0, {}}, false);
    carrier = central("carrier", {}, true);
    for (int k = 0; k < planets; ++k) {
      const double at = 2.0 * std::numbers::pi * k / planets;
      Joint joint =
          joint_of("planet", JointKind::revolute, carrier,
                   (s + p) * Vector3d(std::cos(at), std::sin(at), 0.0), Vector3d::UnitZ());
      joint.name += std::to_string(k);
      const int planet = add(mechanism, joint, true);
      add_gear(mechanism, "sun gear", sun, planet, -s / p);
      add_gear(mechanism, "annulus", ring, planet, ring_radius / p);
    }
    mechanism.duration.length = 2.0;
  }
};

}  // namespace

TEST_CASE(
    "Spur gears turn by their radii and push by their torque, and apart by the pressure angle") {
  // Wheels of 0.1 m and 0.2 m about z, 30 N m on the first: F = T/r = 300 N where they meet.
  for (const double sense : {1.0, -1.0}) {  // of the second one's axis
    Mechanism mechanism;
    const int one = add(
        mechanism,
        joint_of("one", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitZ()), true);
    Joint held =
        joint_of("two", JointKind::revolute, ground, {0.3, 0.0, 0.0}, sense * Vector3d::UnitZ());
    held.driver = HarmonicDriver{0.0, 0.8, 2.0, 0.0, {}};
    const int two = add(mechanism, held, false);
    add_gear(mechanism, "teeth", one, two, -0.5 * sense);
    mechanism.duration.length = 2.0;
    for (const double torque : {30.0, -30.0}) {
      mechanism.loads.clear();
      add_couple(mechanism, one, Vector3d::UnitZ(), torque);
      const Chain chain(mechanism);
      CHECK(chain.loops()->equations() == 1);
      CHECK(chain.loops()->repeating() == 0);
      for (const double time : {0.0, 0.4, 1.7}) {
        const State state = chain.at(time);
        CHECK(state.coordinates[0].value ==
              Approx(-2.0 * sense * state.coordinates[1].value).margin(1e-12));
        const std::vector<Wrench> joints = chain.joint_wrenches(state);
        CHECK(
            (position_of(state, place_of(mechanism.closing[0])) - Vector3d(0.1, 0.0, 0.0)).norm() <
            1e-15);
        // On the second wheel; the bearing of the first bears the same.
        const Vector3d push(300.0 * tan_20, torque / 0.1, 0.0);
        CHECK((joints[2].force - push).norm() < 1e-9);
        CHECK(joints[2].moment.norm() == 0.0);
        CHECK((joints[0].force - push).norm() < 1e-9);
        CHECK((joints[1].force + push).norm() < 1e-9);
        CHECK(joints[1].moment.z() == Approx(2.0 * torque));
        check_balance(chain, time);
      }
    }
  }
}

TEST_CASE("An epicyclic train follows Willis, its torques too") {
  // (w_sun - w_c)/(w_ring - w_c) = -z_ring/z_sun, and T_sun : T_ring : T_c = 1 : R : -(1 + R) with
  // R = z_ring/z_sun, where nothing is accelerated: bodies without mass. Source: Willis, Principles
  // of Mechanism (1841).
  Epicyclic train(ground, 1);
  constexpr double R = Epicyclic::ring_radius / Epicyclic::s, T = 55.0;
  add_couple(train.mechanism, train.carrier, Vector3d::UnitZ(), T);
  const Chain chain(train.mechanism);
  CHECK(chain.loops()->freedoms() == 2);
  CHECK(chain.loops()->repeating() == 0);
  for (int i = 0; i <= 10; ++i) {
    const State state = chain.at(0.2 * i);
    const auto rate = [&](int body) { return state.coordinates[index(body)].rate; };
    const auto turn = [&](int body) { return state.coordinates[index(body)].value; };
    const double carrier = rate(train.carrier);
    CHECK(rate(train.sun) - carrier == Approx(-R * (rate(train.ring) - carrier)).margin(1e-11));
    CHECK(turn(train.sun) + R * turn(train.ring) ==
          Approx((1.0 + R) * turn(train.carrier)).margin(1e-11));
    CHECK(state.bodies[3].omega.z() - carrier ==
          Approx(-Epicyclic::s / Epicyclic::p * (rate(train.sun) - carrier)).margin(1e-11));
    // What the drivers bear against the couple on the carrier.
    CHECK(moment_along(chain, state, train.sun) == Approx(-T / (1.0 + R)).epsilon(1e-11));
    CHECK(moment_along(chain, state, train.ring) == Approx(-R * T / (1.0 + R)).epsilon(1e-11));
    check_balance(chain, 0.2 * i);
    // Both teeth push the planet one way, each with half of the couple over the carrier's arm; the
    // pressure angle pushes it towards its own axis from both sides: its bearing bears none of it.
    const std::vector<Wrench> joints = chain.joint_wrenches(state);
    const double F = 0.5 * T / (Epicyclic::s + Epicyclic::p);
    CHECK(joints[3].force.norm() == Approx(2.0 * F).epsilon(1e-11));
    for (const std::size_t teeth : {4, 5}) {
      CHECK(joints[teeth].force.norm() == Approx(F / std::cos(pressure)).epsilon(1e-11));
      const Vector3d place = position_of(state, place_of(train.mechanism.closing[teeth - 4]));
      const Vector3d inwards = (state.bodies[3].position - place).normalized();
      CHECK(inwards.dot(joints[teeth].force) == Approx(F * tan_20).epsilon(1e-11));
    }
  }
}

TEST_CASE("Further planets repeat an equation each, and share what they carry") {
  const Epicyclic train(ground, 3);
  const Chain chain(train.mechanism);
  CHECK(chain.loops()->equations() == 6);
  CHECK(chain.loops()->freedoms() == 4);
  CHECK(chain.loops()->repeating() == 2);
  CHECK(names_not_unique(train.mechanism, *chain.loops()).size() >= 6 + 3);
  check_balance(chain, 0.4);
}

TEST_CASE("A train on a base that moves keeps balance of forces, moments and power") {
  test::Chance chance(88);
  for (int k = 0; k < 12; ++k) {
    Mechanism base;
    base.gravity = chance.vector(10.0);
    Joint turn = joint_of("turn", JointKind::revolute, ground, chance.vector(), chance.direction());
    turn.turn = chance.rotation();
    turn.driver = HarmonicDriver{0.2, 0.9, 2.5, 0.4, {}};
    const int first = add(base, turn, false);
    Joint slide =
        joint_of("slide", JointKind::prismatic, first, chance.vector(), chance.direction());
    slide.turn = chance.rotation();
    slide.driver = HarmonicDriver{0.1, 0.3, 3.5, 0.0, {}};
    const int second = add(base, slide, false);
    Epicyclic train(second, 1, base);
    Mechanism& mechanism = train.mechanism;
    add_masses(mechanism, chance);
    add_couple(mechanism, train.carrier, chance.direction(), 20.0);
    INFO("case " << k);
    const Chain chain(mechanism);
    for (const double time : {0.2, 0.9, 1.6}) check_balance(chain, time);
    // By forces in place of the sun's driver.
    mechanism.joints[index(train.sun)].moved_by = MovedBy::forces;
    mechanism.joints[index(train.sun)].start = 0.3;
    mechanism.duration.length = 0.3;
    const Chain forced(mechanism);
    for (const double time : {0.0, 0.1, 0.29}) check_balance(forced, time, 1e-9);
  }
}

TEST_CASE("Forces drive a gear pair against both inertias, and a pinion its rack") {
  // q'' = T/(I_1 + I_2 i^2), i the ratio; of a rack T/(I + m r^2).
  constexpr double T = 3.0, I_1 = 0.2, I_2 = 0.9, ratio = -0.4, r = 0.06, m = 7.0;
  for (const bool rack : {false, true}) {
    Mechanism mechanism;
    const int one = add(
        mechanism,
        joint_of("one", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitZ()), false);
    mechanism.joints[0].moved_by = MovedBy::forces;
    const int two = add(mechanism,
                        joint_of("two", rack ? JointKind::prismatic : JointKind::revolute, ground,
                                 {0.5, 0.0, 0.0}, rack ? Vector3d::UnitX() : Vector3d::UnitZ()),
                        true);
    add_gear(mechanism, "teeth", one, two, rack ? r : ratio);
    mechanism.bodies[0].mass = 1.0;
    mechanism.bodies[0].inertia = I_1 * Matrix3d::Identity();
    mechanism.bodies[1].mass = m;
    mechanism.bodies[1].inertia = I_2 * Matrix3d::Identity();
    add_couple(mechanism, one, Vector3d::UnitZ(), T);
    mechanism.duration.length = 2.0;
    const double a = T / (I_1 + (rack ? m * r * r : I_2 * ratio * ratio));
    const Chain chain(mechanism);
    for (const double time : {0.0, 0.9, 2.0}) {
      const State state = chain.at(time);
      CHECK(state.coordinates[0].value == Approx(0.5 * a * time * time).epsilon(1e-9));
      CHECK(state.coordinates[1].acceleration == Approx((rack ? r : ratio) * a).epsilon(1e-9));
      const Wrench teeth = chain.joint_wrenches(state)[2];
      if (rack) {
        // On the rack below the pinion, along it and away from it.
        CHECK((teeth.force - m * r * a * Vector3d(1.0, -tan_20, 0.0)).norm() < 1e-9);
        CHECK((position_of(state, place_of(mechanism.closing[0])) - Vector3d(0.0, -r, 0.0)).norm() <
              1e-15);
      }
      check_balance(chain, time);
    }
  }
}

TEST_CASE(
    "Teeth press a rack onto its guide, which rubs by their push, whichever way they drive it") {
  // F = m a + s mu |F| tan 20, s the sense of the velocity: F = m a/(1 - s sgn(a) mu tan 20).
  constexpr double r = 0.06, m = 7.0, mu = 0.3;
  for (const double turning : {-40.0, 40.0}) {
    Mechanism mechanism;
    const int one = add(
        mechanism,
        joint_of("one", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitZ()), false);
    // It turns back after half of the time.
    mechanism.joints[0].driver = PolynomialDriver{{0.0, -0.5 * turning, 0.5 * turning}};
    const int two = add(
        mechanism,
        joint_of("two", JointKind::prismatic, ground, {0.5, 0.0, 0.0}, Vector3d::UnitX()), true);
    mechanism.joints[1].friction.coulomb = mu;
    mechanism.joints[1].friction.creep = 1e-7;
    add_gear(mechanism, "teeth", one, two, r);
    mechanism.bodies[1].mass = m;
    mechanism.duration.length = 1.0;
    const Chain chain(mechanism);
    for (const double time : {0.0, 0.2, 0.4, 0.6, 0.9}) {
      const State state = chain.at(time);
      const double a = r * turning, v = a * (time - 0.5);
      const double along = m * a / (1.0 - std::copysign(1.0, v * a) * mu * tan_20);
      const Wrench teeth = chain.joint_wrenches(state)[2];
      CHECK(teeth.force.x() == Approx(along).epsilon(1e-9));
      CHECK(teeth.force.y() == Approx(-std::abs(along) * tan_20).epsilon(1e-9));
      CHECK(state.friction[0] == Approx(-std::copysign(mu * tan_20 * along, v)).epsilon(1e-9));
      check_balance(chain, time);
    }
    // Without drivers it would have to be solved with the accelerations.
    mechanism.joints[0].moved_by = MovedBy::forces;
    CHECK_THROWS_AS(Chain(mechanism), AnalysisError);
  }
}

namespace {

/// A cage about x with a pinion about y on it between two side gears about x, all of radius r.
struct Differential {
  static constexpr double r = 0.08;
  Mechanism mechanism;
  int cage = 0, left = 0, right = 0, pinion = 0;

  explicit Differential(const Matrix3d& R) {
    const auto about_x = [&](const char* name, const Driver& driver, bool free) {
      Joint joint = joint_of(name, JointKind::revolute, ground, R * Vector3d(0.1, 0.2, 0.3),
                             R * Vector3d::UnitX());
      joint.turn = R;
      joint.driver = driver;
      return add(mechanism, joint, free);
    };
    cage = about_x("cage", HarmonicDriver{0.2, 1.0, 2.0, 0.0, {}}, false);
    left = about_x("left", {}, true);
    right = about_x("right", HarmonicDriver{0.0, 0.6, 3.0, 0.5, {}}, false);
    pinion = add(mechanism,
                 joint_of("pinion", JointKind::revolute, cage, Vector3d::Zero(), Vector3d::UnitY()),
                 true);
    add_gear(mechanism, "left mesh", left, pinion, 1.0, Attachment{cage, {-r, r, 0.0}});
    add_gear(mechanism, "right mesh", right, pinion, -1.0, Attachment{cage, {r, r, 0.0}});
    mechanism.duration.length = 2.0;
  }
};

}  // namespace

TEST_CASE("A bevel differential halves turns and torques") {
  Differential of(Matrix3d::Identity());
  constexpr double T = 40.0;
  add_couple(of.mechanism, of.left, Vector3d::UnitX(), T);
  const Chain chain(of.mechanism);
  for (int i = 0; i <= 8; ++i) {
    const State state = chain.at(0.25 * i);
    const auto turn = [&](int body) { return state.coordinates[index(body)].value; };
    CHECK(turn(of.left) + turn(of.right) == Approx(2.0 * turn(of.cage)).margin(1e-12));
    // What the drivers bear: the right side as much as the left, the cage both.
    CHECK(moment_along(chain, state, of.right) == Approx(T).epsilon(1e-11));
    CHECK(moment_along(chain, state, of.cage) == Approx(-2.0 * T).epsilon(1e-11));
    check_balance(chain, 0.25 * i);
    // Of straight bevel gears with delta = 45 deg: F = T/r, radial F tan cos(delta), axial F tan
    // sin(delta), the wheel pushed away from the apex. Source: Shigley, chapter 13.
    const std::vector<Wrench> joints = chain.joint_wrenches(state);
    const Vector3d on_side = in_axes(state, of.cage, -joints[4].force);
    const double F = T / Differential::r;
    CHECK(std::abs(on_side.z()) == Approx(F).epsilon(1e-11));
    CHECK(on_side.x() == Approx(-F * tan_20 * std::sqrt(0.5)).epsilon(1e-11));
    CHECK(on_side.y() == Approx(-F * tan_20 * std::sqrt(0.5)).epsilon(1e-11));
  }
}

TEST_CASE("A differential with masses in a turned world does the same, in balance") {
  const auto made = [](const Matrix3d& R) {
    Differential of(R);
    test::Chance same(5);
    add_masses(of.mechanism, same);
    add_couple(of.mechanism, of.left, R * Vector3d(0.6, 0.0, 0.8), 40.0);
    of.mechanism.gravity = R * Vector3d(1.0, -9.0, 2.0);
    return of.mechanism;
  };
  const Mechanism straight = made(Matrix3d::Identity());
  const Chain chain(straight);
  test::Chance chance(6);
  for (int k = 0; k < 6; ++k) {
    const Matrix3d R = chance.rotation();
    const Mechanism turned = made(R);
    const Chain other(turned);
    for (const double time : {0.3, 1.4}) {
      const auto a = chain.joint_wrenches(chain.at(time)), b = other.joint_wrenches(other.at(time));
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK((R * a[i].force - b[i].force).norm() < 1e-9 * (1.0 + a[i].force.norm()));
        CHECK((R * a[i].moment - b[i].moment).norm() < 1e-9 * (1.0 + a[i].moment.norm()));
      }
      check_balance(other, time);
    }
  }
}

TEST_CASE("Two wheels of one shaft mesh where the case says") {
  // A wheel of 0.2 m at z = 0 and a pinion of 0.05 m at z = 0.4 on one shaft: each by itself.
  Mechanism mechanism;
  const auto shaft = [&](const char* name, const Vector3d& at, bool free) {
    return add(mechanism, joint_of(name, JointKind::revolute, ground, at, Vector3d::UnitZ()), free);
  };
  const int in = shaft("in", {-0.3, 0.0, 0.0}, true);
  const int middle = shaft("middle", Vector3d::Zero(), true);
  const int out = shaft("out", {0.2, 0.0, 0.4}, false);
  add_gear(mechanism, "fast", in, middle, -0.5);
  add_gear(mechanism, "slow", middle, out, -1.0 / 3.0, Attachment{ground, {0.05, 0.0, 0.4}});
  add_couple(mechanism, in, Vector3d::UnitZ(), 10.0);
  const Chain chain(mechanism);
  const State state = chain.at(0.0);
  CHECK(moment_along(chain, state, out) == Approx(-60.0));
  const std::vector<Wrench> joints = chain.joint_wrenches(state);
  // The bearing of the middle shaft: 100 N at z = 0 and 20 N m/0.05 m at z = 0.4.
  CHECK(joints[3].force.y() == Approx(100.0));
  CHECK(joints[4].force.y() == Approx(-400.0));
  CHECK(joints[1].force.y() == Approx(-100.0 - 400.0));
  CHECK(joints[1].moment.x() == Approx(400.0 * 0.4));
  check_balance(chain, 0.0);

  // That shaft as the verified beam: both forces stand at their places while it turns.
  TaperedBeam beam;
  const Section tube{RoundTube{si<Length>(0.04), si<Length>(0.005)}, {}};
  beam.segments = {{"", {}, si<Length>(0.5), tube, tube}};
  BeamPlacement placement;
  placement.body = middle;
  placement.axes << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  const BeamBody body = beam_body_of(beam, placement, mechanism);
  mechanism.joints[index(out)].driver = RateDriver{0.0, 1.0};
  mechanism.duration.length = 5.0;
  const Chain turning(mechanism);
  for (const double time : {0.0, 1.1, 3.7}) {
    const BeamLoads loads = beam_loads_of(turning, turning.at(time), body);
    REQUIRE(loads.points.size() == 3);
    CHECK(loads.points[1].name == "fast");
    CHECK(loads.points[1].s.value() == 0.0);
    CHECK(loads.points[1].moment.x() == Approx(-20.0));  // what the wheel puts into the shaft
    CHECK(loads.points[2].s.value() == Approx(0.4).epsilon(1e-15));
    CHECK(loads.points[2].moment.x() == Approx(20.0));
    CHECK(loads.points[2].force.norm() == Approx(400.0 / std::cos(pressure)));
    CHECK(std::find(body.places.begin(), body.places.end(), loads.points[2].s) !=
          body.places.end());
  }
}

TEST_CASE("What cannot mesh says why", "[bad_input]") {
  Mechanism mechanism;
  const auto joint = [&](const char* name, JointKind kind, int parent, const Vector3d& at,
                         const Vector3d& axis) {
    return index(add(mechanism, joint_of(name, kind, parent, at, axis), true));
  };
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ(), o = Vector3d::Zero();
  const std::size_t wheel = joint("wheel", JointKind::revolute, ground, o, z);
  const std::size_t beside = joint("beside", JointKind::revolute, ground, {0.3, 0.0, 0.0}, z);
  const std::size_t in_line = joint("in line", JointKind::revolute, ground, {0.0, 0.0, 0.2}, z);
  const std::size_t above = joint("above", JointKind::revolute, ground, {0.3, 0.0, 0.1}, z);
  const std::size_t crossed = joint("crossed", JointKind::revolute, ground, {0.0, 0.3, 0.0}, x);
  const std::size_t bevel = joint("bevel", JointKind::revolute, ground, o, x);
  const std::size_t plate = joint("plate", JointKind::fixed, ground, o, z);
  const std::size_t rack = joint("rack", JointKind::prismatic, ground, o, x);
  const std::size_t leaning = joint("leaning", JointKind::prismatic, ground, o, {1.0, 0.0, 1.0});
  const std::size_t screw = joint("screw", JointKind::screw, ground, o, z);
  const std::size_t arm = joint("arm", JointKind::revolute, ground, {1.0, 0.0, 0.0}, z);
  const std::size_t far = joint("far", JointKind::revolute, static_cast<int>(arm), x, z);
  const auto check = [&](std::size_t first, std::size_t second, double ratio,
                         std::optional<Attachment> at, const char* said) {
    const MeshFound found = mesh_of(mechanism, {first, second, ratio, 0.0, pressure, at});
    CHECK(!found.mesh);
    CHECK_THAT(found.problem, Catch::Contains(said));
    CHECK(!found.hint.empty());
  };
  check(wheel, wheel, -1.0, {}, "cannot mesh with itself");
  check(wheel, plate, -1.0, {}, "\"plate\" is of kind \"fixed\"");
  check(screw, wheel, -1.0, {}, "\"screw\" is of kind \"screw\"");
  check(rack, wheel, -1.0, {}, "\"rack\" is of kind \"prismatic\"");
  check(wheel, in_line, -1.0, {}, "lie in line");
  check(wheel, above, -1.0, {}, "0.1 m apart along their axes");
  check(wheel, beside, 1.0, {}, "both wheels turn alike");
  check(wheel, crossed, -1.0, {}, "cross without meeting");
  check(wheel, leaning, 0.1, {}, "does not stand square");
  check(wheel, bevel, -1.0, {}, "bevel gears meet is not known");
  check(wheel, bevel, -1.0, Attachment{ground, o}, "not meet where the axes do");
  check(wheel, beside, -1.0, Attachment{ground, {0.1, 0.0, 0.0}}, "0.05 m beside the line");
  check(wheel, beside, -1.0, Attachment{static_cast<int>(arm), o}, "does not stand still");
  check(wheel, far, -1.0, {}, "no body keeps the axes");
  CHECK(
      mesh_of(mechanism, {wheel, beside, -1.0, 0.0, pressure, Attachment{ground, {0.15, 0.0, 0.7}}})
          .mesh);
}

}  // namespace mesh_test
