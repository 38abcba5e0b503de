// Compressed beams that bend, from the case to the member's checks, beside equations 6.61 and 6.62
// of EN 1993-1-1:2005 with k of annex B, written out here: uniform boxes of class 1 to 3, pinned at
// both ends, in the plane and in space, under one moment all along or forces in the middle.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"
#include "support/uniform.hpp"

namespace member_interaction_test {

using namespace boxbeam;
using test::chi_of;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 210e3, G = 81e3, f_y = 355.0;  // MPa

/// A box in mm, and what acts on it.
struct Strut {
  double width = 0.0, height = 0.0, flange = 0.0, web = 0.0, length = 0.0;
  double n = 0.0;               ///< N/(A f_y)
  double m_y = 0.0, m_z = 0.0;  ///< M/(W f_y) of the straight beam
  bool central = false;         ///< by forces in the middle, else by moments all along
  bool in_space = false;

  double area() const { return width * height - (width - 2.0 * web) * (height - 2.0 * flange); }
  double I_y() const { return inertia(width, height, web, flange); }
  double I_z() const { return inertia(height, width, flange, web); }
  /// Which has tests of its own; Bredt's is low by what thick corners add.
  double I_T() const {
    const auto mm = [](double of) { return si<Length>(1e-3 * of); };
    return 1e12 * torsion_constant_of_box(symmetric_box(mm(width), mm(height), mm(flange), mm(web)))
                      .value();
  }
  double force() const { return n * area() * f_y; }
  /// N/N_cr, by Euler.
  double part(double I) const { return force() * length * length / (pi * pi * E * I); }
  /// What shear adds to it in the plane, N/(G A_s), the webs between the mid-lines of the flanges
  /// (Timoshenko, Gere, section 2.17).
  double by_shear() const { return force() / (G * 2.0 * web * (height - flange)); }
  double moment_y() const { return m_y * I_y() / (0.5 * height) * f_y; }
  double moment_z() const { return m_z * I_z() / (0.5 * width) * f_y; }

  /// Equation 6.61 or 6.62, gamma_M1 = 1: tables B.1, class 3, with C_m = 1; curve d of the general
  /// case, 6.3.2.2, M_cr of forks at both ends under one moment all along (which forces in the
  /// middle, applied at the axis, do not come to). The code's y is the stronger axis, 1.7.
  double by_the_code(bool about_z) const {
    const auto lambda = [&](double I) { return std::sqrt(part(I) / n); };
    const auto n_b = [&](double I) { return part(I) > 0.04 ? n / chi_of(lambda(I)) : n; };
    const auto k = [&](double I) { return 1.0 + 0.6 * std::min(1.0, lambda(I)) * n_b(I); };
    const bool lies = I_z() > I_y();
    const double I_strong = std::max(I_y(), I_z()), I_weak = std::min(I_y(), I_z());
    const double strong = lies ? m_z : m_y, weak = lies ? m_y : m_z;
    // What bends across its weak axis does not turn over; else it bends before (Trahair).
    const double stiff = 1.0 / I_weak - 1.0 / I_strong;
    const double turning = central ? 0.0
                                   : (lies ? moment_z() : moment_y()) * length / pi *
                                         std::sqrt(stiff / (E * G * I_T()));
    const double chi_LT = turning > 0.041 ? chi_of(std::sqrt(turning / strong), 0.76) : 1.0;
    return about_z != lies ? n_b(I_weak) + 0.8 * k(I_strong) * strong / chi_LT + k(I_weak) * weak
                           : n_b(I_strong) + k(I_strong) * strong / chi_LT + k(I_weak) * weak;
  }

