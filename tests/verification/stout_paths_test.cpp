// Forces into stout walls of thin-walled paths, whose plates need no effective widths: the same by
// either route of plates, beside diaphragms that are too thin, into walls that lean, and into walls
// that are no webs.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/verification/patch_checks.hpp"
#include "catch.hpp"
#include "support/gates.hpp"
#include "support/path_cases.hpp"

namespace stout_paths_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::held;
using path_cases::section;

namespace {

const std::string by_reduced = "plates = \"reduced stresses\"\n";

std::string pads(double stiff_length) {
  return fmt::format(
      "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"3 m\"\nstiff_length = \"{} mm\"\n",
      stiff_length);
}

/// A diaphragm with fillets.
std::string diaphragm(double at, double thickness, double throat) {
  return diaphragms({at}, thickness) + fmt::format("throat = \"{} mm\"\n", throat);
}
const std::string ends = diaphragm(0.0, 40.0, 14.0) + diaphragm(3.0, 40.0, 14.0);

std::string in_plane(const ThinWalled& path, const std::string& more, double kN,
                     const std::string& last = "", const std::string& other = "") {
  return "[case]\nname = \"path\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         section("a", path) + other + "[beam]\ndensity = \"7850 kg/m^3\"\n" +
         (other.empty() ? segment(3.0, "a")
                        : segment(1.4, "a") + taper(0.2, "a", "b") + segment(1.4, "b")) +
         held(3.0, 10) + more +
         "[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\n"
         "[supports.b]\nkind = \"roller\"\nat = \"3 m\"\n" +
         fmt::format(
             "[loads.hook]\nkind = \"force\"\nat = \"1.5 m\"\nforce = [\"0 kN\", \"{} "
             "kN\"]\n",
             kN) +
         steel + "[strength]\nrequired = 1.0\nshear_lag = false\n" + last;
}

std::string in_space(const ThinWalled& path, const std::string& more, const std::string& loads) {
  return "[case]\nname = \"path\"\nkind = \"static\"\n[frame]\nspace = true\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
         section("a", path) + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segment(3.0, "a") + more +
         "[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\nfork = true\n"
         "[supports.z]\nkind = \"roller\"\nat = \"3 m\"\ndirection = \"z\"\nfork = true\n"
         "[supports.y]\nkind = \"roller\"\nat = \"3 m\"\ndirection = \"y\"\n" +
         loads + steel + "[strength]\nrequired = 1.0\nshear_lag = false\n";
}

std::string down(double kN) {
  return fmt::format(
      "[loads.hook]\nkind = \"force\"\nat = [\"1.5 m\", \"0 m\", \"0 m\"]\n"
      "force = [\"0 kN\", \"0 kN\", \"{} kN\"]\n",
      -kN);
}

std::string line(double kN_per_m) {
  return fmt::format(
      "[loads.q]\nkind = \"line\"\nforce_per_length = [\"0 kN/m\", \"0 kN/m\", \"{} kN/m\"]\n",
      -kN_per_m);
}

/// Of the checks under the hook whose point begins so the one that is used most.
const CheckResult* under_hook(const Verification& of, const std::string& begins,
                              Criterion by = Criterion::patch_loading) {
  const CheckResult* worst = nullptr;
  for (const CheckResult& result : of.checks) {
    const std::string& point = result.check.point;
    if (result.check.criterion != by || point.rfind(begins, 0) != 0 ||
        !point.ends_with(" under hook"))
      continue;
    if (worst == nullptr || result.check.utilisation() > worst->check.utilisation())
      worst = &result;
  }
  return worst;
}

bool blocks(const Verification& of, const std::string& words) {
  return of.verdict != Verdict::pass && test::blocks(of, words);
}

/// What is said of the walls of a path in the verdict line; "" where nothing is.
std::string said(const Verification& of) {
  for (const NotJudged& what : of.not_judged)
    if (what.what.rfind("walls of a path", 0) == 0) return what.reason;
  return "";
}

/// S355, flanges 300 x 25, web 550 x 20. Under a force on s_s: l_y = s_s + 2 t_f (1 + sqrt(m_1)),
/// m_1 = b_f/t_w = 15, and chi_F = 1, for lambda_F = sqrt(F_y/F_cr) < 0.5 with
/// F_cr = 0.9 x 6 E t_w^3/h_w = 16.5 MN (EN 1993-1-5, 6.4, 6.5).
const ThinWalled stout_i = i_section(300.0, 25.0, 550.0, 20.0);
double borne_by_stout_i(double s_s) {
  return 355.0 * 20.0 * (s_s + 2.0 * 25.0 * (1.0 + std::sqrt(15.0))) * 1e-3;  // kN
}

/// A box of 400 x 400 whose bottom flange is narrower by so many mm on both sides, mid-lines.
ThinWalled trapezium(double by) {
  ThinWalled path = box_path(400.0, 400.0, 20.0, 16.0);
  for (SectionPlace& node : path.nodes)
    if (node.z < Length{}) node.y += node.y > Length{} ? mm(-by) : mm(by);
  return path;
}

/// Three webs of 18 mm between flanges of 20 mm, 600 x 400, mid-lines.
ThinWalled two_cells() {
  ThinWalled path;
  std::array<std::size_t, 3> top{}, bottom{};
  for (const std::size_t k : {0U, 1U, 2U}) {
    const double y = 300.0 - 300.0 * static_cast<double>(k);
    top[k] = add_node(path, mm_place(y, 200.0));
    bottom[k] = add_node(path, mm_place(y, -200.0));
    add_wall(path, top[k], bottom[k], 18.0);
  }
  for (const std::size_t k : {0U, 1U}) {
    add_wall(path, top[k], top[k + 1], 20.0);
    add_wall(path, bottom[k], bottom[k + 1], 20.0);
  }
  return path;
}

/// A hexagon with corners on a circle of 250 mm, two of them at the height of the axis, of 16 mm.
ThinWalled hexagon() {
  ThinWalled path;
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3.0;
    add_node(path, mm_place(250.0 * std::cos(angle), 250.0 * std::sin(angle)));
  }
  for (std::size_t k = 0; k < 6; ++k) add_wall(path, k, (k + 1) % 6, 16.0);
  return path;
}

}  // namespace

