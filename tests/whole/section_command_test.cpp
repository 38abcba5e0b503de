// The command "section" as a user runs it.

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <utility>

#include "catch.hpp"
#include "support/path_cases.hpp"
#include "support/program.hpp"

namespace section_command_test {

using namespace boxbeam;
using Json = nlohmann::json;

TEST_CASE("section RHS 200x100x8: EN 10210-2's properties in SI") {
  const test::ProgramResult result =
      test::run_program({"section", "RHS", "200x100x8", "--json", "-"});
  REQUIRE(result.exit_code == 0);
  const Json json = Json::parse(result.out);
  CHECK(json["schema"] == "boxbeam.section/1");
  CHECK(json["area"].get<double>() * 1e4 == Approx(44.75).margin(0.005));
  CHECK(json["I_y"].get<double>() * 1e8 == Approx(2234).margin(0.5));
  CHECK(json["I_z"].get<double>() * 1e8 == Approx(739).margin(0.5));
  CHECK(json["I_T"].get<double>() * 1e8 == Approx(1804).margin(0.5));
}

TEST_CASE("section box: the rig's pivot section by hand, the same from its case file") {
  const test::ProgramResult words =
      test::run_program({"section", "box 400x1000 flange 50 web 50", "--json", "-"});
  REQUIRE(words.exit_code == 0);
  const Json json = Json::parse(words.out);
  CHECK(json["I_y"].get<double>() * 1e12 ==
        Approx((400e9 - 300.0 * 900 * 900 * 900) / 12).epsilon(1e-9));
  CHECK(json["I_T"].get<double>() * 1e12 == Approx(8.8577e9).epsilon(5e-4));
  const test::ProgramResult file = test::run_program(
      {"section", test::project_file("sections/sledge-rig/rig.toml") + ":A2", "--json", "-"});
  REQUIRE(file.exit_code == 0);
  CHECK(Json::parse(file.out)["I_T"] == json["I_T"]);
}

TEST_CASE("section: several profiles give a list, a table each") {
  const test::ProgramResult result =
      test::run_program({"section", "SHS 100x5", "CHS 168.3x8", "--json", "-"});
  REQUIRE(result.exit_code == 0);
  CHECK(Json::parse(result.out).size() == 2);
  const test::ProgramResult text = test::run_program({"section", "SHS", "100x5"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("class 1 up to") != std::string::npos);
}

TEST_CASE("section under forces: effective section and plates by hand") {
  // 600 x 1224 mm, flanges 12, webs 8 mm of S355 (hand calculation in sections/slender-boom).
  const test::ProgramResult result =
      test::run_program({"section", "box 600x1224 flange 12 web 8", "--forces",
                         "N = -863.4 kN, M_y = 1890 kN m, V_z = 400 kN", "--json", "-"});
  REQUIRE(result.exit_code == 0);
  const Json json = Json::parse(result.out);
  CHECK(json["class"] == 4);
  CHECK(json["effective"]["A"].get<double>() == Approx(16427e-6).epsilon(1e-4));
  CHECK(json["effective"]["e_z"] == 0.0);
  CHECK(json["effective"]["W_y"].get<double>() == Approx(-9.354e-3).epsilon(1e-3));
  CHECK(json["effective"]["utilisation"].get<double>() == Approx(254.7 / 355.0).epsilon(1e-3));
  REQUIRE(json["shear"]["webs"].size() == 2);
  // chi_w = 0.83/(150/(86.4 eps)) of an endless panel.
  const double chi = 0.83 / (150.0 / (86.4 * std::sqrt(235.0 / 355.0)));
  CHECK(json["shear"]["webs"][0]["chi"].get<double>() == Approx(chi).epsilon(1e-3));
  const double V = chi * 355e6 * 1.2 * 0.008 / std::sqrt(3.0);
  CHECK(json["shear"]["webs"][0]["V_b_Rd"].get<double>() == Approx(V).epsilon(1e-3));
  CHECK(json["shear"]["webs"][1]["utilisation"].get<double>() == Approx(200e3 / V).epsilon(0.03));
  CHECK(json["interaction"]["utilisation"].get<double>() >=
        json["effective"]["utilisation"].get<double>());
  CHECK(json["reduced_stress"]["utilisation"].get<double>() >
        json["effective"]["utilisation"].get<double>());
  const test::ProgramResult text = test::run_program(
      {"section", "box 600x1224 flange 12 web 8", "--forces", "N = -863.4 kN, M_y = 1890 kN m"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("effective section") != std::string::npos);
  CHECK(text.out.find("71.7") != std::string::npos);
}

TEST_CASE("section under forces: plates with stiffeners") {
  const test::TemporaryFolder folder;
  const auto box = [&](const std::string& name, double depth) {
    std::string text =
        "[sections.box]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"1224 mm\"\n"
        "flange = \"12 mm\"\nweb = \"8 mm\"\n";
    for (const char* web : {"left web", "right web"}) {
      text += "[[sections.box.stiffeners]]\non = \"" + std::string(web) +
              "\"\nat = \"0 mm\"\ndepth = \"" + std::to_string(depth) +
              " mm\"\nthickness = \"10 mm\"\n";
    }
    return folder.write(name, text) + ":box";
  };
  const auto under = [](const std::string& section, const std::string& forces) {
    const test::ProgramResult result =
        test::run_program({"section", section, "--forces", forces, "--json", "-"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return Json::parse(result.out);
  };
  // Stretched, all of it works: A = 2 (600 12 + 1200 8 + 100 10) mm^2.
  const std::string with = box("with.toml", 100.0);
  const Json stretched = under(with, "N = 1000 kN");
  CHECK(stretched["effective"]["utilisation"].get<double>() ==
        Approx(1000e3 / (35600.0 * 355.0)).epsilon(1e-9));
  // Compressed, the flats leave more of the webs, and they bear more shear: A.3 adds to k_tau.
  const std::string bare = "box 600x1224 flange 12 web 8";
  const std::string forces = "N = -1000 kN, V_z = 300 kN";
  const Json stiffened = under(with, forces), plain = under(bare, forces);
  CHECK(stiffened["effective"]["A"].get<double>() > plain["effective"]["A"].get<double>() + 4e-3);
  CHECK(stiffened["shear"]["webs"][0]["chi"].get<double>() >
        1.2 * plain["shear"]["webs"][0]["chi"].get<double>());
  CHECK(stiffened["interaction"]["utilisation"].get<double>() <
        plain["interaction"]["utilisation"].get<double>());
  CHECK_FALSE(stiffened.contains("reduced_stress"));
  CHECK(plain.contains("reduced_stress"));
  const test::ProgramResult text = test::run_program({"section", with, "--forces", "N = -1000 kN"});
  const std::string unbroken = std::regex_replace(text.out, std::regex("\\s+"), " ");
  CHECK(unbroken.find("not computed of plates that stiffeners divide") != std::string::npos);
  // 10 x 20 mm: gamma = I/(b t^3/10.92) of a few.
  const test::ProgramResult weak =
      test::run_program({"section", box("weak.toml", 20.0), "--forces", forces});
  CHECK(weak.exit_code == 2);
  CHECK(weak.err.find("too weak") != std::string::npos);
  const test::ProgramResult twists =
      test::run_program({"section", box("deep.toml", 200.0), "--forces", forces});
  CHECK(twists.exit_code == 2);
  CHECK(twists.err.find("twists") != std::string::npos);
}

TEST_CASE("section under forces: a box as a path is the box") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write(
      "path.toml", path_cases::section("a", paths::box_path(600.0, 1224.0, 12.0, 8.0)));
  const auto under = [](const std::string& section, const std::string& forces) {
    const test::ProgramResult result =
        test::run_program({"section", section, "--forces", forces, "--json", "-"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return Json::parse(result.out);
  };
  for (const char* const forces :
       {"N = -863.4 kN, V_z = 400 kN", "N = 900 kN, T = -200 kN m", "M_y = 900 kN m"}) {
    INFO(forces);
    const Json box = under("box 600x1224 flange 12 web 8", forces), of = under(path + ":a", forces);
    CHECK(of["class"] == box["class"]);
    CHECK(of["effective"]["A"].get<double>() ==
          Approx(box["effective"]["A"].get<double>()).epsilon(1e-9));
    // Moments go on from the standard's pass until nothing changes.
    const bool bends = std::string(forces).find("M_y") != std::string::npos;
    const double use = box["effective"]["utilisation"], path_use = of["effective"]["utilisation"];
    CHECK(path_use >= use * (1.0 - 1e-9));
    CHECK(path_use <= use * (bends ? 1.04 : 1.0 + 1e-9));
    for (const char* const which : {"webs", "flanges"}) {
      REQUIRE(of["shear"][which].size() == 2);
      for (const std::size_t k : {0U, 1U}) {
        // Flows beyond the clear width of a path's walls are those of its mid-lines.
        const Json &a = of["shear"][which][k], &b = box["shear"][which][k];
        CHECK(a["V_b_Rd"].get<double>() == Approx(b["V_b_Rd"].get<double>()).epsilon(1e-9));
        CHECK(a["utilisation"].get<double>() ==
              Approx(b["utilisation"].get<double>()).epsilon(1e-5));
      }
    }
    if (!bends) {
      CHECK(of["interaction"]["utilisation"].get<double>() ==
            Approx(box["interaction"]["utilisation"].get<double>()).epsilon(1e-5));
    }
    CHECK_FALSE(of.contains("reduced_stress"));
  }
}

TEST_CASE(
    "section under forces: the class of an I by its plates, and what of paths is not judged") {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const ThinWalled& path) {
    return folder.write(name, path_cases::section("a", path)) + ":a";
  };
  const auto class_of = [&](const std::string& section, const std::string& forces) {
    const test::ProgramResult result = test::run_program(
        {"section", section, "--steel", "S235", "--forces", forces, "--json", "-"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return Json::parse(result.out)["class"].get<int>();
  };
  // Outstands (208 - 8)/2/10 = 10, web 400/8 = 50: class 2 (10) bent about y or along its flanges,
  // the web class 4 (above 42) compressed, nothing stretched.
  const std::string stout = write("stout.toml", paths::i_section(208.0, 10.0, 400.0, 8.0));
  CHECK(class_of(stout, "M_y = 1 kN m") == 2);
  CHECK(class_of(stout, "N = -1 kN") == 4);
  CHECK(class_of(stout, "N = 1 kN") == 1);
  // Outstands 13: class 3 (10 to 14) evenly; under M_z pressed at the tip almost to the web, psi =
  // 4/134: alpha = 1, class 3 up to 21 sqrt(0.57 - 0.21 psi) = 15.8.
  const std::string wide = write("wide.toml", paths::i_section(268.0, 10.0, 400.0, 8.0));
  CHECK(class_of(wide, "M_y = 1 kN m") == 3);
  CHECK(class_of(wide, "M_z = 1 kN m") == 3);
  // Outstands 15: beyond 14, not beyond 15.8.
  const std::string wider = write("wider.toml", paths::i_section(308.0, 10.0, 400.0, 8.0));
  CHECK(class_of(wider, "M_y = 1 kN m") == 4);
  CHECK(class_of(wider, "M_z = 1 kN m") == 3);
  // A flange so wide shears more along y than anything judges.
  const test::ProgramResult sheared =
      test::run_program({"section", wider, "--steel", "S235", "--forces", "V_y = 300 kN"});
  CHECK(sheared.exit_code == 2);
  CHECK(sheared.err.find("bears shear") != std::string::npos);
  const test::ProgramResult text = test::run_program(
      {"section", wider, "--steel", "S235", "--forces", "V_z = 100 kN, M_y = 20 kN m"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("node of walls") != std::string::npos);
  CHECK(text.out.find("nor of thin-walled paths") != std::string::npos);
}

TEST_CASE("section under forces: what is wrong is said") {
  const std::pair<const char*, const char*> wrong[] = {
      {"N", "is not a name, =, and a value"}, {"N = 3", "N is a force"},
      {"M = 3 kN m", "no cut force \"M\""},   {"M_y = 3 kN", "M_y is a moment"},
      {"N = 1 kN, N = 2 kN", "stands twice"}, {"N = 1 kN,", "is not a name"},
      {"T = nan kN m", "T is a moment"}};
  for (const auto& [forces, words] : wrong) {
    const test::ProgramResult result =
        test::run_program({"section", "SHS 100x5", "--forces", forces});
    INFO(forces << "\n" << result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.err.find(words) != std::string::npos);
    CHECK(result.err.find("hint: ") != std::string::npos);
  }
  const test::ProgramResult round =
      test::run_program({"section", "CHS 168.3x8", "--forces", "N = 1 kN"});
  CHECK(round.exit_code == 2);
  CHECK(round.err.find("boxes, rectangular tubes and thin-walled paths") != std::string::npos);
}

TEST_CASE("section: wrong words are exit code 2 with a hint") {
  for (const std::string& wrong :
       {std::string("RHS 200x100x9"), std::string("box 400x600"), std::string("IPE 200"),
        std::string("no-such.toml:A"), std::string("box 400x600 flange 300 web 50"),
        test::project_file("sections/sledge-rig/rig.toml") + ":A9"}) {
    const test::ProgramResult result = test::run_program({"section", wrong});
    INFO(wrong << "\n" << result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(result.err.find("hint: ") != std::string::npos);
  }
  CHECK(test::run_program({"section"}).exit_code == 2);
  CHECK(test::run_program({"section", "SHS 100x5", "--steel", "S1"}).exit_code == 2);
}

}  // namespace section_command_test
