// Steels beyond S450 and materials of the case's own, from the case file to the verdict.

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/clamped_beam.hpp"
#include "support/refusals.hpp"

namespace material_of_case_test {

using namespace boxbeam;

namespace {

/// A cantilever of 4 m, 30 kN at its tip, of a material.
Project beam_of(const std::string& material, const std::string& web = "8 mm") {
  return parse_project(
      "beam.toml",
      "[case]\nname = \"beam\"\nkind = \"static\"\n[sections.box]\nkind = \"box\"\n"
      "width = \"150 mm\"\nheight = \"300 mm\"\nflange = \"12 mm\"\nweb = \"" +
          web +
          "\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[beam]\n"
          "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n"
          "[supports.root]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.tip]\nkind = \"force\"\n"
          "at = \"4 m\"\nforce = [\"0 kN\", \"-30 kN\"]\n[strength]\nrequired = 1.0\n[material]\n" +
          material);
}

const std::string own =
    "name = \"1.4462\"\nfy = \"500 MPa\"\nfu = \"700 MPa\"\nup_to = \"8 mm\"\n"
    "source = \"EN 10088-4\"\n"
    "thicker = [{ up_to = \"13.5 mm\", fy = \"460 MPa\", fu = \"660 MPa\" }]\n";

bool says(const Verification& of, const std::string& words, bool blocks) {
  return std::any_of(of.gates.begin(), of.gates.end(), [&](const Gate& gate) {
    return gate.blocks == blocks && gate.finding.find(words) != std::string::npos;
  });
}

std::string refusal(const std::string& material) {
  return test::refusal_of([&] { return beam_of(material); });
}

}  // namespace

TEST_CASE("a beam of stronger steel bears as much more as its plates are stronger") {
  const double s355 =
      verify(beam_of("steel = \"S355\"\n")).governing(Criterion::yield)->check.safety_factor;
  for (const auto& [name, f_y] : {std::pair{"S460N", 460.0}, {"S690QL", 690.0}, {"S960Q", 960.0}}) {
    const Verification of = verify(beam_of("steel = \"" + std::string(name) + "\"\n"));
    CHECK(of.governing(Criterion::yield)->check.safety_factor ==
          Approx(s355 * f_y / 355.0).epsilon(1e-12));
    CHECK(says(of, "filler metal", false) == (f_y > 460.0));
    CHECK(says(of, "EN 1993 ends at S700", false) == (f_y > 700.0));
  }
}

TEST_CASE("a material of the case's own has its strengths by thickness") {
  // The flange of 12 mm has the second step.
  const Verification of = verify(beam_of(own));
  const CheckResult* yield = of.governing(Criterion::yield);
  REQUIRE(yield != nullptr);
  CHECK(yield->check.resisting.value() == Approx(460e6));
  CHECK(of.verdict == Verdict::pass);
}

TEST_CASE("Young's modulus of an own material bends the beam and is asked for its rules") {
  const auto bent = [&](const std::string& modulus) {
    Project project = beam_of(own + modulus);
    return project.model.youngs_modulus;
  };
  CHECK(bent("") == 2.1e11);
  CHECK(bent("youngs_modulus = \"200 GPa\"\n") == 2e11);
  // c/t of the web: 276/8 = 34.5, 276/6 = 46; 37 epsilon = 37 sqrt(235/500 200/210) = 24.8.
  const Verification stainless = verify(beam_of(own + "youngs_modulus = \"200 GPa\"\n"));
  CHECK(stainless.verdict == Verdict::not_applicable);
  CHECK(says(stainless, "37 epsilon = 24.8", true));
  const Verification stout = verify(beam_of(own + "youngs_modulus = \"200 GPa\"\n", "12 mm"));
  CHECK(stout.verdict == Verdict::pass);
  const Verification aluminium = verify(beam_of(own + "youngs_modulus = \"70 GPa\"\n", "12 mm"));
  CHECK(aluminium.verdict == Verdict::not_applicable);
  CHECK(says(aluminium, "no steel", true));
}

TEST_CASE("what is wrong with a material is said") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal("steel = \"S460\"\n"), Contains("did you mean \"S460"));
  CHECK_THAT(refusal("steel = \"S690Q\"\nfy_source = \"EN 10025-2\"\n"),
             Contains("EN 10025-2 does not have S690Q") && Contains("EN 1993-1-12"));
  CHECK_THAT(refusal("steel = \"S355\"\nfy = \"300 MPa\"\n"), Contains("either a steel"));
  CHECK_THAT(refusal(""), Contains("either a steel"));
  CHECK_THAT(refusal("name = \"x\"\nfy = \"300 MPa\"\nfu = \"200 MPa\"\nup_to = \"20 mm\"\n"
                     "source = \"s\"\n"),
             Contains("below the yield strength"));
  CHECK_THAT(refusal("name = \"x\"\nfy = \"300 MPa\"\nfu = \"400 MPa\"\nup_to = \"10 mm\"\n"
                     "source = \"s\"\n"),
             Contains("ends at 10 mm"));
  CHECK_THAT(refusal("fy = \"300 MPa\"\n"), Contains("source"));
}

}  // namespace material_of_case_test
