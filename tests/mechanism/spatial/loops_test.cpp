// Closed loops in space against closed forms, and against balances that hold in every mechanism.

#include "boxbeam/mechanism/spatial/loops.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/forced_motion.hpp"
#include "catch.hpp"
#include "support/random_loops.hpp"
#include "support/spatial_balance.hpp"

namespace loops_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::add;
using test::check_balance;
using test::closing;
using test::joint_of;
using test::random_loops;
using test::set_mass;

namespace {

/// The spatial slider-crank of the IFToMM library of computational benchmark problems: crank 0.08 m
/// about x at (0, 0.1, 0.12) m, rod 0.3 m, slider along x.
Mechanism slider_crank() {
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -9.81};
  Joint crank = joint_of("crank", JointKind::revolute, ground, {0.0, 0.1, 0.12}, Vector3d::UnitX());
  crank.driver = RateDriver{0.0, 6.0};
  const int on_crank = add(mechanism, crank, false);
  const int slider = add(
      mechanism,
      joint_of("slider", JointKind::prismatic, ground, Vector3d::Zero(), Vector3d::UnitX()), true);
  mechanism.joints.back().start = 0.25;
  // The rod, its x from the slider to the crank at the start; its universal joint turns about the
  // slider's x, then about k of the rod.
  const Vector3d along = Vector3d(-0.2, 0.1, 0.2) / 0.3;
  const Vector3d k = Vector3d(0.0, -2.0, 1.0).normalized();
  int rod = add(
      mechanism,
      joint_of("hook.1", JointKind::revolute, slider, Vector3d::Zero(), Vector3d::UnitX()), true);
  rod = add(mechanism, joint_of("hook.2", JointKind::revolute, rod, Vector3d::Zero(), k), true);
  mechanism.closing.push_back(
      closing("ball", ClosingKind::spherical, {on_crank, {0.0, 0.0, 0.08}}, {rod, 0.3 * along}));
  set_mass(mechanism.bodies[0], 0.12, {0.0, 0.0, 0.04}, {1e-4, 1e-4, 1e-5});
  set_mass(mechanism.bodies[1], 2.0, Vector3d::Zero(), {1e-4, 1e-4, 1e-4});
  spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(rod)];
  body.mass = 0.5;
  body.centre = 0.15 * along;
  body.inertia =
      4e-3 * (Matrix3d::Identity() - along * along.transpose()) + 4e-4 * along * along.transpose();
  return mechanism;
}

}  // namespace

TEST_CASE("A spatial slider-crank begins with the rates of its closed form") {
  const Mechanism mechanism = slider_crank();
  const Chain chain(mechanism);
  const State state = chain.at(0.0);
  CHECK(state.bodies[1].position.x() == Approx(std::sqrt(0.09 - 0.01 - 0.04)).epsilon(1e-13));
  CHECK(state.bodies[1].velocity.x() == Approx(0.24).epsilon(1e-12));
  CHECK((state.bodies[3].omega - Vector3d(1.92, -0.96, 0.48)).norm() < 1e-12);
  const Vector3d middle = velocity_of(state, {3, mechanism.bodies[3].centre});
  CHECK((middle - Vector3d(0.12, -0.24, 0.0)).norm() < 1e-12);
  CHECK(chain.loops()->repeating() == 0);
  for (int i = 0; i < 40; ++i) check_balance(chain, 0.03 * i);
}

