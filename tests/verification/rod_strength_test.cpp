// What rods beside the beam take from the case: partial factors, modulus; and their own bending.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"

namespace rod_strength_test {

using namespace boxbeam;

namespace {

/// A beam of 3 m on a hinge and a strut of 4 m beneath its end, box 120 x 80 x 6, loaded by F in
/// its middle: the strut bears F/2 and half its own weight.
std::string propped(double F, double E, const std::string& strength, const std::string& rod = "",
                    double mass = 1.0, const char* sideways = "0 m/s^2",
                    const char* of_mass = "uniform_rod = \"4 m\"") {
  return "[case]\nname = \"a\"\nkind = \"planar\"\n[mechanism]\n" +
         fmt::format("gravity = [\"{}\", \"0 m/s^2\"]\n", sideways) +
         "[bodies.b]\npoints = { A = [\"0 m\", \"0 m\"], "
         "M = [\"1.5 m\", \"0 m\"], B = [\"3 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"] "
         "}\n"
         "[bodies.rod]\n" +
         fmt::format("mass = \"{:.17g} kg\"\n", mass) + of_mass +
         "\npoints = { F = [\"-2 m\", "
         "\"0 m\"], B = [\"2 m\", \"0 m\"] }\nsketch = { at = [\"3 m\", \"-2 m\"], "
         "angle = \"90 deg\" }\n[joints.A]\nkind = \"pin\"\nconnect = [\"b.A\", \"ground\"]\n"
         "at = [\"0 m\", \"0 m\"]\n[joints.B]\nkind = \"pin\"\nconnect = [\"rod.B\", \"b.B\"]\n"
         "[joints.F]\nkind = \"pin\"\nconnect = [\"rod.F\", \"ground\"]\nat = [\"3 m\", \"-4 m\"]\n"
         "[forces.f]\nkind = \"force\"\npoint = \"b.M\"\ndirection = \"-90 deg\"\n" +
         fmt::format("size = \"{:.17g} kN\"\n", F) +
         "[motion]\nduration = \"1 s\"\n[sections.s]\nkind = \"box\"\nwidth = \"300 mm\"\n"
         "height = \"400 mm\"\nflange = \"20 mm\"\nweb = \"12 mm\"\n[sections.r]\nkind = \"box\"\n"
         "width = \"120 mm\"\nheight = \"80 mm\"\nflange = \"6 mm\"\nweb = \"6 mm\"\n"
         "[beam]\nbody = \"b\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"3 m\"\n"
         "section = \"s\"\n[material]\nname = \"a\"\n" +
         fmt::format("youngs_modulus = \"{} GPa\"\n", E) +
         "fy = \"355 MPa\"\nfu = \"510 MPa\"\nup_to = \"40 mm\"\n"
         "source = \"test\"\n[strength]\nrequired = 1.0\n" +
         strength +
         "[[rods]]\nname = \"r\"\nfrom = \"rod.F\"\nto = \"rod.B\"\nsection = \"r\"\n"
         "curve = \"c\"\n" +
         rod;
}

constexpr double A = 0.12 * 0.08 - 0.108 * 0.068;
const double I = (0.12 * std::pow(0.08, 3) - 0.108 * std::pow(0.068, 3)) / 12.0;

/// gamma_M1 N/(chi A f_y), EN 1993-1-1, 6.3.1, curve c, N_cr = pi^2 E I/L^2.
double use_by_hand(double N, double E, double gamma_M1) {
  const double N_cr = std::pow(std::numbers::pi / 4.0, 2) * E * I;
  const double lambda = std::sqrt(A * 355e6 / N_cr);
  const double chi = test::chi_of(lambda);
  return gamma_M1 * N / (chi * A * 355e6);
}

double use_of(const std::string& text) {
  const Verification of = verify(parse_project("c.toml", text));
  const CheckResult* const result = of.governing(Criterion::buckling);
  REQUIRE(result != nullptr);
  return result->check.utilisation();
}

}  // namespace

TEST_CASE("a rod has the partial factor on buckling of the case", "[rods]") {
  CHECK(use_of(propped(400.0, 210.0, "")) == Approx(use_by_hand(200e3, 210e9, 1.0)).epsilon(1e-6));
  CHECK(use_of(propped(400.0, 210.0, "gamma_M1 = 1.1\n")) ==
        Approx(use_by_hand(200e3, 210e9, 1.1)).epsilon(1e-6));
  CHECK(use_of(propped(400.0, 210.0, "gamma_M1 = 1.1\n", "gamma_M1 = 1.2\n")) ==
        Approx(use_by_hand(200e3, 210e9, 1.2)).epsilon(1e-6));
}

