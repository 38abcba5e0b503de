#include "boxbeam/section/section_properties.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "boxbeam/section/level_shear.hpp"
#include "catch.hpp"
#include "section/random_sections.hpp"

namespace section_properties_test {

using namespace boxbeam;
using std::numbers::pi;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

Box box(double width, double height, double flange, double web) {
  return symmetric_box(mm(width), mm(height), mm(flange), mm(web));
}

// In mm^2 and mm^4, to compare with hand formulas in millimetres.
double area(const SectionProperties& p) { return p.area.value() * 1e6; }
double I_y(const SectionProperties& p) { return p.I_y.value() * 1e12; }
double I_z(const SectionProperties& p) { return p.I_z.value() * 1e12; }

Hole web_hole(double diameter, double level) {
  return {"hole", mm(diameter), HoleWalls::webs, mm(level)};
}

Hole flange_hole(double diameter, double y) {
  return {"hole", mm(diameter), HoleWalls::flanges, mm(y)};
}

// Boxes of the sledge rig; its hub at the pivot has a hole of 145 mm and four of 18 mm.
const Section A1{box(400, 600, 50, 50), {}};
const Section A2{box(400, 1000, 50, 50), {}};
const std::vector<Hole> hub{web_hole(145, 0), web_hole(18, 100), web_hole(18, -100)};

/// Simpson's rule, so that the integral owes nothing to the closed forms.
template <class Function>
double integral(const Function& f, double low, double high, int steps = 2000) {
  const double h = (high - low) / steps;
  double sum = f(low) + f(high);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(low + i * h);
  return sum * h / 3.0;
}

/// The integral of tau b over the height for a unit shear force; `borders` part the height where
/// the width jumps or has a kink.
double carried_shear(const Section& section, const std::vector<Hole>& holes,
                     const std::vector<double>& borders) {
  const auto flow = [&](double z) {
    return level_shear_of(section, holes, {}, z)[cut_force::V_z] *
           width_at(section, holes, si<Length>(z)).value();
  };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    sum += integral(flow, 1e-3 * borders[i], 1e-3 * borders[i + 1]);
  }
  return sum;
}

}  // namespace

TEST_CASE("box 400 x 600 x 50 by hand: b h^3/12 outside minus inside") {
  const SectionProperties p = properties_of(A1);
  CHECK(area(p) == Approx(90e3).epsilon(1e-12));
  CHECK(I_y(p) == Approx(4.075e9).epsilon(1e-12));
  // 600*400^3/12 - 500*300^3/12
  CHECK(I_z(p) == Approx(3.2e9 - 1.125e9).epsilon(1e-12));
  CHECK(p.W_y.value() * 1e9 == Approx(4.075e9 / 300).epsilon(1e-12));
  CHECK(p.W_z.value() * 1e9 == Approx(2.075e9 / 200).epsilon(1e-12));
  CHECK(p.centroid_z.value() == 0.0);
  CHECK(p.z_top == mm(300));
  CHECK(p.z_bottom == mm(-300));
}

TEST_CASE("box 400 x 1000 x 50 by hand") {
  const SectionProperties p = properties_of(A2);
  CHECK(area(p) == Approx(130e3).epsilon(1e-12));
  // 400*1000^3/12 - 300*900^3/12 = 15.108e9; the sledge-rig thesis prints 15.1e-3 m^4
  CHECK(I_y(p) == Approx(400e9 / 12 - 300.0 * 900 * 900 * 900 / 12).epsilon(1e-12));
  CHECK(I_y(p) == Approx(15.108e9).epsilon(5e-5));
}

TEST_CASE("rectangular tube 290 x 490 x 56 by hand") {
  const SectionProperties p = properties_of({box(290, 490, 56, 56), {}});
  // Inside 178 x 378 mm.
  CHECK(area(p) == Approx(290 * 490 - 178 * 378).epsilon(1e-12));
  CHECK(I_y(p) == Approx(290 * std::pow(490, 3) / 12 - 178 * std::pow(378, 3) / 12).epsilon(1e-12));
  CHECK(I_z(p) == Approx(490 * std::pow(290, 3) / 12 - 378 * std::pow(178, 3) / 12).epsilon(1e-12));
}

