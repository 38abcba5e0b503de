// Stiff joints between elastic links: every digit in boxbeam, one less with every power of ten in a
// stiffness matrix of absolute coordinates.

#include <cmath>

#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace stiff_joint_map_test {

using namespace boxbeam::charts;

TEST_CASE("the map of stiff joints: boxbeam loses nothing, absolute coordinates what theory says",
          "[charts][stability]") {
  const Map map = stiff_joint_map({}, {true});
  REQUIRE(map.panels.size() == 2);
  const MapPanel& boxbeam = map.panels[0];
  CHECK(boxbeam.count(Outcome::solved) == boxbeam.cells.size());
  for (const Cell& cell : boxbeam.cells) {
    CAPTURE(cell.x, cell.y);
    CHECK(cell.value.value() > 14.0);
  }
  // Digits left of a sum c + k: 16 less the powers of ten of c/k.
  const MapPanel& absolute = map.panels[1];
  for (const Cell& cell : absolute.cells) {
    const double power = std::log10(cell.x);
    CAPTURE(cell.x, cell.y);
    if (cell.y == 1.0 && power >= 4.0 && power <= 12.0) {
      CHECK(cell.value.value() == Approx(16.0 - power).margin(2.0));
    }
    if (power >= 16.0) CHECK(cell.outcome == Outcome::wrong);
  }
  CHECK(test::errors_of({{}, {stiff_joint_map({}, {true})}, ""}) ==
        test::errors_of({{}, {map}, ""}));
}

}  // namespace stiff_joint_map_test