TEST_CASE("A crank and a rocker in space follow the closed form of their rod's length") {
  // Crank of radius 0.3 m about z, rocker of radius 0.7 m about a line parallel to x at (0, 1, 0.2)
  // m, rod 1.1 m between balls: (b - c)^2 = l^2 is A cos psi + B sin psi = C.
  constexpr double r = 0.3, R = 0.7, l = 1.1;
  const Vector3d pivot(0.1, 1.0, 0.2);
  Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81, 0.0};
  Joint crank = joint_of("crank", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitZ());
  crank.driver = HarmonicDriver{0.2, 1.5, 2.0, 0.3, {}};
  const int a = add(mechanism, crank, false);
  const int b = add(
      mechanism, joint_of("rocker", JointKind::revolute, ground, pivot, Vector3d::UnitX()), true);
  mechanism.joints.back().start = 0.5;
  mechanism.closing.push_back(
      closing("rod", ClosingKind::distance, {a, {r, 0.0, 0.0}}, {b, {0.0, 0.0, R}}));
  mechanism.closing.back().length = PolynomialDriver{{l}};
  set_mass(mechanism.bodies[0], 3.0, {0.1, 0.0, 0.0}, {0.01, 0.02, 0.03});
  set_mass(mechanism.bodies[1], 5.0, {0.0, 0.1, 0.3}, {0.4, 0.3, 0.2});
  const Chain chain(mechanism);
  const auto psi_at = [&](double time) {
    const double phi = driver_at(mechanism.joints[0].driver, time).value;
    const Vector3d d = Vector3d(r * std::cos(phi), r * std::sin(phi), 0.0) - pivot;
    // c - pivot = R (0, -sin psi, cos psi)
    const double A = d.z(), B = -d.y();
    const double C = (d.squaredNorm() + R * R - l * l) / (2.0 * R);
    const double one = std::atan2(B, A), turn = std::acos(C / std::hypot(A, B));
    return std::pair(one + turn, one - turn);  // the two branches
  };
  const auto [plus, minus] = psi_at(0.0);
  const double start = chain.at(0.0).coordinates[1].value;
  const bool is_plus = std::abs(std::remainder(start - plus, full_turn)) <
                       std::abs(std::remainder(start - minus, full_turn));
  const auto exact = [&](double time) {
    const auto both = psi_at(time);
    return is_plus ? both.first : both.second;
  };
  for (int i = 0; i <= 60; ++i) {
    const double time = 0.05 * i + 0.01, h = 1e-4;
    const State state = chain.at(time);
    CHECK(std::abs(std::remainder(state.coordinates[1].value - exact(time), full_turn)) < 1e-12);
    const double rate = std::remainder(exact(time + h) - exact(time - h), full_turn) / (2.0 * h);
    CHECK(state.coordinates[1].rate == Approx(rate).margin(1e-6));
    const double acceleration = (std::remainder(exact(time + h) - exact(time), full_turn) -
                                 std::remainder(exact(time) - exact(time - h), full_turn)) /
                                (h * h);
    CHECK(state.coordinates[1].acceleration == Approx(acceleration).margin(1e-5));
    check_balance(chain, time);
  }
}

TEST_CASE("A universal joint turns its second shaft unevenly, two of them evenly") {
  // tan(second) = tan(first)/cos(beta) where the first fork stands in the shafts' plane; source:
  // every textbook of machine elements.
  constexpr double beta = 0.5;
  Mechanism mechanism;
  Joint first = joint_of("first", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitX());
  first.driver = RateDriver{0.0, 1.0};
  const int in = add(mechanism, first, false);
  const auto shaft = [&](const char* name, double angle, const Vector3d& at) {
    Joint joint = joint_of(name, JointKind::revolute, ground, at, Vector3d::UnitX());
    joint.turn = rotation_about({0.0, 0.0, angle});
    joint.axis = joint.turn.col(0);
    return add(mechanism, joint, true);
  };
  const int middle = shaft("middle", beta, Vector3d::Zero());
  const Vector3d second_centre = rotation_about({0.0, 0.0, beta}).col(0);
  const int out = shaft("out", 0.0, second_centre);
  const auto hook = [&](const char* name, const Attachment& a, const Attachment& b) {
    ClosingJoint joint = closing(name, ClosingKind::universal, a, b);
    joint.axis = Vector3d::UnitY();
    joint.other = Vector3d::UnitZ();
    mechanism.closing.push_back(joint);
  };
  hook("hook", {in, Vector3d::Zero()}, {middle, Vector3d::Zero()});
  hook("other", {out, Vector3d::Zero()}, {middle, Vector3d::UnitX()});
  mechanism.closing.back().axis = Vector3d::UnitY();
  const Chain chain(mechanism);
  CHECK(chain.loops()->repeating() == 6);  // both centres lie on both shafts anyhow
  for (const char unique : {chain.loops()->unique()[3], chain.loops()->unique()[4]}) CHECK(!unique);
  for (int i = 0; i < 50; ++i) {
    const double time = 0.13 * i;
    const State state = chain.at(time);
    const double theta = state.coordinates[1].value;
    CHECK(std::abs(std::sin(theta) * std::cos(time) * std::cos(beta) -
                   std::cos(theta) * std::sin(time)) < 1e-12);
    CHECK(std::abs(std::remainder(state.coordinates[2].value - time, full_turn)) < 1e-11);
    CHECK(state.coordinates[2].rate == Approx(1.0).epsilon(1e-11));
    const double c = std::cos(time);
    CHECK(state.coordinates[1].rate ==
          Approx(std::cos(beta) / (1.0 - std::pow(std::sin(beta) * c, 2))).epsilon(1e-11));
  }
}