TEST_CASE("round tube: closed forms of the annulus") {
  const double D = 0.5, d = 0.4;
  const Section section{RoundTube{si<Length>(D), mm(50)}, {}};
  const SectionProperties p = properties_of(section);
  CHECK(p.area.value() == Approx(pi / 4 * (D * D - d * d)).epsilon(1e-12));
  const double I = pi / 64 * (std::pow(D, 4) - std::pow(d, 4));
  CHECK(p.I_y.value() == Approx(I).epsilon(1e-12));
  CHECK(p.I_z.value() == Approx(I).epsilon(1e-12));
  CHECK(p.W_y.value() == Approx(2 * I / D).epsilon(1e-12));
  CHECK(p.W_z.value() == Approx(2 * I / D).epsilon(1e-12));
  // First moment of half an annulus: two half discs, A_i 4 r_i/(3 pi) each.
  CHECK(first_moment_beyond(section, {}, mm(0), mm(0)).value() ==
        Approx((D * D * D - d * d * d) / 12).epsilon(1e-12));
  CHECK(width_at(section, {}, mm(0)).value() == Approx(D - d).epsilon(1e-12));
  // A chord above the hollow: 2 sqrt(250^2 - 240^2) = 140 mm.
  CHECK(width_at(section, {}, mm(240)).value() == Approx(0.14).epsilon(1e-12));
}

TEST_CASE("nested profiles act together: their properties add") {
  const Profile inner = box(290, 490, 56, 56);
  const Section both{A1.outer, inner};
  const SectionProperties p = properties_of(both);
  const SectionProperties a = properties_of(A1);
  const SectionProperties b = properties_of({inner, {}});
  CHECK(area(p) == Approx(area(a) + area(b)).epsilon(1e-14));
  CHECK(I_y(p) == Approx(I_y(a) + I_y(b)).epsilon(1e-14));
  CHECK(I_z(p) == Approx(I_z(a) + I_z(b)).epsilon(1e-14));
  CHECK(p.W_y.value() == Approx(p.I_y.value() / 0.3).epsilon(1e-14));
  CHECK(width_at(both, {}, mm(0)).value() == Approx(0.1 + 0.112).epsilon(1e-12));
}

