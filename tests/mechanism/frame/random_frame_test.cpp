// Random frames of prismatic pieces against a direct stiffness program that shares nothing with
// the solver: reactions, joint forces, cut forces on both sides of every node, and motions.

#include "support/random_frame.hpp"
#include "catch.hpp"
#include "support/frame_by_stiffness.hpp"
#include "support/frame_differences.hpp"
#include "support/property.hpp"

namespace random_frame_test {

using namespace boxbeam;
using namespace boxbeam::frame;

namespace {

void agree(bool plane) {
  const test::RandomFrame random(plane, false);
  const ActingLoads loads = random.loads();
  const Statics statics(random.of);
  const Equilibrium at = statics.solve(loads);
  const test::FrameByStiffness expected(random.of, loads);
  RC_ASSERT(expected.solution().balance < 1e-17);

  test::Differences joints(1.0), cuts(1.0), motions(1e-9);
  for (std::size_t j = 0; j < at.joints.size(); ++j)
    joints.add(at.joints[j], expected.solution().joints[j]);
  for (const auto& station : expected.stations()) {
    cuts.add(test::cut_at(at, station.member, station.s, Side::before), station.before);
    cuts.add(test::cut_at(at, station.member, station.s, Side::behind), station.behind);
    motions.add(statics.motion_at(station.member, station.s, at), station.motion);
  }
  RC_ASSERT(joints.largest() < 1e-9);
  RC_ASSERT(cuts.largest() < 1e-9);
  RC_ASSERT(motions.largest() < 1e-9);
}

TEST_CASE("random frames in the plane stand as by direct stiffness", "[frame]") {
  test::holds([] { agree(true); }, 250);
}

TEST_CASE("random frames in space stand as by direct stiffness", "[frame]") {
  test::holds([] { agree(false); }, 250);
}

}  // namespace

}  // namespace random_frame_test
