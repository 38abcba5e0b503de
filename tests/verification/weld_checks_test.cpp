// Welds between parts of a beam against hand calculation: a cantilever under a pulsating force.

#include "boxbeam/verification/weld_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/table_cantilever.hpp"

namespace weld_checks_test {

using namespace boxbeam;

namespace {

constexpr double a = 0.006;

Project read(const std::string& weld) {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  return parse_project((folder.path() / "case.toml").string(),
                       table_cantilever::text("periodic = true", "[[welds]]\n" + weld));
}

const std::string around_the_box =
    "name = \"splice\"\nstation = \"0.5 m\"\naround = \"box\"\nthroat = \"6 mm\"\n";

const Check& check_of(const Verification& verification, Criterion criterion) {
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion == criterion && result.check.point.starts_with("weld ")) {
      return result.check;
    }
  }
  FAIL("there is no such check");
  return verification.checks.front().check;
}

}  // namespace

TEST_CASE("a weld around a box: throat and root by the weld's line") {
  const Verification verification = verify(read(around_the_box));
  // M = 20 kN 0.5 m and V = 20 kN in a line of 6 mm along the outline 100 x 200 mm, which is a tube
  // of 106 x 206 mm outside; at the root z = 100 mm.
  const double M = 10e3, V = 20e3, b = 0.1, h = 0.2;
  const double I = ((b + a) * std::pow(h + a, 3) - (b - a) * std::pow(h - a, 3)) / 12.0;
  const double sigma = M * 0.5 * h / I;
  const Check& root = check_of(verification, Criterion::fatigue);
  CHECK(root.acting.value() == Approx(sigma).epsilon(2e-3));
  // Row 8.5/3: 36 at 2e6 cycles, not raised.
  CHECK(root.safety_factor == Approx(36e6 / sigma).epsilon(2e-3));
  CHECK(root.station.s.value() == 0.5);
  // tau at mid-height by V S/(2 I a), S = b a h/2 + 2 a (h/2)^2/2 on thin lines.
  const double I_thin = 2.0 * b * a * 0.25 * h * h + 2.0 * a * h * h * h / 12.0;
  const auto tau = [&](double z) {
    const double S = b * a * 0.5 * h + a * (0.25 * h * h - z * z);
    return V * S / (2.0 * I_thin * a);
  };
  const Check& shear = check_of(verification, Criterion::shear_fatigue);
  CHECK(shear.safety_factor == Approx(80e6 / tau(0.0)).epsilon(0.02));
  // Both together where (sigma/36)^3 + (tau/80)^5 is largest.
  const auto damage = [&](double k) {
    double most = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      const double z = 0.5 * h * i / 1000;
      most = std::max(
          most, std::pow(k * sigma * z / (0.5 * h) / 36e6, 3) + std::pow(k * tau(z) / 80e6, 5));
    }
    return most;
  };
  const Check& both = check_of(verification, Criterion::combined_fatigue);
  CHECK(damage(both.safety_factor) == Approx(1.0).epsilon(0.03));
  // Static: the worst of sqrt(2 sigma^2 + 3 tau^2) over the web line, f_u = 470 MPa (10 mm plates),
  // beta_w = 0.9, gamma_M2 = 1.25.
  double most = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double z = 0.5 * h * i / 1000;
    most =
        std::max(most, std::hypot(std::sqrt(2.0) * sigma * z / (0.5 * h), std::sqrt(3.0) * tau(z)));
  }
  const Check& throat = check_of(verification, Criterion::weld);
  CHECK(throat.safety_factor == Approx(470e6 / (0.9 * 1.25) / most).epsilon(0.02));
}

TEST_CASE("twice the throat, half the stress of a thin weld") {
  const double thin = check_of(verify(read(around_the_box)), Criterion::fatigue).safety_factor;
  std::string thick_weld = around_the_box;
  thick_weld.replace(thick_weld.find("6 mm"), 4, "3 mm");
  const double thinner = check_of(verify(read(thick_weld)), Criterion::fatigue).safety_factor;
  // I of the lines differs from 2 : 1 by terms of a^2/h^2, below 0.1 %.
  CHECK(thin / thinner == Approx(2.0).epsilon(2e-3));
}