TEST_CASE("stout walls of a path bear forces alike by either route of plates", "[patch]") {
  // No plate of them needs any route.
  for (const std::string& route : {std::string(), by_reduced}) {
    CAPTURE(route);
    const Verification given = verified(in_plane(stout_i, ends + pads(50.0), -2000.0, route));
    REQUIRE(under_hook(given, "wall") != nullptr);
    CHECK(under_hook(given, "wall")->patch->resistance.value() ==
          Approx(1e3 * borne_by_stout_i(50.0)).epsilon(1e-6));
    CHECK(given.verdict == Verdict::fail);
    // 2200 kN above 1730 kN under an edge.
    const Verification edge = verified(in_plane(stout_i, ends, -2200.0, route));
    CHECK(blocks(edge, fmt::format("bears {:.4g} kN under an edge", borne_by_stout_i(0.0))));
    CHECK(
        blocks(verified(in_space(trapezium(0.0), ends, down(1000.0)) + route), "bends it across"));
  }
}

TEST_CASE("stout walls that rise steeply along the beam bear forces as others", "[patch]") {
  // Edges at atan(50/200) = 14 deg, h_w = 600 mm in the middle. What turns off at both ends of the
  // segment opposes the force: k_F = 3.5 + 2 (h_w/a)^2, a = 3 m (figure 6.1, type b); lambda_F is
  // above 0.5, so m_2 = 0.02 (h_w/t_f)^2 (6.5).
  const Verification of = verified(in_plane(stout_i, ends + pads(50.0), -2000.0, "",
                                            section("b", i_section(300.0, 25.0, 650.0, 20.0))));
  REQUIRE(under_hook(of, "wall") != nullptr);
  const double l_y = 50.0 + 50.0 * (1.0 + std::sqrt(15.0 + 0.02 * 24.0 * 24.0)),
               F_y = 355.0 * 20.0 * l_y, F_cr = 0.9 * (3.5 + 2.0 * 0.04) * 210e3 * 8000.0 / 600.0;
  CHECK(under_hook(of, "wall")->patch->resistance.value() ==
        Approx(0.5 * std::sqrt(F_cr / F_y) * F_y).epsilon(1e-6));
}

TEST_CASE("flats that twist beside a stout web are none", "[patch]") {
  // 140/1, 140/3 and 140/12 above 10.5 (9.2.1(8)): the web by itself; 140/20 = 7 takes it.
  const double bare = under_hook(verified(in_plane(stout_i, ends + pads(50.0), -2000.0)), "wall")
                          ->check.utilisation();
  CHECK(bare > 1.0);
  for (const double thickness : {1.0, 3.0, 12.0}) {
    CAPTURE(thickness);
    const Verification of =
        verified(in_plane(stout_i, ends + diaphragm(1.5, thickness, 3.0) + pads(50.0), -2000.0));
    REQUIRE(under_hook(of, "wall") != nullptr);
    CHECK(under_hook(of, "wall")->check.utilisation() == Approx(bare).epsilon(1e-9));
    CHECK(of.verdict == Verdict::fail);
  }
  CHECK(blocks(verified(in_plane(stout_i, ends + diaphragm(1.5, 3.0, 3.0), -2200.0)), "twists"));
  const Verification thick =
      verified(in_plane(stout_i, ends + diaphragm(1.5, 20.0, 16.0) + pads(50.0), -2000.0));
  CHECK(thick.verdict == Verdict::pass);
}

