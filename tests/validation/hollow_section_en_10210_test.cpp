// Properties of rolled hollow sections. Source: EN 10210-2:2006, tables of hot-finished sections
// and the formulas of annex B, outer radius 1.5 t, inner radius 1.0 t.

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"

namespace hollow_section_en_10210_test {

using namespace boxbeam;

namespace {

RectangularTube rolled(double width, double height, double wall) {
  const auto mm = [](double x) { return si<Length>(1e-3 * x); };
  return {mm(width), mm(height), mm(wall), mm(1.5 * wall), mm(wall)};
}

}  // namespace

TEST_CASE("RHS 200 x 100 x 8: A 44.75 cm^2, I 2234 and 739 cm^4, I_T 1804 cm^4", "[validation]") {
  const Section section{rolled(100, 200, 8), {}};
  const SectionProperties p = properties_of(section);
  CHECK(p.area.value() * 1e4 == Approx(44.75).margin(0.005));
  CHECK(p.I_y.value() * 1e8 == Approx(2234).margin(0.5));
  CHECK(p.I_z.value() * 1e8 == Approx(739).margin(0.5));
  CHECK(torsion_properties_of(section).I_T->value() * 1e8 == Approx(1804).margin(0.5));
}

TEST_CASE("SHS 100 x 5: A 18.73 cm^2, I 279.4 cm^4, I_T 439.4 cm^4", "[validation]") {
  const Section section{rolled(100, 100, 5), {}};
  const SectionProperties p = properties_of(section);
  CHECK(p.area.value() * 1e4 == Approx(18.73).margin(0.01));
  CHECK(p.I_y.value() * 1e8 == Approx(279.4).margin(0.1));
  CHECK(p.I_z.value() * 1e8 == Approx(279.4).margin(0.1));
  CHECK(torsion_properties_of(section).I_T->value() * 1e8 == Approx(439.4).margin(0.1));
}

}  // namespace hollow_section_en_10210_test
