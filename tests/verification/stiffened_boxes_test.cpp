// Boxes whose plates have longitudinal stiffeners, from the case to the verdict: against hand
// values and stations looked at one by one.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "support/slender_cases.hpp"
#include "support/uniform.hpp"

namespace stiffened_boxes_test {

using namespace boxbeam;
using namespace slender_cases;

TEST_CASE("a flange of 1000 x 10 mm with a flat, compressed: by hand", "[plates]") {
  // Box 1024 x 820 mm, webs 800 x 12, diaphragms every 2 m; flat 120 x 12 in the middle of the
  // bottom flange. Its rho 0.74296 and rho_c 0.71932 by hand in stiffened_plate_test. Of the flange
  // work 2 x 0.74296 x 247 mm at the edges wholly, 0.74296 x 494 + 12 mm and the flat by rho_c. The
  // webs: psi near -0.7, lambda_p = 66.7/(28.4 x 0.8136 sqrt(17)) = 0.70: whole.
  const std::string steel_box = box("a", 1024.0, 820.0, 10.0, 12.0);
  const Verification of = verified(
      cantilever(steel_box + flats("a", "bottom flange", {0.0}, 120.0, 12.0),
                 segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}), tip(8.0, -200.0)));
  const double rho = 0.742961, rho_c = 0.719325;
  const double wide = 24.0 + 2.0 * rho * 247.0 + rho_c * (rho * 494.0 + 12.0);
  struct Part {
    double area, z, own;
  };
  const std::vector<Part> parts{{10240.0, 405.0, 1024.0 * 1000.0 / 12.0},
                                {10.0 * wide, -405.0, wide * 1000.0 / 12.0},
                                {19200.0, 0.0, 24.0 * std::pow(800.0, 3) / 12.0},
                                {rho_c * 1440.0, -340.0, rho_c * 12.0 * std::pow(120.0, 3) / 12.0}};
  double A = 0.0, S = 0.0, I = 0.0;
  for (const Part& part : parts) {
    A += part.area;
    S += part.area * part.z;
    I += part.own + part.area * part.z * part.z;
  }
  const double z = S / A;
  I -= A * z * z;
  const CheckResult* const section = of.governing(Criterion::effective_section);
  REQUIRE(section != nullptr);
  CHECK(section->check.id == "effective-section/0+/bottom-flange");
  CHECK(section->check.acting.value() == Approx(200e3 * 8e3 * (405.0 + z) / I * 1e6).epsilon(1e-5));
  // Without the flat: lambda_p = 100/(28.4 x 0.8136 x 2) = 2.164, rho = 0.415.
  const double bare = use_of(
      verified(cantilever(steel_box, segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}),
                          tip(8.0, -200.0))),
      Criterion::effective_section);
  CHECK(bare > 1.1 * section->check.utilisation());
}

TEST_CASE("webs with stiffeners bear more shear, by hand", "[plates]") {
  // Web 1200 x 8, flat 90 x 9 at mid-height, diaphragms every 3 m: plate 2 x 15 x 0.8136 x 8 + 9 =
  // 204.3 mm = 1634 mm^2, A = 810, I = 810 x 90^2/12 + 204.3 x 8^3/12 + 1634 x 810/2444 x 49^2 =
  // 1.8557e6; theta = 1.8557e6/(8^3 x 1200) = 3.0203. k_tau = 4.1 + (6.3 + 0.5437) x 0.16 + 2.2 x
  // 1.4455 = 8.3751; lambda_w = 150/(37.4 x 0.8136 sqrt(8.3751)) = 1.7034, subpanel 595.5 x 8:
  // 74.44/(37.4 x 0.8136 x 2.3428) = 1.044.
  const Verification of = verified(
      cantilever(box("a", 600.0, 1224.0, 12.0, 8.0) + flats("a", "left web", {0.0}, 90.0, 9.0) +
                     flats("a", "right web", {0.0}, 90.0, 9.0),
                 segment(9.0, "a") + diaphragms({0.0, 3.0, 6.0, 9.0}), tip(9.0, -400.0)));
  CHECK(shear_resistance_in(of) ==
        Approx(0.83 / 1.7034 * 355.0 * 1200.0 * 8.0 / std::sqrt(3.0)).epsilon(1e-3));
  // The shear flow passes the foot of the stiffener: both webs carry V less what is in the flanges.
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  CHECK(shear->check.acting.value() > 0.97 * 200e3);
  CHECK(shear->check.acting.value() < 200e3);
}

TEST_CASE("short panels between diaphragms buckle like columns, bare ones too", "[plates]") {
  // Flange 876 x 8 mm, clear, of S355: from a = 0.707 b on as a long plate; below, less.
  const auto use = [](double apart) {
    std::vector<double> at;
    for (double s = 0.0; s < 6.0 + 1e-9; s += apart) at.push_back(s);
    return use_of(verified(cantilever(box("a", 900.0, 600.0, 8.0, 12.0),
                                      segment(6.0, "a") + diaphragms(at), tip(6.0, -50.0))),
                  Criterion::effective_section);
  };
  CHECK(use(1.0) == Approx(use(3.0)).epsilon(1e-9));
  CHECK(use(0.5) > 1.1 * use(3.0));
}

