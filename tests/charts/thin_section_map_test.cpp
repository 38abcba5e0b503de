#include <cmath>

#include "catch.hpp"
#include "charts/topics.hpp"

namespace thin_section_map_test {

using namespace boxbeam::charts;

namespace {

const Cell& cell_at(const MapPanel& panel, double x, double y) {
  for (const Cell& cell : panel.cells) {
    if (std::abs(cell.x / x - 1.0) < 1e-9 && std::abs(cell.y / y - 1.0) < 1e-9) return cell;
  }
  throw std::out_of_range("no such trial");
}

}  // namespace

TEST_CASE("thin walls: never silently wrong, and refused where no hollow is left", "[charts]") {
  const Map map = thin_section_map(reference_scenes(), {true});
  REQUIRE(map.panels.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) {
    const MapPanel& panel = map.panels[i];
    CAPTURE(panel.method);
    CHECK_FALSE(panel.yardstick);
    CHECK(panel.count(Outcome::wrong) == 0);
    for (const Cell& cell : panel.cells) {
      CAPTURE(cell.x, cell.y);
      const bool hollow = 2.0 * cell.x < cell.y && 2.0 * cell.x < 1.0;
      CHECK((cell.outcome == Outcome::refused) == !hollow);
      if (!hollow) {
        CHECK(cell.reason.find("leave no clear height") != std::string::npos);
        continue;
      }
      // Outer less inner rectangle: eps over the part of the area that is wall, and H - 2 t loses
      // eps H/t of nothing. Some ten roundings.
      const double wall = cell.x * (1.0 + 1.0 / cell.y);
      CHECK(*cell.value >= std::min(14.5, -std::log10(20.0 * 1.1e-16 / std::min(wall, 1.0))));
    }
  }
  // The torsion constant is no difference: 15 digits however thin.
  for (const Cell& cell : map.panels[1].cells) CHECK(cell.value.value_or(16.0) > 15.0);
  // The control: Bredt on mid-lines is 4 % low or so in a box of a tenth of its height.
  CHECK(map.panels[3].yardstick);
  CHECK(cell_at(map.panels[3], 0.1, 1.0).outcome == Outcome::wrong);
  CHECK(cell_at(map.panels[3], 1e-6, 1.0).outcome == Outcome::solved);
}

TEST_CASE("tapers from gentle slopes to steps and wedges: never silently wrong", "[charts]") {
  const Map map = taper_map(reference_scenes(), {true});
  REQUIRE(map.panels.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(map.panels[i].method);
    CHECK(map.panels[i].count(Outcome::solved) == map.panels[i].cells.size());
  }
  // Exact integrals of polynomials; the differences of the taper have steps of 1e-5.
  for (const Cell& cell : map.panels[1].cells) CHECK(*cell.value > 14.5);
  for (const Cell& cell : map.panels[2].cells) {
    // Where stations are told apart by few digits, in the middle of a short taper, that is felt.
    CHECK(*cell.value > (cell.x > 1e-9 * 10.0 ? 9.0 : 6.0));
  }
  // The control: at the tip of a wedge of 1 : 1e6 the height changes tenfold in one such step.
  CHECK(cell_at(map.panels[3], 1.0, 1e-6).outcome == Outcome::wrong);
  CHECK(cell_at(map.panels[3], 1.0, 0.1).outcome == Outcome::solved);
}

}  // namespace thin_section_map_test
