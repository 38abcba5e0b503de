// Thin-walled struts that twist as they buckle, or lose a part of their section: by hand.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"
#include "support/held_rod.hpp"
#include "support/path_cases.hpp"

namespace twisting_struts_test {

using namespace boxbeam;
using test::buckling_of;
using test::chi_of;
using test::compression_of;
using test::rod_result;
using test::rod_under;
using test::rods_of;

namespace {

constexpr double pi = std::numbers::pi;

/// A path as the strut's section, moved by so much along y and z [mm].
std::string strut_of(ThinWalled path, double by_y = 0.0, double by_z = 0.0) {
  for (SectionPlace& at : path.nodes) at = {at.y + paths::mm(by_y), at.z + paths::mm(by_z)};
  std::string text = path_cases::section("strut", path);
  return text.substr(text.find('\n') + 1);
}

/// Mid-lines of a channel, web `h` along z, flanges `b` along y, all `t` thick: closed forms [m].
struct ChannelByHand {
  double h, b, t;
  double A() const { return t * (h + 2.0 * b); }
  double centroid() const { return b * b * t / A(); }
  double I_y() const { return t * h * h * h / 12.0 + 0.5 * b * t * h * h; }
  double I_z() const { return 2.0 * t * b * b * b / 3.0 - A() * centroid() * centroid(); }
  double y_0() const { return b * b * h * h * t / (4.0 * I_y()) + centroid(); }
  double i_0_2() const { return (I_y() + I_z()) / A() + y_0() * y_0(); }
  double twisting(double L) const {
    const double I_w = t * b * b * b * h * h / 12.0 * (3.0 * b + 2.0 * h) / (6.0 * b + h);
    return (210e9 / 2.6 * A() * t * t / 3.0 + pi * pi * 210e9 * I_w / (L * L)) / i_0_2();
  }
  /// EN 1993-1-3, 6.2.3(7), with the axis of symmetry y.
  double critical(double L) const {
    const double N_y = pi * pi * 210e9 * I_y() / (L * L), N_z = N_y * I_z() / I_y();
    const double beta = 1.0 - y_0() * y_0() / i_0_2(), r = twisting(L) / N_y;
    const double both =
        N_y / (2.0 * beta) * (1.0 + r - std::sqrt((1.0 - r) * (1.0 - r) + 4.0 * (1.0 - beta) * r));
    return std::min(N_z, both);
  }
};

}  // namespace

TEST_CASE("an open strut twists as it buckles: a channel by hand", "[twisting]") {
  // Walls as long as their mid-lines; S355 by EN 10025-2, 8 mm. I_z of mid-lines leaves out the
  // web's own, 0.5 %.
  const ChannelByHand hand{0.2, 0.08, 0.008};
  const ThinWalled channel = paths::channel(208.0, 80.0, 8.0, 8.0);
  const double centred = -1e3 * hand.centroid();
  for (const double length : {1.0, 1.6, 3.0}) {
    CAPTURE(length);
    const Project project = rod_under(false, "-90 deg", "9.6 kN", strut_of(channel, centred),
                                      fmt::format("buckling_length = \"{} m\"\n", length));
    const NeighbourChecks checks = rods_of(project);
    CHECK(checks.gates.empty());
    REQUIRE(checks.results.size() == 1);
    const double lambda = std::sqrt(hand.A() * 355e6 / hand.critical(length));
    CHECK(compression_of(checks.results.front()).slenderness == Approx(lambda).epsilon(4e-3));
    CHECK(checks.results.front().check.resisting.value() ==
          Approx(chi_of(lambda) * hand.A() * 355e6).epsilon(5e-3));
  }
  // It bends about z alone where it is long, and twists as well where it is short.
  CHECK(hand.critical(1.0) < 0.97 * pi * pi * 210e9 * hand.I_z());
}

TEST_CASE("what a force beside the centroid of a strut bends counts, pressed and pulled",
          "[twisting]") {
  // The line of the rod on the web.
  const ChannelByHand hand{0.2, 0.08, 0.008};
  const ThinWalled channel = paths::channel(208.0, 80.0, 8.0, 8.0);
  const double e = hand.centroid(), W_z = hand.I_z() / (0.08 - e);
  const double m = hand.A() * e / W_z;
  const Project pressed = rod_under(false, "-90 deg", "9.6 kN", strut_of(channel));
  const double chi = chi_of(std::sqrt(hand.A() * 355e6 / hand.critical(1.0)));
  CHECK(
      buckling_of(pressed).check.resisting.value() ==
      Approx(std::min(chi * hand.A() * 355e6 / (1.0 + 1.6 * chi * m), hand.A() * 355e6 / (1.0 + m)))
          .epsilon(6e-3));
  const Project pulled = rod_under(false, "90 deg", "10.4 kN", strut_of(channel));
  CHECK(rod_result(pulled, Criterion::rod).check.resisting.value() ==
        Approx(hand.A() * 0.9 * 470e6 / 1.25 / (1.0 + m)).epsilon(3e-3));
  // Off its centroid in the stiffer plane it may turn over: no verdict.
  const Project high =
      rod_under(false, "-90 deg", "9.6 kN", strut_of(channel, -1e3 * hand.centroid(), 30.0));
  const NeighbourChecks checks = rods_of(high);
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding.find("may turn the open section over") != std::string::npos);
  CHECK(checks.results.empty());
}