TEST_CASE("a flat plate that leans by 30 degrees resists most about the axis square to it") {
  // About its long axis L t^3/12, about the one square to it t L^3/12.
  const double L = 0.3, t = 0.01, lean = pi / 6;
  const SectionPlace end{si<Length>(L * std::cos(lean)), si<Length>(L * std::sin(lean))};
  const SectionProperties p =
      properties_of({ThinWalled{{SectionPlace{}, end}, {{0, 1, si<Length>(t), {}, {}}}}, {}});
  CHECK(p.I_1.value() == Approx(t * L * L * L / 12).epsilon(1e-12));
  CHECK(p.I_2.value() == Approx(L * t * t * t / 12).epsilon(1e-9));
  CHECK(std::cos(p.principal_angle - (lean - pi / 2)) == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("a section turned back by its principal angle has I_1 about y, I_2 about z, no I_yz") {
  // A tensor of second moments in its own axes is diagonal; the integrals are those of the turned
  // outline, which know no formula of principal axes.
  test::RandomSections random(2);
  double largest = 0.0;
  for (int i = 0; i < 20; ++i) {
    ThinWalled path = random.path();
    const SectionProperties p = properties_of({path, {}});
    CHECK(p.I_1 >= p.I_2);
    const double c = std::cos(p.principal_angle), s = std::sin(p.principal_angle);
    for (SectionPlace& node : path.nodes) {
      node = {c * node.y + s * node.z, c * node.z - s * node.y};
    }
    const SectionProperties turned = properties_of({path, {}});
    CAPTURE(i, p.principal_angle);
    largest = std::max(largest, std::abs(p.principal_angle));
    CHECK(turned.I_y.value() == Approx(p.I_1.value()).epsilon(1e-9));
    CHECK(turned.I_z.value() == Approx(p.I_2.value()).epsilon(1e-9));
    CHECK(std::abs(turned.I_yz.value()) < 1e-9 * p.I_1.value());
  }
  CHECK(largest > 0.1);  // some are far from symmetric
}

TEST_CASE("net section of the sledge rig's hub by hand") {
  const SectionProperties net = properties_of(A2, hub);
  // 130 000 - 2*145*50 - 4*18*50 = 111 900 mm^2; the thesis prints 112e3.
  CHECK(area(net) == Approx(111.9e3).epsilon(1e-12));
  // Strips by b h^3/12 + A z^2.
  const double strips =
      100 * std::pow(145, 3) / 12 + 2 * (100 * std::pow(18, 3) / 12 + 1800.0 * 100 * 100);
  CHECK(I_y(net) == Approx(I_y(properties_of(A2)) - strips).epsilon(1e-12));
  CHECK(net.centroid_z.value() == Approx(0.0).margin(1e-15));
  // Each strip of a web lies 175 mm off the middle: b h^3/12 + A y^2 with h the wall.
  const double removed = 2 * 181.0 * (std::pow(50, 3) / 12 + 50.0 * 175 * 175);
  CHECK(I_z(net) == Approx(I_z(properties_of(A2)) - removed).epsilon(1e-12));
}

TEST_CASE("a hole off mid-height moves the centroid away from it") {
  const SectionProperties gross = properties_of(A1);
  const SectionProperties net = properties_of(A1, {web_hole(120, 150)});
  // z_c = -A_h z_h/(A - A_h); I = I_gross - (b d^3/12 + A_h z_h^2) - A_net z_c^2 (Steiner).
  const double A_h = 2 * 50 * 120.0;
  const double z_c = -A_h * 150 / (90e3 - A_h);
  CHECK(net.centroid_z.value() * 1e3 == Approx(z_c).epsilon(1e-12));
  const double I =
      I_y(gross) - (100 * std::pow(120, 3) / 12 + A_h * 150 * 150) - (90e3 - A_h) * z_c * z_c;
  CHECK(I_y(net) == Approx(I).epsilon(1e-12));
  CHECK(net.W_y.value() * 1e9 == Approx(I / (300 - z_c)).epsilon(1e-12));
}

TEST_CASE("flange holes: one on the axis, or two beside it") {
  // On the axis: one strip of 60 x 50 mm per flange, centre at 275 mm.
  const SectionProperties one = properties_of(A1, {flange_hole(60, 0)});
  const double strip = 60 * std::pow(50, 3) / 12 + 60 * 50 * 275.0 * 275;
  CHECK(area(one) == Approx(90e3 - 2 * 60 * 50).epsilon(1e-12));
  CHECK(I_y(one) == Approx(4.075e9 - 2 * strip).epsilon(1e-12));
  const SectionProperties two = properties_of(A1, {flange_hole(60, 80)});
  CHECK(area(two) == Approx(90e3 - 4 * 60 * 50).epsilon(1e-12));
  CHECK(I_y(two) == Approx(4.075e9 - 4 * strip).epsilon(1e-12));
  const double across = 50 * std::pow(60, 3) / 12 + 60 * 50 * 80.0 * 80;
  CHECK(I_z(two) == Approx(2.075e9 - 4 * across).epsilon(1e-12));
}

TEST_CASE("first moment: hand values of the rig's box") {
  // The thesis: Q_B = 4.88e-3 m^3 at z = 475 mm of the 1000 mm box; 400*25*487.5 mm^3 by hand.
  CHECK(first_moment_beyond(A2, {}, mm(475), mm(0)).value() == Approx(4.875e-3).epsilon(1e-12));
  // At the neutral axis: flange 400*50*475 and webs 100*450*225.
  CHECK(first_moment_beyond(A2, {}, mm(0), mm(0)).value() ==
        Approx((400 * 50 * 475.0 + 100 * 450 * 225.0) * 1e-9).epsilon(1e-12));
  CHECK(first_moment_beyond(A2, {}, mm(500), mm(0)).value() == Approx(0.0).margin(1e-18));
}

TEST_CASE("the first moment of a whole section about its centroid vanishes") {
  const std::vector<Hole> off_centre{web_hole(120, 150), flange_hole(40, 60)};
  const SectionProperties net = properties_of(A1, off_centre);
  CHECK(first_moment_beyond(A1, off_centre, mm(-300), net.centroid_z).value() ==
        Approx(0.0).margin(1e-15));
}

TEST_CASE("width by hand, holes taken off") {
  CHECK(width_at(A2, {}, mm(475)).value() == Approx(0.4).epsilon(1e-14));
  CHECK(width_at(A2, {}, mm(450)).value() == Approx(0.1).epsilon(1e-14));
  CHECK(width_at(A2, hub, mm(0)).value() == 0.0);
  CHECK(width_at(A2, hub, mm(-100)).value() == 0.0);
  CHECK(width_at(A2, hub, mm(85)).value() == Approx(0.1).epsilon(1e-14));
  CHECK(width_at(A2, {flange_hole(60, 80)}, mm(475)).value() == Approx(0.28).epsilon(1e-14));
  CHECK(width_at(A2, {}, mm(501)).value() == 0.0);
}

TEST_CASE("area and first moment beyond a level are integrals of the width") {
  const double z_c = 0.06;  // about a level off the middle, so that the area counts too
  const Section round_in_box{box(400, 600, 30, 20), RoundTube{mm(340), mm(40)}};
  for (const double z : {-290.0, -100.0, 0.0, 140.0, 280.0}) {
    const auto width = [&](double zeta) {
      return width_at(round_in_box, {}, si<Length>(zeta)).value();
    };
    double expected = 0.0;
    const double borders[] = {-300, -270, -170, -130, 130, 170, 270, 300};
    for (std::size_t i = 0; i + 1 < std::size(borders); ++i) {
      const double low = std::max(borders[i], z), high = borders[i + 1];
      // The middle of many steps, since the width jumps at the borders.
      const int steps = 20000;
      const double h = 1e-3 * (high - low) / steps;
      for (int k = 0; k < steps && high > low; ++k) {
        const double zeta = 1e-3 * low + (k + 0.5) * h;
        expected += width(zeta) * (zeta - z_c) * h;
      }
    }
    CAPTURE(z);
    CHECK(first_moment_beyond(round_in_box, {}, mm(z), si<Length>(z_c)).value() ==
          Approx(expected).epsilon(1e-5).margin(1e-9));
  }
}

TEST_CASE("the shear stresses sum to the shear force") {
  // Equilibrium: the integral of tau b over the height is V, here 1.
  CHECK(carried_shear(A1, {}, {-300, -250, 250, 300}) == Approx(1.0).epsilon(1e-9));
  CHECK(carried_shear(A2, {flange_hole(60, 80)}, {-500, -450, 450, 500}) ==
        Approx(1.0).epsilon(1e-9));
  CHECK(carried_shear({A1.outer, box(290, 490, 56, 56)}, {},
                      {-300, -250, -245, -189, 189, 245, 250, 300}) == Approx(1.0).epsilon(1e-9));
  CHECK(carried_shear({RoundTube{mm(500), mm(20)}, {}}, {}, {-250, -230, 230, 250}) ==
        Approx(1.0).epsilon(1e-6));
}

TEST_CASE("shear lag takes material out beside holes, and never gives any back") {
  // Holes anywhere, wider and narrower than the idle strips, in boxes and tubes.
  const Section profiles[] = {A1, Section{RectangularTube{mm(300), mm(200), mm(12), {}, {}}, {}}};
  for (const Section& section : profiles) {
    const double width = section == A1 ? 300.0 : 276.0, height = section == A1 ? 500.0 : 176.0;
    for (const double diameter : {5.0, 20.0, 60.0, 120.0}) {
      for (const double place : {0.0, 0.02, 0.1, 0.2}) {
        for (const double part : {0.999, 0.95, 0.8, 0.5}) {
          const std::vector<Hole> holes{flange_hole(diameter, place * width),
                                        web_hole(diameter, place * height)};
          const SectionProperties net = properties_of(section, holes);
          const SectionProperties gross_lag = properties_of(section, {}, part, part);
          const SectionProperties lag = properties_of(section, holes, part, part);
          CAPTURE(width, diameter, place, part);
          for (const SectionProperties* whole : {&net, &gross_lag}) {
            CHECK(area(lag) <= area(*whole) * (1.0 + 1e-12));
            CHECK(I_y(lag) <= I_y(*whole) * (1.0 + 1e-12));
            CHECK(I_z(lag) <= I_z(*whole) * (1.0 + 1e-12));
          }
          if (place > 0.0) continue;
          // In the middle the wider of strip and hole is missing, once, in each of four plates.
          const double thickness = section == A1 ? 50.0 : 12.0;
          const double flange = std::max(diameter, (1.0 - part) * width);
          const double web = std::max(diameter, (1.0 - part) * height);
          const double whole = area(properties_of(section));
          CHECK(area(lag) == Approx(whole - 2.0 * thickness * (flange + web)).epsilon(1e-9));
        }
      }
    }
  }
}

TEST_CASE("of a stiffener what stands on the idle strip is idle, and no more") {
  // Clear width 280, of which the part 0.9 works: the strip is 28 wide. A bar of 12 x 40 in the
  // middle of the flange, at its border and beside it; then a strip of 7 in a bar of 12.
  Box of = symmetric_box(mm(300), mm(400), mm(10), mm(10));
  const auto bar_left = [&](double place, double part) {
    of.stiffeners = {};
    const double bare = area(properties_of({of, {}}, {}, part));
    of.stiffeners = {{BoxPlate::top_flange, mm(place), mm(40), mm(12)}};
    return area(properties_of({of, {}}, {}, part)) - bare;
  };
  CHECK(bar_left(0, 0.9) == Approx(0.0).margin(1e-6));
  CHECK(bar_left(14, 0.9) == Approx(6.0 * 40).epsilon(1e-9));
  CHECK(bar_left(-17, 0.9) == Approx(9.0 * 40).epsilon(1e-9));
  CHECK(bar_left(30, 0.9) == Approx(12.0 * 40).epsilon(1e-9));
  CHECK(bar_left(0, 0.975) == Approx(5.0 * 40).epsilon(1e-9));
}

}  // namespace section_properties_test