TEST_CASE("Bennett's linkage moves though counting says that it does not") {
  // Opposite bars alike, a/sin(alpha) = b/sin(beta): tan(theta/2) tan(phi/2) =
  // sin((beta + alpha)/2)/sin((beta - alpha)/2). Source: Bennett, Engineering 76 (1903).
  constexpr double alpha = 0.6, beta = 1.1, a = 0.5;
  const double b = a * std::sin(beta) / std::sin(alpha);
  const double ratio = std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha));
  Mechanism mechanism;
  const double theta = 1.0;
  const double phi = 2.0 * std::atan(ratio / std::tan(0.5 * theta));
  // Denavit and Hartenberg: about z by the joint's angle, along x by the length, about x by the
  // twist.
  const double lengths[] = {a, b, a, b}, twists[] = {alpha, beta, alpha, beta};
  const double angles[] = {theta, phi, -theta, -phi};
  int body = ground;
  for (int k = 0; k < 3; ++k) {
    Joint joint = joint_of("bar", JointKind::revolute, body, Vector3d::Zero(), Vector3d::UnitZ());
    if (k > 0) {
      joint.at = {lengths[k - 1], 0.0, 0.0};
      joint.turn = rotation_about({twists[k - 1], 0.0, 0.0});
      joint.axis = joint.turn.col(2);
    }
    joint.start = angles[k];
    if (k == 0) joint.driver = HarmonicDriver{theta, 0.4, 1.0, 0.0, {}};
    body = add(mechanism, joint, k > 0);
  }
  // The last joint closes it: the third bar's end turns about the ground's z seen from the end of
  // the fourth bar, which is the ground.
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    R = (R * rotation_about({0.0, 0.0, angles[k]})).eval();
    p += R * Vector3d(lengths[k], 0.0, 0.0);
    R = (R * rotation_about({twists[k], 0.0, 0.0})).eval();
  }
  ClosingJoint last = closing("last", ClosingKind::revolute, {ground, p}, {body, {a, 0.0, 0.0}});
  last.axis = R.col(2);
  last.turn = R * rotation_about({twists[2], 0.0, 0.0}).transpose();
  mechanism.closing.push_back(last);
  const Chain chain(mechanism);
  CHECK(chain.loops()->equations() == 5);
  CHECK(chain.loops()->freedoms() == 2);
  CHECK(chain.loops()->repeating() == 3);
  for (int i = 0; i < 40; ++i) {
    const double time = 0.15 * i;
    const double first = driver_at(mechanism.joints[0].driver, time).value;
    const State state = chain.at(time);
    CHECK(std::tan(0.5 * state.coordinates[1].value) ==
          Approx(ratio / std::tan(0.5 * first)).epsilon(1e-7));
    CHECK(chain.loops()->residual_of(Tree(mechanism), state) < 1e-8);
  }
}

namespace {

/// Nothing where chance gave joints that leave freedoms, or that cannot follow.
std::optional<Chain> chain_of(const Mechanism& mechanism) {
  std::optional<Chain> chain;
  try {
    chain.emplace(mechanism);
  } catch (const AnalysisError&) {
  }
  return chain;
}

/// Balance to `balance`, and rates that are those of the coordinates to 1e-7 `wider`, all times the
/// condition.
void check_motion(const Chain& chain, double time, double balance, double wider) {
  const State state = chain.at(time);
  const double condition = chain.loops()->condition_of(chain.tree(), state);
  check_balance(chain, time, balance * condition);
  constexpr double h = 1e-5;
  const State before = chain.at(time - h), after = chain.at(time + h);
  for (std::size_t i = 0; i < state.coordinates.size(); ++i) {
    const DriverState &q = state.coordinates[i], &p = after.coordinates[i],
                      &m = before.coordinates[i];
    // Central differences: truncation with the third derivative, round-off with the condition.
    const double size = wider * condition * (1.0 + std::abs(q.acceleration));
    CHECK((p.value - m.value) / (2.0 * h) == Approx(q.rate).margin(1e-7 * size));
    CHECK((p.rate - m.rate) / (2.0 * h) == Approx(q.acceleration).margin(1e-6 * size));
  }
}

}  // namespace

