#include "boxbeam/section/section.hpp"

#include <tuple>

#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "catch.hpp"

namespace section_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

Box box(double width, double height, double flange, double web) {
  return symmetric_box(mm(width), mm(height), mm(flange), mm(web));
}

RoundTube tube(double diameter, double wall) { return {mm(diameter), mm(wall)}; }

bool possible(const Section& section) { return !defect_of(section).has_value(); }

}  // namespace

// The box of the sledge rig: 400 x 600 mm, plates of 50 mm, clear space 300 x 500 mm.

TEST_CASE("sound profiles have no defect") {
  CHECK(possible({box(400, 600, 50, 50), {}}));
  CHECK(possible({tube(200, 10), {}}));
  CHECK(possible({box(400, 600, 50, 50), box(290, 490, 56, 56)}));
}

TEST_CASE("dimensions and walls must be above zero") {
  CHECK_FALSE(possible({box(0, 600, 50, 50), {}}));
  CHECK_FALSE(possible({box(400, -600, 50, 50), {}}));
  CHECK_FALSE(possible({box(400, 600, 0, 50), {}}));
  CHECK_FALSE(possible({box(400, 600, 50, -1), {}}));
  CHECK_FALSE(possible({tube(0, 10), {}}));
  CHECK_FALSE(possible({tube(200, 0), {}}));
}

TEST_CASE("a plate thinner than a ten thousandth of its profile is a foil") {
  CHECK_FALSE(foil_in({box(400, 600, 0.061, 10), {}}));
  CHECK(foil_in({box(400, 600, 0.059, 10), {}}));
  CHECK(*foil_in({box(400, 600, 10, 1e-5), {}}) == "1e-05 mm thin in a profile of 600 mm");
  CHECK_FALSE(foil_in({tube(200, 0.021), {}}));
  CHECK(foil_in({box(400, 600, 10, 10), tube(200, 0.019)}));
}

TEST_CASE("walls must leave a hollow") {
  CHECK(possible({box(400, 600, 299, 199), {}}));
  CHECK_FALSE(possible({box(400, 600, 300, 50), {}}));
  CHECK_FALSE(possible({box(400, 600, 50, 200), {}}));
  CHECK(possible({tube(200, 99), {}}));
  CHECK_FALSE(possible({tube(200, 100), {}}));
}

TEST_CASE("a defect of the inner profile is said to be the inner one's") {
  const auto defect = defect_of(Section{box(400, 600, 50, 50), tube(200, 100)});
  REQUIRE(defect);
  CHECK(defect->find("inner profile") == 0);
}

TEST_CASE("an inner profile must fit the clear space of a box") {
  const Profile outer = box(400, 600, 50, 50);
  CHECK(possible({outer, box(299, 499, 20, 20)}));
  CHECK_FALSE(possible({outer, box(301, 490, 20, 20)}));
  CHECK_FALSE(possible({outer, box(290, 501, 20, 20)}));
  CHECK(possible({outer, tube(299, 10)}));
  CHECK_FALSE(possible({outer, tube(301, 10)}));
}

TEST_CASE("no round tube in the rig's box reaches the published 74.9e-3 m^2") {
  // The largest circle in 300 x 500 mm has pi/4 0.3^2 = 70.7e-3 m^2, even as a solid bar. A tube
  // of that area with a wall of 56 mm has the diameter A/(pi t) + t = 482 mm.
  CHECK_FALSE(possible({box(400, 600, 50, 50), tube(482, 56)}));
}

TEST_CASE("an inner profile must fit the clear diameter of a round tube") {
  const Profile outer = tube(520, 10);  // clear 500 mm
  CHECK(possible({outer, tube(499, 5)}));
  CHECK_FALSE(possible({outer, tube(501, 5)}));
  // A rectangle by its diagonal: 300-400-500 is a right triangle.
  CHECK(possible({outer, box(299, 400, 10, 10)}));
  CHECK_FALSE(possible({outer, box(301, 400, 10, 10)}));
}

