// The seams by which forces come into the webs of boxes, against hand values and against all
// instants and places looked at one by one.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/report/remarks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/gates.hpp"

namespace patched_seams_test {

using namespace boxbeam;

namespace {

/// A stout box: nothing of it buckles.
struct StoutBox {
  double width = 300.0, height = 400.0, top = 12.0, bottom = 12.0, web = 10.0, throat = 6.0;

  std::string text() const {
    return fmt::format(
        "[sections.c]\nkind = \"box\"\nwidth = \"{} mm\"\nheight = \"{} mm\"\ntop_flange = \"{} "
        "mm\"\nbottom_flange = \"{} mm\"\nweb = \"{} mm\"\n{}",
        width, height, top, bottom, web,
        throat > 0.0 ? fmt::format("seam_throat = \"{:.12g} mm\"\n", throat) : "");
  }
};

std::string introduction(const std::string& where, double stiff_length) {
  return fmt::format("[[beam.load_introductions]]\n{}\nstiff_length = \"{} mm\"\n", where,
                     stiff_length);
}

std::string place(double at) { return fmt::format("station = \"{} m\"", at); }

std::string force(const std::string& name, double at, double kN) {
  return fmt::format("[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 kN\", \"{} kN\"]\n",
                     name, at, kN);
}

/// A weightless beam of 9 m on two supports.
std::string beam(const StoutBox& box, const std::string& more, const std::string& loads) {
  return "[case]\nname = \"seams\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         box.text() +
         "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"9 m\"\n"
         "section = \"c\"\n" +
         more +
         "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
         "[supports.right]\nkind = \"roller\"\nat = \"9 m\"\n" +
         loads +
         "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n"
         "[strength]\nrequired = 1.0\n";
}

Verification verified(const std::string& text) { return verify(parse_project("seams.toml", text)); }

const CheckResult* seam_at(const Verification& of, const std::string& under) {
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == Criterion::weld && result.patch &&
        result.check.point.ends_with(" under " + under))
      return &result;
  }
  return nullptr;
}

/// EN 1993-1-8, 4.5.3.2: S355 by EN 1993-1-1, f_u = 490 MPa, beta_w = 0.9, gamma_M2 = 1.25.
double use_of(double sigma_w, double tau) {
  const double perp = sigma_w / std::sqrt(2.0);
  const double f_u = 490e6;
  return std::max(std::sqrt(perp * perp + 3.0 * (perp * perp + tau * tau)) / (f_u / (0.9 * 1.25)),
                  perp / (0.9 * f_u / 1.25));
}

/// S/I over both throats, of a box with flanges alike [1/m^2].
double shear_per_force(const StoutBox& box) {
  const double b = 1e-3 * box.width, h = 1e-3 * box.height, t = 1e-3 * box.top, w = 1e-3 * box.web;
  const double clear = h - 2.0 * t, arm = 0.5 * (h - t);
  const double I = 2.0 * b * t * (arm * arm + t * t / 12.0) + 2.0 * w * std::pow(clear, 3) / 12.0;
  return b * t * arm / I / (2.0 * 1e-3 * box.throat);
}

}  // namespace

TEST_CASE("a force goes through the seams: by hand over s_s + 2 t_f, with the shear flow",
          "[patch]") {
  // Each web takes 50 kN, over 50 + 24 = 74 mm of two seams' 6 mm: 112.6 MPa; V = 50 kN on either
  // side: 8.09 MPa along.
  const Verification of =
      verified(beam({}, introduction(place(4.5), 50.0), force("hook", 4.5, -100.0)));
  const CheckResult* const hook = seam_at(of, "hook");
  REQUIRE(hook != nullptr);
  CHECK(hook->check.id == "weld/4.5/seam-of-web-and-top-flange-under-hook");
  const double sigma_w = 50e3 / (0.074 * 0.006), tau = 50e3 * shear_per_force({});
  CHECK(sigma_w == Approx(112.6e6).epsilon(1e-3));
  CHECK(tau == Approx(8.09e6).epsilon(1e-3));
  CHECK(hook->check.utilisation() == Approx(use_of(sigma_w, tau)).epsilon(1e-9));
  CHECK(hook->check.acting.value() ==
        Approx(std::sqrt(2.0 * sigma_w * sigma_w + 3.0 * tau * tau)).epsilon(1e-9));
  // Beside it the web itself, as without seams, and the seams far from forces by the flow alone.
  CHECK(std::any_of(of.checks.begin(), of.checks.end(), [](const CheckResult& result) {
    return result.check.criterion == Criterion::patch_loading;
  }));
  CHECK(std::any_of(of.checks.begin(), of.checks.end(), [](const CheckResult& result) {
    return result.check.criterion == Criterion::weld && !result.patch;
  }));
}

