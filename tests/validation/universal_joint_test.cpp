// Shafts on universal joints: one turns unevenly, two together evenly.

#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

namespace universal_joint_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;
using test::add;
using test::closing;
using test::joint_of;

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

}  // namespace universal_joint_test