TEST_CASE("every dimension of an interpolated section varies linearly") {
  const Section from{box(400, 600, 50, 40), tube(200, 10)};
  const Section to{box(200, 1000, 30, 60), tube(100, 30)};
  const Section quarter = interpolate(from, to, 0.25);
  const auto& outer = std::get<Box>(quarter.outer);
  CHECK(outer.width.value() == Approx(0.350).epsilon(1e-14));
  CHECK(outer.height.value() == Approx(0.700).epsilon(1e-14));
  CHECK(outer.top_flange.value() == Approx(0.045).epsilon(1e-14));
  CHECK(outer.left_web.value() == Approx(0.045).epsilon(1e-14));
  const auto& inner = std::get<RoundTube>(*quarter.inner);
  CHECK(inner.diameter.value() == Approx(0.175).epsilon(1e-14));
  CHECK(inner.wall.value() == Approx(0.015).epsilon(1e-14));
  CHECK(interpolate(from, to, 0.0) == from);
  CHECK(interpolate(from, from, 0.7) == from);
}

TEST_CASE("only sections of the same kinds of profile taper into each other") {
  const Section plain{box(400, 600, 50, 50), {}};
  const Section other_size{box(100, 200, 5, 5), {}};
  const Section round{tube(200, 10), {}};
  const Section nested{box(400, 600, 50, 50), tube(200, 10)};
  const Section nested_box{box(400, 600, 50, 50), box(100, 200, 5, 5)};
  CHECK(same_kind(plain, other_size));
  CHECK(same_kind(nested, nested));
  CHECK_FALSE(same_kind(plain, round));
  CHECK_FALSE(same_kind(plain, nested));
  CHECK_FALSE(same_kind(nested, plain));
  CHECK_FALSE(same_kind(nested, nested_box));
}

TEST_CASE("height, clear height and the wall at a level follow the drawing") {
  const Profile outer = box(400, 600, 50, 40);
  CHECK(height_of(outer).value() == Approx(0.6).epsilon(1e-15));
  CHECK(clear_top_of(outer).value() == Approx(0.25).epsilon(1e-15));
  for (const double sign : {1.0, -1.0}) {
    CHECK(wall_at(outer, mm(sign * 260)) == mm(50));
    CHECK(wall_at(outer, mm(sign * 240)) == mm(40));
  }
  CHECK(wall_at(outer, mm(0)) == mm(40));
  const Profile round = tube(200, 10);
  CHECK(height_of(round) == mm(200));
  CHECK(clear_top_of(round).value() == Approx(0.09).epsilon(1e-15));
  CHECK(wall_at(round, mm(95)) == mm(10));
}

TEST_CASE("the webs of a box with unlike flanges end at each flange's own inner face") {
  // 600 mm high: the top flange of 30 mm ends at 270 mm, the bottom one of 80 mm at -220 mm.
  const Profile unlike = Box{mm(400), mm(600), mm(30), mm(80), mm(10), mm(20)};
  CHECK(clear_top_of(unlike).value() == Approx(0.27).epsilon(1e-12));
  CHECK(clear_bottom_of(unlike).value() == Approx(-0.22).epsilon(1e-12));
  CHECK(wall_at(unlike, mm(265)) == mm(20));
  CHECK(wall_at(unlike, mm(275)) == mm(30));
  CHECK(wall_at(unlike, mm(-215)) == mm(20));
  CHECK(wall_at(unlike, mm(-225)) == mm(80));
}

TEST_CASE("of two plates beside each other the weaker decides, which is the thicker") {
  // S355 by EN 10025-2, table 7: 355 MPa up to 16 mm, 345 MPa up to 40 mm, 335 MPa up to 63 mm.
  const auto yield_at = [](const Section& section, double z) {
    return yield_strength_of(*find_steel("S355", "EN 10025-2"), wall_at(section, mm(z)))
               .value()
               .value() *
           1e-6;
  };
  const Profile thin = box(400, 600, 50, 12), stout = box(400, 600, 50, 30);
  for (const auto& [outer, inner_web, weaker] :
       {std::tuple(thin, 20.0, 345.0), {thin, 10.0, 355.0}, {stout, 10.0, 345.0}}) {
    const Section nested{outer, box(290, 400, 14, inner_web)};
    CAPTURE(inner_web);
    CHECK(yield_at(nested, 0) == Approx(weaker));
    CHECK(yield_at(nested, -180) == Approx(weaker));
    // Above the inner box the web stands alone, and beyond it the flange.
    CHECK(yield_at(nested, 220) == Approx(yield_at({outer, {}}, 220)));
    CHECK(yield_at(nested, 290) == Approx(335.0));
  }
  CHECK(beside_inner({thin, box(290, 400, 14, 20)}, mm(12), mm(0)) == mm(20));
  CHECK(beside_inner({thin, box(290, 400, 14, 20)}, mm(12), mm(220)) == mm(12));
}