TEST_CASE("what of a force no fillet leads on is not judged in seams", "[patch]") {
  const std::string hook = force("hook", 4.5, -100.0);
  StoutBox full;
  full.throat = 0.0;
  CHECK(seam_at(verified(beam(full, introduction(place(4.5), 50.0), hook)), "hook") == nullptr);
  CHECK(seam_at(verified(beam({},
                              introduction(place(4.5), 50.0) +
                                  "[[beam.diaphragms]]\nstation = \"4.5 m\"\nthickness = \"10 "
                                  "mm\"\n",
                              hook)),
                "hook") == nullptr);  // of the diaphragm it is not said how it is welded
  const std::string into_webs =
      "[[beam.load_introductions]]\nstation = \"4.5 m\"\ninto = \"webs\"\n";
  CHECK(seam_at(verified(beam({}, into_webs, hook)), "hook") == nullptr);
}

TEST_CASE("a thin throat under a force fails, and the one named suffices, just", "[patch]") {
  StoutBox box;
  box.throat = 4.0;
  const auto under = [&](double throat) {
    StoutBox other = box;
    other.throat = throat;
    return verified(beam(other, introduction(place(4.5), 50.0), force("hook", 4.5, -250.0)));
  };
  const Verification of = under(4.0);
  CHECK(of.verdict == Verdict::fail);
  const CheckResult* const hook = seam_at(of, "hook");
  REQUIRE(hook != nullptr);
  CHECK_FALSE(hook->check.passes());
  REQUIRE(hook->sufficient_throat);
  const double enough = 1e3 * hook->sufficient_throat->value();
  CHECK(seam_at(under(enough), "hook")->check.utilisation() == Approx(1.0).epsilon(1e-9));
  // What would pass is a thicker throat, in half millimetres.
  const auto into_webs = [](double at) {
    return "[[beam.load_introductions]]\n" + place(at) + "\ninto = \"webs\"\n";
  };
  const Project project = parse_project(
      "seams.toml", beam(box, introduction(place(4.5), 50.0) + into_webs(0.0) + into_webs(9.0),
                         force("hook", 4.5, -250.0)));
  const Verification advised = verify(project, Figures::without, Advice::with);
  REQUIRE(advised.checks.front().patch);
  REQUIRE(advised.remedies.found.size() == 1);
  CHECK(advised.remedies.found.front().what == Remedy::What::throat);
  CHECK(1e3 * advised.remedies.found.front().value == Approx(0.5 * std::ceil(2.0 * enough)));
}

TEST_CASE("a force may pull: the thinner flange spreads it less, wherever it acts", "[patch]") {
  StoutBox box;
  box.bottom = 8.0;
  for (const double kN : {-100.0, 100.0}) {
    const Verification of =
        verified(beam(box, introduction(place(4.5), 50.0), force("hook", 4.5, kN)));
    const CheckResult* const hook = seam_at(of, "hook");
    REQUIRE(hook != nullptr);
    CHECK(hook->check.point == "seam of web and bottom flange under hook");
    const auto& seam = std::get<PatchedSeam>(hook->patch->bears);
    CHECK(seam.loaded.value() == Approx(0.066));
  }
}

TEST_CASE("at the end of the beam there is half of the seam to spread over", "[patch]") {
  const Verification of =
      verified(beam({}, introduction(place(0.0), 50.0) + introduction(place(4.5), 50.0),
                    force("hook", 4.5, -100.0)));
  const CheckResult* const left = seam_at(of, "left");
  REQUIRE(left != nullptr);
  CHECK(std::get<PatchedSeam>(left->patch->bears).loaded.value() == Approx(0.037));
}

