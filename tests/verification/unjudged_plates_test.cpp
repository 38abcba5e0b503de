// What of slender plates is not judged, and that no verdict is given then.

#include <fmt/format.h>

#include <string>

#include "catch.hpp"
#include "support/slender_cases.hpp"

namespace unjudged_plates_test {

using namespace boxbeam;
using namespace slender_cases;

TEST_CASE("slender webs along which a load runs have a verdict where they bear it under an edge",
          "[plates]") {
  const auto of = [&](double web, double force) {
    return verified(cantilever(
        box("a", 600.0, 1224.0, 20.0, web), segment(4.0, "a"),
        fmt::format(
            "[loads.trolley]\nkind = \"wheels\"\nwheels = [{{ force = [\"0 kN\", \"{} kN\"] "
            "}}]\n",
            -force)));
  };
  // At the free end k_F = 2, l_e = 0: l_y = 20 sqrt(31.5/2 + 70.1) = 185 mm, F_Rd = 147 kN.
  CHECK(of(8.0, 400.0).verdict == Verdict::not_applicable);
  CHECK(has_gate(of(8.0, 400.0), "clause 6"));
  CHECK(of(8.0, 280.0).verdict == Verdict::pass);
  CHECK(of(8.0, 300.0).verdict == Verdict::not_applicable);
  CHECK(of(30.0, 400.0).verdict == Verdict::pass);
}

TEST_CASE("a flange of a box may buckle into its slender web: no verdict (clause 8)", "[plates]") {
  // Webs 1200 x t, flanges 600 x 40, which work whole (592/40 = 14.8): 0.55 x 210e3/355 sqrt(1200
  // t/ 12000) = 205.8 of t = 4 mm, where h_w/t = 300, and 230.1 of 5 mm, where it is 240; 252.0
  // of 6.
  const auto stops = [](double web) {
    const Verification of = verified(
        cantilever(box("a", 600.0, 1280.0, 40.0, web),
                   segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}, 20.0), tip(6.0, -50.0)));
    return of.verdict == Verdict::not_applicable && has_gate(of, "may buckle into");
  };
  CHECK(stops(4.0));
  CHECK(stops(5.0));
  CHECK_FALSE(stops(6.0));
}

TEST_CASE("clause 8 asks of a box that lies on its side what it asks of the upright one",
          "[plates]") {
  const auto stops = [](double width, double height, double flange, double web, bool space) {
    const std::string load = space ? "[loads.tip]\nkind = \"force\"\nat = \"6 m\"\n"
                                     "force = [\"0 kN\", \"-50 kN\", \"0 kN\"]\n"
                                   : tip(6.0, -50.0);
    const Verification of =
        verified(cantilever(box("a", width, height, flange, web),
                            segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}, 20.0), load,
                            space ? "space = true\n" : ""));
    return has_gate(of, "may buckle into");
  };
  // The numbers of the upright box above: 4 mm stop, 6 mm do not.
  for (const double thin : {4.0, 6.0})
    CHECK(stops(1280.0, 600.0, thin, 40.0, true) == stops(600.0, 1280.0, 40.0, thin, false));
}

TEST_CASE("plates that are not judged stop the verdict, with the reason", "[plates]") {
  const std::string slender = box("a", 600.0, 1224.0, 12.0, 8.0);
  const std::string force = tip(10.0, -10.0);
  const auto refused = [&](const std::string& text, const std::string& why) {
    const Verification of = verified(text);
    INFO(why);
    CHECK(of.verdict == Verdict::not_applicable);
    CHECK(has_gate(of, why));
  };
  CHECK(verified(cantilever(slender, segment(10.0, "a"), force)).verdict == Verdict::pass);
  // 13 eps = 10.6; gamma of 50 x 8 mm by hand: (83e3 + 400 x 3504/3904 x 31^2)/92.4e3 = 4.6.
  refused(cantilever(slender + flats("a", "bottom flange", {0.0}, 180.0, 12.0), segment(10.0, "a"),
                     force),
          "a stiffener of the bottom flange twists: d/t = 15");
  refused(cantilever(slender + flats("a", "bottom flange", {0.0}, 50.0, 8.0), segment(10.0, "a"),
                     force),
          "the stiffeners of the bottom flange are too weak, gamma = 4.6");
  // Between its flats the flange would be of class 3; with them it may buckle.
  refused(cantilever(
              box("a", 600.0, 400.0, 12.0, 12.0) + flats("a", "bottom flange", {0.0}, 180.0, 12.0),
              segment(10.0, "a"), force),
          "its stiffeners may buckle with it");
  refused(cantilever(slender,
                     segment(10.0, "a") + "[[beam.holes]]\nname = \"h\"\nstation = \"5 m\"\n"
                                          "diameter = \"100 mm\"\nthrough = \"webs\"\nlevels = "
                                          "[\"0 mm\"]\nconcentration = \"in-plane bending\"\n",
                     force),
          "wider than 0.05 of its plate");
}

