// Reactions: Newton and Euler body by body, a pendulum by hand, the freedom of the joints.

#include "boxbeam/mechanism/planar/reactions.hpp"

#include <cmath>

#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace reactions_test {

using namespace boxbeam;
using namespace boxbeam::planar;

TEST_CASE("Newton and Euler hold for every body of the rig, at 40 instants") {
  const Mechanism& mechanism = planar_of(test::rig());
  const Motion motion = solve_motion(mechanism, 40);
  double worst = 0.0;
  double largest = 0.0;
  for (const State& state : motion.states) {
    const std::vector<Reaction> reactions = reactions_of(mechanism, state);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      const Body& body = mechanism.bodies[i];
      const auto k = static_cast<Eigen::Index>(3 * i);
      Eigen::Vector2d force = body.mass * mechanism.gravity - body.mass * state.a.segment<2>(k);
      double moment = -body.inertia * state.a[k + 2];
      const double c = std::cos(state.q[k + 2]);
      const double s = std::sin(state.q[k + 2]);
      for (const Reaction& reaction : reactions) {
        if (reaction.on != static_cast<int>(i)) continue;
        const Eigen::Vector2d arm(c * reaction.point.x() - s * reaction.point.y(),
                                  s * reaction.point.x() + c * reaction.point.y());
        force += reaction.force;
        moment += reaction.moment + arm.x() * reaction.force.y() - arm.y() * reaction.force.x();
        largest = std::max(largest, reaction.force.norm());
      }
      worst = std::max({worst, force.norm(), std::abs(moment)});
    }
  }
  CHECK(largest > 1e5);
  CHECK(worst < 1e-10 * largest);
}

TEST_CASE("every force has its opposite") {
  const Mechanism& mechanism = planar_of(test::rig());
  const State state = test::rig_state(0.3);
  const std::vector<Reaction> reactions = reactions_of(mechanism, state);
  const int B = joint_index(mechanism, "B");
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (const Reaction& reaction : reactions) {
    if (reaction.joint != B) continue;
    sum += reaction.force;
    ++count;
  }
  CHECK(count == 2);
  CHECK(sum.norm() == 0.0);
}

TEST_CASE("one reaction per joint stands on the beam where the beam is in the joint") {
  const Mechanism& mechanism = planar_of(test::rig());
  const int beam = body_index(mechanism, "beam");
  const auto chosen = reactions_per_joint(mechanism, test::rig_state(0.0), beam);
  REQUIRE(chosen.size() == mechanism.joints.size());
  for (const char* name : {"O", "B", "C"}) {
    CHECK(chosen[static_cast<std::size_t>(joint_index(mechanism, name))].on == beam);
  }
  CHECK(mechanism.bodies[static_cast<std::size_t>(chosen[2].on)].name == "upper_rod");  // joint A
}

TEST_CASE("a driven pendulum: reactions by hand") {
  // Mass m at distance l from the pin, angle phi(t) from the x axis driven:
  // pin force = m (a - g), driver moment = J phi'' + m l (l phi'' + g cos phi).
  Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81};
  const double m = 3.0;
  const double l = 0.8;
  const double J = 0.2;
  mechanism.bodies = {Body{"rod", m, J, {{"pin", {-l, 0.0}}}, {{l, 0.0}, 0.0}}};
  const HarmonicDriver driver{0.3, 0.9, 5.0, 0.4};
  mechanism.joints = {{"pin", Pin{{0, {-l, 0.0}}, {ground, {0.0, 0.0}}}},
                      {"motor", Driven{{0}, Coordinate::angle, driver}}};
  InstantSolver solver(mechanism);
  const double time = 0.37;
  const State state = solver.solve_from_sketch(time, sketch_of(mechanism));
  const double phi = 0.3 + 0.9 * std::sin(5.0 * time + 0.4);
  const double omega = 0.9 * 5.0 * std::cos(5.0 * time + 0.4);
  const double alpha = -0.9 * 25.0 * std::sin(5.0 * time + 0.4);
  const Eigen::Vector2d e(std::cos(phi), std::sin(phi));
  const Eigen::Vector2d n(-e.y(), e.x());
  const Eigen::Vector2d force =
      m * (l * alpha * n - l * omega * omega * e + Eigen::Vector2d(0.0, 9.81));
  const auto reactions = reactions_per_joint(mechanism, state, 0);
  CHECK((reactions[0].force - force).norm() < 1e-11);
  CHECK(reactions[1].moment ==
        Approx(J * alpha + m * l * (l * alpha + 9.81 * std::cos(phi))).epsilon(1e-12));
}

TEST_CASE("degrees of freedom: Gruebler and rank agree on the rig and differ where joints repeat") {
  const Mechanism& mechanism = planar_of(test::rig());
  const State state = test::rig_state(0.0);
  const DegreesOfFreedom rig = degrees_of_freedom_of(mechanism, state.q);
  // 3 x 5 bodies - 2 x 5 pins - 2 x 2 sliders.
  CHECK(rig.gruebler == 1);
  CHECK(rig.by_rank == 1);
  CHECK(rig.redundant == 0);
  CHECK(rig.drivers == 1);
  CHECK(rig.condition > 1.0);

  // A second slider on the sledge says the same twice.
  Mechanism repeated = mechanism;
  repeated.joints.insert(
      repeated.joints.begin(),
      mechanism.joints[static_cast<std::size_t>(joint_index(mechanism, "rail"))]);
  const DegreesOfFreedom twice = degrees_of_freedom_of(repeated, state.q);
  CHECK(twice.gruebler == -1);
  CHECK(twice.by_rank == 1);
  CHECK(twice.redundant == 2);
}

TEST_CASE("the rank does not depend on the unit of length") {
  const Mechanism& mechanism = planar_of(test::rig());
  const State state = test::rig_state(0.1);
  Mechanism scaled = mechanism;
  const double factor = 1e3;
  Eigen::VectorXd q = state.q;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (i % 3 != 2) q[i] *= factor;
  }
  for (Joint& joint : scaled.joints) {
    if (auto* pin = std::get_if<Pin>(&joint.kind)) {
      pin->a.p *= factor;
      pin->b.p *= factor;
    } else if (auto* slider = std::get_if<Slider>(&joint.kind)) {
      slider->point.p *= factor;
      slider->guide.p *= factor;
    }
  }
  for (Body& body : scaled.bodies) {
    for (BodyPoint& point : body.points) point.p *= factor;
  }
  const DegreesOfFreedom metres = degrees_of_freedom_of(mechanism, state.q);
  const DegreesOfFreedom millimetres = degrees_of_freedom_of(scaled, q);
  CHECK(metres.by_rank == millimetres.by_rank);
  CHECK(metres.condition == Approx(millimetres.condition).epsilon(1e-9));
}

}  // namespace reactions_test
