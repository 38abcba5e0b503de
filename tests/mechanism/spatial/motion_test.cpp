// How many instants a motion needs: by hand from its fastest wave, and by what they resolve.

#include "boxbeam/mechanism/spatial/motion.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"

namespace motion_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// An arm that swings once a second about z and a wheel on it that turns about the arm.
Mechanism arm_and_wheel(Driver wheel, double off_centre) {
  Mechanism mechanism;
  mechanism.bodies.resize(2);
  mechanism.bodies[0].mass = 10.0;
  mechanism.bodies[0].centre = {0.5, 0.0, 0.0};
  mechanism.bodies[1].mass = 4.0;
  mechanism.bodies[1].centre = {0.0, off_centre, 0.0};
  mechanism.bodies[1].inertia = Vector3d(0.2, 0.1, 0.1).asDiagonal();
  mechanism.joints.resize(2);
  mechanism.joints[0].kind = JointKind::revolute;
  mechanism.joints[0].driver = HarmonicDriver{0.0, 0.5, turn, 0.0, {}};
  mechanism.joints[1].kind = JointKind::revolute;
  mechanism.joints[1].parent = 0;
  mechanism.joints[1].at = {1.0, 0.0, 0.0};
  mechanism.joints[1].axis = Vector3d::UnitX();
  mechanism.joints[1].driver = std::move(wheel);
  return mechanism;
}

Motion motion_of(const Mechanism& mechanism) { return motion_of(Chain(mechanism)); }

/// The largest force of the wheel's joint at the instants, and at 36 times between each two.
std::pair<double, double> peaks_of(const Mechanism& mechanism, const Motion& motion) {
  const Chain chain(mechanism);
  std::pair<double, double> peaks;
  const std::size_t fine = 37;
  for (std::size_t i = 0; i < fine * motion.instants; ++i) {
    const double time = motion.begin + motion.period * static_cast<double>(i) /
                                           static_cast<double>(fine * motion.instants);
    const double force = chain.joint_wrenches(chain.at(time))[1].force.y();
    if (i % fine == 0) peaks.first = std::max(peaks.first, force);
    peaks.second = std::max(peaks.second, force);
  }
  return peaks;
}

}  // namespace

TEST_CASE("a slow motion gets 96 instants over one period") {
  const Motion motion = motion_of(arm_and_wheel(PolynomialDriver{{0.3}}, 0.0));
  CHECK(motion.instants == 96);
  CHECK(motion.closed);
  CHECK(motion.begin == 0.0);
  CHECK(motion.period == Approx(1.0));
  CHECK(time_of(motion, 24) == Approx(0.25));
  CHECK(time_of(motion, 96) == Approx(1.0));
}

TEST_CASE("a settling time is left out") {
  Mechanism mechanism = arm_and_wheel(PolynomialDriver{{0.3}}, 0.0);
  mechanism.duration = {0.5, 2.0};
  const Motion motion = motion_of(mechanism);
  CHECK(motion.closed);
  CHECK(time_of(motion, 0) == Approx(0.5));
  CHECK(time_of(motion, motion.instants) == Approx(2.5));
}

TEST_CASE("a fast wheel has eight instants to a turn, also where no force shows it") {
  // 50 turns a second over the arm's second: at least 400, in doublings of 96 at least 768.
  CHECK(motion_of(arm_and_wheel(RateDriver{0.0, 50.0 * turn}, 0.0)).instants == 768);
  // Of a drive that does not say its frequency only the turns tell.
  Mechanism mechanism = arm_and_wheel(PolynomialDriver{{0.0, 50.0 * turn}}, 0.0);
  mechanism.duration.length = 1.0;
  const Motion motion = motion_of(mechanism);
  CHECK(!motion.closed);
  CHECK(motion.instants == 768);
}

TEST_CASE("of a fast unbalanced wheel every wave is resolved") {
  // On the swinging arm, w_a = its rate, the moment about the axle is m r^2 w_a^2 sin(2 theta)/2:
  // 100 waves. A wave of N instants to x of them is missed by the cubic by |1 - (9 cos a - cos
  // 3a)/8| of its size, a = 2 pi x/N, which must be under 2 %: 13 % at 768, 1 % at 1536.
  const auto missed = [](double a) { return 1.0 - (9.0 * std::cos(a) - std::cos(3.0 * a)) / 8.0; };
  REQUIRE(missed(turn * 100.0 / 768.0) > 0.02);
  REQUIRE(missed(turn * 100.0 / 1536.0) < 0.02);
  const Motion motion = motion_of(arm_and_wheel(RateDriver{0.0, 50.0 * turn}, 0.05));
  CHECK(motion.instants == 1536);
  CHECK(motion.closed);
}

TEST_CASE("the instants bracket the peaks of an unbalanced wheel") {
  // A harmonic with k instants to its wave is caught within 1 - cos(pi/k): at 8, 7.6 % of its size.
  for (const double turns : {3.0, 17.0, 90.0}) {
    const Mechanism mechanism = arm_and_wheel(RateDriver{0.1, turns * turn}, 0.05);
    const Motion motion = motion_of(mechanism);
    const auto [seen, true_peak] = peaks_of(mechanism, motion);
    CHECK(static_cast<double>(motion.instants) >= 8.0 * turns);
    CHECK(seen > (1.0 - 0.077) * true_peak);
  }
}

TEST_CASE("a motion that does not repeat is open and ends with its last step") {
  Mechanism mechanism = arm_and_wheel(StepDriver{0.0, 1.5, 0.2, 0.9}, 0.05);
  mechanism.joints[0].driver = StepDriver{0.0, 1.0, 0.0, 1.4};
  const Motion motion = motion_of(mechanism);
  CHECK(!motion.closed);
  CHECK(motion.instants >= 96);
  CHECK(time_of(motion, motion.instants) == Approx(1.4));
}

TEST_CASE("what 24 576 instants cannot resolve is an error that says so") {
  // 4000 turns of the wheel to one swing of the arm: 32 000 instants.
  CHECK_THROWS_AS(motion_of(arm_and_wheel(RateDriver{0.0, 4000.0 * turn}, 0.0)), AnalysisError);
  Mechanism mechanism = arm_and_wheel(PolynomialDriver{{0.0, 4000.0 * turn}}, 0.0);
  mechanism.duration.length = 1.0;
  CHECK_THROWS_AS(motion_of(mechanism), AnalysisError);
  // A step of a load within a ten-thousandth of the time: known beforehand by its timing.
  mechanism = arm_and_wheel(PolynomialDriver{{0.0}}, 0.0);
  mechanism.loads = {{"blow",
                      LoadKind::force,
                      1,
                      {1, {0, 0, 0}},
                      1,
                      {0, 1, 0},
                      StepDriver{0.0, 1e3, 0.5, 0.50001}}};
  mechanism.duration.length = 1.0;
  CHECK_THROWS_AS(motion_of(mechanism), AnalysisError);
}

TEST_CASE("where no duration follows from the drivers it must be given") {
  CHECK_THROWS_AS(motion_of(arm_and_wheel(PolynomialDriver{{0.0, 1.0}}, 0.0)), AnalysisError);
}

}  // namespace motion_test
