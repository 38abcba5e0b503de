// What of a slender path is not judged, what is said then, and forces that come into its webs.

#include <string>
#include <utility>
#include <vector>

#include "boxbeam/report/remarks.hpp"
#include "boxbeam/verification/path_checks.hpp"
#include "catch.hpp"
#include "support/path_cases.hpp"

namespace unjudged_paths_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::girder;
using path_cases::girder_case;
using path_cases::held;
using path_cases::section;

TEST_CASE("what of a path is not judged keeps the verdict back", "[plates]") {
  SECTION("a force without a diaphragm that the web does not bear under an edge") {
    // 84 kN at the end of the beam: EN 1993-1-5, 6.5 type c with l_e = 0.
    const auto under = [](double kN) {
      return verified(
          cantilever(section("a", girder), segment(6.0, "a") + held(6.0, 20), tip(6.0, -kN)));
    };
    const Verification of = under(100.0);
    CHECK(test::blocks(of, "clause 6"));
    CHECK(of.verdict == Verdict::not_applicable);
    CHECK(!test::blocks(under(50.0), "clause 6"));
    CHECK(!test::blocks(verified(girder_case(girder, 6.0, -50.0)), "clause 6"));
  }
  SECTION("a rib, a lip, reduced stresses, steep walls") {
    const auto found = [](const ThinWalled& path, const std::string& words,
                          const std::string& strength = "") {
      const Verification of = verified(
          cantilever(section("a", path), segment(2.0, "a") + diaphragms({2.0}) + held(2.0, 20),
                     tip(2.0, -0.5), "", strength));
      CAPTURE(words);
      CHECK(of.verdict == Verdict::not_applicable);
      CHECK(test::blocks(of, words));
      CHECK(of.governing(Criterion::effective_section) == nullptr);
    };
    ThinWalled ribbed = girder;
    ribbed = split(ribbed, 4, 0.2);
    const std::size_t foot = ribbed.nodes.size() - 1;
    add_wall(ribbed, foot, add_node(ribbed, mm_place(80.0, 363.6)), 8.0);
    found(ribbed, "a rib stands on it");
    ThinWalled lipped = channel(300.0, 150.0, 2.0, 2.0);
    add_wall(lipped, lipped.walls[0].from, add_node(lipped, mm_place(150.0, 100.0)), 2.0);
    add_wall(lipped, lipped.walls[2].to, add_node(lipped, mm_place(150.0, -100.0)), 2.0);
    found(lipped, "a lip alone");
    found(girder, "plates = \"effective widths\"", "plates = \"reduced stresses\"\n");
    // 400/(2000) is 11.3 degrees on each side.
    const Verification steep = verified(
        cantilever(section("a", girder) + section("b", i_section(400.0, 12.0, 400.0, 6.0)),
                   taper(2.0, "a", "b") + diaphragms({2.0}) + held(2.0, 20), tip(2.0, -10.0)));
    CHECK(test::blocks(steep, "above 10 deg"));
  }
  SECTION("a web into which its flange may buckle: 0.55 E/f_y sqrt(A_w/A_fc)") {
    // 0.55 x 591.5 x sqrt(1500 x 5/(500 x 40)) = 199 < 300.
    const Verification of = verified(girder_case(i_section(500.0, 40.0, 1500.0, 5.0), 6.0, -50.0));
    CHECK(test::blocks(of, "its flange may buckle into it"));
  }
  SECTION("the stem of a T that bears shear") {
    ThinWalled tee;
    const std::size_t top = add_node(tee, mm_place(0.0, 100.0));
    add_wall(tee, add_node(tee, mm_place(100.0, 100.0)), top, 10.0);
    add_wall(tee, top, add_node(tee, mm_place(-100.0, 100.0)), 10.0);
    add_wall(tee, top, add_node(tee, mm_place(0.0, -200.0)), 6.0, 5.0);
    CHECK(test::blocks(verified(girder_case(tee, 0.5, -60.0)), "free edge"));
  }
  SECTION("fatigue of flanges that shear lag reduces") {
    for (const bool counts : {false, true}) {
      Project project =
          parse_project("path.toml", girder_case(girder, 2.0, -20.0, 0.0) + lifted_often);
      CHECK(!test::blocks(verify(project), "shear lag"));
      project.strength.shear_lag = true;
      project.fatigue.asked = counts;
      const Verification of = verify(project);
      CHECK(test::blocks(of, "shear lag") == counts);
      CHECK(has_gate(of, "shear lag"));
    }
  }
}

TEST_CASE("a web that breathes, and a plate of which less than half works, keep fatigue back",
          "[plates]") {
  // tau = 200e3/7200 = 28 MPa; sigma_E = 190e3/200^2 = 4.75 MPa: 1.1 x 28/(5.34 x 4.75) = 1.2.
  CHECK(has_gate(verified(girder_case(girder, 1.0, -200.0) + lifted_often), "breathes"));
  // Its web, evenly compressed by 150 MPa: lambda_red = 200/(28.4 eps 2) sqrt(150/355) = 2.8.
  CHECK(has_gate(verified(girder_case(girder, 1.0, 0.0, -2500.0) + lifted_often), "less than 0.5"));
}