  std::string text() const {
    const std::string supports =
        in_space ? fmt::format(
                       "[supports.pin]\nkind = \"pinned\"\nat = \"0 m\"\nfork = true\n"
                       "[supports.up]\nkind = \"roller\"\nat = \"{0:.17g} mm\"\n"
                       "direction = \"z\"\nfork = true\n"
                       "[supports.side]\nkind = \"roller\"\nat = \"{0:.17g} mm\"\n"
                       "direction = \"y\"\n",
                       length)
                 : fmt::format(
                       "[supports.pin]\nkind = \"pinned\"\nat = \"0 m\"\n"
                       "[supports.roller]\nkind = \"roller\"\nat = \"{:.17g} mm\"\n",
                       length);
    const auto at = [](const std::string& name, double s, const std::string& acting) {
      return fmt::format("[loads.{}]\nkind = \"force\"\nat = \"{:.17g} mm\"\n{}\n", name, s,
                         acting);
    };
    const auto force = [&](double x, double y, double z) {
      return in_space
                 ? fmt::format("force = [\"{:.17g} N\", \"{:.17g} N\", \"{:.17g} N\"]", x, y, z)
                 : fmt::format("force = [\"{:.17g} N\", \"{:.17g} N\"]", x, z);
    };
    const auto moment = [&](double sign) {
      const double y = 1e-3 * sign * moment_y(), z = 1e-3 * sign * moment_z();
      return in_space ? fmt::format("moment = [\"0 N m\", \"{:.17g} N m\", \"{:.17g} N m\"]", y, z)
                      : fmt::format("moment = \"{:.17g} N m\"", y);
    };
    const double L = length;
    const std::string bending =
        central ? at("middle", 0.5 * L, force(0.0, 4.0 * moment_z() / L, -4.0 * moment_y() / L))
                : at("one", 0.0, moment(1.0)) + at("other", L, moment(-1.0));
    return fmt::format(
               "[case]\nname = \"strut\"\nkind = \"static\"\n[frame]\n{}"
               "[sections.a]\nkind = \"box\"\nwidth = \"{:.17g} mm\"\nheight = \"{:.17g} mm\"\n"
               "flange = \"{:.17g} mm\"\nweb = \"{:.17g} mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
               "{}[[beam.segments]]\nlength = \"{:.17g} mm\"\nsection = \"a\"\n",
               in_space ? "space = true\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
                        : "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n",
               width, height, flange, web,
               in_space ? "from = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"x\"\nz = \"z\"\n" : "",
               length) +
           supports + at("push", L, force(-this->force(), 0.0, 0.0)) + bending +
           "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n"
           "[strength]\nrequired = 1.0\nshear_lag = false\n";
  }

