// The verdict in words leaves out nothing that was asked for.

#include "boxbeam/verification/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "boxbeam/report/html_writer.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/latex_writer.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/summary.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "catch.hpp"
#include "support/cantilever.hpp"
#include "support/changed_rig.hpp"
#include "support/clamped_beam.hpp"
#include "support/held_bar.hpp"
#include "support/refusals.hpp"

namespace verdict_text_test {

using namespace boxbeam;
using test::contains;

namespace {

/// What the terminal, the reports and the results say.
struct Said {
  Verification verification;
  std::string terminal, text, html, latex;
  nlohmann::json json;
};

Said said_of(const Project& project) {
  Said said{verify(project), "", "", "", "", {}};
  said.terminal = summary(project, said.verification).text;
  const report::Document document = report_of(project, said.verification, ReportLevel::summary);
  said.text = report::text_of(document);
  said.html = report::html_of(
      document, [](const std::string&) -> std::optional<std::string> { return std::nullopt; });
  said.latex = report::latex_of(document, [](const std::string&) { return false; });
  said.json = nlohmann::json::parse(results_json(project, said.verification));
  return said;
}

const std::string shaken =
    "law = { kind = \"harmonic\", mean = \"30 kN\", amplitude = \"1 kN\", frequency = \"1 Hz\" }\n";

}  // namespace

TEST_CASE("fatigue that is asked for and finds no stress range stands in the verdict line") {
  const Said said = said_of(test::clamped_beam(test::clamped::steady, test::clamped::fatigue));
  // 30 kN at 4 m on W = I/150 mm = 758 cm^3: 158 MPa, below the yield strength.
  CHECK(said.verification.verdict == Verdict::pass);
  const std::string line = "PASS for strength; fatigue: no stress range";
  CHECK(said.terminal.starts_with(line));
  CHECK(contains(said.text, "VERDICT: " + line));
  CHECK(contains(said.html, "<strong>" + line + "</strong>"));
  CHECK(contains(said.latex, line));
  CHECK(said.json["verdict"] == "pass");
  CHECK(said.json["verdict_text"] == line);
  REQUIRE(said.json["not_judged"].size() == 1);
  CHECK(said.json["not_judged"][0]["what"] == "fatigue");
  CHECK(said.json["not_judged"][0]["reason"] == "no stress range");
}

TEST_CASE("a case without [fatigue] is judged for its strength only, and says so") {
  const Said said = said_of(test::clamped_beam(shaken, ""));
  CHECK(said.verification.verdict == Verdict::pass);
  CHECK(said.terminal.starts_with("PASS (strength only)"));
  CHECK(contains(said.text, "VERDICT: PASS (strength only)"));
  CHECK(contains(said.html, "<strong>PASS (strength only)</strong>"));
  CHECK(said.json["verdict_text"] == "PASS (strength only)");
  CHECK(said.json["not_judged"].empty());
  CHECK(said.json["governing"]["fatigue"].is_null());
  for (const CheckResult& result : said.verification.checks) {
    const Criterion criterion = result.check.criterion;
    const bool strength = criterion == Criterion::yield || criterion == Criterion::weld ||
                          criterion == Criterion::effective_section ||
                          criterion == Criterion::interaction;
    CHECK(strength);
  }
  // With [fatigue] the same beam is judged for both.
  const Verification both = verify(test::clamped_beam(shaken, test::clamped::fatigue));
  CHECK(both.governing(Criterion::fatigue) != nullptr);
  CHECK(both.not_judged.empty());
  CHECK(verdict_text_of(test::clamped_beam(shaken, test::clamped::fatigue), both).line == "PASS");
}

TEST_CASE("a strength that fails is FAIL, whatever was not judged") {
  // 100 kN: 528 MPa.
  const Project project = test::clamped_beam("size = \"100 kN\"\n", "");
  const Verification verification = verify(project);
  CHECK(verification.verdict == Verdict::fail);
  CHECK(verdict_text_of(project, verification).whole() == "FAIL (strength only)");
}

TEST_CASE("cycles of situations count nothing without [fatigue]") {
  const Project project = test::clamped_beam(
      shaken,
      "[[situations]]\nname = \"work\"\ncycles = 1e6\n[[situations]]\nname = \"rest\"\n"
      "[[situations]]\nname = \"start\"\nbetween = [\"rest\", \"work\"]\ncycles = 1e4\n");
  CHECK_FALSE(project.fatigue.asked);
  CHECK(most_cycles_of(project) == 0.0);
  CHECK(verdict_text_of(project, verify(project)).line == "PASS (strength only)");
}

TEST_CASE("pins and rods without a force, and a beam that never bends, are named") {
  // A bar without weight hangs on a rod and moves nothing: nothing acts but what the tip bears.
  const Project project = test::clamped_beam(
      "size = \"30 kN\"\n",
      test::clamped::fatigue +
          "[bodies.idle]\nmass = \"0 kg\"\npoints = { P = [\"0 m\", \"0 m\"], "
          "Q = [\"1 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"1 m\"] }\n"
          "[joints.P]\nkind = \"pin\"\nconnect = [\"idle.P\", \"ground\"]\n"
          "at = [\"0 m\", \"1 m\"]\n"
          "[joints.Q]\nkind = \"distance\"\nconnect = [\"idle.Q\", \"ground\"]\n"
          "at = [\"1 m\", \"2 m\"]\nlength = \"1 m\"\n"
          "[[pins]]\nname = \"bolt\"\njoint = \"P\"\ndiameter = \"50 mm\"\n"
          "inner_plate = \"20 mm\"\nouter_plate = \"10 mm\"\n"
          "[[rods]]\nname = \"idler\"\nfrom = \"idle.P\"\nto = \"idle.Q\"\nsection = \"box\"\n"
          "curve = \"b\"\n");
  const Verification verification = verify(project);
  CHECK(verdict_text_of(project, verification).line ==
        "PASS for strength; fatigue: no stress range; pin bolt: no force; rod idler: no force");
  CHECK(contains(remarks_of(project, verification).back().text, ", rods, deflection"));
}

TEST_CASE("what is not checked names rods where they have no check") {
  const std::string flat = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n";
  const auto last_remark = [&](const std::string& rods) {
    const Project project = test::held_bar(true, flat, rods);
    return remarks_of(project, verify(project)).back().text;
  };
  CHECK(contains(last_remark(""), ", rods"));
  const std::string rod =
      "[[rods]]\nname = \"hanger\"\nfrom = \"rod.P\"\nto = \"rod.Q\"\nsection = \"bar\"\n"
      "curve = \"c\"\n";
  CHECK(contains(last_remark(rod), "bending of rods by their own weight and inertia"));
  const Project project = test::held_bar(true, flat, rod);
  const std::vector<Remark> remarks = remarks_of(project, verify(project));
  CHECK(std::any_of(remarks.begin(), remarks.end(), [](const Remark& remark) {
    return remark.text.starts_with("rod hanger is never compressed");
  }));
}

TEST_CASE("a cable that becomes slack in a motion by drivers leaves vibration out, and says so") {
  // Between 1.4 and 2 m long.
  const auto verdict_with = [](const std::string& free_length) {
    const Project project = test::changed_rig(
        {},
        "\n[forces.rope]\nkind = \"spring\"\nconnect = [\"sledge.E\", \"ground\"]\n"
        "at = [\"-1 m\", \"-3.2 m\"]\nstiffness = \"1 kN/m\"\nacts = \"pulling\"\n"
        "free_length = \"" +
            free_length + "\"\n");
    return verdict_text_of(project, verify(project)).line;
  };
  const std::string left_out = "what it adds is not estimated: a stop or a cable begins or ends";
  CHECK(contains(verdict_with("1.7 m"), left_out));
  CHECK_FALSE(contains(verdict_with("1 m"), left_out));
  CHECK_FALSE(contains(verdict_with("3 m"), left_out));
}

TEST_CASE("why a verdict is not applicable stands beside it") {
  // A shell: 300/3 = 100 is above 90 eps^2 = 59.6.
  const std::string thin = "kind = \"round tube\"\ndiameter = \"300 mm\"\nwall = \"3 mm\"\n";
  const Said said = said_of(test::held_bar(true, thin));
  REQUIRE(said.verification.verdict == Verdict::not_applicable);
  const VerdictText text = verdict_text_of(test::held_bar(true, thin), said.verification);
  CHECK(text.line == "NOT APPLICABLE");
  REQUIRE(text.reasons.size() == 2);
  CHECK(text.reasons[1] == "fatigue: no stress range");
  CHECK(contains(text.reasons[0], "c/t = 100"));
  CHECK(contains(said.terminal.substr(0, said.terminal.find("use [%]")), "c/t = 100"));
  CHECK(contains(said.text.substr(0, said.text.find("use [%]")), "c/t = 100"));
  const std::size_t banner = said.html.find("<strong>NOT APPLICABLE</strong>");
  REQUIRE(banner != std::string::npos);
  CHECK(contains(said.html.substr(banner, 400), "c/t = 100"));
  const std::size_t first_page = said.latex.find("\\begin{document}");
  REQUIRE(first_page != std::string::npos);
  const std::size_t signing = said.latex.find("\\signfield", first_page);
  CHECK(contains(said.latex.substr(first_page, signing - first_page), "c/t = 100"));
  CHECK(said.json["verdict"] == "not applicable");
  CHECK(said.json["verdict_text"].get<std::string>().starts_with("NOT APPLICABLE: round wall of"));
}

TEST_CASE("the terminal names the chosen model before its checks") {
  const Said said = said_of(test::clamped_beam(test::clamped::steady, test::clamped::fatigue));
  const std::string first = said.terminal.substr(0, said.terminal.find("criterion"));
  CHECK(contains(first, "model"));
  CHECK(contains(first, said.verification.model.reason.substr(0, 12)));
}

TEST_CASE("what ties nested profiles together is said not to be checked, with its part of V") {
  Project project = test::clamped_beam(test::clamped::steady, test::clamped::fatigue);
  const auto mm = [](double length) { return si<Length>(1e-3 * length); };
  Box outer = symmetric_box(mm(150), mm(300), mm(12), mm(8));
  const Box inner = symmetric_box(mm(100), mm(200), mm(10), mm(10));
  const auto said = [&] {
    project.beam.segments[0].from = project.beam.segments[0].to = {outer, inner};
    const std::vector<Remark> remarks = remarks_of(project, verify(project));
    const auto found = std::find_if(remarks.begin(), remarks.end(), [](const Remark& of) {
      return contains(of.text, "the outer and the inner profile");
    });
    REQUIRE(found != remarks.end());
    return found->text;
  };
  CHECK(!contains(said(), "% of V"));
  // With a top flange of 24 the outer centroid lies e above that of the inner box, which adds
  // A_o A_i e^2/(A_o + A_i) to the sum of both I (Steiner).
  outer.top_flange = mm(24);
  const double A_o = 150 * 36 + 16 * 264, A_i = 100 * 200 - 80 * 180;
  const double e = (150 * 24 * 138 - 150 * 12 * 144 - 16 * 264 * 6) / A_o;
  const double I_o = (150 * 24 * 24 * 24 + 150 * 12 * 12 * 12 + 16 * 264.0 * 264 * 264) / 12 +
                     150 * 24 * std::pow(138 - e, 2) + 150 * 12 * std::pow(144 + e, 2) +
                     16 * 264 * std::pow(6 + e, 2);
  const double I_i = (100.0 * 200 * 200 * 200 - 80.0 * 180 * 180 * 180) / 12;
  const double tied = A_o * A_i * e * e / (A_o + A_i);
  CHECK(contains(said(), fmt::format("up to {:.2g} % of V", 100 * tied / (I_o + I_i + tied))));
}

TEST_CASE("in space nested profiles beside one another carry V across the beam together") {
  const auto mm = [](double length) { return si<Length>(1e-3 * length); };
  Box outer = symmetric_box(mm(150), mm(300), mm(12), mm(8));
  outer.left_web = mm(16);
  const Box inner = symmetric_box(mm(100), mm(200), mm(10), mm(10));
  Project project = test::cantilever("kind = \"plate\"\nwidth = \"20 mm\"\nheight = \"50 mm\"\n",
                                     {{{0.0, 1e3, 1e3}, 0.0, 0.5, 0.5, 0.0}});
  project.beam.segments[0].from = project.beam.segments[0].to = {outer, inner};
  // About z, as above: flanges 24 x 150, webs of 16 and 8 x 276, whose middles are at 67 and -71.
  const double A_o = 24 * 150 + 24 * 276, A_i = 100 * 200 - 80 * 180;
  const double e = 276 * (16 * 67 - 8 * 71) / A_o;
  const double I_o = 24 * 150.0 * 150 * 150 / 12 + 276.0 * (16 * 16 * 16 + 8 * 8 * 8) / 12 +
                     24 * 150 * e * e + 276 * (16 * std::pow(67 - e, 2) + 8 * std::pow(71 + e, 2));
  const double I_i = (200.0 * 100 * 100 * 100 - 180.0 * 80 * 80 * 80) / 12;
  const double tied = A_o * A_i * e * e / (A_o + A_i);
  const std::vector<Remark> remarks = remarks_of(project, verify(project));
  const std::string expected = fmt::format("up to {:.2g} % of V", 100 * tied / (I_o + I_i + tied));
  CHECK(std::any_of(remarks.begin(), remarks.end(),
                    [&](const Remark& of) { return contains(of.text, expected); }));
}

}  // namespace verdict_text_test