TEST_CASE("what a weld cannot go around, and where it cannot be, is refused", "[bad_input]") {
  CHECK_THROWS_AS(read("name = \"w\"\nstation = \"2 m\"\naround = \"box\"\nthroat = \"6 mm\"\n"),
                  InputError);
  CHECK_THROWS_AS(read("name = \"w\"\nstation = \"0.5 m\"\naround = \"bar\"\nthroat = \"6 mm\"\n"),
                  InputError);
  CHECK_THROWS_AS(read(around_the_box + "[[welds]]\n" + around_the_box), InputError);
}

TEST_CASE("a weld has a throat, or penetrates fully, and not through its wall", "[bad_input]") {
  const auto refused = [](const std::string& more, const std::string& message) {
    try {
      read("name = \"w\"\nstation = \"0.5 m\"\naround = \"box\"\n" + more);
      FAIL("taken: " << more);
    } catch (const InputError& error) {
      REQUIRE(error.problems().size() == 1);
      CHECK(error.problems().front().message.find(message) != std::string::npos);
      CHECK_FALSE(error.problems().front().hint.empty());
    }
  };
  refused("", "the weld has no throat");
  refused("penetration = \"2 mm\"\n", "the weld has no throat");
  refused("throat = \"6 mm\"\npenetration = \"full\"\n", "has no throat of its own");
  refused("throat = \"6 mm\"\npenetration = \"10 mm\"\n", "through the wall");
  refused("throat = \"6 mm\"\npenetration = \"half\"\n", "penetration");
  refused("throat = \"6 mm\"\nattachment_length = 80\n", "attachment_length");
}

TEST_CASE("a throat that fills the profile it goes around is refused", "[bad_input]") {
  // The box is 100 mm wide: beyond, the throat's ring has no hollow.
  const auto with_throat = [](const std::string& throat) {
    std::string weld = around_the_box;
    return weld.replace(weld.find("6 mm"), 4, throat);
  };
  CHECK_THROWS_AS(read(with_throat("100 mm")), InputError);
  CHECK_THROWS_AS(read(with_throat("20 m")), InputError);
  CHECK_FALSE(verify(read(with_throat("99 mm"))).checks.empty());
}

namespace {

const CheckResult* find(const Verification& verification, Criterion criterion,
                        const std::string& begin) {
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion == criterion && result.check.point.starts_with(begin))
      return &result;
  }
  return nullptr;
}

/// The largest utilisation of throat and root.
double use_of_line(const Verification& verification) {
  double most = 0.0;
  for (const CheckResult& result : verification.checks) {
    if (result.check.point.starts_with("weld ")) most = std::max(most, result.check.utilisation());
  }
  return most;
}

double sufficient_throat_in(const Verification& verification) {
  const CheckResult* root = find(verification, Criterion::fatigue, "weld ");
  REQUIRE(root != nullptr);
  REQUIRE(root->sufficient_throat);
  for (const CheckResult& result : verification.checks) {
    if (result.check.point.starts_with("weld "))
      CHECK(result.sufficient_throat == root->sufficient_throat);
  }
  return root->sufficient_throat->value();
}

std::string with_throat(const std::string& throat, const std::string& more = {}) {
  std::string weld = around_the_box + more;
  return weld.replace(weld.find("6 mm"), 4, throat);
}

}  // namespace

