// Near resonance: digits fall with the distance from it and the damping, and are never lost
// unsaid.

#include <cmath>

#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace resonance_map_test {

using namespace boxbeam::charts;

TEST_CASE(
    "the map of resonance: refused where nothing limits the amplitude, else as many digits "
    "as there can be",
    "[charts][stability]") {
  const Map map = resonance_map({}, {true});
  REQUIRE(map.panels.size() == 3);
  for (std::size_t i = 0; i < 2; ++i) {
    CAPTURE(map.panels[i].method);
    CHECK(map.panels[i].count(Outcome::wrong) == 0);
    for (const Cell& cell : map.panels[i].cells) {
      // |1 - r^2 + 2 i zeta r| = 2 |1 - r + i zeta| near r = 1.
      const double limit = std::hypot(cell.x, cell.y);
      CAPTURE(cell.x, cell.y);
      CHECK((cell.outcome == Outcome::refused) == (limit < 1e-6));
      if (cell.outcome == Outcome::refused) {
        CHECK(cell.reason.find("natural frequency") != std::string::npos);
      } else if (i == 0) {
        CHECK(*cell.value > 16.0 + std::log10(limit) - 2.0);
      }
    }
  }
  CHECK(map.panels[2].count(Outcome::wrong) > 0);
  CHECK(test::errors_of({{}, {resonance_map({}, {true})}, ""}) == test::errors_of({{}, {map}, ""}));
}

}  // namespace resonance_map_test