TEST_CASE("walls of a path that lean to ten degrees are webs, with F/cos along themselves",
          "[patch]") {
  const auto of = [](double by, double thickness, double throat) {
    return verified(in_space(trapezium(by), ends + diaphragm(1.5, thickness, throat) + pads(200.0),
                             down(1200.0)));
  };
  // A hundredth of a mm decides nothing: the diaphragm of 4 mm is too weak.
  for (const double by : {0.0, 0.01, 5.0, 40.0}) {
    CAPTURE(by);
    CHECK(blocks(of(by, 4.0, 3.0), "bends it across"));
  }
  // Its plate of 20 mm bears it: weld with the web, half of the force over the cosine.
  const auto share = [&](double by) {
    const Verification found = of(by, 20.0, 10.0);
    const CheckResult* const weld =
        under_hook(found, "weld of flange and diaphragm", Criterion::weld);
    REQUIRE(weld != nullptr);
    CHECK(found.verdict == Verdict::pass);
    return weld->patch->share;
  };
  // From mid-line to mid-line 380 mm high.
  for (const double by : {0.0, 0.01, 20.0, 60.0})
    CHECK(share(by) == Approx(0.5 * std::hypot(380.0, by) / 380.0).epsilon(1e-9));
  // Without a diaphragm a web bears as much of it as of a rectangle: 355 x 16 (2 x 20 (1 +
  // sqrt(m_1))), m_1 of half of the flange, 15 eps t_f at most (6.5).
  const auto edge = [&](double by) { return verified(in_plane(trapezium(by), ends, -2400.0)); };
  for (const double by : {0.0, 0.01, 40.0}) {
    CAPTURE(by);
    CHECK(blocks(edge(by), "under an edge"));
  }
}

TEST_CASE("what a diaphragm leads into walls of a path that are no webs is estimated", "[patch]") {
  const auto of = [](const ThinWalled& path, double thickness, double throat, double kN) {
    return verified(in_plane(path, ends + diaphragm(1.5, thickness, throat), -kN));
  };
  const double f_vw = 490.0 / (std::numbers::sqrt3 * 0.9 * 1.25);  // MPa
  // To either side half, by two fillets: 400 mm along the outer of three webs, 433 mm of a hexagon.
  const std::pair<ThinWalled, double> cases[] = {{two_cells(), 400.0}, {hexagon(), 433.01}};
  for (const auto& [path, reach] : cases) {
    CAPTURE(reach);
    const double use = 0.5 * 800e3 / (2.0 * 5.0 * reach * f_vw);
    const std::string why = said(of(path, 20.0, 5.0, 800.0));
    CHECK(why.ends_with(fmt::format("are used by {:.2g}", use)));
    CHECK(of(path, 20.0, 5.0, 800.0).verdict == Verdict::pass);
    // Twice the force on fillets of 2 mm, 2 x 5/2 x use; on a plate of 2 mm less.
    CHECK(5.0 * use > 1.0);
    CHECK(blocks(of(path, 20.0, 2.0, 1600.0), "a diaphragm is taken to bear it"));
    CHECK(blocks(of(path, 2.0, 5.0, 1600.0), "a diaphragm is taken to bear it"));
    // What hardly presses asks for no word.
    CHECK(said(of(path, 20.0, 5.0, 40.0)).empty());
  }
}

TEST_CASE("stout walls of a path that are no webs bear forces without a diaphragm only if small",
          "[patch]") {
  for (const ThinWalled& path : {two_cells(), hexagon(), trapezium(120.0)}) {
    CHECK(blocks(verified(in_plane(path, ends, -800.0)), "comes into walls of a path"));
    CHECK(blocks(verified(in_space(path, ends, down(800.0))), "comes into walls of a path"));
    // A tenth of t f_y 4 t of the thinnest, 16 mm: 36 kN (6.5 with m_1 = 1).
    CHECK(verified(in_plane(path, ends, -30.0)).verdict == Verdict::pass);
  }
}

TEST_CASE("loads along the beam come into walls of a path that lean, too", "[patch]") {
  // As of the rectangle: 4/27 q b on t^2 f_y/6, b = 384 mm between the webs' mid-lines.
  const auto use_text = [](double q, double b) {
    return fmt::format("by about {:.2g} of its strength",
                       4.0 / 27.0 * q * b * 6.0 / (20.0 * 20.0 * 345.0));
  };
  for (const double by : {0.0, 40.0}) {
    CAPTURE(by);
    CHECK(blocks(verified(in_space(trapezium(by), ends, line(700.0))), use_text(700.0, 384.0)));
  }
  CHECK(blocks(verified(in_space(hexagon(), ends, line(500.0))), "a load along the beam"));
  // Weight is none.
  CHECK(verified(in_space(hexagon(), ends, line(2.0))).verdict == Verdict::pass);
}

}  // namespace stout_paths_test