TEST_CASE("the throat that is said to suffice does: the weld is used up with it") {
  for (const std::string more :
       {"", "penetration = \"3 mm\"\n", "required = 9.0\n", "required = 30.0\n"}) {
    double known = 0.0;
    for (const std::string throat : {"3.5 mm", "6 mm", "20 mm", "60 mm"}) {
      CAPTURE(more, throat);
      Project project = read(with_throat(throat, more));
      const double sufficient = sufficient_throat_in(verify(project));
      // From wherever it is looked for.
      if (known != 0.0) CHECK(sufficient == Approx(known).epsilon(1e-8));
      known = sufficient;
      REQUIRE(sufficient > 3e-3);
      project.welds.front().throat = si<Length>(sufficient);
      CHECK(use_of_line(verify(project)) == Approx(1.0).epsilon(1e-6));
      // More is used less.
      project.welds.front().throat = si<Length>(1.02 * sufficient);
      CHECK(use_of_line(verify(project)) < 1.0);
      project.welds.front().throat = si<Length>(0.98 * sufficient);
      CHECK(use_of_line(verify(project)) > 1.0);
    }
  }
}

TEST_CASE("no throat is said to suffice below 3 mm, nor where the thickest one does not") {
  // EN 1993-1-8, 4.5.2(2).
  std::string little = around_the_box;
  little.replace(little.find("0.5 m"), 5, "0.98 m");
  const Verification slight = verify(read(little));
  REQUIRE(use_of_line(slight) < 0.5);
  CHECK(sufficient_throat_in(slight) == 3e-3);
  const Verification hopeless = verify(read(around_the_box + "required = 1000.0\n"));
  const CheckResult* throat = find(hopeless, Criterion::weld, "weld ");
  REQUIRE(throat != nullptr);
  CHECK_FALSE(throat->check.passes());
  CHECK_FALSE(throat->sufficient_throat);
}

TEST_CASE("what penetrates beyond the throat counts, around a root as deep below the outline") {
  const Verification verification = verify(read(with_throat("4 mm", "penetration = \"2 mm\"\n")));
  // A line of 6 mm along 96 x 196 mm, its root at 98 mm.
  const double M = 10e3, b = 0.096, h = 0.196;
  const double I = ((b + a) * std::pow(h + a, 3) - (b - a) * std::pow(h - a, 3)) / 12.0;
  const CheckResult* root = find(verification, Criterion::fatigue, "weld ");
  REQUIRE(root != nullptr);
  CHECK(root->check.acting.value() == Approx(M * 0.5 * h / I).epsilon(1e-9));
}

TEST_CASE("a weld that penetrates fully is judged by its profile, and has no root") {
  const Verification verification = verify(
      read("name = \"splice\"\nstation = \"0.5 m\"\naround = \"box\"\npenetration = \"full\"\n"
           "attachment_length = \"40 mm\"\nrequired = 1.5\n"));
  CHECK(use_of_line(verification) == 0.0);
  const double sigma = 10e3 / table_cantilever::W;
  const CheckResult* toe = find(verification, Criterion::fatigue, "toe of weld splice");
  REQUIRE(toe != nullptr);
  CHECK(toe->check.acting.value() == Approx(sigma).epsilon(1e-9));
  CHECK(toe->check.safety_factor == Approx(80e6 / sigma).epsilon(1e-6));
  CHECK_FALSE(toe->sufficient_throat);
  // The fibre, or where shear adds more: at the end of a web, at z = 90 mm, not above.
  const CheckResult* strength = find(verification, Criterion::yield, "toe of weld splice");
  REQUIRE(strength != nullptr);
  CHECK(strength->check.safety_factor <= 355e6 / sigma * (1.0 + 1e-9));
  CHECK(strength->check.safety_factor > 0.85 * 355e6 / sigma);
  CHECK(strength->check.required == 1.5);
}