TEST_CASE("stiffeners lie inside the box and not in one another", "[section]") {
  Box stiff = box(400, 600, 20, 20);
  stiff.stiffeners = {{BoxPlate::top_flange, mm(0), mm(100), mm(10)}};
  CHECK(possible({stiff, {}}));
  stiff.stiffeners.push_back({BoxPlate::left_web, mm(230), mm(300), mm(10)});
  CHECK(defect_of(Section{stiff, {}})->find("cuts into") != std::string::npos);
  stiff.stiffeners = {{BoxPlate::top_flange, mm(178), mm(100), mm(10)}};
  CHECK(defect_of(Section{stiff, {}})->find("does not fit inside") != std::string::npos);
}

TEST_CASE("corner radii come in pairs and fit the tube", "[section]") {
  CHECK(possible({RectangularTube{mm(100), mm(200), mm(8), mm(12), mm(8)}, {}}));
  CHECK_FALSE(possible({RectangularTube{mm(100), mm(200), mm(8), mm(12), mm(0)}, {}}));
  CHECK_FALSE(possible({RectangularTube{mm(100), mm(200), mm(8), mm(60), mm(40)}, {}}));
}

TEST_CASE("loops must not cross themselves, hollows lie inside", "[section]") {
  const auto at = [](double y, double z) { return SectionPlace{mm(y), mm(z)}; };
  const std::vector<SectionPlace> square{at(0, 0), at(100, 0), at(100, 100), at(0, 100)};
  CHECK(possible({Polygon{square}, {}}));
  CHECK_FALSE(possible({Polygon{{at(0, 0), at(100, 100), at(100, 0), at(0, 100)}}, {}}));
  CHECK_FALSE(possible({Polygon{{at(0, 0), at(100, 0)}}, {}}));
  CHECK(possible({Polygon{square, {{at(10, 10), at(20, 10), at(10, 20)}}}, {}}));
  CHECK_FALSE(possible({Polygon{square, {{at(110, 10), at(120, 10), at(110, 20)}}}, {}}));
  CHECK_FALSE(possible({Polygon{square, {{at(90, 10), at(120, 10), at(90, 20)}}}, {}}));
}

TEST_CASE("walls of a path hang together and do not cross away from nodes", "[section]") {
  const auto at = [](double y, double z) { return SectionPlace{mm(y), mm(z)}; };
  const ThinWall first{0, 1, mm(5), {}, {}}, second{2, 3, mm(5), {}, {}}, join{1, 2, mm(5), {}, {}};
  CHECK(possible({ThinWalled{{at(0, 0), at(100, 0), at(100, 50)}, {first, join}}, {}}));
  const std::vector<SectionPlace> apart{at(0, 0), at(100, 0), at(0, 50), at(100, 50)};
  CHECK(defect_of(Section{ThinWalled{apart, {first, second}}, {}})->find("hang together") !=
        std::string::npos);
  const std::vector<SectionPlace> crossed{at(0, 0), at(100, 100), at(0, 100), at(100, 0)};
  CHECK(defect_of(Section{ThinWalled{crossed, {first, second, join}}, {}})->find("cross") !=
        std::string::npos);
}

TEST_CASE("only hollow sections stand in one another", "[section]") {
  CHECK_FALSE(possible({box(400, 600, 50, 50), Plate{mm(20), mm(100)}}));
}

TEST_CASE("only boxes with the same stiffeners taper into each other", "[section]") {
  Box stiff = box(400, 600, 20, 20);
  stiff.stiffeners = {{BoxPlate::top_flange, mm(40), mm(100), mm(10)}};
  CHECK_FALSE(same_kind({box(400, 600, 20, 20), {}}, {stiff, {}}));
  CHECK(same_kind({stiff, {}}, {stiff, {}}));
  CHECK_FALSE(is_symmetric_about_z({stiff, {}}));
  stiff.stiffeners.push_back({BoxPlate::top_flange, mm(-40), mm(100), mm(10)});
  CHECK(is_symmetric_about_z({stiff, {}}));
}

}  // namespace section_test