TEST_CASE("an eccentric force: its lever between the webs, and the flow of its torque", "[patch]") {
  // 100 mm beside the axis of a cantilever; webs' middles 290 mm apart, Bredt's area 290 x 388 mm.
  const StoutBox box;
  const Verification of = verified(
      "[case]\nname = \"seams\"\nkind = \"static\"\n[frame]\nspace = true\ngravity = [\"0 m/s^2\", "
      "\"0 m/s^2\", \"0 m/s^2\"]\n" +
      box.text() +
      "[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"x\"\nz = "
      "\"z\"\npoints = { hook = [\"3 m\", \"0.1 m\", \"0 m\"] }\n[[beam.segments]]\nlength = \"6 "
      "m\"\nsection = \"c\"\n" +
      introduction(place(3.0), 50.0) +
      "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.hook]\nkind = \"force\"\nat = "
      "\"beam.hook\"\nforce = [\"0 N\", \"0 N\", \"-100 kN\"]\n[material]\nsteel = \"S355\"\n"
      "fy_source = \"EN 1993-1-1\"\n[strength]\nrequired = 1.0\n");
  const CheckResult* const hook = seam_at(of, "hook");
  REQUIRE(hook != nullptr);
  CHECK(hook->check.point == "seam of left web and top flange under hook");
  CHECK(hook->patch->share == Approx(245.0 / 290.0));
  const double sigma_w = 245.0 / 290.0 * 100e3 / (0.074 * 0.006);
  // Of the torque the walls carry 0.3 % themselves, after Saint-Venant; the flow of both is one.
  const double tau = 100e3 * shear_per_force(box) + 100e3 * 0.1 / (2.0 * 0.290 * 0.388 * 0.006);
  CHECK(hook->check.utilisation() == Approx(use_of(sigma_w, tau)).epsilon(1e-4));
}

TEST_CASE("wheels: no instant and place of a seam is worse than what is reported", "[patch]") {
  std::mt19937 engine(11);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int i = 0; i < 8; ++i) {
    // Half of them so close that what they load of the seam meets.
    const double stiff = in(40.0, 200.0), P = in(50.0, 150.0), Q = in(50.0, 150.0);
    const double behind = i % 2 == 0 ? 1e-3 * in(0.1, 1.2) * stiff : in(0.4, 2.5);
    const StoutBox box{in(280.0, 320.0), in(360.0, 400.0), 12.0, 12.0, 10.0, in(4.0, 8.0)};
    const std::string wheels = fmt::format(
        "[loads.crab]\nkind = \"wheels\"\nwheels = [{{ force = [\"0 kN\", \"{} kN\"] }}, {{ behind "
        "= \"{:.12g} m\", force = [\"0 kN\", \"{} kN\"] }}]\nfrom = \"{:.12g} m\"\nto = \"9 m\"\n"
        "speed = \"1 m/s\"\n",
        -P, behind, -Q, behind);
    const Verification of =
        verified(beam(box, introduction("from = \"0 m\"\nto = \"9 m\"", stiff), wheels));
    double reported = 0.0;
    for (const CheckResult& result : of.checks) {
      if (result.patch && result.check.criterion == Criterion::weld &&
          result.check.point.find("crab") != std::string::npos)
        reported = std::max(reported, result.check.utilisation());
    }
    const double a = 1e-3 * box.throat, l = 1e-3 * stiff + 0.024;
    double most = 0.0;
    constexpr int instants = 2000, places = 41;
    for (int k = 0; k <= instants; ++k) {
      const double front = behind + (9.0 - behind) * k / instants, rear = front - behind;
      const double left = 1e3 * (P * (9.0 - front) + Q * (9.0 - rear)) / 9.0;
      // Half a wheel spread evenly over what there is of the seam, at places of it.
      const auto spread_at = [&](double wheel, double kN, double s) {
        const double from = std::max(0.0, wheel - 0.5 * l), to = std::min(9.0, wheel + 0.5 * l);
        return s >= from && s <= to ? 0.5e3 * kN / ((to - from) * a) : 0.0;
      };
      for (const double wheel : {front, rear}) {
        const double from = std::max(0.0, wheel - 0.5 * l), to = std::min(9.0, wheel + 0.5 * l);
        // The beam's own shear is that beside the wheel, before or behind it.
        const bool other_is_before = wheel == front && behind > 0.0;
        const double before = left - (other_is_before ? 1e3 * Q : 0.0);
        const double V =
            std::max(std::abs(before), std::abs(before - 1e3 * (wheel == front ? P : Q)));
        for (int p = 0; p < places; ++p) {
          const double s = from + (to - from) * p / (places - 1);
          const double sigma_w = spread_at(front, P, s) + spread_at(rear, Q, s);
          most = std::max(most, use_of(sigma_w, V * shear_per_force(box)));
        }
      }
    }
    CAPTURE(i, stiff, behind, P, Q);
    CHECK(most > 0.05);
    CHECK(most <= reported * (1.0 + 1e-6));
    CHECK(reported <= most * (1.0 + 2e-3));
  }
}

