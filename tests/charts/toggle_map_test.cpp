// Where assembly succeeds, refuses and fails silently near a toggle.

#include <cmath>

#include "charts/chart_values.hpp"
#include "charts/toggle.hpp"

namespace toggle_map_test {

using namespace boxbeam::charts;

namespace {

void check_map(const Map& map) {
  INFO(map.scene);
  REQUIRE(map.panels.size() == 3);
  const MapPanel& program = map.panels[0];
  const MapPanel& newton = map.panels[1];
  CHECK(program.count(Outcome::wrong) == 0);
  // Plain Newton and least squares know nothing of branches: from anywhere half of the two or four
  // assemblies are wrong, and with five starts per cell one nearly always is.
  CHECK(newton.count(Outcome::wrong) > newton.cells.size() / 4);
  CHECK(map.panels[2].count(Outcome::wrong) > newton.cells.size() / 10);
  for (const Cell& cell : program.cells) {
    INFO("distance " << cell.x << ", start error " << cell.y);
    if (cell.outcome == Outcome::refused) {
      // Only where there is hardly a digit to give: round-off over the distance.
      CHECK(cell.reason != "");
      CHECK(cell.x < 1e-11);
    } else {
      // Digits left: those of 2^-53 over the distance, less what the mechanism's shape takes.
      REQUIRE(cell.value);
      CHECK(*cell.value > -std::log10(1e-14 / cell.x));
      CHECK(*cell.value > 2.0);
    }
  }
  // A start within a tenth of the distance between the branches is right with any method.
  for (const Cell& cell : newton.cells) {
    if (cell.y < 0.1 * std::sqrt(cell.x)) CHECK(cell.outcome == Outcome::solved);
  }
}

}  // namespace

TEST_CASE("near a toggle boxbeam is right or says why not, where plain Newton is silently wrong") {
  check_map(toggle_map_of(four_bar_before_toggle(), {true}));
  check_map(toggle_map_of(toggle_scene_of(reference_scenes()), {true}));
  check_map(toggle_map_of(toggle_scene_of(test::shipped_scene("scissor-lift/lift.toml")), {true}));
}

TEST_CASE("the map of toggles is the same twice") {
  const Map first = toggle_map_of(four_bar_before_toggle(), {true});
  const Map second = toggle_map_of(four_bar_before_toggle(), {true});
  for (std::size_t p = 0; p < first.panels.size(); ++p) {
    REQUIRE(first.panels[p].cells.size() == second.panels[p].cells.size());
    for (std::size_t i = 0; i < first.panels[p].cells.size(); ++i) {
      CHECK(first.panels[p].cells[i].outcome == second.panels[p].cells[i].outcome);
      CHECK(first.panels[p].cells[i].value == second.panels[p].cells[i].value);
    }
  }
}

}  // namespace toggle_map_test