TEST_CASE("a flange with stiffeners counts in shear with its subpanel that is sheared most",
          "[plates]") {
  // Of its shear under V_z, V z y/I without flats, the outer third has 2/3 of that at the web,
  // mean.
  const double V = 300e3;
  const Project project = parse_project(
      "slender.toml", cantilever(box("a", 924.0, 600.0, 8.0, 12.0) +
                                     flats("a", "top flange", {-150.0, 150.0}, 80.0, 8.0) +
                                     flats("a", "bottom flange", {-150.0, 150.0}, 80.0, 8.0),
                                 segment(4.0, "a"), tip(4.0, -1e-3 * V)));
  const auto plates = slender_plates_at(project, {}, {Length{}, Side::behind});
  REQUIRE(plates != nullptr);
  // Flats of 640 mm^2, centroid 252 mm from the middle: the flow at y is V (8 y 296 + what hangs on
  // the way in)/I; from 150 mm on one flat is on the way.
  const double I = (0.924 * std::pow(0.6, 3) - 0.9 * std::pow(0.584, 3)) / 12.0 +
                   4.0 * (0.008 * std::pow(0.08, 3) / 12.0 + 640e-6 * 0.252 * 0.252);
  const double mean = V * (0.008 * 0.296 * 0.5 * (0.150 + 0.450) + 640e-6 * 0.252) / (I * 0.008);
  check_flanges_under(V, *plates, mean, 0.02);
}

TEST_CASE("where A.3 changes its formula, at a = 3 h_w, the search finds the worse side",
          "[plates]") {
  // Webs 1400 to 800 mm deep with one flat, a = 3.003 m: h_w is 1001 mm at s = 1.997 m, where k_tau
  // falls from that of A.5 to that of A.6. V only between 1.9 and 2.05 m.
  std::string sections;
  for (const auto& [name, height] : {std::pair{"a", 1424.0}, {"b", 824.0}}) {
    sections += box(name, 600.0, height, 12.0, 8.0) + flats(name, "left web", {0.0}, 90.0, 9.0) +
                flats(name, "right web", {0.0}, 90.0, 9.0);
  }
  const Verification of = verified(cantilever(
      sections, taper(3.003, "a", "b") + diaphragms({0.0, 3.003}),
      "[loads.down]\nkind = \"force\"\nat = \"2.05 m\"\nforce = [\"0 kN\", \"-400 kN\"]\n"
      "[loads.up]\nkind = \"force\"\nat = \"1.9 m\"\nforce = [\"0 kN\", \"400 kN\"]\n"));
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  CHECK(shear->check.station.s.value() == Approx(1.997).margin(2e-3));
  CHECK(shear->plates->plate->panel.depth.value() > 3.003 / 3.0);
}

TEST_CASE("stiffened boxes: no place between the stations is used more than what is reported",
          "[plates]") {
  test::Uniform in(45);
  int judged = 0;
  for (int i = 0; i < 20; ++i) {
    const double width = in(500.0, 1200.0), web = in(6.0, 9.0), flange = in(8.0, 12.0);
    const double first = in(900.0, 1500.0), last = in(600.0, 900.0);
    const auto stiffened = [&](const std::string& name, double height) {
      const double d = 100.0, t = 10.0, b = width - 2.0 * web;
      std::string text = box(name, width, height, flange, web);
      if (i % 4 == 0) text += flats(name, "bottom flange", {0.0}, d, t);
      if (i % 4 == 1) text += flats(name, "top flange", {-b / 6.0, b / 6.0}, d, t);
      if (i % 4 == 2) text += flats(name, "bottom flange", {-b / 4.0, 0.0, b / 4.0}, d, t);
      if (i % 4 != 2) {
        for (const char* on : {"left web", "right web"})
          text += flats(name, on, {-0.2 * height, 0.15 * height}, d, t);
      }
      return text;
    };
    std::vector<double> at;
    if (i % 3 != 0) at = {0.0, in(1.0, 2.5), in(2.6, 4.0), in(4.1, 6.5)};
    const std::string text = cantilever(
        stiffened("a", first) + stiffened("b", last),
        segment(in(0.5, 2.0), "a") + taper(in(4.5, 8.0), "a", "b") + segment(1.0, "b") +
            diaphragms(at),
        fmt::format("[loads.a]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"{} kN\", \"{} kN\"]\n"
                    "[loads.l]\nkind = \"line\"\nforce_per_length = [\"0 kN/m\", \"{} kN/m\"]\n",
                    in(1.0, 6.0), in(-200.0, 200.0), in(-200.0, 200.0), in(-60.0, 60.0)));
    CAPTURE(i);
    judged += look_along(parse_project("slender.toml", text), 1000);
  }
  CHECK(judged > 10'000);
}

}  // namespace stiffened_boxes_test
