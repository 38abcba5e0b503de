// What comes into webs and flanges is judged alike however a case is written: from the other end,
// as several forces, as a couple or as its forces, as one kink or as a curve; and what stands
// beside each other is judged together.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace pressed_mirrors_test {

using namespace pressed_beams;

TEST_CASE("a beam and its mirror image are judged alike where forces and kinks come in",
          "[patch]") {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::round(100.0 * std::uniform_real_distribution(low, high)(random)) / 100.0;
  };
  int alike = 0, stopped = 0, pressed = 0;
  for (int i = 0; i < 60; ++i) {
    Beam beam;
    const double width = between(300.0, 600.0);
    const auto sizes = [&](double height, double flange, double web) {
      return Sizes{width, height, flange, web, i % 3 == 0 ? 0.0 : std::round(between(6.0, 20.0))};
    };
    const double high = between(500.0, 900.0), low = between(300.0, high);
    const double web = std::round(between(10.0, 20.0)), flange = std::round(between(14.0, 30.0));
    const double thin = i % 2 == 0 ? flange : std::round(between(0.5 * flange, flange));
    beam.pieces = {{between(1.0, 2.0), sizes(high, flange, web), sizes(high, flange, web)},
                   {between(0.6, 1.5), sizes(high, thin, web), sizes(low, thin, web)},
                   {between(1.0, 2.0), sizes(low, thin, web), sizes(low, thin, web)}};
    for (Piece& of : beam.pieces) of.to.throat = of.from.throat;
    // A force at a border stands on neither side of it: without rounding in both images.
    if (i % 4 == 0)
      for (Piece& of : beam.pieces) of.length = std::round(64.0 * of.length) / 64.0;
    const double L = beam.length(), border = beam.pieces[0].length;
    const bool jumps = i % 4 == 1;  // M, where the flanges kink
    beam.diaphragms = {0.0, L};
    beam.supports = {{0.0, 0.0}, {L, 0.0}};
    beam.forces = {{"f", i % 4 == 0 ? border : between(0.3, L - 0.3), between(50.0, 400.0)},
                   {"m", jumps ? border : 0.5 * border, 0.0, 0.0, 0.0, between(-200.0, 200.0)}};
    if (i % 3 == 1) beam.more = introduced(0.2, L - 0.2, std::round(between(0.0, 100.0)));
    beam.more += cycles(1e6, "f = 1, m = 1", "m = 1");
    Beam image = beam.mirrored();
    if (i % 3 == 1) image.more = beam.more;
    const Verification one = beam.verified(), other = image.verified();
    INFO(beam.text());
    CHECK(one.verdict == other.verdict);
    for (const Criterion criterion :
         {Criterion::patch_loading, Criterion::patch_fatigue, Criterion::weld}) {
      INFO(to_text(criterion));
      CHECK(use_of(one, criterion) == Approx(use_of(other, criterion)).epsilon(1e-3).margin(1e-4));
    }
    CHECK(says(one, "the kink of") == says(other, "the kink of"));
    ++alike;
    if (one.verdict == Verdict::not_applicable) ++stopped;
    if (use_of(one, Criterion::patch_loading) > 0.0) ++pressed;
  }
  CHECK(alike == 60);
  CHECK(stopped > 5);
  CHECK(pressed > 10);
}

