// The seam between mechanism and beam, on the rig.

#include "boxbeam/mechanism/planar/beam_loads.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace beam_loads_test {

using namespace boxbeam;
using namespace boxbeam::planar;

TEST_CASE("beam axes: x along the axis, z its left normal, y into the plane") {
  const double angle = 1.2;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d left(-std::sin(angle), std::cos(angle));
  CHECK((in_beam_axes(along, angle) - Eigen::Vector3d::UnitX()).norm() < 1e-15);
  CHECK((in_beam_axes(left, angle) - Eigen::Vector3d::UnitZ()).norm() < 1e-15);
}

namespace {

void check_balance(const BeamLoads& loads) {
  const Imbalance open = imbalance_of(loads);
  double largest = 0.0;
  for (const PointLoad& load : loads.points) largest = std::max(largest, load.force.norm());
  CHECK(open.force.norm() < 1e-11 * largest);
  CHECK(open.moment.norm() < 1e-11 * largest * 6.2);
}

}  // namespace

TEST_CASE("the loads on the rig's beam are in balance at every instant") {
  const Project& project = test::rig();
  const BeamBody body = beam_body_of(project.beam, project.beam_body);
  for (const State& state : solve_motion(planar_of(project), 24).states) {
    const BeamLoads loads = beam_loads_of(planar_of(project), state, body);
    REQUIRE(loads.points.size() == 3);
    check_balance(loads);
  }
}

TEST_CASE("a force beside the axis turns the beam: balance, and the couple by hand") {
  // 40 kN along the beam, 0.3 m to the left of its axis: 12 kN m clockwise, positive about y, which
  // points into the plane.
  const Project& project = test::rig();
  Mechanism mechanism = planar_of(project);
  mechanism.forces.push_back(
      {"push", PointForce{{project.beam_body, {0.5, 0.3}}, 0.0, true, PolynomialDriver{{40e3}}}});
  const BeamBody body = beam_body_of(project.beam, project.beam_body);
  for (const State& state : solve_motion(mechanism, 24).states) {
    const BeamLoads loads = beam_loads_of(mechanism, state, body);
    const PointLoad& push = loads.points.back();
    CHECK(push.force.x() == Approx(40e3).epsilon(1e-12));
    CHECK(push.moment.y() == Approx(12e3).epsilon(1e-12));
    check_balance(loads);
  }
}

// Newton's third law, and a frame that turns: a load in beam axes has the length of the reaction in
// the world.
TEST_CASE("every load is named after the joint whose reaction it is, or the force") {
  const Project& project = test::rig();
  Mechanism mechanism = planar_of(project);
  mechanism.forces.push_back(
      {"push", PointForce{{project.beam_body, {0.5, 0.3}}, 0.0, true, PolynomialDriver{{40e3}}}});
  const BeamBody body = beam_body_of(project.beam, project.beam_body);
  for (const State& state : solve_motion(mechanism, 24).states) {
    const BeamLoads loads = beam_loads_of(mechanism, state, body);
    std::size_t found = 0;
    for (const Reaction& reaction : reactions_of(mechanism, state)) {
      if (reaction.on != project.beam_body) continue;
      const std::string& joint = mechanism.joints[static_cast<std::size_t>(reaction.joint)].name;
      for (const PointLoad& load : loads.points) {
        if (load.name != joint) continue;
        CHECK(load.force.norm() == Approx(reaction.force.norm()).epsilon(1e-12));
        ++found;
      }
    }
    CHECK(found == 3);
    CHECK(loads.points.back().name == "push");
  }
}

TEST_CASE("the bending moments of the two ends meet at the pivot to 1e-10") {
  // From the lower end by the diagram; from the upper end by summing what acts above the pivot,
  // with Simpson's rule on weight and inertia per length (exact for cubics).
  const Project& project = test::rig();
  const BeamBody body = beam_body_of(project.beam, project.beam_body);
  for (const State& state : solve_motion(planar_of(project), 24).states) {
    const BeamLoads loads = beam_loads_of(planar_of(project), state, body);
    const double pivot = 3.2;
    const double from_below =
        cut_forces_of(loads).at({si<Length>(pivot), Side::behind}).M_y.value();
    double from_above = 0.0;
    for (const PointLoad& load : loads.points) {
      if (load.s.value() > pivot) {
        from_above += load.moment.y() - (load.s.value() - pivot) * load.force.z();
      }
    }
    for (std::size_t i = 0; i < project.beam.segments.size(); ++i) {
      const Segment& segment = project.beam.segments[i];
      if (segment.start.value() < pivot - 1e-9) continue;
      const int n = 32;
      const double h = segment.length.value() / n;
      for (int k = 0; k <= n; ++k) {
        const double x = h * k;
        const double weight = h / 3.0 * (k == 0 || k == n ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0));
        from_above -= weight * (segment.start.value() + x - pivot) * loads.lines[i].force[2](x);
      }
    }
    // The cut's moment balances what acts behind it: its own sign is that of the part before.
    CHECK(from_below == Approx(from_above).epsilon(1e-10).margin(1e-4));
  }
}

TEST_CASE("a joint stands exactly where the segments meet") {
  const Project& project = test::rig();
  const BeamBody body = beam_body_of(project.beam, project.beam_body);
  const BeamLoads loads = beam_loads_of(planar_of(project), test::rig_state(0.1), body);
  CHECK(loads.points[0].s == project.beam.segments[1].end());
  CHECK(cut_forces_of(loads).pieces.size() == project.beam.segments.size());
}

}  // namespace beam_loads_test
