// Friction of joints that slide in space: by hand, and by balances that hold in every mechanism.

#include "boxbeam/mechanism/spatial/friction.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "mechanism/spatial/rubbing.hpp"
#include "support/random_tree.hpp"
#include "support/spatial_balance.hpp"

namespace spatial_friction_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using namespace rubbing;
using Eigen::Vector3d;
using test::set_mass;

TEST_CASE("what presses on a guide is the sizes of the contact forces at its two ends") {
  // By hand: N = 30 N at half on both ends; a couple of 8 N m over 0.2 m is 40 N at each. In one
  // plane 55 N and -25 N, together max(30, 2 x 40); square to each other twice hypot(15, 40).
  Friction law;
  law.guide = 0.2;
  GuideLoad load;
  load << 0.0, 30.0, 0.0, 0.0, 8.0, 0.0;
  CHECK(pressure_of(law, load) == Approx(80.0).epsilon(1e-14));
  load << 0.0, 30.0, 0.0, 0.0, 0.0, 8.0;
  CHECK(pressure_of(law, load) == Approx(2.0 * std::hypot(15.0, 40.0)).epsilon(1e-14));
  load << 0.0, 100.0, 0.0, 0.0, 8.0, 0.0;
  CHECK(pressure_of(law, load) == Approx(100.0).epsilon(1e-14));
  law.guide = 0.0;
  CHECK(pressure_of(law, load) == Approx(100.0).epsilon(1e-14));
}

TEST_CASE("friction changes nothing but the drive of a joint that a driver moves") {
  // It acts between the same bodies along the same line as the drive.
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    test::Chance chance(seed);
    const Mechanism smooth = test::random_tree(chance, 12);
    Mechanism rough = smooth;
    for (Joint& joint : rough.joints)
      if (joint.kind == JointKind::prismatic) joint.friction = {0.3, 5.0, 0.1, 0.2};
    const Chain without(smooth), with(rough);
    const double time = 0.1 * seed;
    const State state = with.at(time);
    const std::vector<Wrench> one = without.joint_wrenches(without.at(time)),
                              two = with.joint_wrenches(state);
    double largest = 0.0;
    for (const Wrench& of : one) largest = std::max({largest, of.force.norm(), of.moment.norm()});
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK((one[i].force - two[i].force).norm() < 1e-12 * largest);
      CHECK((one[i].moment - two[i].moment).norm() < 1e-12 * largest);
      if (rough.joints[i].kind != JointKind::prismatic) continue;
      const double v = state.coordinates[i].rate;
      const Vector3d a = in_world(state, rough.joints[i].parent, rough.joints[i].axis);
      const double rubs = 0.3 * pressure_by_ends(one[i], a, 0.2) * v / std::hypot(v, 0.1) + 5.0 * v;
      CHECK(with.along_axis(state, i, two[i]) - a.dot(one[i].force) ==
            Approx(rubs).margin(1e-12 * largest));
    }
    CHECK(check_laws(with, time) > 0);
  }
}

TEST_CASE("loops that rub: every body in equilibrium, and power in balance") {
  // A table on a slide, an arm on it that a ball-ended strut holds, whose other end a cylinder's
  // sleeve guides along a line askew in space, on a body that turns.
  int rubbing = 0, ended = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Chance chance(100 + seed);
    Mechanism mechanism;
    mechanism.gravity = chance.vector(10.0);
    const auto mass = [&](int of) {
      spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(of)];
      body.mass = 2.0 + chance.any(1.0);
      body.centre = chance.vector(0.3);
      body.inertia = chance.inertia(body.mass, 0.4);
    };
    const auto driven = [&](double rate) {
      mechanism.joints.back().driver = HarmonicDriver{0.0, 0.03, rate, 0.2, {}};
    };
    const int base = add(mechanism, "base", JointKind::revolute, ground, chance.vector(),
                         chance.direction(), MovedBy::driver);
    driven(2.0);
    const int table = add(mechanism, "table", JointKind::prismatic, base, chance.vector(),
                          chance.direction(), MovedBy::loops);
    mechanism.joints.back().friction = {0.06, 3.0, 0.01, 0.4};
    const int arm = add(mechanism, "arm", JointKind::revolute, table, chance.vector(0.3),
                        chance.direction(), MovedBy::driver);
    driven(3.0);
    const int first = add(mechanism, "first", JointKind::revolute, arm, chance.vector(0.5),
                          chance.direction(), MovedBy::loops);
    const int second = add(mechanism, "second", JointKind::revolute, first, Vector3d::Zero(),
                           chance.direction(), MovedBy::loops);
    const int other = add(mechanism, "other", JointKind::prismatic, ground, chance.vector(),
                          chance.direction(), MovedBy::driver);
    driven(1.5);
    mechanism.joints.back().friction = {0.2, 0.0, 0.01, 0.0};
    for (const int of : {base, table, arm, second, other}) mass(of);
    ClosingJoint closing;
    closing.name = "sleeve";
    constexpr ClosingKind kinds[] = {ClosingKind::slot, ClosingKind::cylindrical,
                                     ClosingKind::prismatic};
    closing.kind = kinds[seed % 3];
    int last = second;
    if (closing.kind == ClosingKind::slot) {
      // Two equations: the table and one turn.
      mechanism.joints[static_cast<std::size_t>(second)].moved_by = MovedBy::driver;
      closing.friction = {0.05, 1.0, 0.01, 0.0};
    } else {
      // Four equations or five: one more turn in the chain, or two.
      closing.friction = {0.05, 1.0, 0.01, 0.5};
      for (unsigned k = 0; k < seed % 3; ++k) {
        last = add(mechanism, "more", JointKind::revolute, last, chance.vector(0.4),
                   chance.direction(), MovedBy::loops);
        mass(last);
      }
    }
    closing.b = {last, chance.vector(0.5)};
    const Tree tree(mechanism);
    State state;
    tree.begin(state);
    tree.move(state);
    closing.axis = chance.direction();
    closing.turn = motion_of(state, other).R_WB.transpose() * motion_of(state, closing.b.body).R_WB;
    closing.a = {other, in_axes(state, other,
                                position_of(state, closing.b) - motion_of(state, other).position)};
    mechanism.closing = {closing};
    mechanism.loads = {{"load",
                        LoadKind::force,
                        second,
                        {second, chance.vector()},
                        ground,
                        chance.direction(),
                        PolynomialDriver{{30.0}}}};
    mechanism.duration.length = 0.3;
    try {
      const Chain chain(mechanism);
      for (int k = 0; k <= 20; ++k) {
        test::check_balance(chain, 0.015 * k, 1e-9);
        rubbing += check_laws(chain, 0.015 * k);
      }
    } catch (const AnalysisError&) {
      // By chance it may come to a dead point, or lock.
      ++ended;
    }
  }
  CHECK(ended <= 2);
  CHECK(rubbing > 450);
}