TEST_CASE("twice the forces, twice the use of a seam", "[patch]") {
  const auto use = [](double kN) {
    return seam_at(verified(beam({}, introduction(place(4.5), 50.0), force("hook", 4.5, kN))),
                   "hook")
        ->check.utilisation();
  };
  CHECK(use(-100.0) == Approx(2.0 * use(-50.0)).epsilon(1e-12));
}

TEST_CASE("the sheet of a seam under a force ends with its factor", "[patch]") {
  const std::string more = "[[situations]]\nname = \"all\"\nloads = { hook = 1.0, jack = 0.5 }\n";
  for (const double load_factor : {1.0, 1.35}) {
    Project project =
        parse_project("seams.toml", beam({}, introduction("from = \"0 m\"\nto = \"9 m\"", 50.0),
                                         force("hook", 4.5, -100.0) + force("jack", 4.55, -50.0)) +
                                        more);
    project.situations.front().load_factor = load_factor;
    const Verification of = verify(project);
    int sheets = 0;
    for (const CheckResult& result : of.checks) {
      if (!result.patch || result.check.criterion != Criterion::weld) continue;
      test::sheet_to_factor(project, of, result);
      ++sheets;
    }
    CHECK(sheets == 4);
    // The jack stands within the hook's 74 mm, and the other way round.
    CHECK(std::get<PatchedSeam>(seam_at(of, "hook")->patch->bears).beside.value() ==
          Approx(12.5e3 / (0.074 * 0.006)));
  }
}

TEST_CASE("where nothing is said of how forces come in, they stand on an edge", "[patch]") {
  // Those of stout webs that bear more than three tenths are listed.
  const Verification stout = verified(beam({}, "", force("hook", 4.5, -50.0)));
  REQUIRE(seam_at(stout, "hook") != nullptr);
  CHECK(std::get<PatchedSeam>(seam_at(stout, "hook")->patch->bears).loaded.value() ==
        Approx(0.024));
  StoutBox slender{600.0, 1224.0, 12.0, 12.0, 8.0, 3.0};
  const Verification of = verified(beam(slender, "", force("hook", 4.5, -200.0)));
  CHECK(of.verdict == Verdict::not_applicable);
  CHECK(test::blocks(of, "\"hook\" and its seam bears"));
}

/// With its welds as thick as said, or not said.
std::string diaphragm(double at, double throat, double opening = 0.0) {
  return fmt::format("[[beam.diaphragms]]\nstation = \"{} m\"\nthickness = \"10 mm\"\n", at) +
         (throat > 0.0 ? fmt::format("throat = \"{:.12g} mm\"\n", throat) : "") +
         (opening > 0.0 ? fmt::format("opening = \"{} mm\"\n", opening) : "");
}

