// Bending of an I-section. Source: Peery and Azar, Aircraft Structures, 6.2.1: depth 6 in, flanges
// 3 x 1 in, web 1 in, M = 8e5 lb in; I = 43.3 in^4, largest stress 55 427 psi (with I rounded so).

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"

namespace peery_i_section_test {

using namespace boxbeam;

TEST_CASE("Peery's I-section: I 43.3 in^4, stress 55 427 psi, as a path and as a polygon",
          "[validation]") {
  constexpr double inch = 0.0254, pound = 4.4482216152605;
  const auto at = [](double y, double z) {
    return SectionPlace{si<Length>(inch * y), si<Length>(inch * z)};
  };
  const Length t = si<Length>(inch);
  // Flanges in halves, the web between their inner faces.
  const ThinWalled path{
      {at(-1.5, 2.5), at(0, 2.5), at(1.5, 2.5), at(-1.5, -2.5), at(0, -2.5), at(1.5, -2.5)},
      {{0, 1, t, {}, {}},
       {1, 2, t, {}, {}},
       {3, 4, t, {}, {}},
       {4, 5, t, {}, {}},
       {4, 1, t, 0.5 * t, 0.5 * t}}};
  const Polygon polygon{{at(-1.5, -3), at(1.5, -3), at(1.5, -2), at(0.5, -2), at(0.5, 2),
                         at(1.5, 2), at(1.5, 3), at(-1.5, 3), at(-1.5, 2), at(-0.5, 2),
                         at(-0.5, -2), at(-1.5, -2)}};
  for (const Profile& profile : {Profile{path}, Profile{polygon}}) {
    const Section section{profile, {}};
    CHECK(properties_of(section).I_y.value() / std::pow(inch, 4) == Approx(43.3).margin(0.05));
    const double M = 8e5 * pound * inch;
    const double stress =
        normal_influence(sums_of(outline_of(section, {})), 0.0, 3 * inch).normal[cut_force::M_y] *
        M;
    CHECK(stress / (pound / (inch * inch)) == Approx(55427).epsilon(1e-3));
  }
}

}  // namespace peery_i_section_test
