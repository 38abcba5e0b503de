// What would make a case pass: each remedy passes when the case is written with it, and the next
// lesser one does not.

#include "boxbeam/verification/remedies.hpp"

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/report/verdict_sentence.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace remedies_test {

using namespace boxbeam;

namespace {

/// A cantilever of 2 m, box 100 x 200, plates 8 mm, with a force at its tip: M = 2 m F at the root.
std::string cantilever(const std::string& loads, const std::string& demands) {
  return "[case]\nname = \"cantilever\"\nkind = \"static\"\n"
         "[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
         "flange = \"8 mm\"\nweb = \"8 mm\"\n"
         "[beam]\ndensity = \"1e-6 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = "
         "\"box\"\n"
         "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n" +
         loads + "[material]\nsteel = \"S235\"\n[strength]\nrequired = 1.0\nshear_lag = false\n" +
         demands;
}

std::string force(const std::string& size) {
  return "[loads.tip]\nkind = \"force\"\nat = \"2 m\"\nforce = [\"0 kN\", \"-" + size +
         "\"]\n[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0 }\n";
}

const std::string cycles =
    "[[situations]]\nname = \"empty\"\nloads = { tip = 0.0 }\n[[situations]]\nname = \"lift\"\n"
    "between = [\"empty\", \"loaded\"]\ncycles = 2e6\n";

const std::string fatigue =
    "[fatigue]\ncategory = 71\nloading = \"spectrum\"\ngamma_Mf = 1.0\nrequired = 1.0\n";

struct Judged {
  Project project;
  Verification verification;
};

Judged judged(const std::string& text, const std::vector<std::string>& set = {},
              Advice advice = Advice::with) {
  Judged of{parse_project("cantilever.toml", text, set), {}};
  of.verification = verify(of.project, Figures::without, advice);
  return of;
}

bool passes(const std::string& text, const std::vector<std::string>& set) {
  return judged(text, set, Advice::without).verification.verdict == Verdict::pass;
}

const Remedy* find(const Remedies& remedies, Remedy::What what) {
  for (const Remedy& remedy : remedies.found) {
    if (remedy.what == what) return &remedy;
  }
  return nullptr;
}

/// Section modulus of the box with flanges of t and webs of 8 [mm^3].
double modulus(double t) {
  return (100.0 * std::pow(200.0, 3) - 84.0 * std::pow(200.0 - 2.0 * t, 3)) / 12.0 / 100.0;
}

}  // namespace

TEST_CASE("fatigue: the next category and the least flange by the section's own formula") {
  // 2e6 cycles of one range: the strength is the category. W(8) = 230.6 cm^3.
  const std::string text = cantilever(force("10 kN") + cycles, fatigue);
  const double moment = 20e6;  // N mm
  const double range = moment / modulus(8.0);
  REQUIRE(range > 80.0);
  REQUIRE(range < 90.0);
  const Judged of = judged(text);
  REQUIRE(of.verification.verdict == Verdict::fail);
  CHECK(of.verification.governing(Criterion::fatigue)->check.utilisation() ==
        Approx(range / 71.0).epsilon(1e-6));
  const Remedies& remedies = of.verification.remedies;
  CHECK(remedies.not_searched.empty());

  const Remedy* category = find(remedies, Remedy::What::category);
  REQUIRE(category != nullptr);
  CHECK(category->value == 90.0);
  CHECK(category->utilisation == Approx(range / 90.0).epsilon(1e-4));
  CHECK(passes(text, {"fatigue.category=90"}));
  CHECK_FALSE(passes(text, {"fatigue.category=80"}));

  int least = 8;
  while (moment / modulus(least) > 71.0) ++least;
  const Remedy* flanges = find(remedies, Remedy::What::flanges);
  REQUIRE(flanges != nullptr);
  CHECK(flanges->value == Approx(1e-3 * least));
  CHECK(flanges->set == std::vector<std::string>{fmt::format("sections.box.flange={} mm", least)});
  CHECK(flanges->utilisation == Approx(moment / modulus(least) / 71.0).epsilon(1e-4));
  CHECK(passes(text, flanges->set));
  CHECK_FALSE(passes(text, {fmt::format("sections.box.flange={} mm", least - 1)}));

  CHECK(verdict_sentence_of(of.project, of.verification) ==
        fmt::format("fails in fatigue at 0 m, fibre +z, {:.0f} % used, under \"lift\"; category 90 "
                    "or {} mm flanges would pass",
                    100.0 * range / 71.0, least));
}

TEST_CASE("yield: the next steel of the catalogue that is strong enough") {
  // 340 MPa at the root: above S235 and S275, below 355 MPa of S355 in 8 mm.
  const double moment = 340.0 * modulus(8.0);  // N mm
  const std::string text = cantilever(force(fmt::format("{:.9g} N", moment / 2000.0)), "");
  const Judged of = judged(text);
  REQUIRE(of.verification.verdict == Verdict::fail);
  const Remedy* steel = find(of.verification.remedies, Remedy::What::steel);
  REQUIRE(steel != nullptr);
  CHECK(steel->value == Approx(355e6));
  CHECK(passes(text, {"material.steel=" + steel->name}));
  CHECK_FALSE(passes(text, {"material.steel=S275"}));
  CHECK(find(of.verification.remedies, Remedy::What::category) == nullptr);
  const Remedy* flanges = find(of.verification.remedies, Remedy::What::flanges);
  REQUIRE(flanges != nullptr);
  int least = 8;
  while (moment / modulus(least) > 235.0) ++least;
  CHECK(flanges->value == Approx(1e-3 * least));
}

TEST_CASE("what no single change mends is said") {
  // 1000 MPa: no steel, and 32 mm flanges are not enough.
  const double moment = 1000.0 * modulus(8.0);
  REQUIRE(moment / modulus(32.0) > 235.0);
  const Judged of = judged(cantilever(force(fmt::format("{:.9g} N", moment / 2000.0)), ""));
  CHECK(of.verification.remedies.found.empty());
  REQUIRE(of.verification.remedies.in_vain.size() == 2);
  CHECK(of.verification.remedies.in_vain[1] == "flanges up to 32 mm");
  const std::string sentence = verdict_sentence_of(of.project, of.verification);
  CHECK(sentence.find("; neither a steel up to S960Q") != std::string::npos);
  CHECK(sentence.ends_with("nor flanges up to 32 mm would make it pass"));
}

TEST_CASE("a case that passes, or is not asked, has no remedies, and advice changes no result") {
  const std::string text = cantilever(force("11 kN") + cycles, fatigue);
  const Judged bare = judged(text, {}, Advice::without);
  CHECK(bare.verification.remedies.found.empty());
  const Judged advised = judged(text);
  REQUIRE(bare.verification.checks.size() == advised.verification.checks.size());
  for (std::size_t i = 0; i < bare.verification.checks.size(); ++i) {
    const Check& a = bare.verification.checks[i].check;
    const Check& b = advised.verification.checks[i].check;
    CHECK(a.id == b.id);
    CHECK(a.safety_factor == b.safety_factor);
  }
  // Bosses lead the force into the webs, which else would feel it anew at every cycle.
  const std::string bosses = "[[beam.load_introductions]]\nstation = \"2 m\"\ninto = \"webs\"\n";
  const Judged passing = judged(cantilever(force("5 kN") + cycles + bosses, fatigue));
  REQUIRE(passing.verification.verdict == Verdict::pass);
  CHECK(passing.verification.remedies.found.empty());
  // 10e6/230.6e3 = 43.4 MPa of 71.
  CHECK(verdict_sentence_of(passing.project, passing.verification) ==
        fmt::format("passes; most used is fatigue at 0 m, fibre +z, {:.1f} % used, under \"lift\"",
                    100.0 * 10e6 / modulus(8.0) / 71.0));
}

TEST_CASE("the remedies of a shipped case pass when they are set, and one step less does not") {
  const std::string path = test::project_file("sections/pump-jack/beam.toml");
  const Project project = read_project(path);
  const Verification verification = verify(project, Figures::without, Advice::with);
  const Remedy* flanges = find(verification.remedies, Remedy::What::flanges);
  REQUIRE(flanges != nullptr);
  REQUIRE(flanges->set.size() == 1);
  CHECK(verify(read_project(path, flanges->set)).verdict == Verdict::pass);
  const std::string key = flanges->set.front().substr(0, flanges->set.front().find('='));
  const int thickness = static_cast<int>(std::lround(1e3 * flanges->value));
  CHECK(verify(read_project(path, {fmt::format("{}={} mm", key, thickness - 1)})).verdict ==
        Verdict::fail);
}

TEST_CASE("plates for which there is no room are no remedy") {
  // The tube inside the rig's box leaves 5 mm above and below: 500 - 490 mm.
  const Project project = read_project(test::project_file("sections/sledge-rig/rig.toml"));
  const Verification verification = verify(project, Figures::without, Advice::with);
  REQUIRE(verification.verdict == Verdict::fail);
  // 1.65 times category 100 is above 160.
  REQUIRE(verification.remedies.in_vain.size() == 2);
  CHECK(verification.remedies.in_vain[0] == "a detail up to category 160");
  CHECK(verification.remedies.in_vain[1] ==
        "flanges up to 55 mm, the most for which there is room,");
}

TEST_CASE("a weld that fails passes with the throat that is said, and not with half a mm less") {
  const std::string text =
      cantilever(force("5 kN") + cycles,
                 fatigue +
                     "[[welds]]\nname = \"foot\"\nstation = \"0.2 m\"\naround = \"box\"\n"
                     "attachment_length = \"40 mm\"\nthroat = \"3 mm\"\n");
  const Judged of = judged(text);
  REQUIRE(of.verification.verdict == Verdict::fail);
  REQUIRE(of.verification.checks.front().check.point.starts_with("weld foot"));
  const Remedy* throat = find(of.verification.remedies, Remedy::What::throat);
  REQUIRE(throat != nullptr);
  const auto with = [&](double mm) {
    Project project = of.project;
    project.welds.front().throat = si<Length>(1e-3 * mm);
    return verify(project);
  };
  const double mm = 1e3 * throat->value;
  CHECK(throat->name == fmt::format("{:.6g} mm throat of weld foot", mm));
  CHECK(std::abs(2.0 * mm - std::round(2.0 * mm)) < 1e-9);
  const Verification passing = with(mm);
  CHECK(passing.verdict == Verdict::pass);
  CHECK(passing.checks.front().check.utilisation() == Approx(throat->utilisation).epsilon(1e-9));
  CHECK(with(mm - 0.5).verdict == Verdict::fail);
}

TEST_CASE("a seam that fails passes with the throat that is said, which its place has exactly") {
  // tau_par = V S/(2 I a) of two seams.
  std::string text = cantilever(force("450 kN"), "");
  text.replace(text.find("web = \"8 mm\""), 12, "web = \"8 mm\"\nseam_throat = \"0.5 mm\"");
  text.replace(text.find("S235"), 4, "S355");
  text.replace(text.find("length = \"2 m\""), 14, "length = \"20 mm\"");
  text.replace(text.find("at = \"2 m\""), 10, "at = \"20 mm\"");
  text.insert(text.find("[supports"),
              "[[beam.load_introductions]]\nstation = \"20 mm\"\ninto = \"webs\"\n");
  const Judged of = judged(text);
  REQUIRE(of.verification.verdict == Verdict::fail);
  const CheckResult& seam = of.verification.checks.front();
  REQUIRE(seam.check.criterion == Criterion::weld);
  const double I = (100.0 * std::pow(200.0, 3) - 84.0 * std::pow(184.0, 3)) / 12.0;
  const double tau_a = 450e3 * 100.0 * 8.0 * 96.0 / (2.0 * I);
  // f_u/(sqrt(3) beta_w gamma_M2) of S355: 470/(sqrt(3) 0.9 1.25).
  const double needed = tau_a / (470.0 / (std::sqrt(3.0) * 0.9 * 1.25));
  REQUIRE(needed > 3.0);
  REQUIRE(seam.sufficient_throat);
  CHECK(1e3 * seam.sufficient_throat->value() == Approx(needed).epsilon(1e-6));
  const Remedy* throat = find(of.verification.remedies, Remedy::What::throat);
  REQUIRE(throat != nullptr);
  CHECK(1e3 * throat->value == Approx(0.5 * std::ceil(2.0 * needed)));
  const std::string set = "sections.box.seam_throat={:.9g} mm";
  CHECK(passes(text, {fmt::format(fmt::runtime(set), 1e3 * throat->value)}));
  CHECK(passes(text, {fmt::format(fmt::runtime(set), needed * (1.0 + 1e-6))}));
  CHECK_FALSE(passes(text, {fmt::format(fmt::runtime(set), needed * (1.0 - 1e-6))}));
}

}  // namespace remedies_test