TEST_CASE("the welds of a diaphragm bear all of a force, with the flange and along the web",
          "[patch]") {
  // Each web takes 50 kN; 376 mm of web and 140 mm of flange beside it, welds on both faces.
  const auto under = [](double throat, double opening, double kN = 100.0) {
    return verified(beam({}, diaphragm(4.5, throat, opening), force("hook", 4.5, -kN)));
  };
  const auto flange_use = [](double a, double width, double kN) {
    return use_of(0.5e3 * kN / (2e-6 * a * (width - 2.0 * a)), 0.0);
  };
  const auto web_use = [](double a, double kN) {
    return use_of(0.0, 0.5e3 * kN / (2e-6 * a * (376.0 - 2.0 * a)));
  };
  for (const double a : {3.0, 5.0}) {
    const Verification of = under(a, 0.0);
    const CheckResult* const hook = seam_at(of, "hook");
    REQUIRE(hook != nullptr);
    CHECK(hook->check.point == "weld of flange and diaphragm beside web under hook");
    CHECK(hook->check.utilisation() == Approx(flange_use(a, 140.0, 100.0)).epsilon(1e-9));
    CHECK(hook->check.utilisation() > web_use(a, 100.0));
  }
  // What is left beside an access hole.
  const Verification opened = under(3.0, 180.0);
  REQUIRE(seam_at(opened, "hook") != nullptr);
  CHECK(seam_at(opened, "hook")->check.utilisation() ==
        Approx(flange_use(3.0, 50.0, 100.0)).epsilon(1e-9));
  // The throat named is the one, and what would pass is that much, in half millimetres.
  const Verification thin = under(3.0, 0.0, 700.0);
  const CheckResult* const weld = seam_at(thin, "hook");
  REQUIRE(weld != nullptr);
  CHECK_FALSE(weld->check.passes());
  REQUIRE(weld->sufficient_throat);
  const double enough = 1e3 * weld->sufficient_throat->value();
  CHECK(enough > 3.0);
  CHECK(flange_use(enough, 140.0, 700.0) == Approx(1.0).epsilon(1e-9));
  CHECK(seam_at(under(enough, 0.0, 700.0), "hook")->check.utilisation() ==
        Approx(1.0).epsilon(1e-9));
}

TEST_CASE("what the welds of diaphragms need is said where the case does not say what they are",
          "[patch]") {
  const auto of = [](const std::string& diaphragms, double kN) {
    return beam({}, diaphragms, force("hook", 4.5, -kN));
  };
  // 700 kN: the smaller root of 2 a (140 - 2 a) f = F/2, f = 490/(sqrt(2) 0.9 1.25) MPa.
  const double f = 490.0 / (std::sqrt(2.0) * 0.9 * 1.25);
  const double a = (140.0 - std::sqrt(140.0 * 140.0 - 4.0 * 350e3 / f)) / 4.0;
  const std::string text = of(diaphragm(4.5, 0.0), 700.0);
  const Verification unsaid = verified(text);
  CHECK(seam_at(unsaid, "hook") == nullptr);
  REQUIRE(unsaid.unsaid_welds);
  CHECK(1e3 * unsaid.unsaid_welds->throat->value() == Approx(a).epsilon(1e-9));
  const std::vector<Remark> remarks = remarks_of(parse_project("seams.toml", text), unsaid);
  const std::string words =
      fmt::format("throats of {:g} mm on both their faces", 0.5 * std::ceil(a / 0.5));
  CHECK(std::any_of(remarks.begin(), remarks.end(), [&](const Remark& remark) {
    return remark.text.find(words) != std::string::npos;
  }));
  // No weld of any thickness: of 50 mm of flange welds of 12.5 mm bear most, 192 kN.
  const Verification none = verified(of(diaphragm(4.5, 0.0, 180.0), 700.0));
  REQUIRE(none.unsaid_welds);
  CHECK_FALSE(none.unsaid_welds->throat);
  CHECK(std::any_of(none.not_judged.begin(), none.not_judged.end(), [](const NotJudged& note) {
    return note.what == "welds of the diaphragm at s = 4.5 m";
  }));
  // Said at one of them it is not asked for there.
  CHECK_FALSE(verified(of(diaphragm(4.5, 4.0), 100.0)).unsaid_welds);
}

}  // namespace patched_seams_test
