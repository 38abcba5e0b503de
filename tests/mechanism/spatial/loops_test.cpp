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
#include "support/spatial_slider_crank.hpp"

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
  Mechanism mechanism = test::spatial_slider_crank();
  // The rod is too short: nearest the slider is 0.1 m beside the crank's circle.
  mechanism.closing[0].b.p *= 0.5;
  CHECK(failure_of(mechanism).what.find("cannot be closed") != std::string::npos);
  CHECK(failure_of(mechanism).where == "joint ball");

  // It just reaches at the start, and no longer when the crank has turned on.
  mechanism = test::spatial_slider_crank();
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
  mechanism = test::spatial_slider_crank();
  Joint spin = joint_of("spin", JointKind::revolute, 3, Vector3d::Zero(), Vector3d(-0.2, 0.1, 0.2));
  add(mechanism, spin, true);
  mechanism.closing[0].b.body = 4;
  const AnalysisFailure idle = failure_of(mechanism);
  CHECK(idle.what.find("1 freedom") != std::string::npos);
  CHECK(idle.what.find("spin") != std::string::npos);
}

}  // namespace loops_test