TEST_CASE("holes side by side count together", "[plates]") {
  const auto of = [](const std::string& levels) {
    return verified(
        cantilever(box("a", 600.0, 1224.0, 12.0, 8.0),
                   segment(4.0, "a") +
                       "[[beam.holes]]\nname = \"h\"\nstation = \"2 m\"\ndiameter = \"40 mm\"\n"
                       "through = \"webs\"\nlevels = [" +
                       levels + "]\nconcentration = \"in-plane bending\"\n",
                   tip(4.0, -10.0)));
  };
  // 0.05 x 1200 = 60 mm.
  CHECK(!has_gate(of("\"0 mm\""), "wider than 0.05"));
  CHECK(has_gate(of("\"-100 mm\", \"100 mm\""), "wider than 0.05"));
}

TEST_CASE("fatigue of plates of which less than half works is not judged", "[plates]") {
  const auto at = [&](double flange, double web, double force) {
    return verified(
        cantilever(box("a", 900.0, 1000.0, flange, web), segment(10.0, "a"), tip(10.0, -force)) +
        lifted_often);
  };
  CHECK(!has_gate(at(16.0, 10.0, 10.0), "2.2(5)"));
  // Flange 880 x 8 mm under 250 MPa: lambda_red = 110/(28.4 x 0.8136 x 2) sqrt(250/355) = 2.0.
  CHECK(has_gate(at(8.0, 10.0, 260.0), "2.2(5)"));
  // Web 968 x 5 mm: sigma_E = 190e9/193.6^2 = 5.07 MPa; k_sigma of bending 23.9, so that it
  // breathes from 1.1 x 23.9 x 5.07 = 133 MPa on.
  CHECK(!has_gate(at(16.0, 5.0, 120.0), "breathes"));
  CHECK(has_gate(at(16.0, 5.0, 260.0), "breathes"));
}

TEST_CASE("webs breathe under shear alone, and under tension with it", "[plates]") {
  // tau = 1e6/(2 x 1200 x 8) = 52 MPa; sigma_E = 190e9/150^2 = 8.44 MPa: 1.1 tau/(5.34 sigma_E) =
  // 1.27, above 1.1.
  for (const double N : {0.0, 3000.0}) {
    const Verification of = verified(
        cantilever(box("a", 600.0, 1224.0, 12.0, 8.0), segment(1.0, "a"), tip(1.0, -1000.0, N)) +
        lifted_often);
    CAPTURE(N);
    CHECK(has_gate(of, "breathes"));
  }
}

TEST_CASE("a flange that is pressed all over breathes below b/t = 120 as well", "[plates]") {
  // sigma_E = 190e9/116.8^2 = 13.93 MPa, k_sigma = 4: 1.1 x 4 x 13.93 = 61.3 MPa is the limit.
  const auto at = [](double moment) {
    return verified(
        cantilever(box("a", 1200.0, 800.0, 10.0, 16.0), segment(2.0, "a"),
                   "[loads.tip]\nkind = \"force\"\nat = \"2 m\"\nforce = [\"0 kN\", \"0 kN\"]\n" +
                       fmt::format("moment = \"{:.17g} kN m\"\n", moment)) +
        lifted_often);
  };
  // I = (1200 x 800^3 - 1168 x 780^3)/12 = 5.01e9 mm^4: 395 mm from the axis 50 and 100 MPa.
  CHECK_FALSE(has_gate(at(634.0), "breathes"));
  CHECK(has_gate(at(1268.0), "breathes"));
}

}  // namespace unjudged_plates_test