TEST_CASE("a rod buckles by the modulus of the case where that is softer than steel", "[rods]") {
  CHECK(use_of(propped(400.0, 196.0, "")) == Approx(use_by_hand(200e3, 196e9, 1.0)).epsilon(1e-6));
  // It may be of structural steel.
  CHECK(use_of(propped(400.0, 214.0, "")) == Approx(use_by_hand(200e3, 210e9, 1.0)).epsilon(1e-6));
}

TEST_CASE("a rod that passes by its force alone has no verdict where its own weight is too much",
          "[rods]") {
  // Gravity across the strut, M = m g L/8 of 3.9 % of f_y; EN 1993-1-1, 6.3.3 and table B.1:
  // n + (1 + 0.6 n) 0.039 is 1.04 at n = 0.98, 0.96 at n = 0.9.
  constexpr double part = 0.039;
  const double mass = 8.0 * part * 355e6 * I / 0.04 / (9.81 * 4.0);
  const auto blocked = [&](double use) {
    const double F = 2e-3 * use / use_by_hand(1.0, 210e9, 1.0);
    const Verification of =
        verify(parse_project("c.toml", propped(F, 210.0, "", "", mass, "9.81 m/s^2")));
    CHECK(of.governing(Criterion::buckling)->check.utilisation() == Approx(use).epsilon(1e-6));
    return std::any_of(of.gates.begin(), of.gates.end(), [](const Gate& gate) {
      return gate.blocks && gate.finding.find("its own weight") != std::string::npos;
    });
  };
  CHECK(blocked(0.98));
  CHECK_FALSE(blocked(0.9));
}

TEST_CASE("a rod with a lump of mass bends by m g L/4, twice as much as an even one", "[rods]") {
  // At n = 0.95 and m g L/8 of 0.02 f_y it passes, n + (1 + 0.6 n) 0.02 = 0.98; with 0.04
  // not, 1.01.
  constexpr double part = 0.02, use = 0.95;
  const double mass = 8.0 * part * 355e6 * I / 0.04 / (9.81 * 4.0);
  const double F = 2e-3 * use / use_by_hand(1.0, 210e9, 1.0);
  const auto words = [&](const char* of_mass) {
    const Verification of =
        verify(parse_project("c.toml", propped(F, 210.0, "", "", mass, "9.81 m/s^2", of_mass)));
    for (const Gate& gate : of.gates)
      if (gate.blocks && gate.finding.find("its own weight") != std::string::npos)
        return gate.finding;
    return std::string();
  };
  CHECK(words("uniform_rod = \"4 m\"").empty());
  // 0.04 x 355 = 14.2 MPa, and 0.95 + 1.57 x 0.04 = 1.01.
  const std::string lump = words("inertia = \"0 kg m^2\"");
  CHECK(lump.find("14.2 MPa") != std::string::npos);
  CHECK(lump.find("101 %") != std::string::npos);
}

TEST_CASE("where fatigue is asked for, what no detail of a rod judges stands with the verdict",
          "[rods]") {
  const std::string fatigue =
      "[fatigue]\nloading = \"spectrum\"\ncategory = 160\ngamma_Mf = 1.0\nrequired = 1.0\n"
      "[[situations]]\nname = \"on\"\n[[situations]]\nname = \"off\"\n"
      "set = { \"forces.f.size\" = \"0 kN\" }\n[[situations]]\nname = \"change\"\n"
      "between = [\"on\", \"off\"]\ncycles = 2e6\n";
  const auto words = [&](const std::string& more) {
    for (const NotJudged& of :
         verify(parse_project("c.toml", propped(400.0, 210.0, "", more))).not_judged)
      if (of.reason.find("in fatigue") != std::string::npos) return of.reason;
    return std::string();
  };
  CHECK(words("").empty());
  // 200 kN on and off the strut.
  CHECK(words(fatigue).find(fmt::format("{:.3g} MPa", 200e-3 / A)) != std::string::npos);
}

}  // namespace rod_strength_test