TEST_CASE("a force is judged as the parts that stand at one place", "[patch]") {
  // 120 kN between the webs, 600 mm apart: F/pi bends the flange of 20 mm by 1.6 of its strength.
  const auto of = [](int parts) {
    Beam beam;
    beam.pieces = {{6.0, {600, 624, 20, 16, 0}, {600, 624, 20, 16, 0}}};
    beam.diaphragms = {0.0, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.space = true;
    for (int i = 0; i < parts; ++i)
      beam.forces.push_back({fmt::format("f{}", i), 3.0, 120.0 / parts});
    return beam.verified();
  };
  for (const int parts : {1, 2, 4}) {
    const Verification found = of(parts);
    CHECK(found.verdict == Verdict::not_applicable);
    CHECK(stops(found, "mm beside the webs bends it across"));
  }
}

TEST_CASE("what is required counts as the loads do", "[patch]") {
  const auto of = [](double required, double kN) {
    Beam beam;
    beam.pieces = {{6.0, {600, 624, 20, 16, 0}, {600, 624, 20, 16, 0}}};
    beam.diaphragms = {0.0, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.space = true;
    beam.required = required;
    beam.forces = {{"f", 3.0, kN}};
    return beam.verified();
  };
  CHECK(of(1.0, 40.0).verdict == Verdict::pass);
  CHECK(of(1.0, 90.0).verdict == Verdict::not_applicable);
  CHECK(of(2.25, 40.0).verdict == Verdict::not_applicable);
}

TEST_CASE("a force straight above a support passes through the web", "[patch]") {
  // Nothing of it is cut anywhere. Type b by hand: k_F = 3.5, F_Rd = 1082 kN of a web.
  Beam beam;
  beam.pieces = {{8.0, {300, 480, 40, 12, 0}, {300, 480, 40, 12, 0}}};
  beam.diaphragms = {0.0, 8.0};
  beam.supports = {{0.0, 0.0}, {4.0, 0.0}, {8.0, 0.0}};
  beam.forces = {{"f", 4.0, 3000.0}, {"g", 2.0, 5.0}};
  CHECK(beam.verified().verdict == Verdict::not_applicable);
  beam.forces[0].down = 300.0;
  CHECK(beam.verified().verdict == Verdict::pass);
}

TEST_CASE("a curve of many kinks is judged as one", "[patch]") {
  // 0.36 altogether within 0.9 m; flanges of 16 mm, 600 wide: 1.5 to 2 f_y by p b^2/8, p = sigma
  // t/R.
  for (const int parts : {1, 2, 4, 10, 40}) {
    Beam beam;
    const auto sizes = [](double height) { return Sizes{600, height, 16, 16, 0}; };
    beam.pieces.push_back({2.0, sizes(900.0), sizes(900.0)});
    // Slopes grow evenly from kink to kink.
    const double length = 0.9 / parts;
    double height = 900.0;
    for (int k = 1; k <= parts; ++k) {
      const double next = height - 2e3 * length * 0.36 * (k - 0.5) / parts;
      beam.pieces.push_back({length, sizes(height), sizes(next)});
      height = next;
    }
    beam.pieces.push_back({0.5, sizes(height), sizes(height - 2e3 * 0.5 * 0.36)});
    const double L = beam.length();
    beam.diaphragms = {0.0, L};
    beam.supports = {{0.0, 0.0}, {L, 0.0}};
    beam.forces = {{"m", 0.0, 0.0, 0.0, 0.0, 800.0}, {"n", L, 0.0, 0.0, 0.0, -800.0}};
    INFO(parts);
    CHECK(stops(beam.verified(), "the kink of"));
  }
}

TEST_CASE("kinks press webs without a shear force, and where others are introduced", "[patch]") {
  const auto of = [](const std::string& more) {
    Beam beam;
    beam.pieces = {{1.5, {600, 600, 25, 20, 0}, {600, 600, 25, 20, 0}},
                   {0.6, {600, 600, 25, 20, 0}, {600, 300, 25, 20, 0}},
                   {1.5, {600, 300, 25, 20, 0}, {600, 300, 25, 20, 0}}};
    beam.diaphragms = {0.0, 3.6};
    beam.supports = {{0.0, 0.0}, {3.6, 0.0}};
    beam.forces = {{"m", 0.0, 0.0, 0.0, 0.0, 750.0}, {"n", 3.6, 0.0, 0.0, 0.0, -750.0}};
    beam.more = more;
    return beam.verified();
  };
  CHECK(stops(of(""), "the kink of"));
  CHECK(stops(of(introduced(0.1, 3.5, 300.0)), "the kink of"));
  CHECK(stops(of("[[beam.load_introductions]]\nfrom = \"0.1 m\"\nto = \"3.5 m\"\ninto = "
                 "\"webs\"\n"),
              "the kink of"));
}

TEST_CASE("a force where a flange kinks is judged with the kink", "[patch]") {
  // Flanges 40, webs 6; over a stiff length of 60 mm one web bears F_Rd.
  const auto of = [](double kN, double kNm) {
    Beam beam;
    beam.pieces = {{1.0, {600, 624, 40, 6, 0}, {600, 624, 40, 6, 0}},
                   {2.0, {600, 624, 40, 6, 0}, {600, 1124, 40, 6, 0}}};
    beam.diaphragms = {0.0, 3.0};
    beam.supports = {{0.0, 0.0}, {3.0, 0.0}};
    beam.forces = {{"f", 1.0, kN}, {"m", 0.0, 0.0, 0.0, 0.0, kNm}, {"n", 3.0, 0.0, 0.0, 0.0, -kNm}};
    beam.more = introduced(0.9, 1.1, 60.0);
    return beam.verified();
  };
  const double alone = use_of(of(300.0, 1e-3), Criterion::patch_loading);
  REQUIRE(alone > 0.1);
  // N_f of 400 kN m, compressed above, turns off by 0.125 into the upper edge: downwards, too.
  const double N_f = 400.0 / 0.584, kink = N_f * 0.125;
  const double both = std::max(use_of(of(300.0, 400.0), Criterion::patch_loading),
                               use_of(of(300.0, -400.0), Criterion::patch_loading));
  CHECK(both > alone * (300.0 + 0.8 * kink) / 300.0);
}

TEST_CASE("webs that end beside the next ones have no verdict, but where a diaphragm leads them on",
          "[patch]") {
  // 188 kN of shear each, sqrt(3) of it above a tenth of 592 x 12 mm x 355 MPa.
  for (const bool space : {false, true}) {
    Beam beam;
    beam.pieces = {{2.0, {600, 624, 16, 12, 0}, {600, 624, 16, 12, 0}},
                   {2.0, {300, 624, 16, 12, 0}, {300, 624, 16, 12, 0}}};
    beam.diaphragms = {0.0, 4.0};
    beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
    beam.space = space;
    beam.forces = {{"f", 1.0, 1500.0}};
    beam.more = "[[beam.load_introductions]]\nstation = \"1 m\"\ninto = \"webs\"\n";
    CHECK(stops(beam.verified(), "web at s = 2 m: it ends where the next one lies 150 mm away"));
    beam.diaphragms.insert(beam.diaphragms.begin() + 1, 2.0);
    CHECK_FALSE(says(beam.verified(), "web at s = 2 m: it ends where"));
    beam.diaphragms.erase(beam.diaphragms.begin() + 1);
    beam.forces[0].down = 20.0;
    CHECK_FALSE(says(beam.verified(), "web at s = 2 m: it ends where"));
  }
}

TEST_CASE("webs that turn off under a normal force press the flanges, in the plane as in space",
          "[patch]") {
  for (const bool space : {false, true}) {
    Beam beam;
    beam.pieces = {{1.0, {900, 500, 16, 16, 0}, {900, 500, 16, 16, 0}},
                   {0.6, {900, 500, 16, 16, 0}, {400, 500, 16, 16, 0}},
                   {1.0, {400, 500, 16, 16, 0}, {400, 500, 16, 16, 0}}};
    beam.diaphragms = {0.0, 2.6};
    beam.supports = {{0.0, 0.0}, {2.6, 0.0}};
    beam.space = space;
    beam.more = space ? "[loads.n]\nkind = \"force\"\nat = [\"2.6 m\", \"0 m\", \"0 m\"]\nforce = "
                        "[\"-4500 kN\", \"0 kN\", \"0 kN\"]\n"
                      : "[loads.n]\nkind = \"force\"\nat = \"2.6 m\"\nforce = [\"-4500 kN\", \"0 "
                        "kN\"]\n";
    INFO(space);
    CHECK(stops(beam.verified(), "the kink of the left web"));
  }
}

TEST_CASE("a couple about the axis presses the webs as its two forces do", "[patch]") {
  const auto of = [](bool couple, double kNm) {
    Beam beam;
    beam.pieces = {{6.0, {600, 1000, 25, 10, 0}, {600, 1000, 25, 10, 0}}};
    beam.diaphragms = {0.0, 2.9, 3.1, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.space = true;
    if (couple)
      beam.forces = {{"f", 3.0, 0.0, 0.0, 0.0, 0.0, kNm}};
    else
      beam.forces = {{"f", 3.0, -kNm / 0.59, 0.295, 0.5}, {"g", 3.0, kNm / 0.59, -0.295, 0.5}};
    return beam.verified();
  };
  // 881 kN of each web, which bears some 767.
  for (const bool couple : {true, false}) {
    CHECK(of(couple, 520.0).verdict == Verdict::not_applicable);
    CHECK_FALSE(of(couple, 50.0).verdict == Verdict::not_applicable);
  }
  CHECK(stops(of(true, 520.0), "the torque of f"));
}

TEST_CASE("a thin diaphragm neither takes a force nor keeps it off the end", "[patch]") {
  // The flange under 300 kN between the webs; a plate that is too thin for them to stand on.
  const auto of = [](double thickness, double kN) {
    Beam beam;
    beam.pieces = {{6.0, {600, 624, 20, 16, 0}, {600, 624, 20, 16, 0}}};
    beam.diaphragms = {0.0, 3.0, 6.0};
    beam.thickness = thickness;
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.space = true;
    beam.forces = {{"f", 3.0, kN}};
    return beam.verified();
  };
  CHECK(stops(of(0.1, 300.0), "mm beside the webs bends it across"));
  CHECK(of(2.0, 300.0).verdict == Verdict::not_applicable);
  CHECK(of(20.0, 300.0).verdict == Verdict::pass);
  // 6 mm is stiff enough but bears less than 450 kN of shear as a plate.
  CHECK(stops(of(8.0, 2400.0), "uses its plate in shear"));
}

TEST_CASE("at every cycle kinks press webs, each flange its own edge", "[patch]") {
  const auto of = [](double web) {
    Beam beam;
    beam.pieces = {{2.0, {600, 600, 25, web, 0}, {600, 600, 25, web, 0}},
                   {0.8, {600, 600, 25, web, 0}, {600, 400, 25, web, 0}},
                   {2.0, {600, 400, 25, web, 0}, {600, 400, 25, web, 0}}};
    beam.diaphragms = {0.0, 4.8};
    beam.supports = {{0.0, 0.0}, {4.8, 0.0}};
    beam.forces = {{"m", 0.0, 0.0, 0.0, 0.0, 220.0}, {"n", 4.8, 0.0, 0.0, 0.0, -220.0}};
    beam.more = cycles(2e6, "m = 1, n = 1");
    return beam.verified();
  };
  // At 2.8 m: sigma of the flange's middle times 600 x 25 and the turn of 0.125, half into each web
  // over 2 t_f.
  const double web = 14.0, clear = 350.0;
  const double I = 2.0 * (600.0 * 25.0 * 187.5 * 187.5 + 600.0 * std::pow(25.0, 3) / 12.0) +
                   2.0 * web * std::pow(clear, 3) / 12.0;
  const double turned = 220e6 * 187.5 / I * 600.0 * 25.0 * 0.125;
  const double sigma = 0.5 * turned / (web * 50.0);
  const Verification found = of(web);
  const auto by_kink = [&](const CheckResult& result) {
    return result.check.criterion == Criterion::patch_fatigue &&
           result.check.point.find("the kink of") != std::string::npos;
  };
  const auto at = std::find_if(found.checks.begin(), found.checks.end(), by_kink);
  const bool listed = at != found.checks.end();
  if (listed)
    CHECK(at->check.acting.value() == Approx(sigma * 1e6).epsilon(1e-3));
  else
    CHECK(stops(found, "in fatigue (stiff length 0)"));
}

TEST_CASE("patch fatigue: of two loads as of one, and the weaker side of a border", "[patch]") {
  const auto beam_of = [](double before, double behind) {
    Beam beam;
    beam.pieces = {{3.0, {600, 900, 20, 12, before}, {600, 900, 20, 12, before}},
                   {3.0, {600, 900, 20, 12, behind}, {600, 900, 20, 12, behind}}};
    beam.diaphragms = {0.0, 6.0};
    beam.thickness = 12.0;
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    return beam;
  };
  // -100 and +100 kN, of one load or of two: 55.6 MPa each.
  Beam one = beam_of(20.0, 20.0), two = one;
  one.forces = {{"f", 3.0, 100.0}};
  one.more = introduced(0.0, 6.0, 50.0) + cycles(1e6, "f = 1", "f = -1");
  two.forces = {{"f", 3.0, 100.0}, {"g", 3.0, -100.0}};
  two.more = introduced(0.0, 6.0, 50.0) + cycles(1e6, "f = 1", "g = 1");
  const double as_one = use_of(one.verified(), Criterion::patch_fatigue);
  CHECK(as_one > 1.0);
  CHECK(use_of(two.verified(), Criterion::patch_fatigue) == Approx(as_one).epsilon(1e-9));
  // 50 kN over 8 x 90 mm of the thinner seam, 36/1.35 at 2e6: 33.6 at 1e6.
  const double range = 36.0 / 1.35 * std::cbrt(2.0);
  for (const bool first : {true, false}) {
    Beam other = first ? beam_of(8.0, 20.0) : beam_of(20.0, 8.0);
    other.forces = {{"f", 3.0, 100.0}};
    other.more = introduced(0.0, 6.0, 50.0) + cycles(1e6, "f = 1");
    CHECK(use_of(other.verified(), Criterion::patch_fatigue) ==
          Approx(50e3 / (8.0 * 90.0) / range).epsilon(1e-3));
  }
}

TEST_CASE("a seam of which nothing is said: as fillets it is said what they would be used by",
          "[patch]") {
  const auto of = [](double throat) {
    Beam beam;
    beam.pieces = {{6.0, {600, 900, 20, 12, throat}, {600, 900, 20, 12, throat}}};
    beam.diaphragms = {0.0, 6.0};
    beam.thickness = 12.0;
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.forces = {{"f", 3.0, 130.0}};
    beam.more = introduced(0.0, 6.0, 50.0) + cycles(1e6, "f = 1");
    return beam.verified();
  };
  const Verification unsaid = of(0.0), said = of(12.0);
  CHECK_FALSE(use_of(unsaid, Criterion::patch_fatigue) > 1.0);
  const double as_fillets = use_of(said, Criterion::patch_fatigue);
  CHECK(as_fillets > 1.0);
  CHECK(says(unsaid, fmt::format("used by {:.3g} in fatigue", as_fillets)));
}

TEST_CASE("a profile inside does not keep forces from pressing the webs", "[patch]") {
  const auto of = [](bool nested) {
    Beam beam;
    beam.pieces = {{6.0, {300, 400, 12, 8, 0.0}, {300, 400, 12, 8, 0.0}}};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.forces = {{"f", 3.0, 800.0}};
    std::string text = beam.text();
    if (nested) {
      for (std::size_t at; (at = text.find("= \"s00\"")) != std::string::npos;)
        text.replace(at, 7, "= \"n\"");
      for (std::size_t at; (at = text.find("= \"s01\"")) != std::string::npos;)
        text.replace(at, 7, "= \"n\"");
      text.insert(text.find("[beam]\n"),
                  "[sections.t]\nkind = \"rectangular tube\"\nwidth = \"60 mm\"\nheight = \"60 "
                  "mm\"\nwall = \"6 mm\"\n[sections.n]\nkind = \"nested\"\nouter = \"s00\"\ninner "
                  "= \"t\"\n");
    }
    return verify(parse_project("nested.toml", text));
  };
  CHECK(stops(of(false), "kN of \"f\""));
  CHECK(stops(of(true), "kN of \"f\""));
}

TEST_CASE("a force between the webs presses the edge of its diaphragm: by hand", "[patch]") {
  const auto of = [](const std::string& more) {
    Beam beam;
    beam.space = true;
    beam.pieces = {{6.0, {600, 600, 20, 12, 0.0}, {600, 600, 20, 12, 0.0}}};
    beam.diaphragms = {0.0, 3.0, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.forces = {{"f", 3.0, 600.0}};
    beam.more = more;
    return beam.verified();
  };
  // 600 kN on 16 mm x 2 x 20 mm: 937.5 MPa of 355.
  CHECK(says(of(""), fmt::format("presses it by {:.3g} of its strength", 937.5 / 355.0)));
  // Over 160 mm, 200 mm with the flange: 187.5 MPa.
  CHECK_FALSE(says(of(introduced(0.0, 6.0, 160.0)), "presses it by"));
}

TEST_CASE("the knee of two beams bends their flanges across", "[patch]") {
  const auto of = [](const std::string& diaphragms) {
    return verify_beams(parse_beams(
        "knee.toml",
        "[case]\nname = \"knee\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
        "m/s^2\"]\n[sections.a]\nkind = \"box\"\nwidth = \"300 mm\"\nheight = \"400 "
        "mm\"\nflange = \"12 mm\"\nweb = \"10 mm\"\n[[beam]]\nname = \"boom\"\nfrom = [\"0 m\", "
        "\"0 m\"]\nangle = \"60 deg\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"3 "
        "m\"\nsection = \"a\"\n" +
            diaphragms +
            "[[beam]]\nname = \"jib\"\nfrom = \"boom.end\"\nangle = \"0 deg\"\ndensity = \"7850 "
            "kg/m^3\"\n[[beam.segments]]\nlength = \"3 m\"\nsection = \"a\"\n" +
            (diaphragms.empty() ? ""
                                : "[[beam.diaphragms]]\nstation = \"0 m\"\nthickness = \"20 "
                                  "mm\"\n") +
            "[supports.root]\nkind = \"fixed\"\nat = \"boom.start\"\n[joints.knee]\nkind = "
            "\"rigid\"\nconnect = [\"boom.end\", \"jib.start\"]\n[loads.f]\nkind = \"force\"\nat = "
            "\"jib.end\"\nforce = [\"0 kN\", \"-90 kN\"]\n[material]\nsteel = "
            "\"S355\"\n[strength]\nrequired = 1.0\n"));
  };
  int stopped = 0;
  for (const VerifiedBeam& beam : of(""))
    stopped += stops(beam.verification, "the knee at knee of the top flange") ? 1 : 0;
  CHECK(stopped == 2);
  for (const VerifiedBeam& beam :
       of("[[beam.diaphragms]]\nstation = \"3 m\"\nthickness = \"20 mm\"\n"))
    CHECK_FALSE(says(beam.verification, "the knee at"));
}

}  // namespace pressed_mirrors_test
