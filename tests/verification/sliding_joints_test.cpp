#include "src/verification/sliding_joints.hpp"

#include <string>

#include "catch.hpp"
#include "support/space_arm.hpp"

namespace sliding_joints_test {

using namespace boxbeam;

// A trolley at 2 m/s on an arm of 4 m that turns: what turns with the arm does not slide along it.
TEST_CASE("what slides along an arm does so by the rate of its joint, however the arm moves",
          "[sliding_joints]") {
  const test::space_arm::Moved moved(test::space_arm::arm(
      R"([bodies.trolley]
mass = "60 kg"
points = { c = ["0 m", "0 m", "0 m"] }
[bodies.load]
mass = "5 kg"
points = { c = ["0 m", "0 m", "0 m"] }
[joints.heel]
kind = "revolute"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
axis = "y"
[joints.run]
kind = "prismatic"
connect = ["arm.heel", "trolley.c"]
axis = "x"
[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
[drivers.turning]
joint = "heel"
kind = "constant rate"
start = "0.2 rad"
rate = "0.7 rad/s"
[drivers.run]
joint = "run"
kind = "constant rate"
start = "1 m"
rate = "2 m/s"
[motion]
duration = "1 s"
)",
      test::space_arm::steel));
  const spatial::Mechanism& mechanism = moved.chain().mechanism();
  const std::vector<spatial::BeamPlacement> arm{moved.project.placement};
  const int body = arm.front().body;
  CHECK(joints_sliding_along(mechanism, body) == std::vector<std::string>{"run"});
  CHECK(moving_along(mechanism, body) == "run");
  CHECK(joints_sliding_along(mechanism, spatial::ground).empty());
  for (const double t : {0.1, 0.4, 0.9})
    CHECK(sliding_along(mechanism, moved.chain().at(t), arm, 4.0) == Approx(0.5).epsilon(1e-9));
  CHECK(sliding_along(mechanism, moved.chain().at(0.4), {}, 4.0) == 0.0);
}

TEST_CASE("teeth roll along a body, and slide along none", "[sliding_joints]") {
  for (const spatial::ClosingKind kind : {spatial::ClosingKind::gear, spatial::ClosingKind::rack}) {
    CHECK_FALSE(slides_along(kind));
    spatial::Mechanism mechanism;
    mechanism.joints.resize(2);
    spatial::ClosingJoint teeth;
    teeth.name = "mesh";
    teeth.kind = kind;
    teeth.a.body = 0;
    teeth.mesh.parts = {{0, 1.0}, {1, -1.0}};
    mechanism.closing = {teeth};
    for (const int body : {0, 1}) {
      CHECK(moving_along(mechanism, body) == "mesh");
      CHECK(joints_sliding_along(mechanism, body).empty());
    }
    CHECK(moving_along(mechanism, 2).empty());
  }
}

}  // namespace sliding_joints_test
