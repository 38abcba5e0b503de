// Class 3 limits of EN 1993-1-1:2005, table 5.2.

#include "boxbeam/strength/plate_slenderness.hpp"

#include "boxbeam/project/catalogue.hpp"
#include "catch.hpp"

namespace plate_slenderness_test {

using namespace boxbeam;

namespace {

Profile box(double width, double height, double thickness) {
  return symmetric_box(si<Length>(width), si<Length>(height), si<Length>(thickness),
                       si<Length>(thickness));
}

}  // namespace

TEST_CASE("S355 up to 16 mm: eps = 0.8136, flange limit 34.2, web limit 100.9") {
  const Material steel = *find_steel("S355");
  // 1 mm plates: the flange of 40 mm is 38/1, the web of 110 mm 108/1.
  const auto slender = slender_plates_of(box(0.040, 0.110, 0.001), steel);
  REQUIRE(slender.size() == 2);
  CHECK(slender[0].ratio == Approx(38.0).epsilon(1e-12));
  CHECK(slender[0].limit == Approx(34.2).margin(0.05));
  CHECK(slender[1].limit == Approx(100.9).margin(0.05));
  CHECK(slender_plates_of(box(0.036, 0.102, 0.001), steel).empty());
}

TEST_CASE("the sledge rig's plates are far from slender") {
  CHECK(slender_plates_of(box(0.4, 1.0, 0.05), *find_steel("S355")).empty());
}

TEST_CASE("round tubes: D/t against 90 eps^2 = 59.6 for S355") {
  const Material steel = *find_steel("S355");
  CHECK(slender_plates_of(RoundTube{0.59 * metre, 0.01 * metre}, steel).empty());
  const auto slender = slender_plates_of(RoundTube{0.60 * metre, 0.01 * metre}, steel);
  REQUIRE(slender.size() == 1);
  CHECK(slender[0].limit == Approx(90.0 * 235.0 / 355.0).epsilon(1e-12));
}

TEST_CASE("the plate of a rolled hollow section is b - 3 t: SHS 300x8 of S355 is class 4") {
  const Material steel = *find_steel("S355");
  const auto shs = [](double wall) {
    const Length t = si<Length>(wall);
    return RectangularTube{0.3 * metre, 0.3 * metre, t, 1.5 * t, 1.0 * t};
  };
  // By hand, EN 1993-1-5 4.4(2) and EN 1993-1-1 table 5.2: eps = sqrt(235/355) = 0.81362,
  // 42 eps = 34.172; (300 - 24)/8 = 34.5 is beyond it, (300 - 30)/10 = 27 is not. The flat part
  // between the corners, 300 - 4 * 8 = 268 mm, would pass with 33.5.
  const auto plates = plate_slenderness_of(shs(0.008), steel);
  REQUIRE(plates.size() == 2);
  CHECK(plates[0].ratio == Approx(34.5).epsilon(1e-12));
  CHECK(plates[0].limit == Approx(34.172).margin(5e-4));
  CHECK(plates[1].ratio == Approx(34.5).epsilon(1e-12));
  const auto slender = slender_plates_of(shs(0.008), steel);
  REQUIRE(slender.size() == 1);
  CHECK(slender[0].plate == "flange");
  CHECK(slender_plates_of(shs(0.010), steel).empty());
}

TEST_CASE("between corners sharper than rolled ones a tube's plate is as long as it is") {
  const RectangularTube folded{0.3 * metre, 0.3 * metre, 0.008 * metre};
  CHECK(plate_slenderness_of(folded, *find_steel("S355")).front().ratio ==
        Approx((300.0 - 16.0) / 8.0).epsilon(1e-12));
}

}  // namespace plate_slenderness_test