TEST_CASE("Loops by chance keep balance of forces, moments and power, and their rates") {
  int judged = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    test::Chance chance(seed);
    const Mechanism mechanism = random_loops(chance);
    const std::optional<Chain> chain = chain_of(mechanism);
    if (!chain) continue;
    ++judged;
    INFO("seed " << seed);
    for (const double time : {0.1, 0.37, 0.8}) check_motion(*chain, time, 1e-14, 1.0);
  }
  CHECK(judged > 100);
}

TEST_CASE("Loops by chance that screws close keep balance, and their rates") {
  int judged = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    test::Chance chance(seed);
    const Mechanism mechanism = random_loops(chance, ClosingKind::screw);
    const std::optional<Chain> chain = chain_of(mechanism);
    if (!chain) continue;
    ++judged;
    INFO("seed " << seed);
    for (const double time : {0.1, 0.37, 0.8}) check_motion(*chain, time, 1e-14, 1.0);
  }
  CHECK(judged > 50);
}

TEST_CASE("Loops by chance that forces move keep balance of forces, moments and power") {
  int judged = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    test::Chance chance(seed);
    Mechanism mechanism = random_loops(chance);
    mechanism.duration.length = 0.1;
    // Of those that drivers moved two begin as these would have it, and go on by forces.
    int forced = 0;
    for (int tries = 0; tries < 20 && forced < 2; ++tries) {
      const auto i =
          static_cast<std::size_t>(chance.one_of(static_cast<int>(mechanism.joints.size())));
      Joint& joint = mechanism.joints[i];
      if (!is_driven(joint)) continue;
      joint.start = driver_at(joint.driver, 0.0).value;
      joint.start_rate = driver_at(joint.driver, 0.0).rate;
      joint.moved_by = MovedBy::forces;
      ++forced;
    }
    const std::optional<Chain> chain = chain_of(mechanism);
    if (!chain) continue;
    ++judged;
    INFO("seed " << seed);
    CHECK(chain->forced()->freedoms() == 2);
    for (const double time : {0.02, 0.07}) check_motion(*chain, time, 1e-12, 10.0);
  }
  CHECK(judged > 40);
}

TEST_CASE("Six cylinders hold a platform where their lengths say") {
  // The lengths follow from the platform's motion, and the motion from the lengths.
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -9.81};
  int body = ground;
  for (int k = 0; k < 3; ++k)
    body = add(mechanism,
               joint_of("shift", JointKind::prismatic, body, Vector3d::Zero(), Vector3d::Unit(k)),
               true);
  for (int k = 2; k >= 0; --k)
    body =
        add(mechanism,
            joint_of("turn", JointKind::revolute, body, Vector3d::Zero(), Vector3d::Unit(k)), true);
  mechanism.joints[2].start = 0.9;
  set_mass(mechanism.bodies.back(), 200.0, {0.02, -0.05, 0.1}, {12.0, 15.0, 20.0});
  // About it the lengths are polynomials of degree five through the motion's exact ones.
  const auto pose = [](double t) {
    return std::pair(rotation_about({0.1 * t, -0.2 * t * t, 0.3 * t}),
                     Vector3d(0.2 * t, 0.1 * t * t, 1.0 + 0.15 * t));
  };
  for (int leg = 0; leg < 6; ++leg) {
    const double at = full_turn / 6.0 * leg;
    const double low = at + (leg % 2 == 0 ? 0.35 : -0.35), high = at - (leg % 2 == 0 ? 0.2 : -0.2);
    const Vector3d base(1.2 * std::cos(low), 1.2 * std::sin(low), 0.0);
    const Vector3d top(0.7 * std::cos(high), 0.7 * std::sin(high), 0.0);
    ClosingJoint joint = closing("leg", ClosingKind::distance, {ground, base}, {body, top});
    const auto [R, p] = pose(0.4);
    joint.length = PolynomialDriver{{(p + R * top - base).norm()}};
    mechanism.closing.push_back(joint);
  }
  const Chain chain(mechanism);
  const State state = chain.at(0.0);
  const auto [R, p] = pose(0.4);
  CHECK((state.bodies.back().position - p).norm() < 1e-11);
  CHECK((state.bodies.back().R_WB - R).norm() < 1e-11);
  // At rest the six forces along the legs carry the weight: 6 equations of a free body.
  const std::vector<Wrench> joints = chain.joint_wrenches(state);
  Vector3d force = mechanism.gravity * 200.0, moment = Vector3d::Zero();
  const Vector3d centre = position_of(state, {body, mechanism.bodies.back().centre});
  for (std::size_t leg = 0; leg < 6; ++leg) {
    force += joints[6 + leg].force;
    moment += (position_of(state, mechanism.closing[leg].b) - centre).cross(joints[6 + leg].force);
    CHECK(joints[6 + leg].moment.norm() == 0.0);
  }
  CHECK(force.norm() < 1e-8);
  CHECK(moment.norm() < 1e-8);
  check_balance(chain, 0.0);
}

