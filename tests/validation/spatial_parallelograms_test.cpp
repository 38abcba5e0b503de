// Parallelograms in space in a row.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

namespace spatial_parallelograms_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::add;
using test::closing;
using test::joint_of;

TEST_CASE("A hundred parallelograms in a row turn as the first: no determinant is too small") {
  // Cranks of 1 m, 1 m apart, about y; couplers on universal joints end in balls. All turn alike.
  constexpr int loops = 100;
  Mechanism row;
  row.gravity = {0.0, 0.0, -9.81};
  const auto moved = [](const char* name, int parent, const Vector3d& at, const Vector3d& axis) {
    Joint joint = joint_of(name, JointKind::revolute, parent, at, axis);
    joint.moved_by = MovedBy::loops;
    return joint;
  };
  Joint first = joint_of("crank", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitY());
  first.driver = PolynomialDriver{{0.1, 0.5}};
  int last = add(row, first, false);
  std::vector<int> cranks{last};
  std::vector<int> couplers;
  for (int i = 1; i <= loops; ++i) {
    const int next = add(row, moved("crank", ground, {1.0 * i, 0.0, 0.0}, Vector3d::UnitY()), true);
    const int frame = add(row, moved("hook.1", last, Vector3d::UnitZ(), Vector3d::UnitY()), true);
    const int coupler = add(row, moved("hook.2", frame, Vector3d::Zero(), Vector3d::UnitZ()), true);
    row.closing.push_back(closing("ball", ClosingKind::spherical, {coupler, {1.0, 0.0, 0.0}},
                                  {next, Vector3d::UnitZ()}));
    cranks.push_back(last = next);
    couplers.push_back(coupler);
  }
  row.duration = Duration{0.0, 0.1};
  const Chain chain(row);
  const State state = chain.at(0.08);
  double worst = 0.0;
  for (const int crank : cranks) {
    const DriverState& q = state.coordinates[static_cast<std::size_t>(crank)];
    worst = std::max(
        {worst, std::abs(q.value - 0.14), std::abs(q.rate - 0.5), std::abs(q.acceleration)});
  }
  for (const int coupler : couplers)
    worst = std::max(
        worst,
        (state.bodies[static_cast<std::size_t>(coupler)].R_WB - Matrix3d::Identity()).norm());
  CHECK(worst < 1e-9);
}

}  // namespace spatial_parallelograms_test