namespace {

/// A block on an incline that rises along its x at an angle, turned about the vertical; by forces.
Mechanism block_on_incline(double angle, const Friction& law, double rate) {
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  const double s = std::sin(angle), c = std::cos(angle);
  add(mechanism, "block", JointKind::prismatic, ground, Vector3d::Zero(),
      Vector3d(-0.6 * c, -0.8 * c, -s), MovedBy::forces);
  mechanism.joints[0].friction = law;
  mechanism.joints[0].start_rate = rate;
  set_mass(mechanism.bodies[0], 7.0, Vector3d::Zero(), {0.1, 0.2, 0.3});
  mechanism.duration.length = 0.5;
  return mechanism;
}

}  // namespace

TEST_CASE("a block slides down an incline with g (sin a - mu cos a)") {
  const double angle = 0.6, mu = 0.3, creep = 1e-6;
  const Mechanism mechanism = block_on_incline(angle, {mu, 0.0, creep, 0.0}, 1.0);
  const Chain chain(mechanism);
  const double a = g * (std::sin(angle) - mu * std::cos(angle));
  for (const double time : {0.0, 0.2, 0.5}) {
    const State state = chain.at(time);
    // (creep/v)^2/2 of the friction is missing: 5e-13.
    CHECK(state.coordinates[0].acceleration == Approx(a).epsilon(1e-11));
    CHECK(state.coordinates[0].value == Approx(time + 0.5 * a * time * time).epsilon(1e-9));
    CHECK(state.friction[0] == Approx(-mu * 7.0 * g * std::cos(angle)).epsilon(1e-11));
    test::check_balance(chain, time);
  }
}

TEST_CASE("a block that friction holds creeps as slowly as its law says") {
  // v/hypot(v, creep) = tan a/mu: the share of mu P that holds it.
  const double angle = 0.25, mu = 0.5, creep = 0.01;
  const Mechanism mechanism = block_on_incline(angle, {mu, 0.0, creep, 0.0}, 0.0);
  const Chain chain(mechanism);
  const double share = std::tan(angle) / mu;
  const State state = chain.at(0.5);
  CHECK(state.coordinates[0].rate ==
        Approx(creep * share / std::sqrt(1.0 - share * share)).epsilon(1e-8));
  CHECK(state.coordinates[0].acceleration == Approx(0.0).margin(1e-7));
}

TEST_CASE("a creep velocity is a fiftieth of the fastest that drivers give a contact") {
  // By hand: 0.2 m x 3 rad/s.
  Mechanism mechanism;
  add(mechanism, "sled", JointKind::prismatic, ground, Vector3d::Zero(), {1.0, 2.0, 2.0},
      MovedBy::driver);
  mechanism.joints[0].driver = HarmonicDriver{0.0, 0.2, 3.0, 0.0, {}};
  mechanism.joints[0].friction.coulomb = 0.1;
  mechanism.joints[0].friction.creep = 1.0;
  Mechanism given = mechanism;
  fit_creep(mechanism, {0});
  CHECK(mechanism.joints[0].friction.creep == Approx(0.02 * 0.6).epsilon(1e-6));
  fit_creep(given, {});
  CHECK(given.joints[0].friction.creep == 1.0);
  CHECK(fitted_creep(given.joints[0].friction, 1e-17, 1.0) == 1.0);  // it stands
  given.joints[0].moved_by = MovedBy::forces;
  fit_creep(given, {});
  CHECK(given.joints[0].friction.creep == 1.0);
  fit_creep(given, {0});
  CHECK(given.joints[0].friction.creep == 0.0);  // it sticks
}

}  // namespace spatial_friction_test
