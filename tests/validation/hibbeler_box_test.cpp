// Shear flow in a box girder of three cells. Source: Hibbeler, Mechanics of Materials, shear flow
// in thin-walled members: a box 145 x 300 mm, walls 10 mm, with two inner plates 125 x 10 mm at
// +-105 mm from the middle, V = 18 kN; q_A at the outer and q_B at the inner plates.

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_flow.hpp"
#include "catch.hpp"

namespace hibbeler_box_test {

using namespace boxbeam;

TEST_CASE("Hibbeler's box girder: I 125.1667e-6 m^4, q_A 13.033 and q_B 9.437 kN/m",
          "[validation]") {
  const auto at = [](double y, double z) {
    return SectionPlace{si<Length>(1e-3 * y), si<Length>(1e-3 * z)};
  };
  const Length t = si<Length>(0.01);
  const Length half = 0.5 * t;
  // Webs over the whole height, plates of 125 mm between them.
  ThinWalled box;
  for (const double z : {-145.0, -105.0, 105.0, 145.0}) {
    box.nodes.push_back(at(-67.5, z));
    box.nodes.push_back(at(67.5, z));
    box.walls.push_back({box.nodes.size() - 2, box.nodes.size() - 1, t, half, half});
  }
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    box.walls.push_back({side, 2 + side, t, -half, {}});
    box.walls.push_back({2 + side, 4 + side, t, {}, {}});
    box.walls.push_back({4 + side, 6 + side, t, {}, -half});
  }
  const Section section{box, {}};
  // 145 300^3/12 - 125 280^3/12 + 2 (125 10^3/12 + 1250 105^2) mm^4
  CHECK(properties_of(section).I_y.value() == Approx(125.1667e-6).epsilon(1e-6));
  CHECK(properties_of(section).area.value() == Approx(11e-3).epsilon(1e-12));

  const ShearFlow flow = *shear_flow_of(section, {}, {});
  CHECK(flow.at.cells.cells.size() == 3);
  const auto q = [&](std::size_t wall) {
    return std::abs(flow_at(flow, wall, 1.0)[cut_force::V_z]) * 18e3;
  };
  CHECK(q(3) == Approx(13.033e3).epsilon(1e-4));
  CHECK(q(2) == Approx(9.437e3).epsilon(1e-4));
  CHECK(q(0) == Approx(13.033e3).epsilon(1e-4));
  CHECK(q(1) == Approx(9.437e3).epsilon(1e-4));
}

}  // namespace hibbeler_box_test
