// Compressed beams that bend, from the case to the member's check, beside equation 6.61 of EN
// 1993-1-1:2005 with k_yy of annex B, written out here: uniform boxes of class 1 to 3, pinned at
// both ends, under one moment all along or a force in the middle.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace member_interaction_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 210e3, G = 81e3, f_y = 355.0;  // MPa

/// Equation 6.49, alpha = 0.49 of curve c.
double chi_of(double lambda) {
  if (lambda <= 0.2) return 1.0;
  const double phi = 0.5 * (1.0 + 0.49 * (lambda - 0.2) + lambda * lambda);
  return 1.0 / (phi + std::sqrt(phi * phi - lambda * lambda));
}

/// A box in mm, and what acts on it.
struct Strut {
  double width = 0.0, height = 0.0, flange = 0.0, web = 0.0;
  double lambda = 0.0;
  double compressed = 0.0;  ///< N/(chi A f_y)
  double bent = 0.0;        ///< M/(W f_y) of the straight beam
  bool central = false;     ///< by a force in the middle, else by one moment all along

  double area() const { return width * height - (width - 2.0 * web) * (height - 2.0 * flange); }
  double inertia() const {
    return (width * std::pow(height, 3) -
            (width - 2.0 * web) * std::pow(height - 2.0 * flange, 3)) /
           12.0;
  }
  double length() const { return lambda * pi * std::sqrt(E * inertia() / (area() * f_y)); }
  double force() const { return compressed * chi_of(lambda) * area() * f_y; }
  /// N/N_cr, by Euler.
  double critical() const { return compressed * chi_of(lambda) * lambda * lambda; }
  /// What shear adds to it, N/(G A_s), the webs between the mid-lines of the flanges (Timoshenko,
  /// Gere, section 2.17).
  double by_shear() const { return force() / (G * 2.0 * web * (height - flange)); }

  /// Equation 6.61, gamma_M1 = 1: tables B.1, class 3, and B.3.
  double by_6_61() const {
    const double C_my = central ? 0.9 : 1.0;
    const double k_yy =
        std::min(C_my * (1.0 + 0.6 * lambda * compressed), C_my * (1.0 + 0.6 * compressed));
    return compressed + k_yy * bent;
  }

  /// Whether its M grows at least as 1 + 0.6 lambda n <= 1 + 0.6 n does. Of one moment all along by
  /// sec(pi/2 sqrt(n_cr)) (Timoshenko, Gere, section 1.11), no less than 1 + pi^2/8 n_cr, n_cr =
  /// chi lambda^2 n; of a central force that is so without C_my = 0.9 as well, by 1/(1 - n_cr).
  bool grows_enough() const {
    return central ||
           pi * pi / 8.0 * chi_of(lambda) * lambda * lambda >= 0.6 * std::min(lambda, 1.0);
  }

  std::string text() const {
    const double L = length(), N = force();
    const double M = bent * inertia() / (0.5 * height) * f_y;
    const auto at = [](const std::string& name, double s, const std::string& acting) {
      return fmt::format("[loads.{}]\nkind = \"force\"\nat = \"{:.17g} mm\"\n{}\n", name, s,
                         acting);
    };
    const auto force = [](double x, double z) {
      return fmt::format("force = [\"{:.17g} N\", \"{:.17g} N\"]", x, z);
    };
    const auto moment = [](double of) { return fmt::format("moment = \"{:.17g} N m\"", of); };
    const std::string bending =
        central ? at("middle", 0.5 * L, force(0.0, -4.0 * M / L))
                : at("one", 0.0, moment(-1e-3 * M)) + at("other", L, moment(1e-3 * M));
    return fmt::format(
               "[case]\nname = \"strut\"\nkind = \"static\"\n"
               "[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
               "[sections.a]\nkind = \"box\"\nwidth = \"{:.17g} mm\"\nheight = \"{:.17g} mm\"\n"
               "flange = \"{:.17g} mm\"\nweb = \"{:.17g} mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
               "[[beam.segments]]\nlength = \"{:.17g} mm\"\nsection = \"a\"\n"
               "[supports.pin]\nkind = \"pinned\"\nat = \"0 m\"\n"
               "[supports.roller]\nkind = \"roller\"\nat = \"{:.17g} mm\"\n",
               width, height, flange, web, L, L) +
           at("push", L, force(-N, 0.0)) + bending +
           "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n"
           "[strength]\nrequired = 1.0\nshear_lag = false\n";
  }
};

/// As wide as high or more, so that it bends across its weak axis and buckles there; c/t below 42
/// eps = 34.2.
Strut random_strut(std::mt19937& random) {
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  Strut of;
  of.flange = in(8.0, 20.0);
  of.web = in(8.0, 20.0);
  const double widest = 33.0 * of.flange;
  of.height = in(120.0, std::min({600.0, 33.0 * of.web, widest}));
  of.width = in(of.height, std::min(1.6 * of.height, widest));
  of.lambda = in(0.3, 2.5);
  of.compressed = in(0.05, 0.9);
  of.bent = in(0.05, 1.05 - of.compressed);
  return of;
}

/// Of the check in the plane of motion, nothing where there is none.
const CheckResult* member_check_of(const Verification& verification) {
  for (const CheckResult& of : verification.checks) {
    if (of.check.id == "member-buckling/in-the-plane-of-motion") return &of;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("struts at random: the member's check is never milder than equation 6.61", "[member]") {
  std::mt19937 random(661);
  int compared = 0, central = 0, left_alone = 0;
  for (int i = 0; i < 320; ++i) {
    Strut of = random_strut(random);
    of.central = i % 2 == 1;
    CAPTURE(i, of.lambda, of.compressed, of.bent, of.central, of.critical());
    const Verification verification = verify(parse_project("strut.toml", of.text()));
    const CheckResult* const check = member_check_of(verification);
    // N/N_cr up to 0.04 leaves a member alone, 6.3.1.2(4).
    const double part = of.critical() + of.by_shear();
    if (part > 0.042) REQUIRE(check != nullptr);
    if (part < 0.038) REQUIRE(check == nullptr);
    if (check == nullptr) {
      ++left_alone;
      continue;
    }
    const MemberLoad& load = check->member->load;
    CHECK(load.compressed == Approx(of.compressed * chi_of(of.lambda)).epsilon(1e-6));
    CHECK(load.critical >= of.critical() * (1.0 - 1e-6));
    CHECK(load.critical == Approx(part).epsilon(0.03));
    // Second order: no less than a bow's, and of one moment all along the secant.
    const double bow = of.bent / (1.0 - load.critical);
    CHECK(load.bent >= bow * (1.0 - 1e-6));
    if (!of.central) {
      const double secant = of.bent / std::cos(0.5 * pi * std::sqrt(of.critical()));
      CHECK(load.bent >= secant * (1.0 - 1e-3));
    }
    if (!of.grows_enough()) continue;
    ++compared;
    central += of.central ? 1 : 0;
    CHECK(check->check.utilisation() >= of.by_6_61());
  }
  CHECK(compared >= 200);
  CHECK(central >= 100);
  CHECK(compared - central >= 80);
  CHECK(left_alone < 80);
}

}  // namespace member_interaction_test
