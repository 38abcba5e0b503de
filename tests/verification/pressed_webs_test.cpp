// Webs that wheels and joints press anew at every cycle, in fatigue: hand formulas, and ways of
// wheels walked in small steps.

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "boxbeam/report/report.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/path_cases.hpp"

namespace pressed_webs_test {

using namespace boxbeam;

namespace {

/// A slender box 600 x 1224, flanges 12 mm, webs so thick [mm].
std::string box(double web = 8.0, const std::string& more = "", const std::string& name = "a") {
  return slender_cases::box(name, 600.0, 1224.0, 12.0, web, more);
}

std::string wheels(const std::string& list, double from = 1.0, double to = 8.0) {
  return fmt::format(
      "[loads.crab]\nkind = \"wheels\"\nwheels = [{}]\nfrom = \"{} m\"\nto = \"{} m\"\n"
      "speed = \"1 m/s\"\n",
      list, from, to);
}

std::string wheel(double kN, double behind = 0.0) {
  return fmt::format("{{ {}force = [\"0 kN\", \"{} kN\"] }}",
                     behind > 0.0 ? fmt::format("behind = \"{} m\", ", behind) : "", kN);
}

std::string fatigue(const std::string& cycles, double gamma_Mf = 1.35) {
  return fmt::format(
      "[fatigue]\n{}category = 160\nloading = \"spectrum\"\ngamma_Mf = {}\n"
      "required = 1.0\n",
      cycles.empty() ? "" : "cycles = " + cycles + "\n", gamma_Mf);
}

/// A weightless beam of 9 m on two supports over diaphragms; forces come in over 100 mm.
std::string beam(const std::string& sections, const std::string& loads, const std::string& more,
                 const std::string& segments =
                     "[[beam.segments]]\nlength = \"9 m\"\nsection = "
                     "\"a\"\n") {
  return "[case]\nname = \"pressed\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments +
         slender_cases::diaphragms({0.0, 9.0}) +
         "[[beam.load_introductions]]\nfrom = \"0.5 m\"\nto = \"8.5 m\"\n"
         "stiff_length = \"100 mm\"\n[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
         "[supports.right]\nkind = \"roller\"\nat = \"9 m\"\n" +
         loads + slender_cases::steel + "[strength]\nrequired = 1.0\nshear_lag = false\n" + more;
}

Verification verified(const std::string& text) {
  return verify(parse_project("pressed.toml", text));
}

double use_in(const std::string& text) {
  return slender_cases::use_of(verified(text), Criterion::patch_fatigue);
}

// 100 kN in each web, over 100 + 2 x 12 mm.
const double sigma_z = 100e3 / (8.0 * 124.0);

/// Of a range so often, by a category and gamma_Mf; above the constant amplitude limit.
double use_of(double range, double cycles, double category, double gamma_Mf) {
  return range / (category / gamma_Mf * std::cbrt(2e6 / cycles));
}

bool says_not_judged(const Verification& of) {
  return std::any_of(of.not_judged.begin(), of.not_judged.end(), [](const NotJudged& at) {
    return at.reason.find("table 8.10") != std::string::npos;
  });
}

}  // namespace

TEST_CASE("a wheel presses the web from nothing and back at every passage", "[pressed]") {
  const std::string text = beam(box(), wheels(wheel(-200.0)), fatigue("1e6"));
  const Verification of = verified(text);
  const CheckResult* const found = of.governing(Criterion::patch_fatigue);
  REQUIRE(found != nullptr);
  CHECK(found->check.utilisation() == Approx(use_of(sigma_z, 1e6, 71.0, 1.35)).epsilon(1e-6));
  CHECK(found->check.acting.value() == Approx(1e6 * sigma_z).epsilon(1e-6));
  CHECK(found->check.point == "web under crab");
  CHECK(of.verdict == Verdict::fail);
  CHECK_FALSE(says_not_judged(of));
  // Without [fatigue] there is nothing to it.
  CHECK(verified(beam(box(), wheels(wheel(-200.0)), "")).governing(Criterion::patch_fatigue) ==
        nullptr);
}

TEST_CASE("the sheet of a pressed web leads from the force to the range", "[pressed]") {
  const Project project =
      parse_project("pressed.toml", beam(box(), wheels(wheel(-200.0)), fatigue("1e6")));
  const Verification of = verify(project);
  const report::Sheet sheet = sheet_of(project, of, *of.governing(Criterion::patch_fatigue));
  const auto value = [&](const std::string& symbol) {
    const auto step = std::find_if(sheet.steps.begin(), sheet.steps.end(),
                                   [&](const report::Step& at) { return at.symbol == symbol; });
    return step == sheet.steps.end() ? 0.0 : std::stod(step->formulas.back());
  };
  CHECK(value("F") == Approx(100.0).epsilon(1e-3));
  CHECK(value("l") == Approx(124.0).epsilon(1e-3));
  CHECK(value("sigma_z") == Approx(sigma_z).epsilon(1e-3));
  CHECK(value("d_sigma") == Approx(sigma_z).epsilon(1e-3));
}

TEST_CASE("fillets are judged by their throats, by 36, where these are used more", "[pressed]") {
  const auto with = [](double throat) {
    return use_in(beam(box(8.0, fmt::format("seam_throat = \"{} mm\"\n", throat)),
                       wheels(wheel(-200.0)), fatigue("1e6")));
  };
  CHECK(with(6.0) == Approx(use_of(sigma_z * 8.0 / 6.0, 1e6, 36.0, 1.35)).epsilon(1e-6));
  // 36 x 20/8 = 90: the web is weaker.
  CHECK(with(20.0) == Approx(use_of(sigma_z, 1e6, 71.0, 1.35)).epsilon(1e-6));
}

TEST_CASE("shear along the seam counts with what presses it: equation 8.3 by hand", "[pressed]") {
  // Over a pad of 800 mm: each passage presses each web by F/2 and lets V jump by F.
  const double F = 1000e3, n = 1e4, gamma = 1.35;
  const auto with = [&](const std::string& more) {
    std::string text =
        beam(box(8.0, more), wheels(wheel(-1e-3 * F)), fatigue(fmt::format("{}", n), gamma));
    const std::string said = "stiff_length = \"100 mm\"";
    text.replace(text.find(said), said.size(), "stiff_length = \"800 mm\"");
    return use_in(text);
  };
  const double I = (600.0 * std::pow(1224.0, 3) - 584.0 * std::pow(1200.0, 3)) / 12.0;
  const double flow = F * 600.0 * 12.0 * 606.0 / (2.0 * I);  // N/mm
  const double pressed = 0.5 * F / 824.0;                    // N/mm
  const auto by_hand = [&](double across, double category, double along, double category_shear) {
    double low = 0.0, high = 100.0;
    for (int i = 0; i < 100; ++i) {
      const double k = 0.5 * (low + high);
      const double damage = n / 2e6 *
                            (std::pow(k * gamma * across / category, 3) +
                             std::pow(k * gamma * along / category_shear, 5));
      (damage < 1.0 ? low : high) = k;
    }
    return 1.0 / low;
  };
  CHECK(with("") == Approx(by_hand(pressed / 8.0, 71.0, flow / 8.0, 100.0)).epsilon(1e-4));
  CHECK(with("") > 1.03 * use_of(pressed / 8.0, n, 71.0, gamma));
  CHECK(with("seam_throat = \"6 mm\"\n") ==
        Approx(by_hand(pressed / 6.0, 36.0, flow / 6.0, 80.0)).epsilon(1e-4));
}

TEST_CASE("a rolled web has no seam: category 160", "[pressed]") {
  const std::string tube =
      "[sections.a]\nkind = \"rectangular tube\"\nwidth = \"300 mm\"\nheight = \"600 mm\"\n"
      "wall = \"10 mm\"\n";
  CHECK(
      use_in(beam(tube, wheels(wheel(-200.0)), fatigue("1e7", 1.0))) ==
      Approx(100e3 / (10.0 * 120.0) / (160.0 * std::cbrt(0.4) * std::pow(0.5, 0.2))).epsilon(1e-6));
}

TEST_CASE("wheels one behind the other press twice, those within their length together",
          "[pressed]") {
  const auto with = [](double apart) {
    return use_in(beam(box(), wheels(wheel(-200.0) + ", " + wheel(-200.0, apart)), fatigue("1e6")));
  };
  CHECK(with(1.0) == Approx(use_of(sigma_z, 2e6, 71.0, 1.35)).epsilon(1e-6));
  CHECK(with(0.13) == Approx(use_of(sigma_z, 2e6, 71.0, 1.35)).epsilon(1e-6));
  // A hundredth of a millimetre of the web is under both, between two instants.
  CHECK(with(0.12399) == Approx(use_of(2.0 * sigma_z, 1e6, 71.0, 1.35)).epsilon(1e-6));
  CHECK(with(0.12) == Approx(use_of(2.0 * sigma_z, 1e6, 71.0, 1.35)).epsilon(1e-6));
}

TEST_CASE("a wheel at an end of the beam loads half as much of the web, but over a diaphragm",
          "[pressed]") {
  std::string held = beam(box(), wheels(wheel(-200.0), 1.0, 9.0), fatigue("1e6"));
  for (const auto& [of, to] :
       {std::pair{"from = \"0.5 m\"", "from = \"0 m\""}, {"to = \"8.5 m\"", "to = \"9 m\""}})
    held.replace(held.find(of), std::string(of).size(), to);
  CHECK(use_in(held) == Approx(use_of(sigma_z, 1e6, 71.0, 1.35)).epsilon(1e-6));
  std::string open = held;
  const std::string last = slender_cases::diaphragms({9.0});
  open.replace(open.find(last), last.size(), "");
  CHECK(use_in(open) == Approx(use_of(2.0 * sigma_z, 1e6, 71.0, 1.35)).epsilon(1e-6));
}

TEST_CASE("a force that stands still: its range between situations, with its sign", "[pressed]") {
  const auto with = [](double empty, const std::string& place) {
    return verified(beam(
        box(),
        "[loads.hook]\nkind = \"force\"\nat = \"" + place +
            "\"\nforce = [\"0 kN\", \"-200 kN\"]\n"
            "[loads.still]\nkind = \"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"-150 kN\"]\n" +
            fmt::format("[[situations]]\nname = \"empty\"\nloads = {{ hook = {}, still = 1.0 }}\n",
                        empty) +
            "[[situations]]\nname = \"loaded\"\nloads = { hook = 1.0, still = 1.0 }\n"
            "[[situations]]\nname = \"lift\"\nbetween = [\"empty\", \"loaded\"]\ncycles = 2e6\n",
        fatigue("", 1.0)));
  };
  const Verification of = with(0.0, "4.5 m");
  CHECK(slender_cases::use_of(of, Criterion::patch_fatigue) ==
        Approx(sigma_z / 71.0).epsilon(1e-6));
  for (const CheckResult& result : of.checks) {
    // What does not change does no damage.
    if (result.check.criterion == Criterion::patch_fatigue)
      CHECK(result.check.point == "web under hook");
  }
  CHECK(slender_cases::use_of(with(-0.5, "4.5 m"), Criterion::patch_fatigue) ==
        Approx(1.5 * sigma_z / 71.0).epsilon(1e-6));
  // A diaphragm takes it.
  CHECK(slender_cases::use_of(with(0.0, "9 m"), Criterion::patch_fatigue) == 0.0);
}

TEST_CASE("random ways of wheels, walked in small steps, press no web more", "[pressed]") {
  std::mt19937 random(20261126);
  const auto draw = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  for (int n = 0; n < 4; ++n) {
    const double first = draw(6.0, 9.0), last = draw(6.0, 9.0);
    const double front = std::round(draw(50.0, 200.0)), rear = std::round(draw(50.0, 200.0));
    const double apart = std::round(1e3 * draw(0.05, 0.5)) / 1e3;
    const std::string text =
        beam(box(first, "", "a") + box(last, "", "b"),
             wheels(wheel(-front) + ", " + wheel(-rear, apart), 1.5, 8.0), fatigue("1e6", 1.0),
             "[[beam.segments]]\nlength = \"9 m\"\nfrom = \"a\"\nto = \"b\"\n");
    CAPTURE(text);
    double most = 0.0;
    for (int k = 0; k <= 200; ++k) {
      const double x = 1.6 + 5.8 * k / 200.0, t = first + (last - first) * x / 9.0;
      const auto pressed = [&](double s) { return std::abs(s - x) <= 0.062; };
      // Once up from nothing and back, however it turns on the way.
      std::vector<double> ranges;
      double before = 0.0, top = 0.0;
      for (int i = 0; i <= 40000; ++i) {
        const double s = 1.5 + 6.5 * i / 40000.0;
        const double F = (pressed(s) ? front : 0.0) + (pressed(s - apart) ? rear : 0.0);
        const double stress = 500.0 * F / (t * 124.0);
        top = std::max(top, stress);
        if (stress == 0.0 && before > 0.0) {
          ranges.push_back(top);
          top = 0.0;
        }
        before = stress;
      }
      // Figure 7.1: slope 3 above the constant amplitude limit, 5 below it down to the cut-off.
      const double limit = 71.0 * std::cbrt(0.4), cut_off = limit * std::pow(0.05, 0.2);
      double damage = 0.0, largest = 0.0;
      for (const double range : ranges) {
        largest = std::max(largest, range);
        if (range >= cut_off) damage += 0.2 * std::pow(range / limit, range >= limit ? 3.0 : 5.0);
      }
      if (largest > limit) most = std::max(most, damage);
    }
    if (most == 0.0) continue;
    const Verification of = verified(text);
    const CheckResult* const found = of.governing(Criterion::patch_fatigue);
    REQUIRE(found != nullptr);
    CHECK(found->pressed->life.damage >= most * (1.0 - 1e-3));
    CHECK(found->pressed->life.damage <= most * 1.15);
  }
}

TEST_CASE("what wheels press into walls of a path is not counted, and that is said", "[pressed]") {
  // An I girder 1200 deep: its seams are not known.
  const auto mm = [](double value) { return si<Length>(1e-3 * value); };
  ThinWalled path;
  path.nodes = {{mm(-150.0), mm(600.0)},  {mm(0.0), mm(600.0)},  {mm(150.0), mm(600.0)},
                {mm(-150.0), mm(-600.0)}, {mm(0.0), mm(-600.0)}, {mm(150.0), mm(-600.0)}};
  const auto wall = [&](std::size_t from, std::size_t to, double thickness) {
    ThinWall of;
    of.from = from;
    of.to = to;
    of.thickness = mm(thickness);
    path.walls.push_back(of);
  };
  wall(0, 1, 16.0);
  wall(1, 2, 16.0);
  wall(3, 4, 16.0);
  wall(4, 5, 16.0);
  wall(4, 1, 8.0);
  const Verification of = verified(beam(path_cases::section("a", path), wheels(wheel(-100.0)),
                                        path_cases::held(9.0, 18) + fatigue("1e6")));
  CHECK(of.governing(Criterion::patch_fatigue) == nullptr);
  CHECK(says_not_judged(of));
}

}  // namespace pressed_webs_test