TEST_CASE("the toe has the line of its length in its plate, the weakest where that is not said") {
  const double sigma = 10e3 / table_cantilever::W;
  const auto factor = [&](const std::string& more) {
    const Verification verification = verify(read(around_the_box + more));
    // Toe and root side by side: both are there.
    CHECK(find(verification, Criterion::fatigue, "weld splice") != nullptr);
    const CheckResult* toe = find(verification, Criterion::fatigue, "toe of weld splice");
    REQUIRE(toe != nullptr);
    return toe->check.safety_factor;
  };
  // Table 8.5, row 1; walls of 10 mm.
  CHECK(factor("attachment_length = \"40 mm\"\n") == Approx(80e6 / sigma).epsilon(1e-6));
  CHECK(factor("attachment_length = \"60 mm\"\n") == Approx(71e6 / sigma).epsilon(1e-6));
  CHECK(factor("attachment_length = \"90 mm\"\n") == Approx(63e6 / sigma).epsilon(1e-6));
  CHECK(factor("attachment_length = \"900 mm\"\n") == Approx(56e6 / sigma).epsilon(1e-6));
  CHECK(factor("") == Approx(56e6 / sigma).epsilon(1e-6));
  CHECK(factor("stress_factor = 1.25\n") == Approx(56e6 / sigma / 1.25).epsilon(1e-6));
  // EN 1993-1-9, 8(1): the range of that stress against 1.5 f_y.
  const Verification ranges = verify(read(around_the_box + "stress_factor = 1.25\n"));
  const CheckResult* range = find(ranges, Criterion::stress_range, "toe of weld splice");
  REQUIRE(range != nullptr);
  CHECK(range->check.safety_factor == Approx(1.5 * 355e6 / (1.25 * sigma)).epsilon(1e-6));
}

TEST_CASE("thick walls have a weaker toe: each wall by its own thickness") {
  // Flanges of 25 mm, webs of 10 mm: 50 in the flanges, 56 in the webs, whose ends are stressed
  // less.
  std::string text = table_cantilever::text("periodic = true", "[[welds]]\n" + around_the_box);
  text.replace(text.find("flange = \"10 mm\""), 16, "flange = \"25 mm\"");
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  const Verification verification =
      verify(parse_project((folder.path() / "case.toml").string(), text));
  const CheckResult* toe = find(verification, Criterion::fatigue, "toe of weld splice");
  REQUIRE(toe != nullptr);
  const double I = (0.1 * std::pow(0.2, 3) - 0.08 * std::pow(0.15, 3)) / 12.0;
  CHECK(toe->check.safety_factor == Approx(50e6 / (10e3 * 0.1 / I)).epsilon(1e-6));
}

TEST_CASE("a weld whose forces change between situations at rest is searched as one that moves") {
  // The same range, from a history of one situation and from a change between two.
  const Verification moving = verify(read(around_the_box));
  const Verification resting = verify(parse_project(
      "case.toml",
      "[case]\nname = \"cantilever\"\nkind = \"static\"\n"
      "[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
      "[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
      "flange = \"10 mm\"\nweb = \"10 mm\"\n"
      "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"1 m\"\nsection = "
      "\"box\"\n[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n"
      "[loads.tip]\nkind = \"force\"\nat = \"1 m\"\nforce = [\"0 kN\", \"20 kN\"]\n"
      "[[situations]]\nname = \"empty\"\nloads = { tip = 0.0 }\n"
      "[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0 }\n"
      "[[situations]]\nname = \"lift\"\nbetween = [\"empty\", \"loaded\"]\ncycles = 2e6\n"
      "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n"
      "[fatigue]\ncategory = 71\nloading = \"spectrum\"\ngamma_Mf = 1.0\nrequired = 1.0\n"
      "[[welds]]\n" +
          around_the_box));
  for (const char* where : {"weld splice", "toe of weld splice"}) {
    for (const Criterion criterion : {Criterion::weld, Criterion::fatigue, Criterion::shear_fatigue,
                                      Criterion::combined_fatigue, Criterion::stress_range}) {
      const CheckResult* a_moving = find(moving, criterion, where);
      const CheckResult* at_rest = find(resting, criterion, where);
      CAPTURE(where, to_text(criterion));
      REQUIRE((a_moving == nullptr) == (at_rest == nullptr));
      if (a_moving == nullptr) continue;
      CHECK(at_rest->check.safety_factor == Approx(a_moving->check.safety_factor).epsilon(1e-6));
    }
  }
}