 private:
  static double inertia(double b, double h, double web, double flange) {
    return (b * std::pow(h, 3) - (b - 2.0 * web) * std::pow(h - 2.0 * flange, 3)) / 12.0;
  }
};

/// Of class 3 at most: c/t below 42 eps = 34.2. In the plane, which it bends in, as wide as high or
/// more.
Strut random_strut(test::Uniform& in, bool in_space) {
  Strut of;
  of.in_space = in_space;
  of.flange = in(8.0, 20.0);
  of.web = in(8.0, 20.0);
  const double widest = 33.0 * of.flange;
  of.height = in(120.0, std::min(600.0, 33.0 * of.web));
  if (!in_space) of.height = std::min(of.height, widest);
  of.width = in_space ? in(120.0, std::min(600.0, widest))
                      : in(of.height, std::min(1.6 * of.height, widest));
  const double lambda = in(0.3, 2.5);
  const double least = in_space ? std::min(of.I_y(), of.I_z()) : of.I_y();
  of.length = lambda * pi * std::sqrt(E * least / (of.area() * f_y));
  const double compressed = in(0.05, 0.9);  // N/(chi A f_y)
  of.n = compressed * chi_of(lambda);
  const double bent = in(0.05, 1.05 - compressed);
  const double about_y = in_space ? in(0.0, 1.0) : 1.0;
  of.m_y = about_y * bent;
  of.m_z = (1.0 - about_y) * bent;
  return of;
}

/// Nothing where there is none.
const CheckResult* member_check_of(const Verification& verification, const std::string& how) {
  for (const CheckResult& of : verification.checks) {
    if (of.check.id == "member-buckling/" + how) return &of;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("struts at random: the member's check is never milder than equation 6.61", "[member]") {
  test::Uniform in(661);
  int compared = 0, left_alone = 0, by_k = 0;
  for (int i = 0; i < 320; ++i) {
    Strut of = random_strut(in, false);
    of.central = i % 2 == 1;
    const double part = of.part(of.I_y());
    CAPTURE(i, of.n, of.m_y, of.central, part);
    const Verification verification = verify(parse_project("strut.toml", of.text()));
    const CheckResult* const check = member_check_of(verification, "in-the-plane-of-motion");
    // N/N_cr up to 0.04 leaves a member alone, 6.3.1.2(4).
    if (part + of.by_shear() > 0.042) REQUIRE(check != nullptr);
    if (part + of.by_shear() < 0.038) REQUIRE(check == nullptr);
    if (check == nullptr) {
      ++left_alone;
      continue;
    }
    ++compared;
    const MemberLoad& load = check->member->load;
    CHECK(load.compressed == Approx(of.n).epsilon(1e-6));
    CHECK(load.straight.m_y == Approx(of.m_y).epsilon(1e-6));
    CHECK(load.straight.m_z == 0.0);
    CHECK(load.critical >= part * (1.0 - 1e-6));
    CHECK(load.critical == Approx(part + of.by_shear()).epsilon(0.03));
    // Second order: no less than a bow's, and of one moment all along the secant.
    const double bow = of.m_y / (1.0 - load.critical);
    CHECK(load.bent >= bow * (1.0 - 1e-6));
    if (!of.central) {
      const double secant = of.m_y / std::cos(0.5 * pi * std::sqrt(part));
      CHECK(load.bent >= secant * (1.0 - 1e-3));
    }
    CHECK(check->check.utilisation() >= of.by_the_code(false) * (1.0 - 1e-9));
    // And by no more than shear, and what second order is above k.
    const double n_b = of.n / chi_of(std::sqrt(part / of.n));
    if (part > 0.04 && n_b + load.bent < of.by_the_code(false)) {
      ++by_k;
      CHECK(check->check.utilisation() <= 1.03 * of.by_the_code(false));
    }
  }
  CHECK(compared >= 240);
  CHECK(by_k >= 5);
  CHECK(left_alone < 80);
}

TEST_CASE("struts in space: equations 6.61 and 6.62 of both planes", "[member]") {
  test::Uniform in(662);
  int in_plane = 0, across = 0;
  for (int i = 0; i < 160; ++i) {
    Strut of = random_strut(in, true);
    of.central = i % 2 == 1;
    CAPTURE(i, of.n, of.m_y, of.m_z, of.central, of.part(of.I_y()), of.part(of.I_z()));
    const Verification verification = verify(parse_project("strut.toml", of.text()));
    for (const bool about_z : {false, true}) {
      const double part = of.part(about_z ? of.I_z() : of.I_y());
      if (part >= 0.95) continue;
      const CheckResult* const check =
          member_check_of(verification, about_z ? "along-y" : "along-z");
      if (part > 0.042) REQUIRE(check != nullptr);
      if (check == nullptr) continue;
      ++(about_z ? across : in_plane);
      CAPTURE(about_z);
      CHECK(check->member->load.straight.m_y == Approx(of.m_y).epsilon(1e-6));
      CHECK(check->member->load.straight.m_z == Approx(of.m_z).epsilon(0.02));
      CHECK(check->check.utilisation() >= of.by_the_code(about_z) * (1.0 - 1e-9));
    }
  }
  CHECK(in_plane >= 70);
  CHECK(across >= 70);
}

namespace {

/// An I of 300 x 150 that is clamped, pressed and bent about its stronger axis, which is the beam's
/// y or its z: in the world all is the same.
std::string pressed_I(bool lies, double kN, double kN_m) {
  const auto at = [lies](double y, double z) {
    return lies ? fmt::format("[\"{} mm\", \"{} mm\"]", z, -y)
                : fmt::format("[\"{} mm\", \"{} mm\"]", y, z);
  };
  return fmt::format(R"([case]
name = "lying"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[bodies.arm]
points = {{ heel = ["0 m", "0 m", "0 m"], tip = ["4 m", "0 m", "0 m"] }}
[joints.heel]
kind = "fixed"
connect = ["ground", "arm.heel"]
[forces.press]
kind = "force"
point = "arm.tip"
direction = "-x"
size = "{} kN"
[forces.bend]
kind = "couple"
point = "arm.tip"
direction = "y"
size = "{} kN m"
[motion]
duration = "1 s"
[sections.a]
kind = "thin-walled"
nodes = {{ a = {}, b = {}, c = {}, d = {}, e = {}, f = {} }}
walls = [{{ from = "a", to = "b", thickness = "10.7 mm" }}, {{ from = "b", to = "c", thickness = "10.7 mm" }}, {{ from = "b", to = "e", thickness = "7.1 mm" }}, {{ from = "d", to = "e", thickness = "10.7 mm" }}, {{ from = "e", to = "f", thickness = "10.7 mm" }}]
[beam]
body = "arm"
start = "heel"
axis = "x"
z = "{}"
density = "7850 kg/m^3"
diaphragms = [{{ station = "0 m", thickness = "12 mm" }}, {{ station = "4 m", thickness = "12 mm" }}]
[[beam.segments]]
length = "4 m"
section = "a"
[material]
steel = "S355"
[strength]
required = 1.5
)",
                     kN, kN_m, at(-75, 150), at(0, 150), at(75, 150), at(-75, -150), at(0, -150),
                     at(75, -150), lies ? "-y" : "z");
}

}  // namespace

// Invariant: how y and z are laid in a section is of no matter.
TEST_CASE("an I that lies buckles and turns over as one that stands", "[member]") {
  for (const auto& [kN, kN_m] : {std::pair{30.0, 5.0}, {60.0, 3.0}, {20.0, 15.0}}) {
    CAPTURE(kN, kN_m);
    const Verification stands = verify(parse_project("i.toml", pressed_I(false, kN, kN_m)));
    const Verification lies = verify(parse_project("i.toml", pressed_I(true, kN, kN_m)));
    const auto same = [&](const char* standing, const char* lying) {
      const CheckResult* const one = member_check_of(stands, standing);
      const CheckResult* const other = member_check_of(lies, lying);
      REQUIRE(one != nullptr);
      REQUIRE(other != nullptr);
      CHECK(other->check.utilisation() == Approx(one->check.utilisation()).epsilon(1e-3));
    };
    same("sideways", "sideways");
    same("along-y", "along-z");
    CHECK(stands.verdict == lies.verdict);
  }
}

}  // namespace member_interaction_test
