// A section under even compression, by hand from EN 1993-1-1 table 5.2 and EN 1993-1-5 4.4.

#include "boxbeam/strength/compressed_section.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/derivation.hpp"
#include "catch.hpp"

namespace compressed_section_test {

using namespace boxbeam;

namespace {

constexpr double f_y = 355e6;
const double eps = std::sqrt(235.0 / 355.0);

Length mm(double x) { return si<Length>(x * 1e-3); }

CompressedSection section_of(const Profile& profile) {
  return compressed_section_of({profile, {}}, si<Stress>(f_y));
}

/// rho of a plate supported at both edges in even compression, EN 1993-1-5 4.4(2).
double rho_of(double ratio) {
  const double lambda = ratio / (28.4 * eps * 2.0);
  return (lambda - 0.055 * 4.0) / (lambda * lambda);
}

}  // namespace

TEST_CASE("a box of 600 x 600 x 1 bears what 186 mm^2 of it bear, not all 2396") {
  const CompressedSection section = section_of(symmetric_box(mm(600), mm(600), mm(1), mm(1)));
  CHECK(section.obstacle.empty());
  CHECK(section.class_4);
  CHECK(section.area.value() == Approx(2396e-6));
  // Four plates of c = 598 mm, of each the part 1 - rho is idle.
  const double effective = 2396.0 - 4.0 * 598.0 * (1.0 - rho_of(598.0));
  CHECK(effective == Approx(185.7).epsilon(1e-3));
  CHECK(section.effective.value() == Approx(effective * 1e-6).epsilon(1e-9));
  CHECK(section.effective.value() * f_y == Approx(65.9e3).epsilon(1e-3));
}

TEST_CASE("a web counts as compressed all over: a box whose web would do in bending is class 4") {
  // c/t of the webs 560/8 = 70: below 124 eps = 100.9 of bending, above 42 eps = 34.2.
  const CompressedSection section = section_of(symmetric_box(mm(200), mm(600), mm(20), mm(8)));
  CHECK(section.class_4);
  const double area = 2.0 * 200.0 * 20.0 + 2.0 * 560.0 * 8.0;
  const double idle = 2.0 * 560.0 * 8.0 * (1.0 - rho_of(70.0));
  CHECK(section.effective.value() == Approx((area - idle) * 1e-6).epsilon(1e-9));
}

TEST_CASE("in classes 1 to 3 the whole area counts") {
  // c/t = 176/8 = 22 and 184/12: below 42 eps = 34.2.
  const CompressedSection section = section_of(symmetric_box(mm(200), mm(200), mm(12), mm(8)));
  CHECK_FALSE(section.class_4);
  CHECK(section.obstacle.empty());
  CHECK(section.effective == section.area);
  // The limit itself: a web of c/t = 42 eps is still of class 3, one a thousandth wider is not.
  const auto box_of = [](double ratio) {
    return symmetric_box(mm(200), mm(40.0 + 8.0 * ratio), mm(20), mm(8));
  };
  CHECK_FALSE(section_of(box_of(42.0 * eps * 0.9999)).class_4);
  CHECK(section_of(box_of(42.0 * eps * 1.001)).class_4);
}

TEST_CASE("a round tube is judged by d/t, up to 90 eps^2, and not beyond") {
  // 90 x 235/355 = 59.58.
  const auto tube = [](double d, double t) { return section_of(RoundTube{mm(d), mm(t)}); };
  CHECK(tube(590, 10).obstacle.empty());
  CHECK_FALSE(tube(590, 10).class_4);
  CHECK(tube(600, 10).class_4);
  CHECK(tube(600, 10).obstacle.find("EN 1993-1-6") != std::string::npos);
}

TEST_CASE("solids have no class, and their whole area counts") {
  const CompressedSection plate = section_of(Plate{mm(5), mm(5)});
  CHECK(plate.plates.empty());
  CHECK(plate.obstacle.empty());
  CHECK(plate.effective.value() == Approx(25e-6));
  const Polygon triangle{{{mm(0), mm(0)}, {mm(50), mm(0)}, {mm(0), mm(50)}}, {}};
  CHECK(section_of(triangle).obstacle.empty());
}

TEST_CASE("what cannot be judged says so, with its reason") {
  const auto reason = [](const Profile& profile) { return section_of(profile).obstacle; };
  const auto says = [](const std::string& text, const std::string& part) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  // An angle drawn as a polygon, a hollow one.
  says(reason(Polygon{{{mm(0), mm(0)},
                       {mm(50), mm(0)},
                       {mm(50), mm(5)},
                       {mm(5), mm(5)},
                       {mm(5), mm(50)},
                       {mm(0), mm(50)}},
                      {}}),
       "not convex");
  says(reason(Polygon{{{mm(0), mm(0)}, {mm(90), mm(0)}, {mm(0), mm(90)}},
                      {{{mm(10), mm(10)}, {mm(20), mm(10)}, {mm(10), mm(20)}}}}),
       "hollow");
  // A channel of walls of 100 x 10, open, and with its fourth side a cell: c/t = 90/10.
  ThinWalled channel{{{mm(0), mm(0)}, {mm(100), mm(0)}, {mm(100), mm(100)}, {mm(0), mm(100)}},
                     {{0, 1, mm(10)}, {1, 2, mm(10)}, {2, 3, mm(10)}}};
  CHECK(reason(channel).empty());
  channel.walls.push_back({3, 0, mm(10)});
  CHECK(reason(channel).empty());
  // Slender, with webs unlike: the centroid of what is effective lies elsewhere.
  Box unlike = symmetric_box(mm(600), mm(600), mm(2), mm(2));
  unlike.left_web = mm(3);
  says(reason(unlike), "not doubly symmetric");
  // A stiffener whose own c/t = 100/5 is above 14 eps = 11.4.
  Box stiffened = symmetric_box(mm(200), mm(200), mm(12), mm(12));
  stiffened.stiffeners = {{BoxPlate::top_flange, mm(0), mm(100), mm(5)}};
  says(reason(stiffened), "stiffener 1: c/t = 20");
}

TEST_CASE("a box of thin walls bears what the box bears, unlike ones say why they are not judged") {
  const auto as_path = [](double left) {
    // Mid-lines of a box of 600 x 400, plates of 4 mm, walls as long as its plates are.
    ThinWalled path{
        {{mm(298), mm(198)}, {mm(-298), mm(198)}, {mm(298), mm(-198)}, {mm(-298), mm(-198)}}, {}};
    path.walls = {{0, 1, mm(4), mm(-2), mm(-2)},
                  {2, 3, mm(4), mm(-2), mm(-2)},
                  {0, 2, mm(left), mm(2), mm(2)},
                  {1, 3, mm(4), mm(2), mm(2)}};
    return path;
  };
  const CompressedSection box = section_of(symmetric_box(mm(600), mm(400), mm(4), mm(4)));
  const CompressedSection path = section_of(as_path(4.0));
  REQUIRE(box.class_4);
  CHECK(path.class_4);
  CHECK(path.obstacle.empty());
  CHECK(path.area.value() == Approx(box.area.value()).epsilon(1e-9));
  CHECK(path.effective.value() == Approx(box.effective.value()).epsilon(1e-9));
  Derivation steps;
  CHECK(derive_effective_area(steps, path, si<Stress>(f_y)).value() ==
        Approx(path.effective.value()).epsilon(1e-9));
  // The thinner web loses more: the centroid moves to the thicker one, at +y.
  const CompressedSection unlike = section_of(as_path(6.0));
  CHECK(unlike.obstacle.empty());
  CHECK(unlike.shift_y.value() > 1e-3);
  CHECK(unlike.shift_z == Length{});
  // Of one within another profile that is not counted.
  const CompressedSection nested = compressed_section_of(
      {symmetric_box(mm(700), mm(500), mm(20), mm(20)), Profile{as_path(6.0)}}, si<Stress>(f_y));
  CHECK(nested.obstacle.find("centroid moves") != std::string::npos);
}

TEST_CASE("a nested profile is judged as well as the one around it") {
  const Section section{symmetric_box(mm(200), mm(200), mm(12), mm(12)),
                        Profile{symmetric_box(mm(170), mm(170), mm(2), mm(2))}};
  const CompressedSection of = compressed_section_of(section, si<Stress>(f_y));
  CHECK(of.class_4);
  CHECK((of.area - of.effective).value() ==
        Approx(4.0 * 166.0 * 2.0 * (1.0 - rho_of(83.0)) * 1e-6).epsilon(1e-9));
}

}  // namespace compressed_section_test
