// Closing loops in space from 30 000 rough starts: on the branch that is asked for, by closed forms
// that know nothing of the equations, or refused with a reason, and never anything else. Beside it
// where the same starts lead when no branch is asked for.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>
#include <random>
#include <string>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/branch.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"
#include "support/spatial_slider_crank.hpp"

namespace rough_starts_in_space_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;
using test::add;
using test::closing;
using test::joint_of;
using test::set_mass;

namespace {

constexpr double r = 0.3, R = 0.7, l = 1.1;  ///< crank, rocker, rod between balls [m]
const Vector3d pivot(0.1, 1.0, 0.2);         ///< of the rocker, from that of its crank

/// A crank about z and its rocker about x, the crank's angle given by its driver; the next rocker
/// is moved by a crank on the first one, about x as well, in a row of two.
Mechanism crank_rockers(int rows, double phi, const std::array<int, 2>& signs) {
  Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81, 0.0};
  Joint crank = joint_of("crank", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitZ());
  crank.driver = PolynomialDriver{{phi}};
  int from = add(mechanism, crank, false);
  Vector3d ball(r, 0.0, 0.0), at = pivot;
  for (int row = 0; row < rows; ++row) {
    const int rocker = add(
        mechanism, joint_of("rocker", JointKind::revolute, ground, at, Vector3d::UnitX()), true);
    set_mass(mechanism.bodies.back(), 5.0, {0.0, 0.1, 0.3}, {0.4, 0.3, 0.2});
    ClosingJoint rod = closing("rod", ClosingKind::distance, {from, ball}, {rocker, {0.0, 0.0, R}});
    rod.length = PolynomialDriver{{l}};
    mechanism.closing.push_back(rod);
    Branch branch;
    branch.name = "rod";
    branch.from = {rocker, Vector3d::Zero()};
    branch.via = Attachment{from, ball};
    branch.to = {rocker, {0.0, 0.0, R}};
    branch.direction = Vector3d::UnitX();
    branch.sign = signs[static_cast<std::size_t>(row)];
    mechanism.branches.push_back(branch);
    from = rocker;
    ball = {0.3, -0.2, 0.25};
    at += Vector3d(0.2, 1.0, 0.1);
  }
  return mechanism;
}

/// The angle of a rocker at `at` whose rod is held at `ball`; nothing where it does not reach.
/// c - at = R (0, -sin psi, cos psi), (ball - c)^2 = l^2, and the rocker behind or before the ball.
std::optional<double> rocker_angle(const Vector3d& ball, const Vector3d& at, int sign) {
  const Vector3d d = ball - at;
  const double C = (d.squaredNorm() + R * R - l * l) / (2.0 * R);
  const double across = std::hypot(d.y(), d.z());
  if (std::abs(C) > across) return std::nullopt;
  return std::atan2(-d.y(), d.z()) + sign * std::acos(C / across);
}

struct Tally {
  int right = 0, wrong = 0, refused = 0, without = 0;
};

/// `judge`: whether a state is what the closed form says.
template <class Judge>
void look_at(const Mechanism& mechanism, const Judge& judge, Tally& tally) {
  try {
    const Chain chain(mechanism);
    const State state = chain.at(0.0);
    const bool right = chain.loops()->residual_of(chain.tree(), state) < 1e-9 && judge(state);
    (right ? tally.right : tally.wrong) += 1;
  } catch (const AnalysisError&) {
    ++tally.refused;
  }
  Mechanism unasked = mechanism;
  unasked.branches.clear();
  try {
    tally.without += judge(Chain(unasked).at(0.0)) ? 1 : 0;
  } catch (const AnalysisError&) {
  }
}

void start_anywhere(Mechanism& mechanism, double length, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (Joint& joint : mechanism.joints) {
    if (joint.moved_by != MovedBy::loops) continue;
    joint.start += (joint.kind == JointKind::prismatic ? length : 0.5 * full_turn) * unit(random);
  }
}

void report(const char* what, const Tally& tally, int starts) {
  std::cout << "stability: " << what << ": " << tally.right << " of " << starts
            << " rough starts on the branch asked for, " << tally.refused << " refused, "
            << tally.wrong << " wrong; " << tally.without << " where none is asked for\n";
  CHECK(tally.wrong == 0);
  CHECK(tally.right + tally.refused == starts);
}

}  // namespace

