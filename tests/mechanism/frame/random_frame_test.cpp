// Random frames of prismatic pieces against a direct stiffness program that shares nothing with
// the solver: reactions, joint forces, cut forces on both sides of every node, and motions.

#include "support/random_frame.hpp"
#include "catch.hpp"
#include "support/frame_by_stiffness.hpp"
#include "support/property.hpp"

namespace random_frame_test {

using namespace boxbeam;
using namespace boxbeam::frame;

namespace {

/// Largest difference of two quantities of six numbers, by the largest of forces (shifts) and of
/// couples (turns).
class Differences {
 public:
  void add(const Vector6& a, const Vector6& b) {
    for (int k = 0; k < 2; ++k) {
      const auto half = [k](const Vector6& of) { return of.segment<3>(3 * k); };
      size_[k] = std::max(size_[k], half(b).norm());
      missed_[k] = std::max(missed_[k], (half(a) - half(b)).norm());
    }
  }
  double largest() const {
    double worst = 0.0;
    for (int k = 0; k < 2; ++k) {
      if (missed_[k] > 0.0) worst = std::max(worst, missed_[k] / std::max(size_[k], least_));
    }
    return worst;
  }
  explicit Differences(double least) : least_(least) {}

 private:
  double least_;  ///< what is smaller is nothing
  double size_[2] = {0.0, 0.0}, missed_[2] = {0.0, 0.0};
};

Vector6 vector_of(const CutForces& of) {
  Vector6 cut;
  cut << of.N.value(), of.V_y.value(), of.V_z.value(), of.T.value(), of.M_y.value(), of.M_z.value();
  return cut;
}

void agree(bool plane) {
  const test::RandomFrame random(plane, false);
  const ActingLoads loads = random.loads();
  const Statics statics(random.of);
  const Equilibrium at = statics.solve(loads);
  const test::FrameByStiffness expected(random.of, loads);
  RC_ASSERT(expected.solution().balance < 1e-17);

  Differences joints(1.0), cuts(1.0), motions(1e-9);
  for (std::size_t j = 0; j < at.joints.size(); ++j)
    joints.add(at.joints[j], expected.solution().joints[j]);
  for (const auto& station : expected.stations()) {
    const CutForceDiagram& cut = at.members[static_cast<std::size_t>(station.member)].cut;
    const Length s = si<Length>(station.s);
    cuts.add(vector_of(cut.at({s, Side::before})), station.before);
    cuts.add(vector_of(cut.at({s, Side::behind})), station.behind);
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