TEST_CASE("a wheel that starts at a diaphragm comes into the web behind it", "[plates]") {
  const auto wheel = [](const std::string& from, const std::string& to) {
    return "[loads.wheel]\nkind = \"wheels\"\nfrom = \"" + from + "\"\nto = \"" + to +
           "\"\nwheels = [{ force = [\"0 kN\", \"-280 kN\"] }]\n";
  };
  for (const auto& [from, to] : {std::pair{"0 m", "6 m"}, {"0.1 m", "5.9 m"}}) {
    CAPTURE(from);
    const Verification of = verified(cantilever(
        section("a", girder), segment(6.0, "a") + diaphragms({2.0, 4.0, 6.0}) + held(6.0, 20),
        "[supports.end]\nkind = \"roller\"\nat = \"6 m\"\n" + wheel(from, to)));
    CHECK(test::blocks(of, "clause 6"));
  }
}

TEST_CASE("a load on a short length comes in like a force", "[plates]") {
  // 350 kN on 100 mm of a web of 6 mm.
  const std::string line =
      "[loads.q]\nkind = \"line\"\nfrom = \"1.45 m\"\nto = \"1.55 m\"\n"
      "force_per_length = [\"0 kN/m\", \"-3500 kN/m\"]\n";
  const std::string beam = segment(3.0, "a") + diaphragms({3.0}) + held(3.0, 20);
  // As the same force over as long a stiff bearing, whose place is told, of a path and of a box.
  std::string plates;
  const auto use_of = [&](const std::string& loads, const std::string& more) {
    const Verification of = verified(cantilever(plates, beam + more, loads));
    const CheckResult* const worst = of.governing(Criterion::patch_loading);
    REQUIRE(worst != nullptr);
    return worst->check.utilisation();
  };
  double as_line = 0.0;
  for (const std::string& of : {section("a", girder), box("a", 400.0, 1200.0, 12.0, 6.0)}) {
    plates = of;
    as_line = use_of(line, "");
    const double as_force =
        use_of("[loads.q]\nkind = \"force\"\nat = \"1.5 m\"\nforce = [\"0 kN\", \"-350 kN\"]\n",
               "[[beam.load_introductions]]\nstation = \"1.5 m\"\nstiff_length = \"100 mm\"\n");
    CHECK(as_line == Approx(as_force).epsilon(0.02));
  }
  // Nor does it matter where segments meet.
  const std::string two = segment(1.5, "a") + segment(1.5, "a") + diaphragms({3.0}) + held(3.0, 20);
  const Verification across = verified(cantilever(plates, two, line));
  REQUIRE(across.governing(Criterion::patch_loading) != nullptr);
  CHECK(across.governing(Criterion::patch_loading)->check.utilisation() ==
        Approx(as_line).epsilon(0.02));
}

TEST_CASE(
    "torque into a slender path around cells keeps the verdict back where nothing holds its shape",
    "[plates]") {
  const auto with = [](const std::vector<double>& at) {
    return verified(cantilever(
        section("a", box_path(1200.0, 1200.0, 8.0, 8.0)), segment(12.0, "a") + diaphragms(at),
        "[loads.twist]\nkind = \"force\"\nat = \"6 m\"\nforce = [\"0 N\", \"0 N\", \"0 N\"]\n"
        "moment = [\"600 kN m\", \"0 N m\", \"0 N m\"]\n",
        "space = true\n"));
  };
  CHECK(test::blocks(with({12.0}), "cells"));
  CHECK_FALSE(test::blocks(with({0.0, 6.0, 12.0}), "cells"));
}

TEST_CASE("of open sections it is said what is taken for granted of them, not of a box",
          "[plates]") {
  const auto remark = [](const std::string& sections) {
    const Project project = parse_project(
        "path.toml", cantilever(sections, segment(4.0, "a") + held(4.0, 20), tip(4.0, -20.0)));
    for (const Remark& of : remarks_of(project, verify(project)))
      if (of.text.starts_with("not checked here")) return of.text;
    return std::string();
  };
  const std::string open = remark(section("a", girder));
  CHECK(open.find("of the box") == std::string::npos);
  CHECK(open.find("open sections") != std::string::npos);
  CHECK(open.find("shear centre") != std::string::npos);
  const std::string closed = remark(section("a", box_path(600.0, 1200.0, 10.0, 8.0)));
  CHECK(closed.find("distortion of the box") != std::string::npos);
  CHECK(closed.find("open sections") == std::string::npos);
}

}  // namespace unjudged_paths_test
