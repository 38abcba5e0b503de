// What rods bear that hang or prop a bar: pulled, pressed, beside their centroid, and where they
// are not judged.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "catch.hpp"
#include "support/buckling_curve.hpp"
#include "support/held_rod.hpp"

namespace held_rods_test {

using namespace boxbeam;
using test::buckling_of;
using test::compression_of;
using test::rod_result;
using test::rod_under;
using test::rods_of;
using test::tension_of;

TEST_CASE(
    "a rod that hangs the beam is pulled by W/2 and never pressed; one that props it bears W/2") {
  const std::string flat = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n";
  const std::string rod =
      "[[rods]]\nname = \"hanger\"\nfrom = \"rod.P\"\nto = \"rod.Q\"\nsection = \"bar\"\n"
      "curve = \"c\"\n";
  const Project hanging = test::held_bar(true, flat, rod);
  const NeighbourChecks pulled = rods_of(hanging);
  REQUIRE(pulled.results.size() == 1);
  // 0.05 x 0.1 x 2 m^3 of 8000 kg/m^3 weigh 800 N; half of it is on the rod.
  const Check& tension = pulled.results.front().check;
  CHECK(tension.id == "rod/hanger");
  CHECK(tension.acting.value() == Approx(400.0).epsilon(1e-6));
  // 50 mm of S355 (EN 10025-2): f_y = 335, f_u = 470 MPa; 0.9 x 470/1.25 = 338.4 MPa is above f_y.
  CHECK(tension.resisting.value() == Approx(0.005 * 335e6).epsilon(1e-12));
  CHECK(pulled.gates.empty());
  CHECK(pulled.not_judged.empty());
  const Project propped = test::held_bar(false, flat, rod);
  const NeighbourChecks pressed = rods_of(propped);
  REQUIRE(pressed.results.size() == 1);
  const NeighbourResult& result = pressed.results.front();
  CHECK(result.check.acting.value() == Approx(400.0).epsilon(1e-6));
  // A flat of 50 x 100 buckles about its z axis: I = 0.1 0.05^3/12.
  CHECK(std::get<PressedRod>(result.basis).weak_axis);
  const double critical = std::numbers::pi * std::numbers::pi * 210e9 * 0.1 * 1.25e-4 / 12.0;
  CHECK(compression_of(result).slenderness ==
        Approx(std::sqrt(0.005 * 335e6 / critical)).epsilon(1e-9));  // 50 mm: 335 MPa
}

namespace {

const std::string wire = "kind = \"plate\"\nwidth = \"5 mm\"\nheight = \"5 mm\"\n";

}  // namespace

TEST_CASE("a pitman of 5 x 5 mm at 4500 MPa fails, although it is never pressed") {
  // 112.9 kN up at the tip, less the bar's 0.4 kN: 112.5 kN on 25 mm^2.
  const Project project = rod_under(false, "90 deg", "112.9 kN", wire);
  const NeighbourResult result = rod_result(project, Criterion::rod);
  CHECK(result.check.acting.value() == Approx(112.5e3).epsilon(1e-6));
  CHECK(result.check.acting.value() / 25e-6 == Approx(4500e6).epsilon(1e-6));
  // 5 mm of S355 by EN 10025-2: f_y = 355, f_u = 470 MPa.
  CHECK(tension_of(result).plastic.value() == Approx(25e-6 * 355e6).epsilon(1e-12));
  CHECK(tension_of(result).net.value() == Approx(0.9 * 25e-6 * 470e6 / 1.25).epsilon(1e-12));
  CHECK(result.check.resisting.value() == Approx(8460.0).epsilon(1e-12));
  CHECK_FALSE(result.check.passes());
  CHECK(verify(project).verdict == Verdict::fail);
}

TEST_CASE(
    "holes for fasteners weaken a rod: the net area the case gives, and its partial factors") {
  const std::string flat = "kind = \"plate\"\nwidth = \"10 mm\"\nheight = \"100 mm\"\n";
  const Project project =
      rod_under(false, "90 deg", "100.4 kN", flat,
                "net_area = \"780 mm^2\"\ngamma_M0 = 1.1\ngamma_M2 = 1.3\nrequired = 2.0\n");
  const NeighbourResult result = rod_result(project, Criterion::rod);
  CHECK(tension_of(result).plastic.value() == Approx(1000e-6 * 355e6 / 1.1).epsilon(1e-12));
  CHECK(tension_of(result).net.value() == Approx(0.9 * 780e-6 * 470e6 / 1.3).epsilon(1e-12));
  CHECK(result.check.safety_factor == Approx(0.9 * 780e-6 * 470e6 / 1.3 / 100e3).epsilon(1e-6));
  CHECK(result.check.required == 2.0);
  CHECK(result.check.source == "EN 1993-1-1:2005, 6.2.3");
}

TEST_CASE("a strut of 600 x 600 x 1 bears about 66 kN, not the 851 kN of its whole area") {
  const std::string box =
      "kind = \"box\"\nwidth = \"600 mm\"\nheight = \"600 mm\"\nflange = \"1 mm\"\n"
      "web = \"1 mm\"\n";
  const Project project = rod_under(false, "-90 deg", "99.6 kN", box);
  const NeighbourResult result = buckling_of(project);
  CHECK(result.check.acting.value() == Approx(100e3).epsilon(1e-6));
  // By hand: c/t = 598, eps = sqrt(235/355), lambda_p = 598/(56.8 eps) = 12.94,
  // rho = (12.94 - 0.22)/12.94^2; the bar of 1 m does not buckle as a whole: lambda < 0.2.
  const double lambda_p = 598.0 / (56.8 * std::sqrt(235.0 / 355.0));
  const double rho = (lambda_p - 0.22) / (lambda_p * lambda_p);
  const double effective = (2396.0 - 4.0 * 598.0 * (1.0 - rho)) * 1e-6;
  CHECK(compression_of(result).slenderness < 0.2);
  CHECK(result.check.resisting.value() == Approx(effective * 355e6).epsilon(1e-9));
  CHECK(result.check.resisting.value() == Approx(66e3).epsilon(0.01));
  CHECK(2396e-6 * 355e6 == Approx(851e3).epsilon(1e-3));
  CHECK_FALSE(result.check.passes());
  CHECK(result.check.source.find("EN 1993-1-5:2006, 4.4") != std::string::npos);
}

TEST_CASE("a stout strut bears no more than its section, by the partial factor of sections") {
  // 50 x 50 mm, 1 m: lambda = 0.88, chi = 0.61 by curve c; 150 x 150 mm: lambda = 0.27, chi = 0.96,
  // so that A f_y/1.5 is the less.
  const auto resistance = [](const std::string& side) {
    const Project project =
        rod_under(false, "-90 deg", "1 kN",
                  "kind = \"plate\"\nwidth = \"" + side + "\"\nheight = \"" + side + "\"\n",
                  "gamma_M0 = 1.5\n");
    return buckling_of(project).check.resisting.value();
  };
  const auto buckling = [](double side, double f_y) {
    const double lambda =
        std::sqrt(side * side * f_y * 12.0 / (210e9 * std::pow(side, 4))) / std::numbers::pi;
    return test::chi_of(lambda) * side * side * f_y;
  };
  // S355 by EN 10025-2: 335 MPa from 40 to 63 mm, 295 MPa from 100 to 150 mm.
  CHECK(resistance("50 mm") == Approx(buckling(0.05, 335e6)).epsilon(1e-9));
  CHECK(resistance("50 mm") < 0.05 * 0.05 * 335e6 / 1.5);
  CHECK(resistance("150 mm") == Approx(0.15 * 0.15 * 295e6 / 1.5).epsilon(1e-12));
  CHECK(resistance("150 mm") < buckling(0.15, 295e6));
}

TEST_CASE("a force beside the centroid of any strut bends it", "[rods]") {
  // Box 100 x 100, flanges 20 and 5, webs 5: A = 2000 + 500 + 2 x 75 x 5 = 3250 mm^2, from the
  // middle e = (2000 x 40 - 500 x 47.5 + 750 x (-7.5))/3250 = 15.58 mm.
  const std::string unlike =
      "kind = \"box\"\nwidth = \"100 mm\"\nheight = \"100 mm\"\ntop_flange = \"20 mm\"\n"
      "bottom_flange = \"5 mm\"\nweb = \"5 mm\"\n";
  const double e = (2000.0 * 40.0 - 500.0 * 47.5 - 750.0 * 7.5) / 3250.0;
  const double I = 100.0 * 8000.0 / 12.0 + 2000.0 * std::pow(40.0 - e, 2) + 100.0 * 125.0 / 12.0 +
                   500.0 * std::pow(47.5 + e, 2) + 10.0 * std::pow(75.0, 3) / 12.0 +
                   750.0 * std::pow(7.5 + e, 2);
  const double m = 3250.0 * e * (50.0 + e) / I;
  const Project pulled = rod_under(false, "90 deg", "10.4 kN", unlike);
  CHECK(rod_result(pulled, Criterion::rod).check.resisting.value() ==
        Approx(3250.0 * std::min(345.0, 0.9 * 470.0 / 1.25) / (1.0 + m)).epsilon(1e-6));
  const Project pressed = rod_under(false, "-90 deg", "9.6 kN", unlike);
  const NeighbourResult found = buckling_of(pressed);
  // 345 MPa of the flange of 20 mm.
  const double chi = compression_of(found).reduction;
  CHECK(found.check.resisting.value() ==
        Approx(3250.0 * 345.0 * std::min(chi / (1.0 + 1.6 * chi * m), 1.0 / (1.0 + m)))
            .epsilon(1e-6));
  // A bar of 100 x 50 whose corner is at y = 500 mm: e_y = 550, W_z = 50 x 100^2/6. In y it is
  // stiffer, and may turn over; e_z = 25.
  const std::string aside =
      "kind = \"polygon\"\nouter = [[\"500 mm\", \"0 mm\"], [\"600 mm\", \"0 mm\"], "
      "[\"600 mm\", \"50 mm\"], [\"500 mm\", \"50 mm\"]]\n";
  const Project bar = rod_under(false, "90 deg", "10.4 kN", aside);
  const double of_bar = 5000.0 * (550.0 / (50.0 * 1e4 / 6.0) + 25.0 / (100.0 * 2500.0 / 6.0));
  CHECK(rod_result(bar, Criterion::rod).check.resisting.value() ==
        Approx(5000.0 * 335.0 / (1.0 + of_bar)).epsilon(1e-6));
  const Project strut = rod_under(false, "-90 deg", "9.6 kN", aside);
  const NeighbourChecks checks = rods_of(strut);
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding.find("may turn the open section over") != std::string::npos);
  // Plates of class 4 that bend: not computed.
  const std::string thin =
      "kind = \"box\"\nwidth = \"300 mm\"\nheight = \"300 mm\"\ntop_flange = \"20 mm\"\n"
      "bottom_flange = \"4 mm\"\nweb = \"4 mm\"\n";
  const Project slender = rod_under(false, "90 deg", "10.4 kN", thin);
  const NeighbourChecks none = rods_of(slender);
  REQUIRE(none.gates.size() == 1);
  CHECK(none.gates.front().blocks);
  CHECK(none.results.empty());
}