TEST_CASE("an angle bears the same however it is turned about its line", "[twisting]") {
  // Legs 100 x 6, the line through the heel: bent about its weak principal axis alone.
  const auto angle = [](double by) {
    ThinWalled of;
    const auto leg = [&](double at) {
      return paths::mm_place(100.0 * std::cos(at), 100.0 * std::sin(at));
    };
    const std::size_t heel = paths::add_node(of, paths::mm_place(0.0, 0.0));
    paths::add_wall(of, heel, paths::add_node(of, leg(by)), 6.0);
    paths::add_wall(of, heel, paths::add_node(of, leg(by + 0.5 * pi)), 6.0);
    return rod_under(false, "-90 deg", "2 kN", strut_of(of));
  };
  const Project by_principal = angle(-0.25 * pi), by_legs = angle(0.0);
  const double principal = buckling_of(by_principal).check.resisting.value();
  const double legs = buckling_of(by_legs).check.resisting.value();
  // Both moments add up by their sizes, on the safe side.
  CHECK(legs <= principal * (1.0 + 1e-6));
  CHECK(legs > 0.5 * principal);
}

TEST_CASE("a slender open strut by its effective area, and where its centroid moves",
          "[twisting]") {
  const double eps = std::sqrt(235.0 / 355.0);
  const auto outstand = [&](double c_over_t) {
    const double lambda = c_over_t / (28.4 * eps * std::sqrt(0.43));
    return lambda <= 0.748 ? 1.0 : (lambda - 0.188) / (lambda * lambda);
  };
  const auto internal = [&](double c_over_t) {
    const double lambda = c_over_t / (28.4 * eps * 2.0);
    return lambda <= 0.673 ? 1.0 : (lambda - 0.22) / (lambda * lambda);
  };
  SECTION("an I, which mirrors itself") {
    // Flanges 200 x 6, web 300 x 5: c/t = 97.5/6 and 60.
    const Project project =
        rod_under(false, "-90 deg", "9.6 kN", strut_of(paths::i_section(200.0, 6.0, 300.0, 5.0)));
    const NeighbourResult result = buckling_of(project);
    const auto& rod = std::get<PressedRod>(result.basis);
    CHECK(rod.section.class_4);
    CHECK_FALSE(rod.beside);
    const double A_eff = 1e-6 * (2.0 * 6.0 * (5.0 + 2.0 * outstand(97.5 / 6.0) * 97.5) +
                                 5.0 * 300.0 * internal(60.0));
    CHECK(rod.section.effective.value() == Approx(A_eff).epsilon(1e-9));
    // Torsion: N_cr,T = (G I_T + pi^2 E I_w)/i_0^2 of 1 m.
    const double I_z = 2.0 * 0.006 * std::pow(0.2, 3) / 12.0 + 0.3 * std::pow(0.005, 3) / 12.0;
    CHECK(result.check.resisting.value() <= A_eff * 355e6);
    const double N_z = pi * pi * 210e9 * I_z;
    CHECK(compression_of(result).slenderness ==
          Approx(std::sqrt(A_eff * 355e6 / N_z)).epsilon(0.02));
  }
  SECTION("a channel, whose flanges lose their tips") {
    // Web 200 x 4, flanges 100 x 4: c/t = 49 and 24.5; centred on its whole section.
    const ChannelByHand hand{0.2, 0.1, 0.004};
    const ThinWalled channel = paths::channel(204.0, 100.0, 4.0, 4.0);
    const Project project =
        rod_under(false, "-90 deg", "9.6 kN", strut_of(channel, -1e3 * hand.centroid()));
    const NeighbourResult result = buckling_of(project);
    const auto& rod = std::get<PressedRod>(result.basis);
    // Of flanges 98 mm beyond the web's face, of the web 196 between flanges.
    const double flange = 2.0 + outstand(98.0 / 4.0) * 98.0;
    const double idle_web = (1.0 - internal(196.0 / 4.0)) * 196.0;
    const double A_eff = 4.0 * (2.0 * flange + 200.0 - idle_web);
    CHECK(1e6 * rod.section.effective.value() == Approx(A_eff).epsilon(1e-3));
    const double moved = 4.0 * flange * flange / A_eff - 1e3 * hand.centroid();
    CHECK(moved < -2.0);
    REQUIRE(rod.beside);
    CHECK(1e3 * rod.beside->e_y.value() == Approx(-moved).epsilon(5e-3));
    CHECK(rod.beside->e_z == Length{});
    const double m = 1e-6 * A_eff * -1e-3 * moved / rod.beside->W_z.value();
    const double chi = compression_of(result).reduction;
    CHECK(result.check.resisting.value() ==
          Approx(std::min(chi / (1.0 + 1.6 * chi * m), 1.0 / (1.0 + m)) * 1e-6 * A_eff * 355e6)
              .epsilon(2e-3));
  }
  SECTION("longer struts and thinner walls bear less") {
    double before = 1e12;
    for (const double length : {1.0, 2.0, 4.0, 8.0}) {
      const Project project =
          rod_under(false, "-90 deg", "9.6 kN", strut_of(paths::i_section(200.0, 6.0, 300.0, 5.0)),
                    fmt::format("buckling_length = \"{} m\"\n", length));
      const double bears = buckling_of(project).check.resisting.value();
      CHECK(bears < before);
      before = bears;
    }
  }
}