TEST_CASE("A hundred parallelograms in a row turn as the first: no determinant is too small") {
  // Cranks of 1 m, 1 m apart, about y; couplers on universal joints end in balls. All turn alike.
  constexpr int loops = 100;
  Mechanism row;
  row.gravity = {0.0, 0.0, -9.81};
  const auto moved = [](const char* name, int parent, const Vector3d& at, const Vector3d& axis) {
    Joint joint = joint_of(name, JointKind::revolute, parent, at, axis);
    joint.moved_by = MovedBy::loops;
    return joint;
  };
  Joint first = joint_of("crank", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitY());
  first.driver = PolynomialDriver{{0.1, 0.5}};
  int last = add(row, first, false);
  std::vector<int> cranks{last};
  std::vector<int> couplers;
  for (int i = 1; i <= loops; ++i) {
    const int next = add(row, moved("crank", ground, {1.0 * i, 0.0, 0.0}, Vector3d::UnitY()), true);
    const int frame = add(row, moved("hook.1", last, Vector3d::UnitZ(), Vector3d::UnitY()), true);
    const int coupler = add(row, moved("hook.2", frame, Vector3d::Zero(), Vector3d::UnitZ()), true);
    row.closing.push_back(closing("ball", ClosingKind::spherical, {coupler, {1.0, 0.0, 0.0}},
                                  {next, Vector3d::UnitZ()}));
    cranks.push_back(last = next);
    couplers.push_back(coupler);
  }
  row.duration = Duration{0.0, 0.1};
  const Chain chain(row);
  const State state = chain.at(0.08);
  double worst = 0.0;
  for (const int crank : cranks) {
    const DriverState& q = state.coordinates[static_cast<std::size_t>(crank)];
    worst = std::max(
        {worst, std::abs(q.value - 0.14), std::abs(q.rate - 0.5), std::abs(q.acceleration)});
  }
  for (const int coupler : couplers)
    worst = std::max(
        worst,
        (state.bodies[static_cast<std::size_t>(coupler)].R_WB - Matrix3d::Identity()).norm());
  CHECK(worst < 1e-9);
}

TEST_CASE("Loops that cannot be closed, moved or determined say where and why") {
  const auto failure_of = [](const Mechanism& mechanism) {
    try {
      const Chain chain(mechanism);
    } catch (const AnalysisError& error) {
      return error.failure();
    }
    FAIL("nothing was refused");
    return AnalysisFailure{};
  };
  Mechanism mechanism = slider_crank();
  // The rod is too short: nearest the slider is 0.1 m beside the crank's circle.
  mechanism.closing[0].b.p *= 0.5;
  CHECK(failure_of(mechanism).what.find("cannot be closed") != std::string::npos);
  CHECK(failure_of(mechanism).where == "joint ball");

  // It just reaches at the start, and no longer when the crank has turned on.
  mechanism = slider_crank();
  mechanism.joints[1].start = 0.05;
  mechanism.closing[0].b.p *= 0.2241 / 0.3;
  const AnalysisFailure dead = failure_of(mechanism);
  CHECK(dead.what.find("dead point") != std::string::npos);
  REQUIRE(dead.time);
  // y^2 + z^2 of the crank's end grows to the rod's length: closed form.
  const double t = *dead.time;
  const double y = 0.1 - 0.08 * std::sin(6.0 * t), z = 0.12 + 0.08 * std::cos(6.0 * t);
  CHECK(std::hypot(y, z) == Approx(0.2241).epsilon(1e-4));

  // A second ball joint leaves the rod's turning about its own line.
  mechanism = slider_crank();
  Joint spin = joint_of("spin", JointKind::revolute, 3, Vector3d::Zero(), Vector3d(-0.2, 0.1, 0.2));
  add(mechanism, spin, true);
  mechanism.closing[0].b.body = 4;
  const AnalysisFailure idle = failure_of(mechanism);
  CHECK(idle.what.find("1 freedom") != std::string::npos);
  CHECK(idle.what.find("spin") != std::string::npos);
}

}  // namespace loops_test