TEST_CASE("a strut whose section cannot be judged stops the verdict; as a tie it may be checked") {
  // d/t = 600/2 = 300 is far above 90 eps^2 = 59.6.
  const std::string shell = "kind = \"round tube\"\ndiameter = \"600 mm\"\nwall = \"2 mm\"\n";
  const Project pressed = rod_under(false, "-90 deg", "0.1 kN", shell);
  const NeighbourChecks checks = rods_of(pressed);
  CHECK(checks.results.empty());
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding.find("rod strut: round wall: d/t = 300") == 0);
  CHECK(verify(pressed).verdict == Verdict::not_applicable);
  const Project pulled = rod_under(false, "90 deg", "0.8 kN", shell);
  const NeighbourChecks tie = rods_of(pulled);
  CHECK(tie.gates.empty());
  REQUIRE(tie.results.size() == 1);
  CHECK(tie.results.front().check.criterion == Criterion::rod);
}

TEST_CASE("what loads a rod beside its ends stops the verdict, for its bending is not counted") {
  const std::string bar = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"50 mm\"\n";
  const Project project =
      rod_under(false, "-90 deg", "1 kN", bar,
                "[forces.side]\nkind = \"couple\"\npoints = [\"rod.P\"]\nsize = \"1 N m\"\n");
  const NeighbourChecks checks = rods_of(project);
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding ==
        "rod strut: side loads it beside its ends or turns it, and its bending is not counted");
}

}  // namespace held_rods_test