TEST_CASE("rough starts of a crank and rocker in space: the branch asked for or a refusal",
          "[unsanitized]") {
  constexpr int starts = 12000;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(0.0, full_turn);
  Tally tally;
  for (int i = 0; i < starts; ++i) {
    const double phi = angle(random);
    const int sign = i % 2 == 0 ? 1 : -1;
    Mechanism mechanism = crank_rockers(1, phi, {sign, 1});
    start_anywhere(mechanism, 1.0, random);
    const std::optional<double> exact =
        rocker_angle({r * std::cos(phi), r * std::sin(phi), 0.0}, pivot, sign);
    look_at(
        mechanism,
        [&](const State& state) {
          return exact &&
                 std::abs(std::remainder(state.coordinates[1].value - *exact, full_turn)) < 1e-7;
        },
        tally);
  }
  report("crank and rocker in space", tally, starts);
  CHECK(tally.right > 0.99 * starts);
  CHECK(tally.without < 0.9 * starts);
}

TEST_CASE("rough starts of two rockers in a row: the branches asked for or a refusal",
          "[unsanitized]") {
  constexpr int starts = 9000;
  std::mt19937 random(2);
  Tally tally;
  int reached = 0;
  for (int i = 0; i < starts; ++i) {
    const double phi = full_turn * i / starts;
    const std::array<int, 2> signs{i % 2 == 0 ? 1 : -1, i / 2 % 2 == 0 ? 1 : -1};
    Mechanism mechanism = crank_rockers(2, phi, signs);
    start_anywhere(mechanism, 1.0, random);
    const std::optional<double> first =
        rocker_angle({r * std::cos(phi), r * std::sin(phi), 0.0}, pivot, signs[0]);
    std::optional<double> second;
    if (first) {
      const Vector3d ball =
          pivot + Eigen::AngleAxisd(*first, Vector3d::UnitX()) * Vector3d(0.3, -0.2, 0.25);
      second = rocker_angle(ball, pivot + Vector3d(0.2, 1.0, 0.1), signs[1]);
    }
    reached += second ? 1 : 0;
    look_at(
        mechanism,
        [&](const State& state) {
          const auto away = [&](std::size_t joint, double exact) {
            return std::abs(std::remainder(state.coordinates[joint].value - exact, full_turn));
          };
          return second && away(1, *first) < 1e-7 && away(2, *second) < 1e-7;
        },
        tally);
  }
  report("two rockers in a row", tally, starts);
  CHECK(tally.right > 0.98 * reached);
  CHECK(tally.without < 0.6 * starts);
}

TEST_CASE("rough starts of a slider-crank in space: the side asked for or a refusal",
          "[unsanitized]") {
  constexpr int starts = 9000;
  std::mt19937 random(3);
  Tally tally;
  for (int i = 0; i < starts; ++i) {
    Mechanism mechanism = test::spatial_slider_crank();
    const double phi = full_turn * i / starts;
    mechanism.joints[0].driver = PolynomialDriver{{phi}};
    const int sign = i % 2 == 0 ? 1 : -1;
    Branch branch;
    branch.name = "slider";
    branch.from = {0, {0.0, 0.0, 0.08}};
    branch.to = {1, Vector3d::Zero()};
    branch.direction = Vector3d::UnitX();
    branch.sign = sign;
    mechanism.branches.push_back(branch);
    start_anywhere(mechanism, 0.3, random);
    // The crank's pin about x at (0, 0.1, 0.12) m, the rod 0.3 m long.
    const double y = 0.1 - 0.08 * std::sin(phi), z = 0.12 + 0.08 * std::cos(phi);
    const double x = sign * std::sqrt(0.09 - y * y - z * z);
    look_at(
        mechanism,
        [&](const State& state) { return std::abs(state.bodies[1].position.x() - x) < 1e-7; },
        tally);
  }
  report("slider-crank in space", tally, starts);
  CHECK(tally.right > 0.99 * starts);
  CHECK(tally.without < 0.9 * starts);
}

TEST_CASE("a branch that no start closes is refused with its loop") {
  Mechanism mechanism = crank_rockers(1, 0.4, {1, 1});
  // No rocker lies behind a plane that is beyond its reach.
  mechanism.branches[0].via.reset();
  mechanism.branches[0].from = {ground, {0.0, 0.0, 2.0}};
  mechanism.branches[0].direction = Vector3d::UnitZ();
  try {
    const Chain chain(mechanism);
    FAIL("nothing was refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().what.find("no assembly found on the wanted branch") == 0);
    CHECK(error.failure().where == "loop rod");
  }
}

}  // namespace rough_starts_in_space_test