TEST_CASE("a throat below 3 mm, and a toe whose length nobody gave, are said") {
  const auto said = [](const std::string& throat, const std::string& more,
                       const std::string& what) {
    const Project project = read(with_throat(throat, more));
    const std::vector<Remark> remarks = remarks_of(project, verify(project));
    return std::any_of(remarks.begin(), remarks.end(), [&](const Remark& remark) {
      return remark.text.find(what) != std::string::npos;
    });
  };
  // EN 1993-1-8, 4.5.2(2).
  CHECK(said("2.9 mm", "", "below 3 mm"));
  CHECK_FALSE(said("3 mm", "", "below 3 mm"));
  const auto diaphragm = [](const std::string& throat) {
    return "[[beam.diaphragms]]\nstation = \"0 m\"\nthickness = \"8 mm\"\nthroat = \"" + throat +
           "\"\n";
  };
  const std::string of_diaphragm = "the weld of the diaphragm at s = 0 m has a throat of";
  CHECK(said("6 mm", diaphragm("2 mm"), of_diaphragm));
  CHECK_FALSE(said("6 mm", diaphragm("3 mm"), of_diaphragm));
  const std::string unknown = "to know: attachment_length";
  CHECK(said("6 mm", "", unknown));
  CHECK_FALSE(said("6 mm", "attachment_length = \"40 mm\"\n", unknown));
}

TEST_CASE("a weld bears what shear lag and buckling leave idle in the plates that it joins") {
  // Cantilever of length L under F at its tip, clamped where the weld stands. A box b wide and h
  // high, flanges t and webs w.
  const auto use_of = [](double width, double height, double flange, double web, double L, double F,
                         double throat, bool lag) {
    const Verification verification = verify(parse_project(
        "case.toml",
        fmt::format(
            "[case]\nname = \"clamped\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
            "m/s^2\"]\n[sections.box]\nkind = \"box\"\nwidth = \"{} mm\"\nheight = \"{} "
            "mm\"\nflange = \"{} mm\"\nweb = \"{} mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
            "[[beam.segments]]\nlength = \"{} m\"\nsection = \"box\"\n"
            "[supports.root]\nkind = \"fixed\"\nat = \"0 m\"\n"
            "[[welds]]\nname = \"w\"\nstation = \"0 m\"\naround = \"box\"\nthroat = \"{} mm\"\n"
            "[loads.f]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 kN\", \"-{} kN\"]\n"
            "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n"
            "[strength]\nrequired = 1.0\nshear_lag = {}\n",
            width, height, flange, web, L, throat, L, F, lag ? "true" : "false")));
    return check_of(verification, Criterion::weld).utilisation();
  };
  // Shear lag: 1000 x 400 x 20 x 16 on 2 m, L_e = 4 m, b_0 = 492 mm, kappa = 0.123, beta_2 =
  // 1/(1 + 6 (kappa - 1/(2500 kappa)) + 1.6 kappa^2); strips of 2 (1 - beta) b_0 idle in the
  // middle.
  const double kappa = 0.492 / 4.0;
  const double beta = 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
  const double I = (1.0 * std::pow(0.4, 3) - 0.968 * std::pow(0.36, 3)) / 12.0;
  const double idle = 2.0 * (1.0 - beta) * 0.492;
  const double I_idle = idle * (std::pow(0.4, 3) - std::pow(0.36, 3)) / 12.0;
  const double ratio =
      use_of(1000, 400, 20, 16, 2, 300, 8, true) / use_of(1000, 400, 20, 16, 2, 300, 8, false);
  // At the corner, where M governs; V shears the line of the web a little there.
  CHECK(ratio == Approx(I / (I - I_idle)).epsilon(0.02));
  // Buckling: 800 x 800 x 10 x 10, class 4. The weld by itself is used by 0.91 (M/W of its line);
  // flanges with k = 4: lambda_p = (780/10)/(28.4 eps 2) = 1.688, rho = (lambda_p -
  // 0.22)/lambda_p^2 = 0.515, so that it must be used by a fifth more at least.
  CHECK(use_of(800, 800, 10, 10, 8, 150, 5, false) > 1.2 * 0.91);
}

}  // namespace weld_checks_test