TEST_CASE("a thin-walled strut around a small cell twists, too", "[twisting]") {
  // Fins 200 x 20 around a cell of 20 x 20 x 4: G I_T/i_0^2.
  ThinWalled cross{{paths::mm_place(10, 10), paths::mm_place(-10, 10), paths::mm_place(-10, -10),
                    paths::mm_place(10, -10), paths::mm_place(210, 10), paths::mm_place(-10, 210),
                    paths::mm_place(-210, -10), paths::mm_place(10, -210)},
                   {}};
  for (const std::size_t k : {0U, 1U, 2U, 3U}) {
    paths::add_wall(cross, k, (k + 1) % 4, 4.0);
    paths::add_wall(cross, k, k + 4, 20.0);
  }
  const Project project = rod_under(false, "-90 deg", "9.6 kN", strut_of(cross));
  const NeighbourResult result = buckling_of(project);
  const Section& section = project.rods.front().section;
  const SectionProperties p = properties_of(section);
  const double critical = 210e9 / 2.6 * torsion_properties_of(section).I_T->value() *
                          p.area.value() / (p.I_y + p.I_z).value();
  CHECK(compression_of(result).slenderness ==
        Approx(std::sqrt(p.area.value() * project.rods.front().yield_strength.value() / critical))
            .epsilon(1e-6));
}

}  // namespace twisting_struts_test
